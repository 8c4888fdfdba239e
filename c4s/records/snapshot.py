"""The scene snapshot: published schema 0.3.0, with c4s's own keys under ``c4s``.

Units are cm and degrees; ``rotation_deg`` is [pitch, yaw, roll]. The models describe what the exporter writes and allow
further keys; verifiers read plain data, because published snapshots may lack any of it and the rules say what then.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from c4s.errors import BadInput
from c4s.files import read_json
from c4s.records.level import Vector
from c4s.records.pack import CollisionBody

SCHEMA_VERSION = "0.3.0"


class _Open(BaseModel):
    model_config = ConfigDict(extra="allow")


class ActorTransform(_Open):
    """World transform."""

    location_cm: Vector
    rotation_deg: Vector
    scale: Vector


class Bounds(_Open):
    """World AABB: centre and half extents."""

    origin_cm: Vector
    extent_cm: Vector


class MaterialSlotState(_Open):
    """A material slot of a component; ``component_identity`` is ``name|class path``."""

    component_identity: str
    slot_index: int
    material_path: str | None
    material_class_path: str | None
    is_dynamic: bool


class WorldTransform(_Open):
    """World transform of a component, with its quaternion (x, y, z, w)."""

    location_cm: Vector
    rotation_deg: Vector
    quaternion_xyzw: tuple[float, float, float, float]
    scale: Vector


class ComponentFacts(_Open):
    """A primitive component: its mesh and where it is."""

    name: str
    class_path: str = Field(alias="class")
    mesh: str | None
    transform: WorldTransform
    collision_enabled: bool
    instances: list[WorldTransform] = Field(default_factory=list)


class ActorFacts(_Open):
    """What c4s adds to an actor."""

    quaternion_xyzw: tuple[float, float, float, float]
    components: list[ComponentFacts]


class SnapshotActor(_Open):
    """One actor."""

    stable_actor_id: str | None = None
    actor_guid: str | None = None
    label: str
    name: str
    actor_path: str
    class_path: str = Field(alias="class")
    asset_path: str | None = None
    component_asset_paths: list[str] = Field(default_factory=list)
    material_paths: list[str | None] = Field(default_factory=list)
    component_material_slots: list[MaterialSlotState] = Field(default_factory=list)
    actor_tags: list[str] = Field(default_factory=list)
    transform: ActorTransform
    bounds: Bounds | None = None
    collision: dict[str, Any] = Field(default_factory=dict)
    properties: dict[str, Any] = Field(default_factory=dict)
    c4s: ActorFacts | None = None


class MeshFacts(_Open):
    """A mesh's digest, local AABB (cm) and collision bodies (local cm), stored once for all its actors."""

    sha256: str | None = None
    bounds_min_cm: Vector
    bounds_max_cm: Vector
    collision: list[CollisionBody] = Field(default_factory=list)


class SceneFacts(_Open):
    """What c4s adds to a scene."""

    engine: str
    meshes: dict[str, MeshFacts] = Field(default_factory=dict)


class SceneSnapshot(_Open):
    """A scene as an engine exported it."""

    schema_version: Literal["0.3.0"]
    units: Literal["cm"]
    map_path: str
    actor_count: int
    actors: list[SnapshotActor]
    c4s: SceneFacts | None = None


def read_snapshot(path: Path) -> dict[str, Any]:
    """A snapshot file as plain data. ``BadInput`` when it is truncated, or is no scene with a list of actors."""
    value = read_json(path, what="snapshot")
    if not isinstance(value, Mapping) or not isinstance(value.get("actors"), list):
        raise BadInput("not a scene snapshot: it has no list of actors", where=str(path))
    return dict(value)


def check_snapshot(value: Any, *, where: str = "snapshot") -> SceneSnapshot:
    """Validate against the schema; ``BadInput`` names the first wrong field."""
    try:
        return SceneSnapshot.model_validate(value)
    except ValidationError as error:
        first = error.errors()[0]
        field = ".".join(str(part) for part in first["loc"])
        raise BadInput(f"snapshot field {field!r}: {first['msg']}", where=where) from None
