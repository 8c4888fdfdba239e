"""The scene snapshot: published schema 0.3.0, with c4s's own keys under ``c4s``.

Units are cm and degrees; ``rotation_deg`` is [pitch, yaw, roll]. The models are the schema of what the exporter writes,
and allow further keys. Snapshots are read as plain data, because published ones may lack much of it and the rules say
what then; what every snapshot must have is checked by ``c4s.records.snapshot_faults``.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from c4s.errors import BadInput
from c4s.files import read_json
from c4s.records.level import Vector
from c4s.records.pack import CollisionBody

SCHEMA_VERSION = "0.3.0"
Text = Annotated[str, Field(min_length=1)]
Count = Annotated[int, Field(ge=0)]


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

    component_identity: Text
    slot_index: Count
    material_path: Text | None
    material_class_path: str | None
    is_dynamic: bool


class CollidingComponent(_Open):
    """A component that takes part in collision, and how, in Unreal's words."""

    name: str
    class_path: str = Field(alias="class")
    collision_enabled: str


class CollisionState(_Open):
    """Which primitive components of an actor collide."""

    collision_enabled: bool
    primitive_component_count: Count
    collision_enabled_component_count: Count
    collision_enabled_components: list[CollidingComponent]


class ExportDiagnostics(_Open):
    """What is recorded of an actor beside its state; the last two only where a generated id was not unique."""

    folder_path: str | None
    hidden_in_editor: bool | None
    component_classes: list[str]
    stable_actor_id_provenance: Literal[
        "explicit_tag", "generated_structural_identity", "generated_structural_identity_disambiguated_by_actor_scope"
    ]
    stable_actor_id_base: str | None = None
    stable_actor_scope: str | None = None


class WorldTransform(_Open):
    """World transform of a component, with its quaternion (x, y, z, w)."""

    location_cm: Vector
    rotation_deg: Vector
    quaternion_xyzw: tuple[float, float, float, float]
    scale: Vector


class ComponentFacts(_Open):
    """A scene component: its mesh, where it is, and whether pictures show it."""

    name: str
    class_path: str = Field(alias="class")
    mesh: str | None
    transform: WorldTransform
    collision_enabled: bool
    visible: bool
    instances: list[WorldTransform] = Field(default_factory=list)


class ActorFacts(_Open):
    """What c4s adds to an actor; a hidden one is in no picture."""

    quaternion_xyzw: tuple[float, float, float, float]
    hidden: bool
    components: list[ComponentFacts]


class SnapshotActor(_Open):
    """One actor. Role, category, origin and logical object are what its tags say."""

    stable_actor_id: Text
    actor_guid: str | None
    actor_origin: str | None
    logical_object_id: Text | None
    actor_role: str | None
    attachment_parent_path: str | None
    attachment_parent_label: str | None
    label: Text
    name: str
    actor_path: Text
    class_path: Text = Field(alias="class")
    asset_path: str | None
    asset_category: str | None
    component_asset_paths: list[str]
    material_paths: list[str]
    component_material_slots: list[MaterialSlotState]
    actor_tags: list[Text]
    collision: CollisionState
    transform: ActorTransform
    bounds: Bounds
    properties: dict[str, bool | float | str | list[float]]
    export_diagnostics: ExportDiagnostics
    export_errors: list[str]
    c4s: ActorFacts | None = None


class MaterialParameters(_Open):
    """A material that some slot shows: values of its parameters, its textures, and what could not be read."""

    schema_version: Literal["1.0"]
    material_path: str
    material_class_path: str
    resolved_scalar_parameters: dict[str, float]
    resolved_vector_parameters: dict[str, list[float]]
    resolved_texture_parameters: dict[str, str]
    used_texture_paths: list[str] | None
    probe_status: Literal["success", "partial"]
    probe_errors: list[str]
    source: str


class ExportMetadata(_Open):
    """What an export says of itself."""

    status: str
    requested_map: str | None
    previous_map_package: str | None
    stable_actor_id_count: Count
    explicit_stable_actor_id_count: Count
    generated_stable_actor_id_count: Count
    disambiguated_generated_stable_actor_id_count: Count
    generated_stable_actor_id_algorithm: dict[str, str | list[str]]
    actor_guid_count: Count
    asset_path_count: Count
    material_actor_count: Count
    material_parameter_catalog_count: Count
    actor_error_count: Count


class MeshFacts(_Open):
    """A mesh's digest, local AABB (cm) and collision bodies (local cm), stored once for all its actors."""

    sha256: str | None
    bounds_min_cm: Vector
    bounds_max_cm: Vector
    collision: list[CollisionBody] | None
    """None where the engine cannot tell."""


class SceneFacts(_Open):
    """What c4s adds to a scene."""

    engine: str
    engine_version: str
    meshes: dict[str, MeshFacts]


class SceneSnapshot(_Open):
    """A scene as an engine exported it."""

    schema_version: Literal["0.3.0"]
    snapshot_type: Literal["ue_editor_scene"]
    units: Literal["cm"]
    map_path: str
    actor_count: Count
    actors: list[SnapshotActor]
    material_parameter_catalog: dict[str, MaterialParameters]
    export_metadata: ExportMetadata
    c4s: SceneFacts | None = None


def read_snapshot(path: Path) -> dict[str, Any]:
    """A snapshot file as plain data. ``BadInput`` when it is truncated, or is no scene with a list of actors."""
    value = read_json(path, what="snapshot")
    if not isinstance(value, Mapping) or not isinstance(value.get("actors"), list):
        raise BadInput("not a scene snapshot: it has no list of actors", where=str(path))
    for number, actor in enumerate(value["actors"], start=1):
        if not isinstance(actor, Mapping):
            raise BadInput(f"actor {number} of this snapshot is no record", where=str(path))
    return dict(value)
