"""The level document: what the headless engine saves and loads, readable JSON in place of a ``.umap``.

Centimetres and degrees; ``rotation_deg`` is [pitch, yaw, roll]; left-handed, Z up.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from c4s.records.base import Record

Vector = tuple[float, float, float]


class Transform(Record):
    """Location (cm), rotation ([pitch, yaw, roll] degrees) and signed scale factors."""

    location_cm: Vector = (0.0, 0.0, 0.0)
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    scale: Vector = (1.0, 1.0, 1.0)


class LevelComponent(Record):
    """One component of an actor. The root component's transform is the actor's; others are relative to the root."""

    name: str
    class_path: str
    static_mesh: str | None = None
    materials: dict[int, str] = Field(default_factory=dict)
    """Material overrides: slot index to asset path."""
    relative: Transform = Transform()
    collision_enabled: bool = True
    instances: list[Transform] = Field(default_factory=list)
    """Instance transforms (relative to the component) of an instanced static mesh component."""
    properties: dict[str, Any] = Field(default_factory=dict)
    """Editor properties that differ from the class default, snake_case names."""


class LevelActor(Record):
    """One actor. ``name`` is the object name, unique in the level; ``label`` is what people read."""

    name: str
    label: str
    class_path: str
    """``/Script/Engine.StaticMeshActor``, or a Blueprint class ``/Game/.../BP_X.BP_X_C``."""
    guid: str
    """32 upper-case hex digits."""
    transform: Transform = Transform()
    components: list[LevelComponent] = Field(default_factory=list)
    tags: list[str] = Field(default_factory=list)
    folder: str = ""
    parent: str | None = None
    """Object name of the actor that this one is attached to."""
    hidden: bool = False
    properties: dict[str, Any] = Field(default_factory=dict)


class Level(Record):
    """A level package."""

    schema_version: Literal["c4s.level.v1"] = "c4s.level.v1"
    package: str
    """``/Game/...`` package path; the file lies at ``<content root>/Game/....level.json``."""
    actors: list[LevelActor] = Field(default_factory=list)
