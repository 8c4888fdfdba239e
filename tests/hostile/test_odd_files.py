"""Folders that a person gives hold pipes, links, sockets and odd names: one line or a note, never a wait."""

from __future__ import annotations

import json
import os
import shutil
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
import trimesh
from called import Done, call, refused

from c4s.bundle import read_bundle
from c4s.errors import BadInput
from c4s.files import digest_bytes, digest_file, open_plain, read_json, read_plain_text, write_json
from c4s.run.configurations import configuration
from catalog.ingest.folder import ingest
from catalog.ingest.source import read_source
from tests.cli.test_bad_input import TASK

SECRET = b"root:x:0:0:the secret of this machine\n"


@pytest.fixture
def odd(tmp_path: Path) -> Iterator[dict[str, Path]]:
    """One of each thing that is no plain file."""
    kinds = {name: tmp_path / "odd" / name for name in ("pipe", "socket", "folder", "device", "nothing", "loop")}
    (tmp_path / "odd").mkdir()
    os.mkfifo(kinds["pipe"])
    kinds["folder"].mkdir()
    kinds["device"].symlink_to("/dev/zero")
    kinds["nothing"].symlink_to(tmp_path / "odd/none")
    kinds["loop"].symlink_to(kinds["loop"])
    short = Path(f"/tmp/c4s-odd-{os.getpid()}")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(short))
        shutil.move(short, kinds["socket"])
        yield kinds


def test_only_plain_files_are_opened(odd: dict[str, Path]) -> None:
    for path in odd.values():
        for read in (open_plain, digest_file, read_json, read_plain_text):
            with pytest.raises(BadInput) as caught:
                read(path)
            assert path.name in caught.value.line()
    with pytest.raises(BadInput):
        open_plain(Path("a\0b"))


def put(place: Path, thing: Path) -> None:
    """The odd thing at this place, by another name of the same thing."""
    place.parent.mkdir(parents=True, exist_ok=True)
    place.unlink(missing_ok=True)
    if thing.is_symlink() or thing.is_dir():
        place.symlink_to(thing)
    else:
        os.link(thing, place)


KINDS = ("pipe", "socket", "folder", "device", "nothing")


@pytest.mark.parametrize("kind", KINDS)
def test_every_command_that_reads_a_file(
    odd: dict[str, Path], kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))

    def at(name: str) -> Path:
        put(tmp_path / "given" / name, odd[kind])
        return tmp_path / "given" / name

    bundle = at("bundle/bundle.json").parent
    run = at("run/plan.json").parent
    at("tasks/yard/task.yaml")
    for arguments in (
        ("verify", "physics", "--snapshot", at("scene.json")),
        ("verify", "repair", "--input", at("a.json"), "--truth", at("b.json"), "--candidate", at("c.json")),
        ("verify", "support", "--batch", at("rows.jsonl")),
        ("score", "--batch", at("rows.jsonl")),
        ("score", run),
        ("score", run, "--policy", at("policy.yaml")),
        ("bundle", "score", bundle),
        ("bundle", "pack", run, "noop", "x", tmp_path / "new"),
        ("engine", "export", at("level.json"), "--glb", tmp_path / "new.glb"),
        ("sql", at("query.sql")),
        ("suite", "import", "code4scene", tmp_path / "given/tasks", "--id", "yard"),
        ("suite", "import-scene", at("scene.csv"), "--id", "yard"),
        ("suite", "import-scene", at("scene.sdf"), "--id", "yard"),
        ("suite", "import-scene", at("scene.glb"), "--id", "yard"),
        ("catalog", "build", at("files/crate.glb").parent, "--id", "yard"),
        ("agent", "replay", run),
    ):
        refused(call(capsys, *arguments))
    with pytest.raises(BadInput):
        configuration(str(at("agent.yaml")))


def test_a_folder_of_meshes_with_everything_in_it(odd: dict[str, Path], tmp_path: Path) -> None:
    folder, outside = tmp_path / "meshes", tmp_path / "outside.glb"
    folder.mkdir()
    outside.write_bytes(trimesh.creation.box().export(file_type="glb"))
    shutil.copy(outside, folder / "crate.glb")
    shutil.copy(outside, folder / "Crate.GLB")
    shutil.copy(outside, os.fsencode(folder) + b"/caf\xe9.glb")
    shutil.copy(outside, folder / "two\nlines.glb")
    shutil.copy(outside, folder / "\x1b[31mred.glb")
    shutil.copy(outside, folder / "\u202ebacklog.glb")
    (folder / "linked.glb").symlink_to(outside)
    (tmp_path / "secret").write_bytes(SECRET)
    (folder / "LICENSE.txt").symlink_to(tmp_path / "secret")
    (folder / "listing.csv").symlink_to(tmp_path / "secret")
    for name in ("pipe", "socket", "device", "nothing"):
        put(folder / f"{name}.glb", odd[name])
        put(folder / f"{name}.csv", odd[name])
        put(folder / f"licence-{name}.txt", odd[name])
        put(folder / f"source.{name}", odd[name])
    report = ingest(folder, "odd", tmp_path / "packs")
    assert report["assets"] == 2 and report["license"] == "unknown"
    reasons = {row["reason"] for row in report["skipped"]}
    assert reasons == {
        "its name is no text",
        "it is a link out of the folder",
        "it is a link to nothing",
        "it is no plain file",
    }
    assert len(report["skipped"]) == 4 + 1 + 4
    assert json.dumps(report, ensure_ascii=False).isprintable()
    made = b"".join(path.read_bytes() for path in (tmp_path / "packs").rglob("*") if path.is_file())
    assert SECRET.strip() not in made
    assert ingest(folder, "odd", tmp_path / "packs")["cached"]


OUTSIDE = (
    "/etc/passwd",
    "../../secret",
    "file:///etc/passwd",
    "..\\..\\secret",
    "a\0b",
    "x" * 5000,
    "\u202ex",
    "..",
    "/",
)


@pytest.mark.parametrize("name", OUTSIDE)
def test_meshes_that_refer_to_files_outside(tmp_path: Path, name: str) -> None:
    folder = tmp_path / "a/b"
    folder.mkdir(parents=True)
    (tmp_path / "secret").write_bytes(SECRET)
    buffer = {"asset": {"version": "2.0"}, "buffers": [{"uri": name, "byteLength": 4}]}
    buffer |= {"bufferViews": [{"buffer": 0, "byteLength": 4}]}
    buffer |= {"accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}]}
    buffer |= {"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]}
    buffer |= {"scenes": [{"nodes": [0]}], "scene": 0}
    (folder / "crate.gltf").write_text(json.dumps(buffer))
    with pytest.raises(BadInput, match="missing"):
        read_source(folder / "crate.gltf", folder)
    cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nf 1/1 2/1 3/1\nf 1/1 2/1 4/1\nusemtl m\nf 2/1 3/1 4/1\n"
    plain = name.replace("\0", " ")
    (folder / "cube.obj").write_text(f"mtllib {plain}\n{cube}")
    read_source(folder / "cube.obj", folder)
    (folder / "cube.mtl").write_text(f"newmtl m\nmap_Kd {plain}\n")
    (folder / "textured.obj").write_text(f"mtllib cube.mtl\n{cube}")
    assert all(part.surface.texture is None for part in read_source(folder / "textured.obj", folder).parts)


@pytest.mark.parametrize("asset", ["/etc/passwd", "../secret.glb", "up/secret.glb", "file:///etc/passwd", "..", ""])
def test_a_table_places_its_own_files_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], asset: str
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    (tmp_path / "scene").mkdir()
    (tmp_path / "scene/up").symlink_to(tmp_path)
    (tmp_path / "secret.glb").write_bytes(trimesh.creation.box().export(file_type="glb"))
    (tmp_path / "scene/table.csv").write_text(f"actor,asset,x,y,z,roll,pitch,yaw\na,{asset},0,0,0,0,0,0\n")
    refused(call(capsys, "suite", "import-scene", tmp_path / "scene/table.csv", "--id", "yard"), "can be placed")
    assert not (tmp_path / "home/packs").exists() or not any((tmp_path / "home/packs").iterdir())


@pytest.mark.parametrize("uri", ["file:///etc/passwd", "model://../../secret", "/etc/passwd", "../secret.dae"])
def test_a_world_reads_its_own_files_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], uri: str
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    (tmp_path / "scene").mkdir()
    (tmp_path / "secret.dae").write_bytes(SECRET)
    mesh = f"<geometry><mesh><uri>{uri}</uri></mesh></geometry>"
    (tmp_path / "scene/a.world").write_text(
        "<sdf version='1.6'><world name='w'><model name='m'><link name='l'>"
        f"<visual name='v'>{mesh}</visual></link></model></world></sdf>"
    )
    refused(call(capsys, "suite", "import-scene", tmp_path / "scene/a.world", "--id", "yard"), "is missing")


BUNDLE = "verifiers:\n- name: semantic_requirements\n  verification_bundle: {}\n"


@pytest.mark.parametrize("name", ["/etc/passwd", "../secret.json", "up/secret.json", "7", "[a]", '"a\\nb"', '"\\0"'])
def test_a_task_brings_its_own_requirements_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    (tmp_path / "tasks/yard").mkdir(parents=True)
    (tmp_path / "tasks/yard/up").symlink_to(tmp_path)
    (tmp_path / "tasks/secret.json").write_bytes(SECRET)
    (tmp_path / "secret.json").write_bytes(SECRET)
    (tmp_path / "tasks/yard/task.yaml").write_text(TASK + BUNDLE.format(name))
    refused(call(capsys, "suite", "import", "code4scene", tmp_path / "tasks", "--id", "yard"))
    assert not (tmp_path / "home/suites/yard").exists()


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("id: yard", "id: '../../pwned'"),
        ("id: yard", 'id: "a\\nb"'),
        ("id: yard", f"id: {'x' * 200}"),
        ("- box |", "- ../../../../pwned |"),
        ("/Game/P/SM_Box.SM_Box", "/Game/../../SM_Box.SM_Box"),
        ("init_map: /Game/Blank", "init_map: /Game/../../etc/passwd"),
        ("kind: scene_generation", "kind: scene_generation\nassets:\n  packs: ['../../pwned']"),
        ("kind: scene_generation", "kind: scene_generation\nassets:\n  packs: 7"),
        ("kind: scene_generation", "kind: scene_generation\nassets: [1]"),
    ],
)
def test_a_task_names_nothing_outside(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], before: str, after: str
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    (tmp_path / "tasks/yard").mkdir(parents=True)
    assert before in TASK
    (tmp_path / "tasks/yard/task.yaml").write_text(TASK.replace(before, after))
    done: Done = call(capsys, "suite", "import", "code4scene", tmp_path / "tasks", "--id", "yard")
    refused(done, "task.yaml")
    assert not list(tmp_path.rglob("*pwned*")) and not (tmp_path / "home/suites/yard").exists()


def test_tasks_that_differ_in_letter_case_are_one_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    for name in ("yard", "Yard"):
        (tmp_path / "tasks" / name).mkdir(parents=True)
        (tmp_path / "tasks" / name / "task.yaml").write_text(TASK.replace("id: yard", f"id: {name}"))
    refused(call(capsys, "suite", "import", "code4scene", tmp_path / "tasks"), "occurs twice")


@pytest.mark.parametrize("kind", KINDS)
def test_a_bundle_of_odd_files(odd: dict[str, Path], tmp_path: Path, kind: str) -> None:
    put(tmp_path / "bundle/a.json", odd[kind])
    manifest = {
        "schema_version": "code4scene.bundle.v1",
        "task": {"id": "x", "setting": "text-to-scene"},
        "run": {"submission": "missing"},
        "files": {"a.json": digest_bytes(b"{}")},
    }
    write_json(tmp_path / "bundle/bundle.json", manifest)
    with pytest.raises(BadInput):
        read_bundle(tmp_path / "bundle")


@pytest.mark.parametrize("name", [b"caf\xe9", b"a\nb", b"\x1b[31m"])
def test_a_folder_whose_own_name_is_no_text(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], name: bytes
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    folder = Path(os.fsdecode(os.fsencode(tmp_path) + b"/" + name))
    folder.mkdir()
    (folder / "task.yaml").write_text(TASK)
    (folder / "crate.glb").write_bytes(trimesh.creation.box().export(file_type="glb"))
    (tmp_path / "crate").mkdir()
    scene = Path(os.fsdecode(os.fsencode(tmp_path / "crate") + b"/" + name + b".glb"))
    shutil.copy(folder / "crate.glb", scene)
    refused(call(capsys, "catalog", "build", folder, "--id", "yard"), "is no text")
    refused(call(capsys, "suite", "import", "code4scene", folder, "--id", "yard"), "is no text")
    refused(call(capsys, "suite", "import-scene", scene, "--id", "yard"), "is no text")
