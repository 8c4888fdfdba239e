"""What it costs to drive trials, and whether every engine slot is busy while there is work.

The stages are dummies: for the cost they return at once, in real worker processes, with and without Prefect; for the
slots they wait as long as given here, an attempt for most of a trial as in life.
"""

from __future__ import annotations

import asyncio
import os
import tempfile
import time
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from bench.row import Row
from c4s.files import json_lines
from c4s.protocol.settings import SETTINGS
from c4s.records.plan import Configuration, Plan, PlannedCase
from c4s.run.drive import Run, run_trials
from c4s.run.limits import LIMITS, Limit, Stage
from c4s.run.plan import Trial, trials
from c4s.run.pool import Pool, work

SLOTS = (1, 2, 4, 8, 16, 32, 64)
TRIALS_A_SLOT = 6
LASTS_S: dict[Stage, float] = {"attempt": 0.2, "integrity": 0.02, "look": 0.06}
COSTED_TRIALS = 40
GOAL_S = 0.3
GOAL_BUSY = 0.98
QUIET = {
    "DO_NOT_TRACK": "1",
    "PREFECT_SERVER_ANALYTICS_ENABLED": "false",
    "PREFECT_LOGGING_LEVEL": "CRITICAL",
    "PREFECT_SERVER_LOGGING_LEVEL": "CRITICAL",
    "PREFECT_SERVER_EPHEMERAL_STARTUP_TIMEOUT_SECONDS": "120",
}


class _Pool(Pool):
    """A pool whose attempts have no budget to read."""

    def limit(self, stage: Stage, trial: Trial, plan: Plan) -> Limit:
        return LIMITS[stage]


def planned(root: Path, count: int) -> tuple[Plan, list[Trial]]:
    """A plan of the size of the published suite, and some of its trials."""
    cases = [
        PlannedCase(
            case_id=f"case-{number}",
            alias=f"case-{number}",
            setting=SETTINGS[number % len(SETTINGS)],
            scene_id="made",
            agent_digest="0" * 64,
            withheld_digest="0" * 64,
        )
        for number in range(max(count, 95))
    ]
    plan = Plan(
        run_id="made",
        suite_id="made",
        suite_digest="0",
        policy="",
        judge="rule",
        engine="headless",
        configurations=[Configuration(name="dummy", client="noop")],
        cases=cases,
        versions={},
    )
    return plan, list(trials(root, root, plan))[:count]


async def _busy(slots: int) -> float:
    """Mean busy engine slots, from the first stage to the start of the last attempt."""
    with tempfile.TemporaryDirectory() as folder:
        plan, made = planned(Path(folder), TRIALS_A_SLOT * slots)
        began, area, seen_at = 0, 0.0, time.perf_counter()
        started = seen_at
        async with _Pool(slots) as pool:
            engines = pool.slots["engine"]

            def note() -> None:
                nonlocal area, seen_at
                now = time.perf_counter()
                if began < len(made):
                    area += engines.taken * (now - seen_at)
                    seen_at = now

            async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> bool:
                nonlocal began
                note()
                began += stage == "attempt"
                await asyncio.sleep(LASTS_S.get(stage, 0.0))
                note()
                return True

            await run_trials(made, plan, pool, run)
        return area / (seen_at - started)


def nothing(*arguments: Any) -> bool:
    """A stage that returns at once."""
    return True


async def _straight(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> bool:
    return await work(nothing, trial, plan, *arguments)


async def _cost(run: Run) -> float:
    """Seconds of orchestration a trial, as it is recorded with every trial."""
    with tempfile.TemporaryDirectory() as folder:
        plan, made = planned(Path(folder), COSTED_TRIALS)
        async with _Pool(1, processors=1) as pool:
            await run_trials(made, plan, pool, run)
        told = [line for trial in made for line in json_lines(trial.folder.stages.read_text().splitlines())]
    return float(sum(line["seconds"] for line in told)) / len(made)


def _under_prefect() -> tuple[float, float]:
    """Seconds a trial with each stage as a Prefect task, and what Prefect takes for as many tasks that do nothing."""
    from prefect import flow, task
    from prefect.cache_policies import NO_CACHE
    from prefect.utilities.annotations import opaque

    @task(task_run_name="{stage}-{trial.name}", cache_policy=NO_CACHE)
    async def one(stage: Stage, trial: Trial, plan: Plan, arguments: tuple[Any, ...]) -> bool:
        return await _straight(stage, trial, plan, *arguments)

    counted: Callable[..., Awaitable[Any]] = one

    @task(cache_policy=NO_CACHE)
    async def empty() -> None:
        pass

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> bool:
        return bool(await counted(stage, opaque(trial), opaque(plan), arguments))

    @flow(validate_parameters=False)
    async def costed() -> tuple[float, float]:
        ours, counted = await _counted(run)
        started = time.perf_counter()
        for _ in range(counted):
            await empty()
        return ours, (time.perf_counter() - started) / COSTED_TRIALS

    return asyncio.run(costed())


async def _counted(run: Callable[..., Awaitable[Any]]) -> tuple[float, int]:
    """The cost a trial, and how many stages ran in all."""
    count = 0

    async def counting(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        nonlocal count
        count += 1
        return await run(stage, trial, plan, *arguments)

    return await _cost(counting), count


def rows() -> list[Row]:
    """Busy slots, and the cost of orchestration a trial."""
    made = []
    for slots in SLOTS:
        busy = asyncio.run(_busy(slots))
        made.append(Row(f"busy of {slots} slots", busy, f"{GOAL_BUSY:.0%}", busy >= GOAL_BUSY * slots, "slots"))
    cost = asyncio.run(_cost(_straight))
    made.append(Row("orchestration of a trial, one process", cost, f"{GOAL_S} s", cost < GOAL_S))
    with tempfile.TemporaryDirectory() as folder:
        os.environ.update({**QUIET, "PREFECT_HOME": folder})
        ours, theirs = _under_prefect()
    rival = "as many empty Prefect tasks"
    made.append(
        Row("orchestration of a trial, Prefect", ours, f"{GOAL_S} s", ours < GOAL_S, "s", rival, theirs, theirs / ours)
    )
    return made
