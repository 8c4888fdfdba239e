"""What scripts put into a level can be exported and saved, or is refused at once; what was saved opens again."""

from __future__ import annotations

import importlib
import json
import math
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from c4s.bounds import BOUNDS
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world import documents

SAVED = "/Game/SavedScenes/odd"
NAN, INFINITY = float("nan"), float("inf")


@pytest.fixture
def unreal(tmp_path: Path) -> ModuleType:
    return boot([], tmp_path / "content")


def cube(unreal: ModuleType) -> Any:
    return unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector()
    )


def save(unreal: ModuleType) -> bool:
    """Whether the level was saved. Then it opens again, and is the same."""
    library = unreal.EditorLoadingAndSavingUtils
    told = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    json.dumps(told, allow_nan=False).encode()
    if not library.save_map(unreal.EditorLevelLibrary.get_editor_world(), SAVED):
        return False
    assert library.load_map(SAVED) is not None
    again = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    assert again["actor_count"] == told["actor_count"]
    return True


@pytest.mark.parametrize("number", [NAN, INFINITY, -INFINITY])
def test_places_that_are_none_are_refused(unreal, number):
    box = cube(unreal)
    for move in (
        lambda: box.set_actor_location(unreal.Vector(number, 0, 0), False, False),
        lambda: box.set_actor_scale3d(unreal.Vector(1, number, 1)),
    ):
        with pytest.raises(Exception, match="a transform must be finite numbers"):
            move()
    assert save(unreal)


def test_a_place_beyond_the_world_is_not_saved_and_told(unreal, capfd):
    box = cube(unreal)
    box.set_actor_label("Lost")
    box.set_actor_location(unreal.Vector(1e300, 0, 0), False, False)
    assert not save(unreal)
    assert "'Lost'" in capfd.readouterr().out
    box.set_actor_location(unreal.Vector(), False, False)
    assert save(unreal)


def test_a_place_that_grows_too_large_by_attachment_is_not_saved_and_told(unreal, capfd):
    parent, child, keep = cube(unreal), cube(unreal), unreal.AttachmentRule.KEEP_RELATIVE
    parent.set_actor_scale3d(unreal.Vector(1e9, 1e9, 1e9))
    child.set_actor_label("Far")
    assert child.attach_to_actor(parent, "", keep, keep, keep)
    child.set_actor_relative_location(unreal.Vector(1e9, 0, 0), False, False)
    assert not save(unreal)
    assert "beyond 1e+12" in capfd.readouterr().out


@pytest.mark.parametrize("number", [NAN, INFINITY])
def test_properties_are_finite(unreal, number):
    light = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.PointLight, unreal.Vector()).point_light_component
    with pytest.raises(Exception, match="'Intensity' for attribute 'intensity' on 'PointLightComponent' takes finite"):
        light.set_intensity(number)
    volume = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.PostProcessVolume, unreal.Vector())
    with pytest.raises(Exception, match="take finite numbers"):
        volume.settings.auto_exposure_bias = number
    kept = unreal.PostProcessSettings()
    kept.auto_exposure_bias = number
    with pytest.raises(Exception, match=r"takes? finite numbers"):
        volume.settings = kept
    assert math.isfinite(volume.settings.auto_exposure_bias)
    box = cube(unreal).static_mesh_component
    made = box.create_dynamic_material_instance(0, unreal.load_asset("/Engine/BasicShapes/BasicShapeMaterial"))
    made.set_scalar_parameter_value("Roughness", number)
    made.set_vector_parameter_value("BaseColor", unreal.LinearColor(0, number, 0, 1))
    assert save(unreal)


def test_half_characters_are_no_text(unreal):
    box, half = cube(unreal), "x\ud800"
    for write in (
        lambda: box.set_actor_label(half),
        lambda: box.set_folder_path(half),
        lambda: unreal.Name(half),
        lambda: box.set_editor_property("tags", [half]),
    ):
        with pytest.raises(TypeError, match="Cannot nativize 'str'"):
            write()
    box.set_actor_label("Stühle \N{CHAIR}\0")
    assert save(unreal)


def test_a_chain_is_as_long_as_one_that_opens_again(unreal, capfd):
    keep, top = unreal.AttachmentRule.KEEP_WORLD, cube(unreal)
    last, attached = top, 0
    for _ in range(documents.DEEPEST + 5):
        below = cube(unreal)
        attached += below.attach_to_actor(last, "", keep, keep, keep)
        last = below if below.get_attach_parent_actor() is not None else last
    assert attached == documents.DEEPEST and "more than 100 deep" in capfd.readouterr().out
    assert not top.attach_to_actor(cube(unreal), "", keep, keep, keep), "it would grow at its upper end"
    assert save(unreal)


def test_a_level_that_could_not_be_read_is_not_written(unreal, capfd, monkeypatch):
    for _ in range(4):
        cube(unreal)
    for limit, complaint in (
        ("level_actors", "4 actors, more than 3"),
        ("level_records", "records, more than 3"),
        ("level_bytes", "more than 3"),
        ("level_values", "values, more than 3"),
    ):
        with monkeypatch.context() as small:
            small.setitem(BOUNDS, limit, replace(BOUNDS[limit], most=3))
            assert not save(unreal)
        assert complaint in capfd.readouterr().out
    assert save(unreal)


def test_paths_longer_than_files_are_nothing(unreal):
    path = "/Game/" + "a" * 5000
    assert unreal.load_asset(path) is None and not unreal.EditorAssetLibrary.does_asset_exist(path)
    assert unreal.EditorLoadingAndSavingUtils.load_map(path) is None
