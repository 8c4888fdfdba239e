"""The level document: what the headless engine saves and loads, readable JSON in place of a ``.umap``.

Centimetres and degrees; ``rotation_deg`` is [pitch, yaw, roll]; left-handed, Z up.

Agents write these: whatever can be many or long in one is bounded (``c4s.bounds``).
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, Field, ValidationError

from c4s.bounds import BOUNDS, long_number_in, values_in
from c4s.errors import BadInput
from c4s.files import read_plain
from c4s.records.base import Record, first_fault

LARGEST_PROPERTY = 1e15
"""Numbers of properties beyond this, either way, are no measurement; it keeps products of them far from overflow."""


def _bounded(properties: dict[str, Any]) -> dict[str, Any]:
    """Properties within their size and nesting, with finite numbers; ``ValueError`` says what is beyond."""
    if not properties:
        return properties
    waiting: list[tuple[Any, int]] = [(properties, 0)]
    size = 0
    while waiting:
        value, depth = waiting.pop()
        if isinstance(value, dict):
            waiting += [(item, depth + 1) for item in value.values()]
            size += sum(len(name) + 2 for name in value)
        elif isinstance(value, list):
            waiting += [(item, depth + 1) for item in value]
            size += len(value)
        elif isinstance(value, str):
            size += len(value) + 2
        else:
            size += 4
            if isinstance(value, int | float) and not abs(value) <= LARGEST_PROPERTY:
                raise ValueError(f"a property must be finite numbers of at most {LARGEST_PROPERTY:g}")
        fault = BOUNDS["properties_size"].fault(size) or BOUNDS["properties_depth"].fault(depth)
        if fault is not None:
            raise ValueError(fault)
    return properties


Vector = tuple[float, float, float]
Label = Annotated[str, Field(max_length=BOUNDS["name_length"].most)]
"""A name, label or path."""
Number = Annotated[float, Field(ge=-LARGEST_PROPERTY, le=LARGEST_PROPERTY)]
"""A number of a material or a property."""
Properties = Annotated[dict[str, Any], AfterValidator(_bounded)]
Slots = Annotated[dict[int, Label], Field(max_length=BOUNDS["component_slots"].most)]


class Transform(Record):
    """Location (cm), rotation ([pitch, yaw, roll] degrees) and signed scale factors."""

    location_cm: Vector = (0.0, 0.0, 0.0)
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    scale: Vector = (1.0, 1.0, 1.0)


class LevelComponent(Record):
    """One component of an actor. The root component's transform is the actor's; others are relative to the root."""

    name: Label
    class_path: Label
    static_mesh: Label | None = None
    materials: Slots = Field(default_factory=dict)
    """Material overrides: slot index to asset path."""
    relative: Transform = Transform()
    collision_enabled: bool = True
    instances: list[Transform] = Field(default_factory=list, fail_fast=True)
    """Instance transforms (relative to the component) of an instanced static mesh component."""
    properties: Properties = Field(default_factory=dict)
    """Editor properties that differ from the class default, snake_case names."""


class LevelActor(Record):
    """One actor. ``name`` is the object name, unique in the level; ``label`` is what people read."""

    name: Label
    label: Label
    class_path: Label
    """``/Script/Engine.StaticMeshActor``, or a Blueprint class ``/Game/.../BP_X.BP_X_C``."""
    guid: Label
    """32 upper-case hex digits."""
    transform: Transform = Transform()
    components: list[LevelComponent] = Field(
        default_factory=list, fail_fast=True, max_length=BOUNDS["actor_components"].most
    )
    tags: list[Label] = Field(default_factory=list, fail_fast=True, max_length=BOUNDS["actor_tags"].most)
    folder: Label = ""
    parent: Label | None = None
    """Object name of the actor that this one is attached to."""
    hidden: bool = False
    properties: Properties = Field(default_factory=dict)


class Level(Record):
    """A level package."""

    schema_version: Literal["c4s.level.v1"] = "c4s.level.v1"
    package: Label
    """``/Game/...`` package path; the file lies at ``<content root>/Game/....level.json``."""
    actors: list[LevelActor] = Field(default_factory=list, fail_fast=True)

    def made_of(self) -> set[str]:
        """Paths of the meshes and Blueprint classes that its actors are made of."""
        classes = {actor.class_path for actor in self.actors}
        return classes | {part.static_mesh for actor in self.actors for part in actor.components if part.static_mesh}

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read and validate a document; ``BadInput`` when it is missing, truncated, wrong or too large."""
        return cls.from_text(read_plain(path, "level", BOUNDS["level_bytes"]), where=str(path))

    @classmethod
    def from_text(cls, data: bytes, *, where: str) -> Self:
        """A document of JSON text, which is measured before it is read; ``BadInput`` as ``read``."""
        BOUNDS["level_bytes"].hold(len(data), where=where)
        BOUNDS["level_records"].hold(data.count(b"{"), where=where)
        BOUNDS["level_values"].hold(values_in(data), where=where)
        if long_number_in(data):
            raise BadInput("a number has too many digits", where=where)
        try:
            level = cls.model_validate_json(data)
        except ValidationError as error:
            field, message = first_fault(error)
            raise BadInput(f"this level document is wrong at {field}: {message}", where=where) from None
        BOUNDS["level_actors"].hold(len(level.actors), where=where)
        instances = sum(len(part.instances) for actor in level.actors for part in actor.components)
        BOUNDS["level_instances"].hold(instances, where=where)
        return level
