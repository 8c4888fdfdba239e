"""One changed byte of a suite or of a pack is told before anything is run, and nothing is replaced unasked."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.files import digest_bytes
from c4s.packs.check import check_pack
from c4s.packs.suite_check import suite_changes
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.pack import Pack
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.configurations import configuration
from c4s.run.inputs import inputs
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.trees import digests
from tests.run.conftest import Command
from tests.run.frozen import changed, edited, flipped

TEXT, REPAIR = "text-flat-family", "indoor-flat-01-mirrored-bath"
Change = Callable[[bytes], bytes]


def plan_of(home: Path) -> Plan:
    return make_plan(
        SuiteFolder(home / "suites/small"),
        [configuration("noop")],
        run_id="frozen",
        policy=DEFAULT_POLICY,
        judge="rule",
        engine="headless",
    )


def trials_of(home: Path, plan: Plan) -> list[Trial]:
    return list(trials(home / "runs/frozen", home / "suites/small", plan))


@pytest.fixture(scope="module")
def own(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the home that this module may change."""
    root = tmp_path_factory.mktemp("own")
    for part in ("packs", "suites"):
        shutil.copytree(home / part, root / part)
    return root


@pytest.fixture
def at_home(own: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("C4S_HOME", str(own))
    return own


def _do_nothing(case: dict[str, Any]) -> None:
    case["prompt"] = "Do nothing."


def _lowered(case: dict[str, Any]) -> None:
    case["minimum_actors"] = 1


def _moved(level: dict[str, Any]) -> None:
    level["actors"][0]["transform"]["location_cm"][0] += 100


def _cut(bundle: dict[str, Any]) -> None:
    predicates = next(value for value in bundle["graph"].values() if isinstance(value, list) and len(value) > 2)
    del predicates[2:]


def _unbound(binding: dict[str, Any]) -> None:
    for entity in binding["entities"].values():
        entity["assets"] = []


def _larger(pack: dict[str, Any]) -> None:
    body = next(asset["collision"][0] for asset in pack["assets"] if asset["collision"])
    body["center"][2] += 10


def _untitled(suite: dict[str, Any]) -> None:
    suite["title"] = "Other"


AGENT, WITHHELD = "suites/small/agent/{alias}", f"suites/small/withheld/{REPAIR}"
KINDS: list[tuple[str, str, Change]] = [
    ("suite.json", "suites/small/suite.json", edited(_untitled)),
    ("suite.json, a byte", "suites/small/suite.json", flipped),
    ("case.json, prompt", f"{AGENT}/case.json", edited(_do_nothing)),
    ("case.json, a byte", f"{AGENT}/case.json", flipped),
    ("start level", f"{AGENT}/start.level.json", flipped),
    ("reference picture", f"{AGENT}/references/*.png", flipped),
    ("withheld case.json, minimum_actors", f"{WITHHELD}/case.json", edited(_lowered)),
    ("truth level", f"{WITHHELD}/truth.level.json", edited(_moved)),
    ("truth snapshot", f"{WITHHELD}/truth.snapshot.json", flipped),
    ("input snapshot", f"{WITHHELD}/input.snapshot.json", flipped),
    ("recipe", f"{WITHHELD}/recipe.json", flipped),
    ("cameras", f"{WITHHELD}/cameras.json", flipped),
    ("view of the truth", f"{WITHHELD}/views/truth/*.png", flipped),
    ("requirement bundle", f"suites/small/withheld/{TEXT}/requirements.bundle.json", edited(_cut)),
    ("requirement bundle, a byte", f"suites/small/withheld/{TEXT}/requirements.bundle.json", flipped),
    ("binding", f"suites/small/withheld/{TEXT}/binding.json", edited(_unbound)),
    ("binding, a byte", f"suites/small/withheld/{TEXT}/binding.json", flipped),
    ("prompt of the bundle", f"suites/small/withheld/{TEXT}/prompt.txt", flipped),
    ("pack manifest", "packs/c4s-home/pack.json", flipped),
    ("collision body", "packs/c4s-home/pack.json", edited(_larger)),
    ("blank in the manifest", "packs/c4s-home/pack.json", lambda data: data + b" "),
    ("mesh", "packs/c4s-home/meshes/*.glb", flipped),
    ("texture", "packs/c4s-home/textures/*.png", flipped),
    ("preview", "packs/c4s-home/previews/*.png", flipped),
]
BY_NAME = pytest.mark.parametrize(("kind", "pattern", "change"), KINDS, ids=[kind for kind, *_ in KINDS])


def named(home: Path, pattern: str) -> Path:
    """The first file that a row means."""
    alias = SuiteFolder(home / "suites/small").case(REPAIR).alias
    return sorted(home.glob(pattern.replace("{alias}", alias)))[0]


@BY_NAME
def test_a_changed_file_is_named_before_anything_runs(
    at_home: Path, kind: str, pattern: str, change: Change, request: pytest.FixtureRequest
) -> None:
    plan, path = plan_of(at_home), named(at_home, pattern)
    with changed(path, change):
        with pytest.raises(BadInput) as refused:
            plan_of(at_home)
        told = refused.value.line()
        assert str(path) in told and "(" in told and refused.value.exit_code == 2
        if kind.split(",")[0] != "suite.json":
            with pytest.raises(BadInput) as at_trial:
                for trial in trials_of(at_home, plan):
                    inputs(trial)
            assert str(path) in at_trial.value.line()
    request.node.user_properties.append(("told", told.replace(f"{at_home}/", "")))
    assert plan_of(at_home) == plan, "what was put back is used again"


@BY_NAME
def test_the_full_check_names_it_though_size_and_time_are_the_same(
    at_home: Path, kind: str, pattern: str, change: Change
) -> None:
    path = named(at_home, pattern)
    with changed(path, change):
        try:
            found = {change.file for change in suite_changes(SuiteFolder(at_home / "suites/small"))}
        except BadInput as error:
            found = {Path(error.where)}
        assert found == {path}
    assert suite_changes(SuiteFolder(at_home / "suites/small")) == []


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(pick=st.integers(0, 10**6), place=st.floats(0, 1, exclude_max=True), flip=st.integers(1, 255))
def test_no_byte_of_any_file_is_free(at_home: Path, pick: int, place: float, flip: int) -> None:
    used = [*(at_home / "suites/small").rglob("*"), *(at_home / "packs").rglob("*")]
    files = sorted(path for path in used if path.is_file() and path.name not in ("build.json", "digests.json"))
    path = files[pick % len(files)]

    def change(data: bytes) -> bytes:
        at = int(place * len(data))
        return bytes([*data[:at], data[at] ^ flip, *data[at + 1 :]])

    with changed(path, change), pytest.raises(BadInput) as refused:
        plan_of(at_home)
    assert str(path) in refused.value.line()


def test_missing_extra_and_linked_files_are_told(at_home: Path) -> None:
    suite = SuiteFolder(at_home / "suites/small")
    folder = suite.withheld(REPAIR)
    (folder / "note.txt").write_text("hint")
    shutil.move(folder / "recipe.json", at_home / "recipe.json")
    (folder / "recipe.json").symlink_to(at_home / "recipe.json")
    with pytest.raises(BadInput, match=r"recipe\.json: a link is not allowed"):
        plan_of(at_home)
    assert [change.file.name for change in suite_changes(suite)] == ["recipe.json"]
    (folder / "recipe.json").unlink()
    with pytest.raises(BadInput, match=r"note\.txt: the file was not there when this was frozen; 1 more"):
        plan_of(at_home)
    assert {(change.file.name, change.what) for change in suite_changes(suite)} == {
        ("note.txt", "extra"),
        ("recipe.json", "missing"),
    }
    shutil.move(at_home / "recipe.json", folder / "recipe.json")
    (folder / "note.txt").unlink()
    (folder / "empty").mkdir()
    (folder / "case.json").chmod(0o600)
    assert suite_changes(suite) == [] and plan_of(at_home), "modes and empty folders are not content"
    (folder / "empty").rmdir()


def test_a_note_of_digests_that_was_changed_is_told_and_not_believed(at_home: Path) -> None:
    suite = SuiteFolder(at_home / "suites/small")
    with changed(suite.root / "digests.json", flipped):
        assert {change.file.name for change in suite_changes(suite)} == {"digests.json"}
        assert plan_of(at_home), "the note only tells which file it is"
        alias = suite.case(REPAIR).alias
        with changed(suite.agent(alias) / "case.json", flipped), pytest.raises(BadInput, match=f"agent/{alias}"):
            plan_of(at_home)


def test_the_full_check_trusts_no_digest_that_was_kept(at_home: Path, c4s: Command) -> None:
    """A cache that calls the changed mesh sound misleads nobody who asks for the full check."""
    mesh = sorted(at_home.glob("packs/c4s-home/meshes/*.glb"))[0]
    check_pack(mesh.parents[1])
    right = Pack.read(mesh.parents[1] / "pack.json").files[f"meshes/{mesh.name}"]
    with changed(mesh, flipped):
        stat = mesh.stat()
        for kept in (at_home / "cache/digests").glob("*.json"):
            noted = json.loads(kept.read_text())
            if f"meshes/{mesh.name}" in noted:
                stamp = [stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns, stat.st_ino]
                noted[f"meshes/{mesh.name}"] = [stamp, right]
                kept.write_text(json.dumps(noted))
        done = c4s("suite", "check", "small", "--json", home=at_home)
    told = json.loads(done.stdout)
    assert done.returncode == 2 and [row["file"] for row in told["problems"]] == [str(mesh)]
    assert str(mesh) in done.stderr and len(done.stderr.strip().splitlines()) == 1
    sound = c4s("suite", "check", "small", home=at_home)
    assert sound.returncode == 0 and "as they were frozen" in sound.stdout


def test_a_pack_of_the_same_name_and_other_content_is_not_mixed_in(at_home: Path) -> None:
    plan = plan_of(at_home)
    folder = at_home / "packs/c4s-home"
    pack = Pack.read(folder / "pack.json")
    other = pack.model_copy(update={"title": "Another"})

    def rewritten(data: bytes) -> bytes:
        return (json.dumps(other.plain(), indent=1, ensure_ascii=False) + "\n").encode()

    with changed(folder / "pack.json", rewritten):
        check_pack(folder)
        for use in (lambda: plan_of(at_home), lambda: inputs(trials_of(at_home, plan)[0])):
            with pytest.raises(BadInput, match=r"pack\.json: this pack has digest"):
                use()


def test_a_suite_that_was_built_again_is_not_mixed_into_a_run(at_home: Path, tmp_path: Path) -> None:
    plan = open_run(tmp_path / "run", plan_of(at_home))
    kept = tmp_path / "small"
    shutil.copytree(at_home / "suites/small", kept)
    suite = SuiteFolder(at_home / "suites/small")
    before = suite.suite()
    path = suite.withheld(REPAIR) / "case.json"
    path.write_bytes(edited(_lowered)(path.read_bytes()))
    suite.freeze(before.suite_id, before.title, before.description, before.packs)
    try:
        assert suite_changes(suite) == []
        with pytest.raises(BadInput, match="not the files that were frozen"):
            inputs(next(t for t in trials_of(at_home, plan) if t.case.case_id == REPAIR))
        with pytest.raises(BadInput, match="another content of its suite"):
            open_run(tmp_path / "run", plan_of(at_home))
    finally:
        shutil.rmtree(suite.root)
        os.rename(kept, suite.root)  # noqa: PTH104


def test_the_command_runs_nothing_on_a_suite_that_was_changed(at_home: Path, c4s: Command) -> None:
    meshes = sorted(at_home.glob("packs/c4s-home/meshes/*.glb"))
    for path, change in (
        (named(at_home, f"{AGENT}/case.json"), edited(_do_nothing)),
        (meshes[0], lambda data: meshes[1].read_bytes()),
    ):
        with changed(path, change):
            done = c4s("run", "small", "-a", "noop", home=at_home)
        assert done.returncode == 2 and f"{path}: the file has changed" in done.stderr
        assert len(done.stderr.strip().splitlines()) == 1 and not (at_home / "runs").exists()


def test_a_file_that_changes_at_once_is_read_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    path = tmp_path / "folder/file"
    path.parent.mkdir()
    for number in range(200):
        path.write_bytes(b"%03d" % number)
        os.utime(path, ns=(1, 1))
        assert digests(path.parent) == {"file": digest_bytes(b"%03d" % number)}
