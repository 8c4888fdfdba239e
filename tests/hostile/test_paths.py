"""Names are data: none becomes a path outside of its root, and nothing that exists is removed unasked."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest
import trimesh
from called import call, contents, refused
from hypothesis import given
from hypothesis import strategies as st

from c4s.bundle import read_bundle
from c4s.cli.suites import built_suite
from c4s.errors import BadInput, MachineryFault
from c4s.files import digest_bytes, write_json
from c4s.folders import check_new, check_out, put_folder, remove_tree
from c4s.names import checked_name, file_in, name_fault, package_fault, path_fault, place_in
from c4s.packs.store import PackStore
from c4s.records.pack import Pack
from c4s.records.plan import Configuration, Plan
from c4s.records.suite import AgentCase, Suite
from reports.site import build_site
from tests.cli.test_bad_input import TASK
from warehouse.database import rebuild
from warehouse.frames import export

OUT = [
    "..",
    "../x",
    "a/../../x",
    "/etc/passwd",
    "~/x",
    "C:\\x",
    "..\\x",
    "file:///etc/passwd",
    "a\nb",
    "a\0b",
    "",
    " ",
    "\u202ex",
    "\udcff",
    "x" * 401,
]
Home = Path


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Home:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    for name in ("runs/mine", "suites/mine", "packs/mine"):
        (tmp_path / "home" / name).mkdir(parents=True)
        (tmp_path / "home" / name / "kept").write_text("of the user")
    return tmp_path / "home"


@pytest.mark.parametrize("text", OUT)
def test_what_is_no_name_and_no_path_is_told(text: str) -> None:
    assert name_fault(text) and path_fault(text) and package_fault(f"/Game/{text}/../x")
    for fault in (name_fault(text), path_fault(text)):
        assert fault.isprintable() and fault.isascii()
    with pytest.raises(BadInput):
        checked_name(text, "thing")


@given(st.text(max_size=40))
def test_a_path_that_passes_stays_below_its_root(text: str) -> None:
    if path_fault(text):
        return
    root = Path("/root/of/documents")
    assert Path(os.path.normpath(root / text)).is_relative_to(root)
    if not name_fault(text):
        assert Path(text).name == text and text not in (".", "..")


@pytest.mark.parametrize("name", ["..", "../mine", "a/b", "a\nb", "/tmp", "x" * 121, "-x", "\x1b[31m"])
@pytest.mark.parametrize(
    "command",
    [
        ("suite", "show", "{}"),
        ("suite", "check", "{}"),
        ("suite", "make-cases", "{}"),
        ("suite", "make-cases", "mine", "--id", "{}"),
        ("suite", "import", "code4scene", ".", "--id", "{}"),
        ("suite", "import-scene", "x.csv", "--id", "{}"),
        ("catalog", "show", "{}"),
        ("catalog", "build", ".", "--id", "{}"),
        ("run", "{}"),
        ("agent", "try", "noop", "--case", "x", "--suite", "{}"),
    ],
)
def test_a_name_on_the_command_line_never_leaves_its_root(
    home: Home, capsys: pytest.CaptureFixture[str], command: tuple[str, ...], name: str
) -> None:
    before = contents(home.parent)
    done = call(capsys, *(word.replace("{}", name) for word in command))
    assert done.code == 2 and done.err.count("\n") == 1, done
    assert contents(home.parent) == before


@pytest.mark.parametrize("name", ["..", "../../other", "a/b", "a\nb"])
def test_a_run_id_never_leaves_the_runs(home: Home, name: str) -> None:
    from c4s.cli.evaluation import evaluate_here

    folder = home / "suites/small"
    Suite(suite_id="small", title="", packs=[], cases=[]).write(folder / "suite.json")
    with pytest.raises(BadInput, match=r"run: .* is no name"):
        evaluate_here("small", ["noop"], run_id=name)
    assert sorted(path.name for path in (home / "runs").iterdir()) == ["mine"]


def test_a_suite_under_the_name_of_another_is_refused(home: Home) -> None:
    Suite(suite_id="starter", title="", packs=[], cases=[]).write(home / "suites/other/suite.json")
    with pytest.raises(BadInput, match="calls itself 'starter'"):
        built_suite("other")


@pytest.mark.parametrize("replace", [False, True])
def test_an_import_leaves_folders_and_links_that_it_did_not_make(
    home: Home, tmp_path: Path, capsys: pytest.CaptureFixture[str], replace: bool
) -> None:
    (tmp_path / "tasks/yard").mkdir(parents=True)
    (tmp_path / "tasks/yard/task.yaml").write_text(TASK)
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere/suite.json").write_text("of the user")
    (home / "suites/linked").symlink_to(tmp_path / "elsewhere")
    before = contents(tmp_path)
    for name, why in (("mine", "c4s did not make"), ("linked", "this is a link")):
        options = ["--replace"] if replace else []
        refused(call(capsys, "suite", "import", "code4scene", tmp_path / "tasks", "--id", name, *options), why)
        after = contents(tmp_path)
        assert {key: after.get(key, b"gone") for key in before} == before


def test_only_what_holds_the_marker_is_replaced(tmp_path: Path) -> None:
    for kind, make in {
        "folder": lambda place: (place.mkdir(), (place / "thesis.txt").write_text("x")),
        "file": lambda place: place.write_text("x"),
        "link": lambda place: place.symlink_to(tmp_path / "folder"),
    }.items():
        place, made = tmp_path / kind, tmp_path / f"made-{kind}"
        make(place)
        made.mkdir()
        (made / "pack.json").write_text("{}")
        with pytest.raises(BadInput, match="c4s did not make"):
            put_folder(made, place, marker="pack.json")
        assert place.is_symlink() or place.read_text() == "x" if kind != "folder" else (place / "thesis.txt").is_file()


def test_a_tree_is_removed_below_its_root_and_nowhere_else(tmp_path: Path) -> None:
    for name in ("root/a/b", "other/c"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "root/link").symlink_to(tmp_path / "other")
    (tmp_path / "root/a/out").symlink_to(tmp_path / "other")
    root = tmp_path / "root"
    for wrong in (
        root,
        tmp_path,
        root / "..",
        root / "a/../../other",
        root / "link",
        root / "link/c",
        tmp_path / "other",
    ):
        with pytest.raises(MachineryFault, match="not c4s's to remove"):
            remove_tree(wrong, inside=root)
    remove_tree(root / "a", inside=root)
    remove_tree(root / "none", inside=root)
    assert contents(tmp_path) == {"other": None, "other/c": None, "root": None, "root/link": None}


def test_an_output_file_is_overwritten_only_when_that_is_asked_and_it_is_of_the_kind(
    home: Home, tmp_path: Path
) -> None:
    for name, text in {"a.glb": "glTF..", "thesis.glb": "Dear reader"}.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "folder.glb").mkdir()
    (tmp_path / "link.glb").symlink_to(tmp_path / "a.glb")
    os.mkfifo(tmp_path / "pipe.glb")
    check_out(tmp_path / "new.glb", replace=False, magic=b"glTF")
    check_out(tmp_path / "a.glb", replace=True, magic=b"glTF")
    for name, replace, why in (
        ("a.glb", False, "exists"),
        ("thesis.glb", True, "another kind"),
        ("folder.glb", True, "no plain file"),
        ("link.glb", True, "no plain file"),
        ("pipe.glb", True, "no plain file"),
        ("home/packs/mine/new.glb", True, "c4s keeps"),
        ("home/packs/../runs/new.glb", True, "c4s keeps"),
    ):
        with pytest.raises(BadInput, match=why):
            check_out(tmp_path / name, replace=replace, magic=b"glTF")
    for name in ("a.glb", "home/suites/new", "link.glb", "home/runs/mine"):
        with pytest.raises(BadInput):
            check_new(tmp_path / name)


def test_rows_are_not_written_over_a_file_and_are_no_formulas(home: Home, tmp_path: Path) -> None:
    rebuild(home / "warehouse")
    out = tmp_path / "rows.csv"
    query = "SELECT '=1+1' AS a, '@x' AS b, -1 AS c, 'x=1' AS d"
    assert export(home / "warehouse", query, out) == 1
    assert out.read_text() == "a,b,c,d\n'=1+1,'@x,-1,x=1\n"
    with pytest.raises(BadInput, match="exists"):
        export(home / "warehouse", "SELECT 1 AS a", out)
    export(home / "warehouse", "SELECT 2 AS a", out, replace=True)
    assert out.read_text() == "a\n2\n"


def test_pages_take_the_place_of_pages_alone(home: Home) -> None:
    rebuild(home / "warehouse")
    (home / "site").mkdir()
    (home / "site/index.html").write_text("of the user")
    with pytest.raises(BadInput, match="c4s did not make"):
        build_site(home / "warehouse", home / "site")
    assert contents(home / "site") == {"index.html": b"of the user"}
    (home / "site/index.html").unlink()
    for _ in range(2):
        build_site(home / "warehouse", home / "site")
    assert "No results yet" in (home / "site/index.html").read_text()


Change = Callable[[dict], None]
PACK = {
    "pack_id": "p",
    "content_folder": "P",
    "title": "",
    "license": "",
    "assets": [
        {
            "id": "a",
            "name": "A",
            "path": "/Game/P/A.A",
            "category": "c",
            "bounds_min_cm": [0, 0, 0],
            "bounds_max_cm": [1, 1, 1],
            "mesh": "meshes/a.glb",
        }
    ],
    "materials": [{"path": "/Game/P/M.M", "texture": "textures/t.png"}],
    "files": {"meshes/a.glb": "0" * 64},
}
CASE = {
    "alias": "a",
    "setting": "text-to-scene",
    "prompt": "",
    "start_map": "/Game/A",
    "budget": {"tool_calls": 1, "wall_minutes": 1},
    "packs": [{"pack_id": "p", "digest": "0"}],
    "catalog": [],
    "reference_views": ["references/a.png"],
}
SUITE = {
    "suite_id": "a",
    "title": "",
    "packs": [{"pack_id": "p", "digest": "0"}],
    "cases": [{"case_id": "a", "alias": "b", "setting": "text-to-scene", "agent_digest": "0", "withheld_digest": "0"}],
}
PLAN = {
    "run_id": "a",
    "suite_id": "s",
    "suite_digest": "0",
    "configurations": [{"name": "a", "client": "noop"}],
    "cases": [
        {
            **{"case_id": "a", "alias": "b", "setting": "text-to-scene", "scene_id": "s"},
            **{"agent_digest": "0", "withheld_digest": "0"},
        }
    ],
    "policy": "p",
    "judge": "rule",
    "engine": "headless",
    "versions": {},
}
FIELDS = [
    *(
        (Pack, PACK, field)
        for field in ("pack_id", "content_folder", "assets.0.id", "assets.0.mesh", "assets.0.preview")
    ),
    *((Pack, PACK, field) for field in ("assets.0.path", "materials.0.path", "materials.0.texture", "files")),
    *((AgentCase, CASE, field) for field in ("alias", "start_map", "packs.0.pack_id", "reference_views.0")),
    *((Suite, SUITE, field) for field in ("suite_id", "cases.0.case_id", "cases.0.alias", "packs.0.pack_id")),
    *((Plan, PLAN, field) for field in ("run_id", "suite_id", "cases.0.case_id", "cases.0.alias", "cases.0.scene_id")),
    *((Plan, PLAN, field) for field in ("configurations.0.name", "configurations.0.client")),
    (Configuration, PLAN["configurations"][0], "name"),
]


@pytest.mark.parametrize(("kind", "sound", "field"), FIELDS, ids=lambda value: value if isinstance(value, str) else "")
def test_every_name_and_path_of_a_document_is_checked(kind: type, sound: dict, field: str) -> None:
    kind.parse(sound)
    for text in (*OUT, "../../../../pwned"):
        value = json.loads(json.dumps(sound))
        place, *_, last = value, *field.split(".")
        for key in field.split(".")[:-1]:
            place = place[int(key)] if key.isdigit() else place[key]
        given_text = f"/Game/{text}" if last in ("path", "start_map") else text
        if given_text in (
            "/Game/",
            "/Game/ ",
            "/Game/~/x",
            "/Game//etc/passwd",
            "/Game/C:\\x",
            "/Game/file:///etc/passwd",
        ):
            continue
        place[int(last) if last.isdigit() else last] = {text: "0" * 64} if last == "files" else given_text
        with pytest.raises(BadInput):
            kind.parse(value, where="x")


def test_a_pack_whose_file_is_a_link_out_is_not_read(tmp_path: Path) -> None:
    (tmp_path / "secret.glb").write_bytes(trimesh.creation.box().export(file_type="glb"))
    (tmp_path / "pack/meshes").mkdir(parents=True)
    (tmp_path / "pack/meshes/a.glb").symlink_to(tmp_path / "secret.glb")
    write_json(tmp_path / "pack/pack.json", PACK)
    store = PackStore([tmp_path / "pack"])
    for read in (store.mesh, store.mesh_file):
        with pytest.raises(BadInput, match="link out"):
            read("/Game/P/A.A")


def test_files_of_a_document_stay_in_its_folder(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "in/up").symlink_to(tmp_path)
    (tmp_path / "in/round").symlink_to(tmp_path / "in")
    assert file_in(tmp_path / "in", "round/x") == tmp_path / "in/round/x"
    for text in (*OUT, "up/x", "up"):
        with pytest.raises(BadInput):
            file_in(tmp_path / "in", text)
    with pytest.raises(BadInput, match="link"):
        place_in(tmp_path / "in", "up", "pack")


@pytest.mark.parametrize("path", ["../secret.json", "/etc/passwd", "up/secret.json", "a\nb"])
def test_a_bundle_reads_its_own_files_alone(tmp_path: Path, path: str) -> None:
    (tmp_path / "bundle").mkdir()
    (tmp_path / "bundle/up").symlink_to(tmp_path)
    (tmp_path / "secret.json").write_text("{}")
    manifest = {
        "schema_version": "code4scene.bundle.v1",
        "task": {"id": "x", "setting": "text-to-scene"},
        "run": {"submission": "missing"},
        "files": {path: digest_bytes(b"{}")},
    }
    write_json(tmp_path / "bundle/bundle.json", manifest)
    with pytest.raises(BadInput):
        read_bundle(tmp_path / "bundle")
