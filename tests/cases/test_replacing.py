"""Nothing that is built is replaced without being asked by name, and never by halves."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest
import trimesh

from c4s.cli.suites import built_suite
from c4s.errors import BadInput
from c4s.folders import put_folder
from c4s.packs.suite_check import suite_changes
from c4s.records.suite import SuiteFolder
from cases.importers.importing import import_scene
from cases.importers.scene import imported_scene
from cases.suite import build_suite
from catalog.build import ensure_pack
from tests.cases.test_case_suite import paddock_home, small
from tests.cli.test_bad_input import TASK
from tests.run.conftest import command_in
from tests.run.frozen import flipped


def quiet(line: str) -> None:
    """No progress."""


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return paddock_home(tmp_path_factory)


@pytest.fixture
def at_home(built: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("C4S_HOME", str(built))
    return built


def times(folder: Path) -> dict[str, int]:
    return {str(path): path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}


def test_a_sound_suite_is_kept_and_another_is_refused_or_replaced(at_home: Path, tmp_path: Path) -> None:
    root, packs = at_home / "suites/small", at_home / "packs"
    before = times(root)
    for replace in (False, True):
        build_suite(small(), root, packs, quiet, replace=replace)
    other = dataclasses.replace(small(), title="Other")
    with pytest.raises(BadInput, match=r"another suite of this name lies here \(give --replace"):
        build_suite(other, root, packs, quiet)
    assert times(root) == before
    shutil.copytree(root, tmp_path / "small")
    changed = tmp_path / "small/withheld/paddock-cow/case.json"
    changed.write_bytes(changed.read_bytes().replace(b'"minimum_actors": 3', b'"minimum_actors": 1'))
    with pytest.raises(BadInput, match=r"paddock-cow/case\.json: the file has changed .*--replace"):
        build_suite(small(), tmp_path / "small", packs, quiet)
    build_suite(small(), tmp_path / "small", packs, quiet, replace=True)
    assert suite_changes(SuiteFolder(tmp_path / "small")) == []
    assert sorted(path.name for path in tmp_path.iterdir()) == ["small"]


def test_a_folder_that_is_no_suite_is_never_replaced(at_home: Path, tmp_path: Path) -> None:
    (tmp_path / "scene").mkdir()
    (tmp_path / "scene/scene.level.json").write_text("{}")
    with pytest.raises(BadInput, match="c4s did not make"):
        build_suite(small(), tmp_path / "scene", at_home / "packs", quiet, replace=True)
    assert (tmp_path / "scene/scene.level.json").read_text() == "{}"


def test_a_suite_is_not_built_of_a_pack_that_was_changed(at_home: Path, tmp_path: Path) -> None:
    shutil.copytree(at_home / "packs", tmp_path / "packs")
    meshes = sorted((tmp_path / "packs/c4s-farm/meshes").glob("*.glb"))
    shutil.copyfile(meshes[1], meshes[0])
    with pytest.raises(BadInput, match=f"{meshes[0].name}: the file has changed"):
        build_suite(small(), tmp_path / "suite", tmp_path / "packs", quiet)
    with pytest.raises(BadInput, match=rf"{meshes[0].name}: .*--replace"):
        ensure_pack("c4s-farm", tmp_path / "packs")
    ensure_pack("c4s-farm", tmp_path / "packs", replace=True)
    before = times(tmp_path / "packs")
    ensure_pack("c4s-farm", tmp_path / "packs")
    assert times(tmp_path / "packs") == before


def test_sources_that_build_the_same_pack_leave_it(at_home: Path, tmp_path: Path) -> None:
    shutil.copytree(at_home / "packs", tmp_path / "packs")
    stamp = tmp_path / "packs/c4s-farm/build.json"
    stamp.write_text(json.dumps({"sources": "of another version"}))
    before = times(tmp_path / "packs/c4s-farm")
    ensure_pack("c4s-farm", tmp_path / "packs")
    after = times(tmp_path / "packs/c4s-farm")
    assert {path for path in after if after[path] != before[path]} == {str(stamp)}


OTHER = """
import dataclasses, fnmatch, os, signal, sys
from pathlib import Path
from cases.suite import build_suite
from tests.cases.test_case_suite import small
home, fatal = Path({home!r}), {fatal!r}

def dies(event, arguments):
    if fatal and event == fatal[0] and any(fnmatch.fnmatch(str(argument), fatal[1]) for argument in arguments):
        os.killpg(0, signal.SIGKILL)

sys.addaudithook(dies)
build_suite(
    dataclasses.replace(small(), title="Other"), home / "suites/small", home / "packs", lambda line: None, replace=True
)
"""


@pytest.mark.parametrize(
    ("event", "path", "title"),
    [
        ("os.mkdir", "suite", "Small"),
        ("open", "suite/agent/*/case.json", "Small"),
        ("os.rename", "suite/build.json", "Small"),
        ("shutil.rmtree", "suite", "Other"),
    ],
)
def test_a_killed_build_leaves_a_whole_suite(
    built: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, event: str, path: str, title: str
) -> None:
    for part in ("packs", "suites", "cache"):
        shutil.copytree(built / part, tmp_path / part)
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    suite = SuiteFolder(tmp_path / "suites/small")
    killed, whole = (
        [sys.executable, "-c", OTHER.format(home=str(tmp_path), fatal=fatal)]
        for fatal in ((event, f"{tmp_path}/suites/.small.*/{path}"), None)
    )
    assert subprocess.run(killed, start_new_session=True, timeout=200).returncode == -signal.SIGKILL
    assert suite.suite().title == title and suite_changes(suite) == []
    subprocess.run(whole, check=True, timeout=200)
    assert suite.suite().title == "Other" and suite_changes(suite) == []


def test_a_place_is_never_empty_while_folders_change_places(tmp_path: Path) -> None:
    place, done = tmp_path / "place", threading.Event()
    place.mkdir()

    def swap() -> None:
        for number in range(300):
            made = tmp_path / f"made-{number}"
            made.mkdir()
            (made / "file").write_text(str(number))
            put_folder(made, place, marker="file")
        done.set()

    worker = threading.Thread(target=swap)
    worker.start()
    seen = []
    while not done.is_set():
        seen.append(place.is_dir())
    worker.join()
    assert all(seen) and (place / "file").read_text() == "299" and os.listdir(tmp_path) == ["place"]  # noqa: PTH208


def c4s(home: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return command_in(home)(*arguments, timeout=100)


def test_imported_tasks_and_their_packs(built: Path, tmp_path: Path) -> None:
    task, home = tmp_path / "tasks/yard/task.yaml", tmp_path / "home"
    shutil.copytree(built / "cache", home / "cache")
    task.parent.mkdir(parents=True)
    task.write_text(TASK)
    command = ("suite", "import", "code4scene", str(task.parent), "--id", "yard")
    assert c4s(home, *command).returncode == 0
    before = times(home / "suites") | times(home / "packs")
    again = c4s(home, *command)
    assert again.returncode == 0 and times(home / "suites") | times(home / "packs") == before, again.stderr
    for old, new in (("tool_calls: 10", "tool_calls: 20"), ("1x1x1 m", "2x1x1 m")):
        task.write_text(TASK.replace(old, new))
        refused = c4s(home, *command)
        assert refused.returncode == 2 and "--replace" in refused.stderr, refused.stderr
        assert len(refused.stderr.strip().splitlines()) == 1
        assert times(home / "suites") | times(home / "packs") == before
    assert c4s(home, *command, "--replace").returncode == 0
    checked = c4s(home, "suite", "check", "yard", "--json")
    assert checked.returncode == 0 and json.loads(checked.stdout)["problems"] == []
    mesh = next(home.glob("packs/proxy-*/meshes/box.glb"))
    mesh.write_bytes(mesh.read_bytes() + b" ")
    changed = c4s(home, *command)
    assert changed.returncode == 2 and str(mesh) in changed.stderr and "--replace" in changed.stderr
    assert c4s(home, *command, "--replace").returncode == c4s(home, "suite", "check", "yard").returncode == 0


TABLE = "actor,asset,x,y,z,roll,pitch,yaw\na,box.obj,0,0,0,0,0,0\nb,box.obj,4,0,0,0,0,0\n"


def test_imported_scenes_and_their_packs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    trimesh.creation.box((1, 1, 1)).export(tmp_path / "box.obj")
    table = tmp_path / "yard.csv"
    suites, packs = tmp_path / "suites", tmp_path / "packs"
    table.write_text(TABLE)
    import_scene(table, "yard", suites=suites, packs=packs)
    level = imported_scene(suites, packs, "yard")
    with pytest.raises(BadInput, match=r"'yard' is an imported scene and no suite .*make-cases yard"):
        built_suite("yard")
    import_scene(table, "yard", suites=suites, packs=packs)
    table.write_text(TABLE.replace("4,0", "5,0"))
    with pytest.raises(BadInput, match="--replace"):
        import_scene(table, "yard", suites=suites, packs=packs)
    assert imported_scene(suites, packs, "yard") == level
    import_scene(table, "yard", suites=suites, packs=packs, replace=True)
    assert imported_scene(suites, packs, "yard") != level
    for path in (suites / "yard/scene.level.json", sorted((packs / "yard/meshes").iterdir())[0]):
        data = path.read_bytes()
        path.write_bytes(data.replace(b"500.0", b"501.0") if path.suffix == ".json" else flipped(data))
        with pytest.raises(BadInput, match=f"{path.name}: the file has changed"):
            imported_scene(suites, packs, "yard")
        path.write_bytes(data)
