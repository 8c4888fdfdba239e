"""Many trials at once, each by the one program, behind the slots of a pool."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from c4s.errors import BadInput, C4SError, MachineryFault
from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.limits import Stage
from c4s.run.plan import Trial
from c4s.run.pool import Pool, work
from c4s.run.trial import Do, run_trial

Run = Callable[..., Awaitable[Any]]
"""Runs a stage by its name, with trial, plan, and what else it takes."""
Persist = Callable[[Trial, Plan], None]


@dataclass(frozen=True)
class Pending:
    """A trial that could not be finished, and why."""

    trial: Trial
    error: Exception

    @property
    def reason(self) -> str:
        """What went wrong, in a line."""
        if isinstance(self.error, C4SError):
            return self.error.line()
        return f"{type(self.error).__name__}: {self.error}"


def in_slots(pool: Pool, run: Run, trial: Trial, plan: Plan, rank: int = 0) -> Do:
    """A trial's ``do``: each stage waits for its slot, and is then run. Earlier ranks go first.

    Stages are given the plan without other trials, so that what crosses to a worker does not grow with the plan.
    """
    own = plan.model_copy(update={"cases": [trial.case], "configurations": [trial.configuration]})

    async def do(stage: Stage, *arguments: Any) -> Any:
        async with pool.turn(stage, trial, own, rank):
            return await run(stage, trial, own, *arguments)

    return do


def stage_functions(persist: Persist | None = None) -> Run:
    """Runs the stages in worker processes; ``persist`` stores a scored trial (c4s knows of no warehouse)."""

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage != "persist":
            return await work(getattr(stages, stage), trial, plan, *arguments)
        return None if persist is None else await work(partial(store, persist), trial, plan)

    return run


def store(persist: Persist, trial: Trial, plan: Plan) -> None:
    """The stage ``persist``."""
    with stages.timed(trial, "persist"):
        persist(trial, plan)


async def run_trials(trials: Sequence[Trial], plan: Plan, pool: Pool, run: Run) -> list[Pending]:
    """Run trials, so many at once as the pool can use, in order of their start; those that are pending at the end.

    What goes wrong in one trial costs that trial only.
    """
    gate = asyncio.Semaphore(pool.in_flight)
    pending: dict[int, Pending] = {}

    async def one(rank: int, trial: Trial) -> None:
        try:
            await run_trial(trial, plan, in_slots(pool, run, trial, plan, rank))
        except Exception as error:
            pending[rank] = Pending(trial, error)
        finally:
            gate.release()

    async with asyncio.TaskGroup() as group:
        for rank, trial in enumerate(trials):
            await gate.acquire()
            group.create_task(one(rank, trial))
    return [pending[rank] for rank in sorted(pending)]


def refuse_pending(pending: Sequence[Pending], total: int) -> None:
    """Raise what kept trials pending: ``BadInput`` where nothing else did, else ``MachineryFault``."""
    if not pending:
        return
    first = next((one for one in pending if not isinstance(one.error, BadInput)), pending[0])
    what = f"{len(pending)} of {total} trials are pending; first {first.trial.name}: {first.reason}"
    if isinstance(first.error, BadInput):
        raise BadInput(what) from first.error
    raise MachineryFault(what, todo="run the same command again") from first.error
