"""Snapshots of the shipped indoor levels: the published exporter's fields, types and ids, and c4s's own apart."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import pytest
from pydantic import BaseModel

from c4s.evidence.collect import export_level
from c4s.files import read_json
from c4s.records.level import Level, LevelActor
from c4s.records.snapshot import SceneSnapshot
from c4s.records.snapshot_faults import snapshot_fault
from cases.starter.indoor_cases import scenes

SCENE_FIELDS = {
    "schema_version": str,
    "snapshot_type": str,
    "units": str,
    "map_path": str,
    "actor_count": int,
    "actors": list,
    "material_parameter_catalog": dict,
    "export_metadata": dict,
}
ACTOR_FIELDS = {
    "stable_actor_id": str,
    "actor_guid": str,
    "actor_origin": str | None,
    "logical_object_id": str | None,
    "actor_role": str | None,
    "attachment_parent_path": str | None,
    "attachment_parent_label": str | None,
    "label": str,
    "name": str,
    "actor_path": str,
    "class": str,
    "asset_path": str | None,
    "asset_category": str | None,
    "component_asset_paths": list,
    "material_paths": list,
    "component_material_slots": list,
    "actor_tags": list,
    "collision": dict,
    "transform": dict,
    "bounds": dict,
    "properties": dict,
    "export_diagnostics": dict,
    "export_errors": list,
}
INNER_FIELDS = {
    "collision": {
        "collision_enabled": bool,
        "primitive_component_count": int,
        "collision_enabled_component_count": int,
        "collision_enabled_components": list,
    },
    "transform": {"location_cm": list, "rotation_deg": list, "scale": list},
    "bounds": {"origin_cm": list, "extent_cm": list},
    "export_diagnostics": {
        "folder_path": str,
        "hidden_in_editor": bool,
        "component_classes": list,
        "stable_actor_id_provenance": str,
    },
}
METADATA_FIELDS = {
    "status": str,
    "requested_map": str | None,
    "previous_map_package": str,
    "stable_actor_id_count": int,
    "explicit_stable_actor_id_count": int,
    "generated_stable_actor_id_count": int,
    "disambiguated_generated_stable_actor_id_count": int,
    "generated_stable_actor_id_algorithm": dict,
    "actor_guid_count": int,
    "asset_path_count": int,
    "material_actor_count": int,
    "material_parameter_catalog_count": int,
    "actor_error_count": int,
}
MATERIAL_FIELDS = {
    "schema_version": str,
    "material_path": str,
    "material_class_path": str,
    "resolved_scalar_parameters": dict,
    "resolved_vector_parameters": dict,
    "resolved_texture_parameters": dict,
    "used_texture_paths": list,
    "probe_status": str,
    "probe_errors": list,
    "source": str,
}
LIGHT_FIELDS = [
    "intensity",
    "intensity_units",
    "light_color",
    "temperature",
    "use_temperature",
    "indirect_lighting_intensity",
    "volumetric_scattering_intensity",
    "fog_density",
    "fog_height_falloff",
    "start_distance",
]


def bare(actor: LevelActor, number: int) -> LevelActor:
    """Every second actor loses its tags, and so its id."""
    return actor.model_copy(update={"tags": []}) if number % 2 else actor


@pytest.fixture(scope="module", params=scenes(), ids=lambda scene: scene.scene_id)
def shipped(request: pytest.FixtureRequest, indoor_packs: Path, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A shipped level with half of its actors untagged, and its snapshot."""
    folder = tmp_path_factory.mktemp("snapshot")
    whole = request.param.level
    level = Level(package=whole.package, actors=[bare(actor, i) for i, actor in enumerate(whole.actors)])
    level.write(folder / "scene.level.json")
    export_level(
        engine="headless",
        packs=[indoor_packs / request.param.packs[0]],
        level=folder / "scene.level.json",
        out=folder / "snapshot.json",
    )
    return level, read_json(folder / "snapshot.json")


def assert_fields(record: dict[str, Any], fields: dict[str, Any]) -> None:
    """The record has these fields, in this order, and no other; a whole number is no truth value."""
    assert list(record) == list(fields)
    for name, kind in fields.items():
        assert isinstance(record[name], kind) and (kind is not int or type(record[name]) is int), name


def test_the_fields_are_the_published_ones(shipped: tuple[Level, dict[str, Any]]) -> None:
    _, snapshot = shipped
    assert_fields(snapshot, SCENE_FIELDS | {"c4s": dict})
    assert_fields(snapshot["export_metadata"], METADATA_FIELDS)
    for actor in snapshot["actors"]:
        assert_fields(actor, ACTOR_FIELDS | {"c4s": dict})
        for section, fields in INNER_FIELDS.items():
            assert_fields(actor[section], fields)
        assert set(actor["properties"]) <= set(LIGHT_FIELDS)
        assert list(actor["properties"]) == [name for name in LIGHT_FIELDS if name in actor["properties"]]
        assert bool(actor["properties"]) == any(kind in actor["class"].rpartition(".")[2] for kind in ("Light", "Fog"))
        slots = [(slot["component_identity"], slot["slot_index"]) for slot in actor["component_material_slots"]]
        assert slots == sorted(slots) and len(set(slots)) == len(slots)
        for slot in actor["component_material_slots"]:
            fields = {"material_path": str, "material_class_path": str, "is_dynamic": bool}
            assert_fields(slot, {"component_identity": str, "slot_index": int} | fields)
        for part in actor["collision"]["collision_enabled_components"]:
            assert_fields(part, {"name": str, "class": str, "collision_enabled": str})
            assert part["collision_enabled"] == "<CollisionEnabled.QUERY_AND_PHYSICS: 3>"
    for path, material in snapshot["material_parameter_catalog"].items():
        assert_fields(material, MATERIAL_FIELDS)
        assert material["material_path"] == path and material["probe_errors"] == []
    used = {path for actor in snapshot["actors"] for path in actor["material_paths"]}
    assert sorted(used) == list(snapshot["material_parameter_catalog"])


def test_ids_follow_from_tags_or_from_what_an_actor_is_made_of(shipped: tuple[Level, dict[str, Any]]) -> None:
    level, snapshot = shipped
    made = explicit = 0
    for document, actor in zip(level.actors, snapshot["actors"], strict=True):
        diagnostics = actor["export_diagnostics"]
        assert diagnostics["folder_path"] == (document.folder or "None")
        if document.tags:
            explicit += 1
            expected, provenance = document.tags[0].removeprefix("simcodearena.stable_actor_id="), "explicit_tag"
        else:
            made += 1
            parts = {
                "actor_name": document.name,
                "class_path": document.class_path,
                "component_asset_paths": sorted({part.static_mesh for part in document.components if part.static_mesh}),
            }
            text = json.dumps(parts, separators=(",", ":"))
            expected = "sca_generated_" + hashlib.sha256(text.encode()).hexdigest()[:32]
            provenance = "generated_structural_identity"
        assert actor["stable_actor_id"] == expected
        assert diagnostics["stable_actor_id_provenance"] == provenance
    metadata = snapshot["export_metadata"]
    assert metadata["explicit_stable_actor_id_count"] == explicit > 20
    assert metadata["generated_stable_actor_id_count"] == made > 20
    assert metadata["stable_actor_id_count"] == len({actor["stable_actor_id"] for actor in snapshot["actors"]})


def unknown_fields(value: Any, where: str = "") -> list[str]:
    """Fields of a validated record that its model does not describe."""
    if isinstance(value, BaseModel):
        found = [f"{where}.{name}" for name in value.model_extra or {}]
        return found + [f for name in type(value).model_fields for f in unknown_fields(getattr(value, name), name)]
    if isinstance(value, dict):
        return [f for each in value.values() for f in unknown_fields(each, where)]
    return [f for each in value for f in unknown_fields(each, where)] if isinstance(value, list) else []


def test_the_schema_describes_every_field_of_a_sound_snapshot(shipped: tuple[Level, dict[str, Any]]) -> None:
    _, snapshot = shipped
    assert snapshot_fault(snapshot) == ""
    assert unknown_fields(SceneSnapshot.model_validate(snapshot)) == []
