"""The schema of snapshots in the docs, and what it has in common with the check that every snapshot goes through."""

from __future__ import annotations

import importlib
import json
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from c4s.engine.headless.process.boot import boot
from c4s.records.schemas import write_schemas
from c4s.records.snapshot_faults import snapshot_fault

DOCS = Path(__file__).parents[2] / "docs" / "schemas"
SCHEMA = jsonschema.Draft202012Validator(json.loads((DOCS / "scene-snapshot.schema.json").read_text(encoding="utf-8")))


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """A cube and a lamp."""
    unreal: Any = boot([], tmp_path_factory.mktemp("content"))
    unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector())
    unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.SpotLight, unreal.Vector(0, 0, 300))
    found: dict[str, Any] = json.loads(json.dumps(importlib.import_module("c4s.editor.snapshot").export_snapshot()))
    return found


def test_the_schemas_in_the_docs_are_those_of_the_code(tmp_path: Path) -> None:
    written = {path.name: path.read_bytes() for path in write_schemas(tmp_path)}
    assert written == {path.name: path.read_bytes() for path in DOCS.iterdir()}


def test_an_exported_scene_has_the_schema_with_and_without_what_c4s_adds(scene: dict[str, Any]) -> None:
    published = deepcopy(scene)
    for owner in (published, *published["actors"]):
        del owner["c4s"]
    for given in (scene, published):
        assert snapshot_fault(given) == "" and SCHEMA.is_valid(given)


BREAKS: dict[str, Callable[[dict[str, Any], dict[str, Any]], Any]] = {
    "version": lambda scene, actor: scene.update(schema_version="0.2.0"),
    "units": lambda scene, actor: scene.update(units="m"),
    "no actors": lambda scene, actor: scene.pop("actors"),
    "actors": lambda scene, actor: scene.update(actors={}),
    "count": lambda scene, actor: scene.update(actor_count="2"),
    "actor": lambda scene, actor: scene["actors"].__setitem__(0, 1),
    "no label": lambda scene, actor: actor.pop("label"),
    "label": lambda scene, actor: actor.update(label=""),
    "class": lambda scene, actor: actor.update({"class": 3}),
    "path": lambda scene, actor: actor.update(actor_path=""),
    "id": lambda scene, actor: actor.update(stable_actor_id=7),
    "empty id": lambda scene, actor: actor.update(stable_actor_id=""),
    "object": lambda scene, actor: actor.update(logical_object_id=[]),
    "empty object": lambda scene, actor: actor.update(logical_object_id=""),
    "tags": lambda scene, actor: actor.update(actor_tags="a"),
    "empty tag": lambda scene, actor: actor.update(actor_tags=[""]),
    "no transform": lambda scene, actor: actor.pop("transform"),
    "no scale": lambda scene, actor: actor["transform"].pop("scale"),
    "short": lambda scene, actor: actor["transform"].update(location_cm=[0, 0]),
    "truth value": lambda scene, actor: actor["transform"].update(rotation_deg=[0, True, 0]),
    "text": lambda scene, actor: actor["transform"].update(scale=["1", 1, 1]),
    "no bounds": lambda scene, actor: actor.update(bounds=None),
    "no extent": lambda scene, actor: actor["bounds"].pop("extent_cm"),
    "properties": lambda scene, actor: actor.update(properties=[]),
    "slots": lambda scene, actor: actor.update(component_material_slots={}),
    "slot": lambda scene, actor: actor.update(component_material_slots=[3]),
    "slot owner": lambda scene, actor: actor["component_material_slots"][0].update(component_identity=""),
    "slot index": lambda scene, actor: actor["component_material_slots"][0].update(slot_index=-1),
    "slot path": lambda scene, actor: actor["component_material_slots"][0].update(material_path=""),
    "slot dynamic": lambda scene, actor: actor["component_material_slots"][0].update(is_dynamic=None),
}


@pytest.mark.parametrize("name", BREAKS)
def test_what_the_check_refuses_breaks_the_schema_too(name: str, scene: dict[str, Any]) -> None:
    broken = deepcopy(scene)
    BREAKS[name](broken, broken["actors"][0])
    assert snapshot_fault(broken) and not SCHEMA.is_valid(broken)
