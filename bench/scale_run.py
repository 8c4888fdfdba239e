"""The process of ``bench.scale`` that drives: ``c4s run`` with other stages, and the times of its parts."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path
from typing import Any
from unittest import mock

from bench.instant import instant_functions, instant_stage
from c4s.cli import evaluation
from c4s.errors import C4SError
from c4s.files import json_lines
from c4s.home import runs_root, warehouse_root
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.run import drive
from c4s.run.drive import Run
from c4s.run.limits import Stage
from c4s.run.plan import Trial, trials
from c4s.run.pool import work
from warehouse.database import rows
from warehouse.ingest import ingest_trial


class _Started(BaseException):
    """The first attempt starts."""


class _Clock:
    """When the first stage began, and when the last one ended."""

    def __init__(self, run: Run, *, start_only: bool) -> None:
        self._run, self._start_only = run, start_only
        self.first: float | None = None
        self.spent_s = 0.0
        self.last = 0.0

    async def __call__(self, stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if self.first is None:
            self.first, self.spent_s = time.perf_counter(), time.process_time()
        if self._start_only:
            raise _Started
        try:
            return await self._run(stage, trial, plan, *arguments)
        finally:
            self.last = time.perf_counter()


def _as_tasks() -> Run:
    """Instant stages as Prefect tasks."""
    from prefect import task
    from prefect.cache_policies import NO_CACHE
    from prefect.utilities.annotations import opaque

    @task(task_run_name="{stage}-{trial.name}", cache_policy=NO_CACHE)
    async def one(stage: Stage, trial: Trial, plan: Plan, arguments: tuple[Any, ...]) -> Any:
        if stage == "persist":
            return await work(drive.store, _persist, trial, plan)
        return await work(instant_stage, stage, trial, plan, *arguments)

    counted: Callable[..., Awaitable[Any]] = one

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        return await counted(stage, opaque(trial), opaque(plan), arguments)

    return run


def _persist(trial: Trial, plan: Plan) -> None:
    ingest_trial(trial, plan, warehouse_root())


def _in_a_flow(evaluate: Callable[[], None]) -> Callable[[], None]:
    """The same with the run of its trials inside a Prefect flow."""
    from prefect import flow

    inside = evaluation._run

    async def run(*arguments: Any) -> Any:
        @flow(name="scale", validate_parameters=False)
        async def scale() -> Any:
            return await inside(*arguments)

        return await scale()

    def evaluated() -> None:
        with mock.patch.object(evaluation, "_run", run):
            evaluate()

    return evaluated


def main(home: Path, repeats: int, stages: str, start_only: bool, agents: Sequence[str]) -> None:
    """Run, and print what it took as a line of JSON."""
    started = time.perf_counter()
    clock: list[_Clock] = []

    def functions(persist: drive.Persist) -> Run:
        real = {"noop": drive.stage_functions, "instant": instant_functions}
        clock.append(_Clock(real[stages](persist) if stages in real else _as_tasks(), start_only=start_only))
        return clock[0]

    def evaluate() -> None:
        evaluation.evaluate_here("made", agents, repeats=repeats)

    failures = ""
    with mock.patch.object(evaluation, "stage_functions", functions):
        try:
            (_in_a_flow(evaluate) if stages == "prefect" else evaluate)()
        except BaseExceptionGroup as group:
            if group.subgroup(_Started) is None:
                raise
        except C4SError as error:
            failures = error.line()
    ended = time.perf_counter()
    run = runs_root() / "made"
    plan = Plan.read(RunFolder(run).plan)
    first = clock[0].first or ended
    told = {
        "start_s": round(first - started, 2),
        "start_cpu_s": round(clock[0].spent_s, 2),
        "run_s": round(max(0.0, clock[0].last - first), 2),
        "end_s": round(ended - max(clock[0].last, first), 2),
        "failures": failures,
        **_recorded(run, plan),
        **({"pending": 0, "answers_s": 0.0} if start_only else _stored()),
    }
    print(json.dumps(told), flush=True)


def _recorded(run: Path, plan: Plan) -> dict[str, float]:
    """How many trials there are, and what the stages and the driving of them took a trial, as it is recorded."""
    spent = {True: 0.0, False: 0.0}
    planned = list(trials(run, run, plan))
    for path in (trial.folder.stages for trial in planned):
        for line in json_lines(path.read_text().splitlines() if path.is_file() else []):
            spent[line["stage"] == "orchestration"] += line["seconds"]
    recorded = {"orchestration_s": spent[True] / len(planned), "stages_s": spent[False] / len(planned)}
    return {"trials": len(planned)} | {name: round(seconds, 4) for name, seconds in recorded.items()}


def _stored() -> dict[str, float]:
    started = time.perf_counter()
    board = rows(warehouse_root(), "SELECT planned, resolved FROM leaderboard")
    answered = time.perf_counter() - started
    return {"pending": sum(row["planned"] - row["resolved"] for row in board), "answers_s": round(answered, 3)}


if __name__ == "__main__":
    home, repeats, stages, start_only, *agents = sys.argv[1:]
    main(Path(home), int(repeats), stages, start_only == "1", agents)
