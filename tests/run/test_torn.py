"""What is torn in a run folder is set aside and made again; what can not be made again is named with what to do."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from c4s.files import digest_file
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from tests.run.conftest import Command, apart, trial_in
from tests.run.frozen import changed, edited, flipped
from tests.run.handed_on import baselines_home, hand_on
from warehouse.database import rows

MIRRORED, LIVING = "indoor-flat-01-mirrored-bath", "indoor-flat-02-living-room"
RUN = ("run", "small", "-a", "noop", "-c", MIRRORED, "-c", LIVING)
TIMES = {"evaluation_s", "orchestration_s", "attempt_wall_s", "wall_s"}
Change = Callable[[bytes], bytes]
Again = Callable[..., str]


@pytest.fixture(scope="module")
def ran(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home with a run of two trials."""
    own = apart(tmp_path_factory.mktemp("torn") / "home", home)
    hand_on(baselines_home(tmp_path_factory), own, ["noop"], [MIRRORED, LIVING])
    return own


@pytest.fixture
def again(ran: Path, c4s: Command) -> Again:
    """Runs the same command again; what it told. The rows are those of before, but for what a clock says."""

    def run(code: int = 0) -> str:
        before = stored(ran)
        done = c4s(*RUN, home=ran)
        assert done.returncode == code, done.stderr
        assert stored(ran) == before
        return done.stderr

    return run


def stored(home: Path) -> dict[str, list[tuple[Any, ...]]]:
    """All rows of a home, without times."""
    return {
        table: sorted(
            tuple(str(value) for name, value in row.items() if name not in TIMES)
            for row in rows(home / "warehouse", f"SELECT * FROM {table}")
        )
        for table in ("outcomes", "verdicts", "attempts", "components", "schedule")
    }


def halved(data: bytes) -> bytes:
    return data[: len(data) // 2]


def garbage(data: bytes) -> bytes:
    return b"\x00\xff" * 20


def raised(value: dict[str, Any]) -> None:
    value["score"] = 0.9


def spoil(folder: Path, pattern: str, change: Change) -> str:
    """Change a file of a trial for good; the name under which it is set aside."""
    path = sorted(folder.glob(pattern))[0]
    path.write_bytes(change(path.read_bytes()))
    return f"{path.name}.torn-{digest_file(path)[:12]}"


@pytest.mark.parametrize(
    "spoilt",
    [
        [("attempt-1/integrity.json", lambda data: b""), ("verdicts/physics.json", halved)],
        [("score.json", edited(raised)), ("verdicts/repair.json", edited(raised))],
        [("verdicts/integrity.json", garbage), ("stages.jsonl", lambda data: data + b'{"stage": "atte')],
    ],
    ids=["gate and verdict", "edited score and verdict", "verdict of the gate and times"],
)
def test_what_can_be_made_again_is_set_aside_and_made_again(
    ran: Path, again: Again, spoilt: list[tuple[str, Change]]
) -> None:
    folders = [trial_in(ran, "small", "noop", case).root for case in (MIRRORED, LIVING)]
    kept = [spoil(folder, *one) for folder, one in zip(folders, spoilt, strict=True)]
    if spoilt[1][0] == "stages.jsonl":
        (folders[1] / "score.json").unlink()
    told = again()
    assert all(name in told and list((ran / "runs").rglob(name)) for name in kept), told
    assert not list((ran / "runs").rglob("*.interrupted-*"))


def test_torn_evidence_is_taken_again_and_a_torn_outcome_repeats_its_attempt(ran: Path, again: Again) -> None:
    folders = [trial_in(ran, "small", "noop", case).root for case in (MIRRORED, LIVING)]
    spoil(folders[0], "evidence/captures/*.png", halved)
    (folders[0] / "score.json").unlink()
    name = spoil(folders[1], "attempt-1/outcome.json", halved)
    before = digest_file(folders[0] / "attempt-1/outcome.json")
    told = again()
    assert "evidence.torn-" in told and len(list(folders[0].glob("evidence.torn-*"))) == 1
    assert digest_file(folders[0] / "attempt-1/outcome.json") == before
    assert (folders[1] / "attempt-1.interrupted-1" / name).is_file()
    assert len(list((ran / "runs").rglob("*.interrupted-*"))) == 1


def test_what_an_agent_did_is_named_with_what_to_do_and_the_others_go_on(ran: Path, again: Again) -> None:
    folder, other = (trial_in(ran, "small", "noop", case).root for case in (MIRRORED, LIVING))
    outcome, trajectory = folder / "attempt-1/outcome.json", folder / "attempt-1/trajectory.jsonl"
    shutil.rmtree(other)
    with changed(outcome, edited(lambda value: value.update(tool_calls=0))):
        told = again(2)
    assert str(outcome) in told and f"move {folder} away: the same command then runs this trial anew" in told
    assert (other / "score.json").is_file()
    (folder / "score.json").unlink()
    with changed(folder / "attempt-1/submission/saves.jsonl", flipped):
        assert "saves.jsonl" in again(2)
    trajectory.write_bytes(b"{\n" + trajectory.read_bytes())
    told = again(2)
    assert str(trajectory) in told and f"move {folder} away" in told
    shutil.rmtree(folder)
    again()


def test_an_edited_score_is_believed_by_nobody(ran: Path, c4s: Command) -> None:
    path = trial_in(ran, "small", "noop", LIVING).score
    before = stored(ran)
    with changed(path, edited(raised)):
        told = c4s("report", "--from-runs", home=ran)
        assert told.returncode == 2 and str(path) in told.stderr and "is left out" in told.stderr
        assert stored(ran) == before
        shutil.rmtree(ran / "warehouse")
        assert c4s("report", home=ran).returncode == 2
        assert len(stored(ran)["outcomes"]) == len(before["outcomes"]) - 1
    assert c4s("report", home=ran).returncode == 0 and stored(ran) == before


@pytest.mark.parametrize("command", [RUN, ("report",)], ids=["run", "report"])
def test_a_warehouse_that_was_lost_or_cut_off_is_filled_again(
    ran: Path, c4s: Command, command: tuple[str, ...]
) -> None:
    before, store = stored(ran), ran / "warehouse"
    for part in sorted(store.glob("*/*/*/*.parquet"))[::3]:
        part.write_bytes(halved(part.read_bytes()))
    (store / "c4s.duckdb").write_bytes(b"no database")
    done = c4s(*command, home=ran)
    assert done.returncode == 0, done.stderr
    assert stored(ran) == before
    shutil.rmtree(store)
    done = c4s(*command, home=ran)
    assert done.returncode == 0, done.stderr
    assert stored(ran) == before


def test_nothing_is_made_when_all_is_done(ran: Path, c4s: Command) -> None:
    before = {path: path.stat().st_mtime_ns for path in (ran / "runs").rglob("*.json") if "lease" not in path.parts}
    done = c4s(*RUN, "--json", home=ran)
    assert json.loads(done.stdout)["ran"] == 0 and json.loads(done.stdout)["reused"] == {"small": 2}
    assert all(path.stat().st_mtime_ns == time for path, time in before.items())


def test_a_run_grows_by_an_agent_and_keeps_the_plan_before(ran: Path, c4s: Command) -> None:
    path, agent = ran / "runs/small/plan.json", ran / "agent.yaml"
    before = Plan.read(path)
    agent.write_text("{name: idle, client: noop}\n")
    for arguments, told in (
        ((*RUN[:2], "-a", str(agent), "-c", LIVING), "trials that nobody asked for (1), such as idle/indoor-flat-01"),
        ((*RUN, "--policy", "repair-only"), "another policy"),
    ):
        refused = c4s(*arguments, home=ran)
        assert refused.returncode == 2 and told in refused.stderr and refused.stderr.count("\n") == 1
        assert Plan.read(path) == before
    done = c4s(*RUN, "-a", str(agent), home=ran)
    assert done.returncode == 0, done.stderr
    assert "2 trials run" in done.stdout and "2 trials are done and reused" in done.stdout
    assert [chosen.name for chosen in Plan.read(path).configurations] == ["noop", "idle"]
    assert Plan.read(ran / f"runs/small/plans/{before.sha256()[:12]}.json") == before
    assert TrialScore.read(trial_in(ran, "small", "idle", LIVING).score).status == "measured"
    agent.write_text("{name: idle, client: planner}\n")
    refused = c4s(*RUN, "-a", str(agent), home=ran)
    assert refused.returncode == 2 and "another configuration 'idle'" in refused.stderr
    assert refused.stderr.count("\n") == 1
