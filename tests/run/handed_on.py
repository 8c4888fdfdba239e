"""Trials of the six baselines on the suite ``small``, run once a test run; other homes are given those that they need.

A trial is what it is by its content, whichever run holds it: a command that asks for one that was handed on finds it
done.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Final

import pytest

from c4s.engine import DEFAULT_ENGINE
from c4s.judge.names import DEFAULT_JUDGE
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.folder import RunFolder
from c4s.records.suite import SuiteFolder
from c4s.run.configurations import configuration
from c4s.run.drive import store
from c4s.run.plan import make_plan, open_run, trials
from reports.site import build_site
from tests.built import built_once
from tests.run.conftest import apart, build_small, environment
from warehouse.database import rebuild
from warehouse.ingest import ingest_schedule, ingest_trial

RUN: Final = "small"
TRIALS: Final = 18


def baselines_home(factory: pytest.TempPathFactory) -> Path:
    """A home where all six baselines ran on the suite ``small``; for reading."""
    small = built_once(factory, "small-home", build_small)
    return built_once(factory, "baselines-home", lambda root: _run_all(apart(root, small)))


def _run_all(home: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", "--json"],
        env=environment(home),
        text=True,
        capture_output=True,
        timeout=290,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["ran"] == TRIALS


def copy_of(baselines: Path, home: Path) -> Path:
    """Another home where the same has run, for changing."""
    apart(home, baselines)
    shutil.copytree(baselines / "runs", home / "runs")
    shutil.copytree(baselines / "warehouse", home / "warehouse", ignore=shutil.ignore_patterns("*.duckdb"))
    _publish(home)
    return home


def hand_on(baselines: Path, home: Path, agents: Sequence[str], cases: Sequence[str], run: str = RUN) -> None:
    """A run of agents on cases in a home, of trials that were done: planned, stored and published as `c4s run` does."""
    suite, own = SuiteFolder(home / "suites/small"), RunFolder(home / "runs" / run)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(home))
        plan = make_plan(
            suite,
            [configuration(agent) for agent in agents],
            run_id=run,
            policy=DEFAULT_POLICY,
            judge=DEFAULT_JUDGE,
            engine=DEFAULT_ENGINE,
            cases=cases,
        )
        plan = open_run(own.root, plan)
        ingest_schedule(own.root, suite.root, plan, home / "warehouse")
        for trial in trials(own.root, suite.root, plan):
            done = RunFolder(baselines / "runs" / RUN).trial(trial.configuration.name, trial.case.alias, trial.repeat)
            shutil.copytree(done.root, trial.folder.root)
            store(partial(ingest_trial, warehouse=home / "warehouse"), trial, plan)
    _publish(home)


def _publish(home: Path) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(home))
        rebuild(home / "warehouse")
        build_site(home / "warehouse", home / "site", home / "suites")
