"""``c4s engine python``: a script on a level, what it printed, what it changed, and how it ended."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from c4s.records.level import Level
from tests.cli.warm import Done, Warm

BUILD = """
import unreal
cube = unreal.load_asset("/Engine/BasicShapes/Cube")
for number in range(3):
    actor = unreal.EditorLevelLibrary.spawn_actor_from_object(cube, unreal.Vector(300 * number, 0, 50))
    actor.set_actor_label(f"Crate_{number}")
print("built 3")
"""
CHANGE = """
import unreal
actors = {a.get_actor_label(): a for a in unreal.EditorLevelLibrary.get_all_level_actors()}
actors["Crate_0"].destroy_actor()
actors["Crate_1"].set_actor_location(unreal.Vector(300, 0, 80), False, False)
actors["Crate_1"].tags.append("moved")
actors["Crate_2"].set_actor_label("Box")
actors["Crate_2"].set_actor_enable_collision(False)
made = unreal.AssetToolsHelpers.get_asset_tools().create_asset(
    "M_Made", "/Game/Made", unreal.Material, unreal.MaterialFactoryNew()
)
actors["Crate_2"].static_mesh_component.set_material(0, made)
"""


@pytest.fixture
def c4s(warm: Warm, world: Path, tmp_path: Path):
    """Calls ``c4s engine python`` on a script of the given source."""

    def call(source: str, *arguments: object) -> Done:
        script = tmp_path / "script.py"
        script.write_text(source)
        said = ["engine", "python", str(script), *map(str, arguments)]
        return warm.call(said, cwd=tmp_path, environment={"C4S_HOME": str(world / "home")})

    return call


def test_what_a_script_builds_is_told_saved_and_drawn(c4s, tmp_path):
    out, shot = tmp_path / "Yard.level.json", tmp_path / "yard.png"
    done = c4s(BUILD, "--case", "yard", "--suite", "yard", "--save", out, "--picture", shot)
    assert done.code == 0, done.err
    assert "built 3" in done.out and "3 added" in done.out and "+ Crate_2" in done.out
    labels = {actor.label for actor in Level.read(out).actors}
    assert {"Crate_0", "Crate_1", "Crate_2"} <= labels
    assert Image.open(shot).size == (1280, 720)


def test_what_a_script_changes_is_told_with_what(c4s, tmp_path):
    level = tmp_path / "Before.level.json"
    assert c4s(BUILD, "--save", level).code == 0
    done = c4s(CHANGE, "--level", level, "--save", tmp_path / "After.level.json", "--json")
    assert done.code == 0, done.err
    told = json.loads(done.out)
    assert told["status"] == "ok" and told["level"] == "/Game/SavedScenes/Before"
    found = told["found"]
    assert [row["label"] for row in found["removed"]] == ["Crate_0"] and found["added"] == []
    what = {row["label"]: row["what"] for row in found["changed"]}
    assert set(what["Crate_1"]) == {"location_cm", "tags"}
    assert what["Crate_1"]["location_cm"] == [[300, 0, 50], [300, 0, 80]]
    assert what["Box"]["label"] == ["Crate_2", "Box"]
    assert what["Box"]["collision StaticMeshComponent0"][1] is None
    assert [told["left_out"], "not kept" in done.err] == [["/Game/Made/M_Made.M_Made"], True]


@pytest.mark.parametrize(
    ("source", "status", "says"),
    [
        ("print('first')\n1 / 0", "error", "ZeroDivisionError"),
        ("import unreal\nunreal.NoSuchThing()", "error", "NoSuchThing"),
        ("print('first'", "error", "SyntaxError"),
        ("raise SystemExit('no')", "error", "no"),
        ("import os\nos._exit(7)", "died", "exit code 7"),
    ],
)
def test_a_script_that_fails_ends_with_1(c4s, source, status, says):
    done = c4s(source, "--json")
    told = json.loads(done.out)
    assert (done.code, told["status"]) == (1, status) and says in told["error"]
    assert c4s(source).code == 1


def test_what_a_failed_script_had_done_is_told_and_kept(c4s, tmp_path):
    out = tmp_path / "Half.level.json"
    done = c4s(f"{BUILD}\nraise ValueError('half way')", "--save", out)
    assert done.code == 1 and "half way" in done.err and "3 added" in done.out
    assert len(Level.read(out).actors) == 3


def test_a_script_reads_no_more_than_an_agents(c4s, world):
    done = c4s(f"print(open({str(world / 'home/suites/yard/suite.json')!r}).read())")
    assert done.code == 1 and ("Error" in done.err)


FORGE = """
from c4s.editor import scene_tools
save = scene_tools.save_scene
scene_tools.save_scene = lambda *given, **named: {**save(*given, **named), "package": PACKAGE}
"""


@pytest.mark.parametrize("package", ["/{up}{folder}/Hidden", "/Game/./SavedScenes/Out", "/Game/SavedScenes/Other"])
def test_a_script_that_forges_the_saved_package_has_no_other_file_copied(c4s, tmp_path, package):
    hidden, out = tmp_path / "Hidden.level.json", tmp_path / "Out.level.json"
    assert c4s(BUILD, "--save", hidden).code == 0
    forged = package.format(up="../" * 20, folder=str(tmp_path)[1:])
    done = c4s(FORGE.replace("PACKAGE", repr(forged)), "--save", out)
    assert done.code == 1 and not out.exists(), done.out
    assert "not an answer" in done.err or "another package" in done.err, done.err


def test_a_script_may_come_from_standard_input(world, tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "engine", "python", "-", "--json"],
        input=BUILD,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "C4S_HOME": str(world / "home")},
        capture_output=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0 and len(json.loads(done.stdout)["found"]["added"]) == 3
