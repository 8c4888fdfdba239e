"""A holder of a trial that is stopped for long, as a suspended machine is, and then goes on: it harms nobody's work."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from bench.waiting import until
from c4s.records.folder import TrialFolder
from c4s.records.handover import Handover
from tests.run.conftest import apart, environment, trial_in

CASE = "indoor-flat-01-mirrored-bath"
WORKER = """
import asyncio, sys
import c4s.run.lease as lease, c4s.run.trial_work as trial_work
lease.LASTS_S, lease.BEAT_S, lease.WAIT_S, trial_work.BEAT_S, trial_work.WAIT_S = 2.0, 0.2, 0.1, 0.2, 0.1
from c4s.home import runs_root
from c4s.records.suite import SuiteFolder
from c4s.run.configurations import configuration
from c4s.run.drive import run_trials, stage_functions
from c4s.run.part import Part
from c4s.run.plan import make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.store import share_suite

suite, run = share_suite("small"), runs_root() / "lost"
plan = make_plan(
    SuiteFolder(suite),
    [configuration("oracle")],
    run_id="lost",
    policy="code4scene-published",
    judge="rule",
    engine="headless",
    cases=[sys.argv[2]],
)
plan = open_run(run, plan)

async def work():
    async with Pool(1, processors=1) as slots:
        part = Part(sys.argv[1], "engines", True)
        return await run_trials(list(trials(run, suite, plan)), plan, slots, stage_functions(), None, None, part)

for pending in asyncio.run(work()):
    print(type(pending.error).__name__, pending.reason)
"""
Start = Callable[[str], subprocess.Popen[str]]


@pytest.fixture
def worker(home: Path, tmp_path: Path) -> Iterator[Start]:
    """Starts workers of one trial; they and their processes are ended with the test."""
    own, started = apart(tmp_path / "home", home), []

    def start(name: str) -> subprocess.Popen[str]:
        started.append(
            subprocess.Popen(
                [sys.executable, "-c", WORKER, name, CASE],
                env=environment(own),
                text=True,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                start_new_session=True,
            )
        )
        return started[-1]

    yield start
    for process in started:
        process.send_signal(signal.SIGCONT)
        process.kill()
        process.communicate()


def contents(folder: TrialFolder) -> dict[str, bytes]:
    """All files of a trial but leases and what was set aside."""
    return {
        path.relative_to(folder.root).as_posix(): path.read_bytes()
        for path in folder.root.rglob("*")
        if path.is_file() and "lease" not in path.parts and ".interrupted-" not in str(path)
    }


def test_a_holder_that_comes_back_late_touches_nothing_of_the_next_one(worker: Start, tmp_path: Path) -> None:
    first = worker("first")
    trial = trial_in(tmp_path / "home", "lost", "oracle", CASE)
    until(trial.attempt(1).manifest.is_file, first)
    os.killpg(first.pid, signal.SIGSTOP)
    second = worker("second")
    out, told = second.communicate(timeout=120)
    assert second.returncode == 0 and out == "", told
    done = contents(trial)
    assert Handover.read(trial.handover).part == "second" and trial.score.is_file()
    os.killpg(first.pid, signal.SIGCONT)
    out, told = first.communicate(timeout=120)
    assert "LeaseLost" in out and "taken over by process" in out, (out, told)
    assert contents(trial) == done
    aside = trial.attempt(1).root.with_name("attempt-1.interrupted-1")
    assert (aside / "trajectory.jsonl").is_file()
