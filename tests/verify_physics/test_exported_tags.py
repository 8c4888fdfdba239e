"""Physics of an exported scene: tags that name one logical object, and what is recorded of lights and grading."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.verify.physics.edited import edited_actors
from c4s.verify.physics.verdict import verify_physics
from c4s.verify.repair import repair_verdict

CUBE = "/Engine/BasicShapes/Cube"


def export() -> dict[str, Any]:
    """The open level's snapshot; the editor's scripts import ``unreal``, so after ``boot`` only."""
    found: dict[str, Any] = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    return found


def penetration(verdict: Any) -> dict[str, Any]:
    found: dict[str, Any] = verdict.measurements["leaf_results"][1]
    return found


@pytest.mark.parametrize(
    ("tags", "score"),
    [
        ((["logical_object_id=car"], ["simcodearena.logical_object_id=car"]), 1.0),
        ((["logical_object_id=car"], ["logical_object_id=van"]), 0.0),
        ((["logical_object_id=car"], []), 0.0),
        (([], []), 0.0),
    ],
)
@pytest.mark.parametrize("setting", ["text-to-scene", "image-to-scene/indoor"])
def test_tags_make_one_logical_object(setting: str, tags: tuple[list[str], ...], score: float, tmp_path: Path) -> None:
    unreal: Any = boot([], tmp_path)
    empty = export()
    for number, told in enumerate(tags):
        cube = unreal.EditorLevelLibrary.spawn_actor_from_object(
            unreal.load_asset(CUBE), unreal.Vector(30 * number, 0, 50)
        )
        cube.set_editor_property("tags", told)
    verdict = verify_physics(setting, export(), empty)
    assert penetration(verdict)["score"] == score
    notes = {note["code"]: note["actors"] for note in verdict.advisories}
    shared = ["StaticMeshActor_0", "StaticMeshActor_1"] if score else None
    assert notes.get("one_logical_object") == shared


def lit(unreal: Any) -> tuple[Any, Any, Any]:
    """A sun, a volume that grades, and a cube."""
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
    cube = unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset(CUBE), unreal.Vector(0, 0, 50))
    return spawn(unreal.DirectionalLight, unreal.Vector()), spawn(unreal.PostProcessVolume, unreal.Vector()), cube


def turn_source_angle(sun: Any, volume: Any) -> None:
    sun.light_component.set_light_source_angle(9.0)


def grade(sun: Any, volume: Any) -> None:
    settings = volume.get_editor_property("settings")
    settings.override_auto_exposure_bias, settings.auto_exposure_bias = True, 3.0
    settings.override_white_temp, settings.white_temp = True, 4000.0
    volume.set_editor_property("settings", settings)


def dim(sun: Any, volume: Any) -> None:
    sun.light_component.set_intensity(1.0)


@pytest.mark.parametrize(("change", "edits"), [(turn_source_angle, 0), (grade, 0), (dim, 1)])
def test_only_what_is_recorded_counts_as_an_edit(change: Any, edits: int, tmp_path: Path) -> None:
    unreal: Any = boot([], tmp_path)
    sun, volume, cube = lit(unreal)
    truth = export()
    cube.set_actor_location(unreal.Vector(400, 0, 50), False, True)
    start = export()
    change(sun, volume)
    candidate = export()
    assert len(edited_actors(candidate, start)) == edits
    verdict = repair_verdict(start, truth, candidate)
    assert verdict.measurements["fp"] == edits + 1, "the untouched target is one already"
