"""The trial flow: trials of a run that was planned, all of their work or one work pool's part of it.

A trial's stages are Prefect tasks here, for the one program of a trial (``c4s.run.trial``).
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, Final

from prefect import flow, runtime
from prefect.utilities.annotations import opaque

from c4s.errors import unknown
from c4s.home import warehouse_root
from c4s.records.handover import WorkPool
from c4s.records.plan import Plan
from c4s.run.drive import Run, refuse_pending, run_trials
from c4s.run.limits import Stage
from c4s.run.oversight import overseen
from c4s.run.part import Part
from c4s.run.plan import Trial
from c4s.run.plan import trials as scheduled
from c4s.run.pool import Pool
from c4s.run.signals import ending_in_order
from c4s.run.store import share_suite, shared_plan
from flows.family import die_with_the_worker
from flows.server import tie
from tasks.attempt import attempt
from tasks.control import control
from tasks.integrity import integrity
from tasks.judge import judge
from tasks.look import look
from tasks.persist import persist
from tasks.score import score
from tasks.verify import verify

TASKS: Final[dict[Stage, Callable[..., Awaitable[Any]]]] = {
    "attempt": attempt,
    "integrity": integrity,
    "look": look,
    "judge": judge,
    "verify": verify,
    "control": control,
    "score": score,
    "persist": persist,
}
tie()


def as_tasks(warehouse: Path) -> Run:
    """Runs each stage as a task of its own, seen by Prefect while it runs and not while it waits."""

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage == "persist":
            arguments = (*arguments, warehouse)
        return await TASKS[stage](opaque(trial), opaque(plan), *arguments)

    return run


@flow(name="trial")
async def trial(
    run_id: str, trials: list[str], pool: WorkPool = "engines", part: str | None = None, whole: bool = True
) -> int:
    """Run trials of a run, or one work pool's part of them. Returns how many.

    The flow evaluate starts these. By hand, it runs some trials to their end: the run has a plan already, and trials
    are named as the terminal and the pages name them.

    Args:
        run_id: folder name of the run.
        trials: names of trials: configuration/case/r1.
        pool: the work pool whose stages are run.
        part: id under which the end of this part is put on record (default: the flow run's).
        whole: run all stages of the trials, not only those of the pool.
    """
    die_with_the_worker()
    run, plan = shared_plan(run_id)
    suite = share_suite(plan.suite_id)
    known = {one.name: one for one in scheduled(run, suite, plan)}
    for name in trials:
        if name not in known:
            raise unknown("trial", name, known, where=f"run {run_id}")
    work = Part(part or str(runtime.flow_run.id), pool, whole)
    chosen = [known[name] for name in trials]
    async with Pool(1, processors=1) as slots:
        with overseen(run, suite, plan, slots, None) as overseer, ending_in_order(overseer):
            pending = await run_trials(chosen, plan, slots, as_tasks(warehouse_root()), None, overseer, work)
    refuse_pending(pending, len(trials))
    return len(trials)
