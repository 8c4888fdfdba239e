"""Pictures of levels with copied meshes, and of copies whose original is gone."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.engine.headless.pictures import take
from c4s.engine.headless.process.boot import boot
from c4s.errors import BadInput

CUBE = "/Engine/BasicShapes/Cube"
VIEW = {"location_cm": [-300, 0, 50], "rotation_deg": [0, 0, 0], "fov_deg": 90, "width": 32, "height": 24}


def shown(folder: Path) -> dict[str, int]:
    """Pixels of each actor."""
    return take.take([VIEW], [str(folder / "view.png")], "base_color", False)[0]["visible"]


def test_a_copied_mesh_is_drawn_and_counted(tmp_path):
    unreal = boot([], tmp_path / "content")
    copy = unreal.EditorAssetLibrary.duplicate_asset(CUBE, "/Game/Made/SM_Copy")
    unreal.EditorLevelLibrary.spawn_actor_from_object(copy, unreal.Vector(0, 0, 50))
    assert shown(tmp_path) == {"StaticMeshActor_0": shown(tmp_path)["StaticMeshActor_0"]}
    subsystem = unreal.get_editor_subsystem(unreal.StaticMeshEditorSubsystem)
    assert copy.get_num_triangles(0) == unreal.load_asset(CUBE).get_num_triangles(0) > 0
    assert subsystem.get_number_verts(copy, 0) > 0

    assert unreal.EditorAssetLibrary.save_asset("/Game/Made/SM_Copy")
    world = unreal.EditorLevelLibrary.get_editor_world()
    assert unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/Made/Yard")
    boot([], tmp_path / "content", start_map="/Game/Made/Yard")
    assert list(shown(tmp_path)) == ["StaticMeshActor_0"]


@pytest.mark.parametrize("parent", ["StaticMesh'/Game/Gone/SM_A.SM_A'", "/Game/Made/SM_Copy.SM_Copy", ""])
def test_a_copy_of_itself_or_of_what_is_no_path_is_refused(tmp_path, parent):
    unreal = boot([], tmp_path / "content")
    unreal.EditorAssetLibrary.duplicate_asset(CUBE, "/Game/Made/SM_Copy")
    unreal.EditorAssetLibrary.save_asset("/Game/Made/SM_Copy")
    document = tmp_path / "content" / "Game" / "Made" / "SM_Copy.asset.json"
    document.write_text(document.read_text().replace("/Engine/BasicShapes/Cube.Cube", parent))
    again = boot([], tmp_path / "content")
    with pytest.raises(BadInput, match="cannot be what it copies"):
        again.load_asset("/Game/Made/SM_Copy")


def test_a_copy_of_a_mesh_that_no_pack_holds_shows_nothing(tmp_path):
    unreal = boot([], tmp_path / "content")
    copy = unreal.EditorAssetLibrary.duplicate_asset(CUBE, "/Game/Made/SM_Copy")
    unreal.EditorLevelLibrary.spawn_actor_from_object(copy, unreal.Vector(0, 0, 50))
    unreal.EditorAssetLibrary.save_asset("/Game/Made/SM_Copy")
    unreal.EditorLoadingAndSavingUtils.save_map(unreal.EditorLevelLibrary.get_editor_world(), "/Game/Made/Yard")
    document = tmp_path / "content" / "Game" / "Made" / "SM_Copy.asset.json"
    document.write_text(document.read_text().replace("/Engine/BasicShapes/Cube.Cube", "/Game/Gone/SM_A.SM_A"))
    again = boot([], tmp_path / "content", start_map="/Game/Made/Yard")
    assert shown(tmp_path) == {}
    assert again.load_asset("/Game/Made/SM_Copy").get_num_triangles(0) == 0
    assert (
        again.get_editor_subsystem(again.StaticMeshEditorSubsystem).get_number_verts(
            again.load_asset("/Game/Made/SM_Copy"), 0
        )
        == 0
    )
