"""Machines that share an object store: a real S3-compatible server, and homes that share nothing else."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytest import MonkeyPatch

from c4s.engine import DEFAULT_ENGINE
from c4s.errors import BadInput, MachineryFault
from c4s.judge.names import DEFAULT_JUDGE
from c4s.meter.spending import Ledger
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.suite import SuiteFolder
from c4s.run.check import freeze_submission
from c4s.run.configurations import configuration
from c4s.run.guards import Watchman, set_guards
from c4s.run.lease import Held, LeaseLost, take
from c4s.run.plan import make_plan, open_run
from c4s.run.sharing import Sharing
from c4s.run.store import Store, open_store, send_suite, share_suite, shared_plan
from c4s.run.store.opening import _object_store
from c4s.trees import digest_tree
from tests.run.conftest import Command, command_in, environment, trial_in
from tests.run.servers import object_store
from warehouse.database import rows

CASE = "indoor-flat-01-mirrored-bath"
TAKE = """
import sys
from pathlib import Path
from c4s.home import home
from c4s.meter.spending import Ledger
from c4s.records.folder import RunFolder
from c4s.run.guards import Watchman, set_guards
from c4s.run.lease import Held, take
from c4s.run.store import open_store
place = open_store().leases(home() / "runs/raced/lease")
print("ready", flush=True)
sys.stdin.readline()
print("held" if isinstance(take(place, "run"), Held) else "told", flush=True)
sys.stdin.readline()
"""


@pytest.fixture(scope="module")
def settings() -> Iterator[dict[str, str]]:
    with object_store() as found:
        yield found


@pytest.fixture
def machine(settings: dict[str, str], tmp_path: Path, monkeypatch: MonkeyPatch) -> Callable[[str], Store]:
    """The store as a machine with a home of its own reaches it."""

    def at(name: str) -> Store:
        for key, value in {**settings, "C4S_HOME": str(tmp_path / name)}.items():
            monkeypatch.setenv(key, value)
        (tmp_path / name).mkdir(exist_ok=True)
        _object_store.cache_clear()
        return open_store()

    return at


def test_a_folder_comes_over_whole_and_what_was_not_sent_is_set_aside(
    machine: Callable[[str], Store], tmp_path: Path
) -> None:
    here = tmp_path / "one/runs/x/trial"
    (here / "attempt-1").mkdir(parents=True)
    (here / "attempt-1/outcome.json").write_text("{}")
    (here / "large").write_bytes(os.urandom(6 << 20))
    machine("one").push(here)
    there = tmp_path / "two/runs/x/trial"
    (there / "attempt-1").mkdir(parents=True)
    (there / "attempt-1/outcome.json").write_text("of a stage that was cut off")
    (there / "attempt-1/left").write_text("left")
    store = machine("two")
    assert store.pull(there)
    assert (there / "attempt-1/outcome.json").read_text() == "{}"
    assert (there / "large").read_bytes() == (here / "large").read_bytes()
    assert [path.name for path in sorted((there / "attempt-1").iterdir())] == ["outcome.json"]
    assert (tmp_path / "two/runs/x/trial.unsent-1/attempt-1/left").read_text() == "left"
    (there / "large").unlink()
    store.push(there)
    machine("one").pull(here)
    assert not (here / "large").exists()
    assert not machine("one").pull(tmp_path / "one/runs/x/never")


def test_a_submission_comes_over_whatever_its_files_are_called(machine: Callable[[str], Store], tmp_path: Path) -> None:
    names = ("L.level.json", "lease/House.level.json", "deep/lease/House.level.json", ".hidden", ".d/.L.json.a1b2c3d4")
    here = TrialFolder(tmp_path / "one/runs/named/trial")
    attempt = here.attempt(1)
    beside_it = ("lease/000001.json", ".score.json.a1b2c3d4", ".evidence.a1b2c3d4/index.json")
    for path in (*(attempt.submission / name for name in names), *(here.root / name for name in beside_it)):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(path.name)
    frozen = freeze_submission(attempt)
    machine("one").push(here.root)
    there = TrialFolder(tmp_path / "two/runs/named/trial")
    assert machine("two").pull(there.root)
    assert digest_tree(there.attempt(1).submission) == frozen
    assert sorted(path.name for path in there.root.iterdir()) == ["attempt-1"]
    left = there.attempt(1).submission / ".L.level.json.d4c3b2a1"
    left.write_text("a fetch was cut off")
    assert machine("two").pull(there.root) and not left.exists()
    assert digest_tree(there.attempt(1).submission) == frozen


def test_a_byte_that_was_changed_in_the_store_is_refused(machine: Callable[[str], Store], tmp_path: Path) -> None:
    here = tmp_path / "one/runs/y/trial"
    here.mkdir(parents=True)
    (here / "score.json").write_text('{"score": 1}')
    machine("one").push(here)
    store = machine("two")
    blob = next(key for key in store._fs.find("c4s/bench/blobs") if store._fs.cat_file(key) == b'{"score": 1}')  # type: ignore[attr-defined]
    store._fs.pipe_file(blob, b'{"score": 2}')  # type: ignore[attr-defined]
    with pytest.raises(MachineryFault, match="other bytes"):
        store.pull(tmp_path / "two/runs/y/trial")


def test_of_many_takers_of_a_lease_one_holds_it(settings: dict[str, str], tmp_path: Path) -> None:
    takers = [
        subprocess.Popen(
            [sys.executable, "-c", TAKE],
            env={**os.environ, **settings, "C4S_HOME": str(tmp_path)},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for _ in range(4)
    ]
    try:
        for taker in takers:
            assert taker.stdout and taker.stdout.readline() == "ready\n"
        for taker in takers:
            assert taker.stdin
            taker.stdin.write("\n")
            taker.stdin.flush()
        said = [taker.stdout.readline().strip() for taker in takers if taker.stdout]
        assert sorted(said) == ["held", "told", "told", "told"]
    finally:
        for taker in takers:
            taker.kill()
            taker.communicate()


def test_a_holder_finds_out_that_its_lease_in_the_store_was_removed(
    machine: Callable[[str], Store], tmp_path: Path
) -> None:
    place = machine("one").leases(tmp_path / "one/runs/z/lease")
    held = take(place, "run")
    assert isinstance(held, Held)
    held.check()
    held.beat()
    assert place.sign(1) is not None
    place.remove(1)
    with pytest.raises(LeaseLost, match="the lease was removed"):
        held.check()
    held.give_back()
    again = take(place, "run")
    assert isinstance(again, Held)
    again.give_back()


@pytest.mark.parametrize(
    ("url", "kind"), [("nosuch://x", BadInput), ("s3://", BadInput), ("s3://no-such-bucket/x", MachineryFault)]
)
def test_what_is_no_store_is_refused(
    machine: Callable[[str], Store], monkeypatch: MonkeyPatch, url: str, kind: type[Exception]
) -> None:
    machine("one")
    monkeypatch.setenv("C4S_STORE", url)
    with pytest.raises(kind):
        open_store().leases(Path(os.environ["C4S_HOME"]) / "runs/r/lease").newest()


@pytest.mark.parametrize(
    "url",
    [
        *("nosuch://someone:pa55@host/x", "s3://someone:pa55@c4s/bench", "ftp://someone:pa55@127.0.0.1:9/x"),
        *("s3://someone:pa55@", "simplecache::ftp://someone:pa55/@127.0.0.1:9/x"),
    ],
)
def test_no_password_of_a_store_is_told(machine: Callable[[str], Store], monkeypatch: MonkeyPatch, url: str) -> None:
    machine("one")
    monkeypatch.setenv("C4S_STORE", url)
    with pytest.raises((BadInput, MachineryFault)) as refused:
        open_store().leases(Path(os.environ["C4S_HOME"]) / "runs/r/lease").newest()
    told = "".join(traceback.format_exception(refused.value))
    assert "pa55" not in told and "someone" not in told


def test_two_machines_share_a_run_through_the_store(
    home: Path, settings: dict[str, str], tmp_path: Path, monkeypatch: MonkeyPatch
) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    for own in (first, second):
        own.mkdir()
    for name in ("packs", "suites", "cache"):
        (home / "cache").mkdir(exist_ok=True)
        (first / name).symlink_to(home / name)
    for key, value in settings.items():
        monkeypatch.setenv(key, value)
    run: Command = command_in(first)
    one = run("run", "small", "-a", "noop", "-c", CASE, "--json", home=first)
    assert one.returncode == 0, one.stderr
    assert json.loads(one.stdout)["ran"] == 1
    two = run("run", "small", "-a", "noop", "-a", "oracle", "-c", CASE, "--json", home=second)
    assert two.returncode == 0, two.stderr
    assert json.loads(two.stdout)["ran"] == 1 and json.loads(two.stdout)["reused"] == {"small": 1}
    three = run("run", "small", "-a", "noop", "-a", "oracle", "-c", CASE, "--json", home=first)
    assert three.returncode == 0 and json.loads(three.stdout)["ran"] == 0, three.stderr
    question = "SELECT configuration, score, run_id FROM outcomes ORDER BY configuration"
    assert rows(first / "warehouse", question) == rows(second / "warehouse", question)
    seen = run("watch", "small", "--json", home=tmp_path / "third")
    assert seen.returncode == 0, seen.stderr
    told = json.loads(seen.stdout)
    assert (told["state"], told["planned"], told["done"]) == ("done", 2, 2)
    scored = trial_in(second, "small", "oracle", CASE)
    assert not trial_in(first, "small", "oracle", CASE).attempt(1).submission.exists()
    assert scored.score.read_bytes() == trial_in(first, "small", "oracle", CASE).score.read_bytes()


def test_a_machine_with_an_older_suite_works_on_no_run_of_the_newer_and_sends_nothing(
    home: Path, machine: Callable[[str], Store], tmp_path: Path
) -> None:
    def store_has() -> set[tuple[str, str]]:
        return {(key, info["ETag"]) for key, info in open_store()._fs.find("c4s/bench/suites", detail=True).items()}  # type: ignore[attr-defined]

    for name in ("newer", "older"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "packs").symlink_to(home / "packs")
        shutil.copytree(home / "suites", tmp_path / name / "suites")
    machine("newer")
    suite, run = SuiteFolder(tmp_path / "newer/suites/small"), tmp_path / "newer/runs/planned"
    send_suite("small")
    plan = make_plan(
        suite,
        [configuration("noop")],
        run_id="planned",
        policy=DEFAULT_POLICY,
        judge=DEFAULT_JUDGE,
        engine=DEFAULT_ENGINE,
    )
    open_run(run, plan)
    open_store().push_files(run / "plan.json")
    sent = store_has()
    machine("older")
    older = SuiteFolder(tmp_path / "older/suites/small")
    older.suite().model_copy(update={"title": "Older"}).write(older.record)
    with pytest.raises(BadInput, match="another suite than the run 'planned' was planned with"):
        shared_plan("planned")
    older.root.rename(tmp_path / "moved-away")
    assert shared_plan("planned") == (tmp_path / "older/runs/planned", plan)
    assert digest_tree(older.root) == digest_tree(suite.root) and store_has() == sent
    older.record.unlink()
    (older.root / "digests.json").unlink()
    share_suite("small")
    assert digest_tree(older.root) == digest_tree(suite.root), "a fetch that was cut off goes on"


def test_what_other_machines_spend_counts_against_the_limit_of_all(
    machine: Callable[[str], Store], tmp_path: Path
) -> None:
    def at(name: str) -> tuple[RunFolder, Sharing, Ledger]:
        machine(name)
        run = RunFolder(tmp_path / name / "runs/spent")
        return run, Sharing(run, run.journals / "none.jsonl"), Ledger(run.spending, 1.0, run.elsewhere)

    def spend(ledger: Ledger, usd: float) -> None:
        entry = ledger.hold(usd)
        assert entry is not None
        ledger.settle(entry, usd)

    for name, usd in (("one", 0.5), ("two", 0.3)):
        _, sharing, ledger = at(name)
        spend(ledger, usd)
        sharing.exchange()
    run, sharing, ledger = at("one")
    assert ledger.spent().total_usd == pytest.approx(0.5)
    sharing.exchange()
    assert ledger.spent().total_usd == pytest.approx(0.8)
    set_guards(run, spend_usd=1.0)
    assert Watchman(run).look() == (False, None)
    two, sharing, ledger = at("two")
    spend(ledger, 0.2)
    sharing.exchange()
    assert ledger.hold(0.01) is None
    _, sharing, ledger = at("one")
    sharing.exchange()
    assert ledger.hold(0.01) is None
    paused, stopped = Watchman(run).look()
    assert not paused and stopped is not None and stopped.guard == "spending" and "1.0000 of 1.0000" in stopped.what
    (mine,) = two.elsewhere.iterdir()
    assert [path.name for path in mine.iterdir()] == ["spending.jsonl"] and not (run.elsewhere / mine.name).exists()


def test_a_store_that_is_gone_ends_a_command_in_one_line(home: Path, tmp_path: Path) -> None:
    settings = environment(home) | {
        "C4S_STORE": "s3://c4s/bench",
        "AWS_ENDPOINT_URL_S3": "http://127.0.0.1:9",
        "AWS_ACCESS_KEY_ID": "key",
        "AWS_SECRET_ACCESS_KEY": "secret",
    }
    told = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop"],
        env=settings,
        capture_output=True,
        text=True,
        check=False,
    )
    assert told.returncode == 3 and told.stderr.count("\n") == 1 and "the store" in told.stderr, told.stderr
