"""What is hidden is in no picture, and the snapshot says so beside the published fields."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.pictures import take
from c4s.engine.headless.process.boot import boot
from c4s.semantics.inventory import inventory

CUBE = "/Engine/BasicShapes/Cube"
VIEW = {"location_cm": [-300, 0, 50], "rotation_deg": [0, 0, 0], "fov_deg": 90, "width": 32, "height": 24}


def actor_hidden_in_game(unreal: Any, cube: Any) -> None:
    cube.set_actor_hidden_in_game(True)


def mesh_hidden_in_game(unreal: Any, cube: Any) -> None:
    cube.static_mesh_component.set_hidden_in_game(True)


def mesh_invisible(unreal: Any, cube: Any) -> None:
    cube.static_mesh_component.set_visibility(False)


def hidden_in_editor(unreal: Any, cube: Any) -> None:
    cube.set_is_temporarily_hidden_in_editor(True)


def nothing(unreal: Any, cube: Any) -> None:
    cube.root_component.set_visibility(True)


@pytest.mark.parametrize(
    ("hide", "hidden", "visible", "in_editor"),
    [
        (nothing, False, True, False),
        (actor_hidden_in_game, True, True, False),
        (mesh_hidden_in_game, True, False, False),
        (mesh_invisible, True, False, False),
        (hidden_in_editor, False, True, True),
    ],
)
def test_what_is_hidden_is_told_and_not_drawn(
    hide: Any, hidden: bool, visible: bool, in_editor: bool, tmp_path: Path
) -> None:
    unreal: Any = boot([], tmp_path / "content")
    cube = unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset(CUBE), unreal.Vector(0, 0, 50))
    hide(unreal, cube)
    snapshot = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    (actor,) = snapshot["actors"]
    assert actor["c4s"]["hidden"] is hidden and actor["c4s"]["components"][0]["visible"] is visible
    assert actor["export_diagnostics"]["hidden_in_editor"] is in_editor and "hidden" not in actor
    drawn = take.take([VIEW], [str(tmp_path / "view.png")], "base_color", False)[0]["visible"]
    assert bool(drawn) == (not hidden and not in_editor)
    assert len(inventory(snapshot, {})) == (not hidden and not in_editor)


def test_an_actor_is_shown_as_long_as_one_of_its_meshes_is(tmp_path: Path) -> None:
    unreal: Any = boot([], tmp_path)
    cube = unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset(CUBE), unreal.Vector(0, 0, 50))
    subsystem = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    root = subsystem.k2_gather_subobject_data_for_instance(cube)[0]
    added, _ = subsystem.add_new_subobject(
        unreal.AddNewSubobjectParams(parent_handle=root, new_class=unreal.StaticMeshComponent)
    )
    library = unreal.SubobjectDataBlueprintFunctionLibrary
    library.get_object(library.get_data(added)).set_static_mesh(unreal.load_asset(CUBE))
    cube.static_mesh_component.set_visibility(False)
    snapshot = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    assert snapshot["actors"][0]["c4s"]["hidden"] is False
    assert len(inventory(snapshot, {})) == 1
