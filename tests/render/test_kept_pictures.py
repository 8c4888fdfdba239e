"""A picture's key changes with all that the picture shows, and pictures of one key are taken once."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.evidence import export_and_look
from c4s.files import read_json
from c4s.home import cache_root

CAMERA = {
    "name": "front",
    "location_cm": [-400.0, 0.0, 100.0],
    "rotation_deg": [-10.0, 0.0, 0.0],
    "fov_deg": 60.0,
    "width": 64,
    "height": 36,
}
SAVED = "/Game/Kept/Room"


def _room(unreal: Any) -> tuple[Any, Any, Any]:
    """A cube with a material of its own, a ball and a sun."""
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_object
    cube = spawn(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(0, 0, 50))
    ball = spawn(unreal.load_asset("/Engine/BasicShapes/Sphere"), unreal.Vector(0, 200, 50))
    sun = unreal.EditorLevelLibrary.spawn_actor_from_class(
        unreal.DirectionalLight, unreal.Vector(0, 0, 500), unreal.Rotator(pitch=-50.0)
    )
    return cube, ball, sun


def test_a_key_stands_for_all_that_a_picture_shows(tmp_path: Path) -> None:
    unreal = boot([], tmp_path / "content")
    from c4s.engine.headless.pictures.keys import picture_keys

    def key(mode: str = "lit", **camera: Any) -> str:
        return picture_keys([{**CAMERA, **camera}], mode)[0]

    cube, ball, sun = _room(unreal)
    red = cube.static_mesh_component.create_dynamic_material_instance(0)
    first = key()
    assert key() == first and key(name="other") == first
    other_cameras = [
        key("base_color"),
        key(fov_deg=61.0),
        key(width=65),
        key(location_cm=[-401.0, 0.0, 100.0]),
        key(rotation_deg=[-10.0, 0.0, 1.0]),
        key(exposure_bias_ev=1.0),
    ]
    seen = [first, *other_cameras]
    for edit in (
        lambda: red.set_vector_parameter_value("BaseColor", unreal.LinearColor(1, 0, 0, 1)),
        lambda: cube.set_actor_location(unreal.Vector(0, 0, 50.001), False, False),
        lambda: cube.set_actor_scale3d(unreal.Vector(1, 1, -1)),
        lambda: sun.light_component.set_intensity(3.0),
        lambda: sun.set_actor_rotation(unreal.Rotator(pitch=-40.0), False),
        lambda: ball.set_actor_label("Round"),
        lambda: unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.ExponentialHeightFog, unreal.Vector()),
        lambda: ball.static_mesh_component.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cone")),
        lambda: ball.set_is_temporarily_hidden_in_editor(True),
    ):
        edit()
        seen.append(key())
    assert len(set(seen)) == len(seen)
    before = key()
    ball.tags = ["nothing to see"]
    assert key() == before


def test_a_scene_that_looks_the_same_takes_the_kept_picture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    unreal = boot([], tmp_path / "content")
    cube, _, _ = _room(unreal)
    saving = unreal.EditorLoadingAndSavingUtils
    world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    for name in ("Room", "Same", "Moved"):
        if name == "Moved":
            cube.set_actor_location(unreal.Vector(0, 10, 50), False, False)
        assert saving.save_map(world, f"/Game/Kept/{name}")

    def take(name: str, keep: bool = False) -> tuple[dict[str, Any], bytes]:
        out = tmp_path / "evidence" / name
        export_and_look(
            engine="headless",
            packs=[],
            submission_content=tmp_path / "content",
            package=f"/Game/Kept/{name}",
            out=out,
            cameras=[CAMERA],
            keep_pictures=keep,
        )
        view = read_json(out / "captures" / "captures.json")["views"][0]
        assert (out / "captures" / view["actors"]).is_file()
        return view, (out / "captures" / view["file"]).read_bytes()

    rendered, picture = take("Room")
    kept = cache_root() / "pictures"
    assert not kept.exists(), "only a suite's own scenes are kept"
    assert take("Room", keep=True) == (rendered, picture)
    files = sorted(kept.iterdir())
    assert [file.suffix for file in files] == [".json", ".npz", ".png"] and files[2].read_bytes() == picture
    assert take("Same") == (rendered, picture)
    files[2].write_bytes(b"kept")
    assert take("Same") == (rendered, b"kept")
    moved, other = take("Moved")
    assert other not in (picture, b"kept") and moved["visible"] != rendered["visible"]
    shutil.rmtree(kept)
    assert take("Same") == (rendered, picture)
