"""Requirement bundles: from a compact authored list to the published bundle format (``schema_version`` 1.0).

An author names entities and predicates by the very words of the prompt; ``cases.graphs`` finds the spans and makes the
graph, and the one validator of bundles (``c4s.protocol.graph``) looks at it: what it refuses is never written.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, ClassVar, Literal, TypeAlias, get_args

from pydantic import ConfigDict

from c4s.errors import BadInput
from c4s.protocol.graph.check import check_bundle
from c4s.protocol.graph.prompt import description_end
from c4s.protocol.rules import FAMILY_OF_TYPE, Family
from cases.graphs.compiler import COMPILER, COMPILER_VERSION, compile_bundle
from cases.graphs.ir import IRArgument, IREntity, IRQualifier, IRQuantity, IRRequirement, SemanticIR

Grounding: TypeAlias = Literal["actor", "actor_collection", "derived_region", "scene_global"]

PredicateType = Literal[
    "scene_identity",
    "environment",
    "existence",
    "quantity",
    "attribute",
    "material",
    "spatial_relation",
    "distribution",
    "composition",
]
FAMILIES: dict[str, Family] = {kind: FAMILY_OF_TYPE[kind] for kind in get_args(PredicateType)}
"""Family of each predicate type that can be authored."""
REVIEW = {
    "approved": True,
    "human_reviewed": False,
    "review_method": "automated_policy",
    "reviewer": f"{COMPILER}:{COMPILER_VERSION}",
    "policy_name": "authored-and-validated",
    "policy_version": "2",
    "basis": ["requirement_graph_contract_valid", "prompt_grounding_valid"],
}


@dataclass(frozen=True)
class EntitySpec:
    """Something the prompt speaks of. ``text`` are its words in the prompt; ``aliases`` are other names for it."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    key: str
    text: str
    aliases: tuple[str, ...] = ()
    entity_type: Literal["object", "region", "surface"] = "object"
    collection: bool = False
    occurrence: int = 0
    """Which occurrence of the words in the prompt (0 is the first)."""


@dataclass(frozen=True)
class Quantity:
    """How many: ``exact``, ``approximately``, ``at_least``, ``range`` or ``qualitative`` (several, few, dense)."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    mode: Literal["exact", "approximately", "at_least", "range", "qualitative"]
    value: float | None = None
    lower: float | None = None
    upper: float | None = None
    qualitative: str | None = None


@dataclass(frozen=True)
class PredicateSpec:
    """One scored requirement about ``subject`` (an entity key), grounded in the prompt's words ``text``.

    ``relation`` and ``reference`` say what it stands in relation to; ``qualifiers`` are (kind, word) pairs such as
    ``("color", "red")`` whose words occur in ``text``.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    type: PredicateType
    name: str
    text: str
    subject: str
    reference: str | None = None
    relation: str | None = None
    quantity: Quantity | None = None
    qualifiers: tuple[tuple[str, str], ...] = ()
    occurrence: int = 0
    references: tuple[str, ...] = ()
    """Further references, behind ``reference``."""


@dataclass(frozen=True)
class RequirementSpec:
    """The authored requirements of one prompt."""

    entities: Sequence[EntitySpec]
    predicates: Sequence[PredicateSpec]
    author: str = field(default="c4s starter suite")


def bundle(case_id: str, description: str, prompt: str, spec: RequirementSpec) -> dict[str, Any]:
    """The requirement bundle of a prompt that starts with ``description``. ``BadInput`` when the spec is wrong."""
    if prompt[: description_end(prompt)] != description:
        raise BadInput("the prompt's description is not the case's", where=case_id)
    if not spec.predicates:
        raise BadInput("a text case needs requirements", where=case_id)
    try:
        made = compile_bundle(case_id, prompt, _ir(spec), _provenance(spec), REVIEW)
    except BadInput as error:
        raise BadInput(error.line(), where=case_id) from None
    check_bundle(made, making=True).refuse(where=case_id)
    return made


def _provenance(spec: RequirementSpec) -> dict[str, Any]:
    return {"authoring_parser": "authored", "authoring_client": {"client": spec.author}}


def _ir(spec: RequirementSpec) -> SemanticIR:
    return SemanticIR(
        entities=[_entity(entity) for entity in spec.entities],
        requirements=[_requirement(predicate, f"r{number}") for number, predicate in enumerate(spec.predicates, 1)],
    )


def _entity(entity: EntitySpec) -> IREntity:
    grounding: dict[str, Grounding] = {
        "object": "actor_collection" if entity.collection else "actor",
        "region": "derived_region",
        "surface": "actor_collection",
    }
    return IREntity(
        key=entity.key,
        name=entity.key,
        source_text=entity.text,
        occurrence=entity.occurrence,
        aliases=list(entity.aliases),
        entity_type=entity.entity_type,
        grounding_mode=grounding[entity.entity_type],
        referent_kind="collection" if entity.collection else "individual",
    )


def _requirement(predicate: PredicateSpec, key: str) -> IRRequirement:
    quantity = predicate.quantity
    return IRRequirement(
        key=key,
        name=predicate.name,
        requirement_type="presence" if predicate.type == "existence" else predicate.type,
        source_text=predicate.text,
        occurrence=predicate.occurrence,
        relation=predicate.relation,
        arguments=[
            IRArgument(role="subject", entity_key=predicate.subject),
            *(
                IRArgument(role="reference", entity_key=key)
                for key in (predicate.reference, *predicate.references)
                if key
            ),
        ],
        qualifiers=[IRQualifier(kind=kind, source_text=word) for kind, word in predicate.qualifiers],
        quantity=None if quantity is None else IRQuantity(**asdict(quantity)),
    )


def families(spec: RequirementSpec) -> set[Family]:
    """The families that a spec asks for."""
    return {FAMILIES[predicate.type] for predicate in spec.predicates}
