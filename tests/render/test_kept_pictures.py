"""A picture's key changes with all that the picture shows, and pictures of one key are taken once."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.evidence import export_and_look
from c4s.evidence.kept import KeptPicture, drop_oldest, keep_picture, kept_picture
from c4s.files import read_json, write_json
from c4s.home import cache_root

CAMERA = {
    "name": "front",
    "location_cm": [-400.0, 0.0, 100.0],
    "rotation_deg": [-10.0, 0.0, 0.0],
    "fov_deg": 60.0,
    "width": 64,
    "height": 36,
}


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

    def take(name: str) -> tuple[dict[str, Any], bytes]:
        out = tmp_path / "evidence" / name
        export_and_look(
            engine="headless",
            packs=[],
            submission_content=tmp_path / "content",
            package=f"/Game/Kept/{name}",
            out=out,
            cameras=[CAMERA],
        )
        view = read_json(out / "captures" / "captures.json")["views"][0]
        assert (out / "captures" / view["actors"]).is_file()
        return view, (out / "captures" / view["file"]).read_bytes()

    rendered, picture = take("Room")
    kept = cache_root() / "pictures"
    files = sorted(kept.iterdir())
    assert [file.suffix for file in files] == [".json", ".npz", ".png"] and files[2].read_bytes() == picture
    written = [file.stat().st_ino for file in files]
    assert take("Same") == (rendered, picture)
    assert [file.stat().st_ino for file in sorted(kept.iterdir())] == written, "taken from there, not rendered"
    moved, other = take("Moved")
    assert other != picture and moved["visible"] != rendered["visible"]
    shutil.rmtree(kept)
    assert take("Same") == (rendered, picture)


MADE = KeptPicture(b"picture" * 100, b"mask" * 100, {"Cube": 7})


def _home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    return cache_root() / "pictures"


@pytest.mark.parametrize("suffix", [".png", ".npz", ".json"])
@pytest.mark.parametrize("damage", [b"", b"other", b"[1]", b'{"visible": {}}', None])
def test_a_damaged_file_is_as_if_nothing_were_kept(
    suffix: str, damage: bytes | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = _home(tmp_path, monkeypatch)
    assert kept_picture("a") is None
    keep_picture("a", MADE)
    assert kept_picture("a") == MADE
    file = kept / f"a{suffix}"
    if damage is None:
        file.unlink()
    else:
        file.write_bytes(damage)
    assert kept_picture("a") is None
    keep_picture("a", MADE)
    assert kept_picture("a") == MADE


def test_a_note_with_another_count_is_as_if_nothing_were_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = _home(tmp_path, monkeypatch)
    keep_picture("a", MADE)
    note = read_json(kept / "a.json")
    write_json(kept / "a.json", note | {"visible": {"Cube": 8}})
    assert kept_picture("a") is None


def test_the_least_recently_used_are_dropped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = _home(tmp_path, monkeypatch)
    drop_oldest()
    for number, key in enumerate("abcd"):
        keep_picture(key, MADE)
        for file in kept.glob(f"{key}.*"):
            os.utime(file, (number, number))
    (kept / ".e.png.abcdefgh").write_bytes(b"being written")
    size = sum(file.stat().st_size for file in kept.glob("a.*"))
    drop_oldest(4 * size)
    assert all(kept_picture(key) for key in "dcba"), "all fit, and reading is use"
    os.utime(kept / "a.json", (3, 3))
    os.utime(kept / "c.json", (4, 4))
    drop_oldest(2 * size)
    assert [key for key in "abcd" if kept_picture(key)] == ["b", "d"]
    drop_oldest(0)
    assert [file.name for file in kept.iterdir()] == [".e.png.abcdefgh"]


def test_what_cannot_be_written_is_not_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = _home(tmp_path, monkeypatch)
    kept.parent.mkdir(parents=True)
    kept.write_bytes(b"no folder")
    keep_picture("a", MADE)
    drop_oldest()
    assert kept_picture("a") is None
