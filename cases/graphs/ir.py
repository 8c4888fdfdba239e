"""The intermediate representation of a prompt's requirements: words quoted instead of offsets, keys instead of ids.

It is what a model is asked for and what an authored list becomes; the field names are those of the published
``stage0_semantic_ir``. ``cases.graphs.compiler`` makes the graph of it.
"""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from pydantic import Field

from c4s.protocol.bundle import MAXIMUM_NODES, MAXIMUM_TEXT
from c4s.records.base import Record

MOST_ROWS: Final = MAXIMUM_NODES // 10
"""Entities, and requirements, an ``A or B`` as many as it stands for."""
Words = Annotated[str, Field(min_length=1, max_length=MAXIMUM_TEXT)]
Key = Annotated[str, Field(min_length=1, max_length=200)]
Occurrence = Annotated[int, Field(ge=0, le=1_000_000)]
Count = Annotated[float, Field(ge=0, le=1_000_000_000, allow_inf_nan=False)]
RequirementType = Literal[
    "presence",
    "quantity",
    "attribute",
    "material",
    "spatial_relation",
    "distribution",
    "composition",
    "environment",
    "scene_identity",
    "style_bundle",
    "logic",
]
Role = Literal["subject", "reference", "region", "collection", "member", "path", "scene", "scene_region"]


class IREntity(Record):
    """Something that the prompt speaks of."""

    key: Key
    name: Words
    source_text: Words
    """Its words in the prompt, to the letter."""
    occurrence: Occurrence = 0
    """Which of their occurrences in the prompt; 0 is the first."""
    aliases: list[Words] = Field(default_factory=list, max_length=50)
    entity_type: Literal["object", "region", "surface"]
    grounding_mode: Literal["actor", "actor_collection", "derived_region", "scene_global"]
    referent_kind: Literal["individual", "collection"]
    list_mode: Literal["none", "or"] = "none"
    member_keys: list[Key] = Field(default_factory=list, max_length=100)
    """Of an ``A or B``: the entities A and B."""


class IRQualifier(Record):
    """A word that a requirement asks for: a colour, a material, a shape, a density, a mood."""

    kind: Annotated[str, Field(min_length=1, max_length=60)]
    source_text: Words
    """Its words, within those of the requirement."""


class IRQuantity(Record):
    """How many."""

    mode: Literal["exact", "approximately", "at_least", "at_most", "range", "qualitative"]
    value: Count | None = None
    lower: Count | None = None
    upper: Count | None = None
    qualitative: Words | None = None


class IRArgument(Record):
    """What a requirement is about, in which role."""

    role: Role
    entity_key: Key


class IRLogic(Record):
    """Which requirements a logic requirement is made of."""

    operator: Literal["any_of", "all_of", "none_of", "not"]
    requirement_keys: list[Key] = Field(min_length=1, max_length=100)


class IRRequirement(Record):
    """One requirement of the prompt."""

    key: Key
    name: Words
    requirement_type: RequirementType
    source_text: Words
    occurrence: Occurrence = 0
    polarity: Literal["affirmative", "negative"] = "affirmative"
    relation: Annotated[str, Field(min_length=1, max_length=100)] | None = None
    arguments: list[IRArgument] = Field(default_factory=list, max_length=100)
    qualifiers: list[IRQualifier] = Field(default_factory=list, max_length=50)
    quantity: IRQuantity | None = None
    logic: IRLogic | None = None


class SemanticIR(Record):
    """All entities and requirements of a prompt."""

    entities: list[IREntity] = Field(min_length=1, max_length=MOST_ROWS)
    requirements: list[IRRequirement] = Field(min_length=1, max_length=MOST_ROWS)


def answer_schema() -> dict[str, Any]:
    """The JSON Schema of an answer: every field required, as structured output wants it."""
    schema: dict[str, Any] = SemanticIR.model_json_schema()
    for part in (schema, *schema.get("$defs", {}).values()):
        _all_required(part)
    return schema


def _all_required(part: dict[str, Any]) -> None:
    properties = part.get("properties")
    if properties is None:
        return
    part["required"] = list(properties)
    for field in properties.values():
        field.pop("default", None)
        field.pop("title", None)
