"""The evaluate flow: what the plan asks for and the run folder does not hold yet."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, TypeVar

from prefect import Task, flow
from prefect.futures import PrefectFuture
from prefect.task_runners import TaskRunner, ThreadPoolTaskRunner

from c4s.errors import MachineryFault
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.check import check_kept
from c4s.run.configurations import configuration
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.verify.registry import is_judged, verifiers_of
from tasks.attempt import attempt
from tasks.integrity import integrity
from tasks.judge import judge as judge_scene
from tasks.look import look
from tasks.persist import persist
from tasks.pool import engine_slots
from tasks.publish import publish
from tasks.verify import verify
from warehouse.ingest import ingest_schedule, is_stored

R = TypeVar("R")
WAITING_THREADS = 32
_RUNNER: TaskRunner[Any] = ThreadPoolTaskRunner(max_workers=WAITING_THREADS)


def _later(stage: Task[..., R], *values: Any, wait_for: list[PrefectFuture[None]] | None = None) -> PrefectFuture[R]:
    """Submit a stage that reads an earlier one: Prefect takes a future for any argument, its types only for these."""
    return stage.submit(*values, wait_for=wait_for)


def _submit(trial: Trial, plan: Plan, warehouse: Path) -> list[PrefectFuture[Any]]:
    """Submit a trial's stages, in order; each waits for what it reads, and the last one stores the trial."""
    ran_1 = attempt.submit(trial, plan, 1)
    valid_1 = _later(integrity, trial, plan, 1, ran_1)
    ran_2 = _later(attempt, trial, plan, 2, valid_1)
    valid = _later(integrity, trial, plan, 2, ran_2, valid_1)
    looked = _later(look, trial, plan, valid)
    judged = [_later(judge_scene, trial, plan, valid, wait_for=[looked])] if is_judged(trial.case.setting) else []
    verdicts = [
        _later(verify, trial, plan, valid, verifier.name, wait_for=judged if "judgements" in verifier.needs else [])
        for verifier in verifiers_of(trial.case.setting)
    ]
    last = _later(persist, trial, plan, warehouse, wait_for=[looked, *verdicts])
    return [ran_1, valid_1, ran_2, valid, looked, *judged, *verdicts, last]


@flow(name="evaluate", task_runner=_RUNNER, validate_parameters=False)
def evaluate(
    suite: str = "starter",
    agents: list[str] | None = None,
    run_id: str | None = None,
    cases: list[str] | None = None,
    repeats: int = 1,
    judge: str = "rule",
    engine: str = "headless",
    slots: int | None = None,
) -> str:
    """Run, verify, store and publish a suite. Returns the address of the leaderboard page.

    Run it again with the same arguments to complete a run that was stopped; finished trials are skipped.

    Args:
        suite: id of a built suite.
        agents: configuration names (default: the five baselines).
        run_id: folder name of the run (default: the suite's id).
        cases: only these cases.
        repeats: repeats of each case.
        judge: ``rule``, the offline judge.
        engine: ``headless``.
        slots: engine processes at once (default: one a core).
    """
    folder = suites_root() / suite
    run = runs_root() / (run_id or suite)
    chosen = [configuration(name) for name in agents or ("noop", "random", "planner", "vandal", "oracle")]
    plan = open_run(
        run,
        make_plan(
            SuiteFolder(folder),
            chosen,
            run_id=run.name,
            policy=DEFAULT_POLICY,
            judge=judge,
            engine=engine,
            repeats=repeats,
            cases=cases or (),
        ),
    )
    warehouse = warehouse_root()
    ingest_schedule(run, folder, plan, warehouse)
    missing = [trial for trial in trials(run, folder, plan) if not is_stored(trial, plan, warehouse)]
    for trial in missing:
        check_kept(trial)
    if missing:
        with engine_slots(slots or os.cpu_count() or 1):
            submitted = [(trial, _submit(trial, plan, warehouse)) for trial in missing]
            failed = [(trial, reason) for trial, stages in submitted if (reason := _final(stages)) is not None]
    else:
        failed = []
    page = publish(warehouse, site_root())
    if failed:
        first, reason = failed[0]
        raise MachineryFault(
            f"{len(failed)} of {len(missing)} trials are pending; first {first.name}: {reason}",
            todo="run the same command again",
        )
    return page.as_uri()


def _final(stages: list[PrefectFuture[Any]]) -> str | None:
    """None when the trial is stored, else why not: what the first stage that failed says."""
    stages[-1].wait()
    if stages[-1].state.is_completed():
        return None
    failed = [stage.state for stage in stages if stage.state.is_failed() or stage.state.is_crashed()]
    state = failed[0] if failed else stages[-1].state
    return state.message or state.name
