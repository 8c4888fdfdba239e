"""An engine that is killed from outside in every run of an attempt: pending, on record, and then an outcome."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from c4s.errors import MOST_REPEATS
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run import stages
from c4s.run.drive import Pending, run_trials, stage_functions
from c4s.run.plan import make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.repeats import faults
from tests.run import broken


def test_an_attempt_whose_engine_is_killed_every_time_ends_after_its_repeats(
    home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("C4S_HOME", str(home))
    monkeypatch.setattr(stages, "attempt", broken.attempt)
    suite = SuiteFolder(home / "suites" / "small")
    plan = make_plan(
        suite,
        [Configuration(name="planner", client="planner")],
        run_id="killed",
        policy=DEFAULT_POLICY,
        judge="rule",
        engine="headless",
        cases=["text-flat-family"],
    )
    open_run(tmp_path / "run", plan)
    (trial,) = trials(tmp_path / "run", suite.root, plan)

    async def run() -> list[Pending]:
        async with Pool(1) as pool:
            return await run_trials([trial], plan, pool, stage_functions())

    monkeypatch.setenv("BROKEN", "attempt:planner:text:loses-its-engine")
    for count in range(1, MOST_REPEATS + 1):
        (pending,) = asyncio.run(run())
        assert "SIGKILL" in pending.reason
        assert [record.counted for record in faults(trial.folder)] == [True] * count
        assert not trial.folder.score.exists()
    assert asyncio.run(run()) == []
    outcome = AttemptOutcome.read(trial.folder.attempt(1).outcome)
    assert (outcome.ended_by, outcome.submission) == ("repeats_spent", None)
    assert len(list(trial.folder.root.glob("attempt-1.interrupted-*"))) == MOST_REPEATS
    score = TrialScore.read(trial.folder.score)
    assert AttemptOutcome.read(trial.folder.attempt(2).outcome).ended_by == "finished"
    assert (score.status, score.retained_attempt) == ("measured", 2)
