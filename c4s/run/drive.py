"""Many trials at once, each by the one program, behind the slots of a pool."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NoReturn

from c4s.errors import BadInput, C4SError, MachineryFault, row_of
from c4s.meter.spending import SpendingLimitReached
from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.aside import set_aside
from c4s.run.guards import StoppedByGuard, left_over, reason_of, spent_up
from c4s.run.headroom import LOOK_S, REPEATS, NoRoom, print_line
from c4s.run.lease import Held, LeaseLost
from c4s.run.limits import Stage
from c4s.run.overseer import Overseer
from c4s.run.part import Part
from c4s.run.plan import Trial
from c4s.run.pool import Pool, work
from c4s.run.torn import settle
from c4s.run.trial import Do, HandedOver, run_trial
from c4s.run.trial_work import holding_trial, in_order, settle_free, while_held

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
        return reason_of(self.error)


def in_slots(
    pool: Pool,
    run: Run,
    trial: Trial,
    plan: Plan,
    rank: int = 0,
    held: Sequence[Held] = (),
    overseer: Overseer | None = None,
) -> Do:
    """A trial's ``do``: each stage waits for its slot, and is then run. Earlier ranks go first.

    Stages are given the plan without other trials, so that what crosses to a worker does not grow with the plan.
    No stage is started without room to work, where a lease was lost, or while the run is paused. Where one fails after
    a lease was lost, that is why: ``LeaseLost``. A run that is stopped waits for no room: ``NoRoom``, or for a new
    attempt ``StoppedByGuard``.
    """
    own = plan.model_copy(update={"cases": [trial.case], "configurations": [trial.configuration]})

    async def check_held() -> None:
        for lease in held:
            await lease.check_beside()

    def give_up(stage: Stage, *arguments: Any) -> None:
        if overseer is not None and overseer.stopped is not None:
            if overseer.holds(stage, trial, arguments):
                raise overseer.stopped
            raise NoRoom("the run was stopped while there was no room to work", where=trial.name)

    async def once(stage: Stage, *arguments: Any) -> Any:
        while True:
            await pool.headroom.room(partial(give_up, stage, *arguments))
            if overseer is not None:
                await overseer.may_start(stage, trial, arguments)
            async with pool.turn(stage, trial, own, rank):
                await check_held()
                if overseer is None:
                    return await run(stage, trial, own, *arguments)
                if overseer.holds(stage, trial, arguments):
                    continue
                with overseer.stage(stage, trial, arguments, pool.limit(stage, trial, own).kind) as returned:
                    made = await run(stage, trial, own, *arguments)
                    returned(made)
                return made

    async def do(stage: Stage, *arguments: Any) -> Any:
        for left in reversed(range(REPEATS + 1)):
            before = pool.headroom.times_short
            try:
                made = await once(stage, *arguments)
            except Exception as error:
                await check_held()
                pool.headroom.look()
                if not left or (pool.headroom.times_short == before and not isinstance(error, NoRoom)):
                    raise
                continue
            pool.headroom.look()
            if pool.headroom.times_short == before or not undone(stage, trial, made, *arguments):
                return made
        raise NoRoom(f"{stage} ended {REPEATS + 1} times while there was no room to work", where=trial.name)

    return do


def undone(stage: Stage, trial: Trial, made: Any, *arguments: Any) -> bool:
    """Take back what a stage put on record against the agent while there was no room; whether it did."""
    if stage == "attempt" and (made.ended_by != "finished" or made.submission is None):
        set_aside(trial.folder.attempt(*arguments).root)
        return True
    if stage == "integrity" and not made:
        trial.folder.attempt(*arguments).integrity.unlink()
        return True
    return False


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


async def run_trials(
    trials: Sequence[Trial],
    plan: Plan,
    pool: Pool,
    run: Run,
    held: Held | None = None,
    overseer: Overseer | None = None,
    part: Part | None = None,
) -> list[Pending]:
    """Run trials, so many at once as the pool can use, in order of their start; those that are pending at the end.

    Each trial is held while it is in work; one that somebody else holds is waited for. What goes wrong in one trial
    costs that trial only; ``LeaseLost`` of the run ends all of them. Where a guard stops the run, the trials that it
    kept from their next attempt are pending with ``StoppedByGuard``.

    Args:
        trials: what to run, best first.
        plan: the run's plan.
        pool: where stages run.
        run: runs a stage.
        held: the lease of the run, where this process has it.
        overseer: the watch over the run, which keeps its journal and guards.
        part: what to do of each trial (default: all); how it ended is then on record in the trial's folder.
    """
    working = asyncio.ensure_future(_run_trials(trials, plan, pool, run, held, overseer, part))
    watching = asyncio.ensure_future(_watch(pool, held, overseer))
    try:
        await asyncio.wait((working, watching), return_when=asyncio.FIRST_COMPLETED)
        pending = working.result() if working.done() else watching.result()
        if held is not None:
            held.check()
        return pending
    finally:
        for task in (working, watching):
            task.cancel()
        await asyncio.gather(working, watching, return_exceptions=True)


async def _watch(pool: Pool, held: Held | None, overseer: Overseer | None) -> NoReturn:
    """Look at the room to work, at the lease and at the guards, for as long as trials run."""
    while True:
        await asyncio.sleep(LOOK_S)
        pool.headroom.look()
        if held is not None:
            await held.check_beside()
        if overseer is not None:
            await overseer.look_beside()


async def _run_trials(
    trials: Sequence[Trial],
    plan: Plan,
    pool: Pool,
    run: Run,
    held: Held | None,
    overseer: Overseer | None,
    part: Part | None,
) -> list[Pending]:
    gate = asyncio.Semaphore(pool.in_flight)
    pending: dict[int, Pending] = {}

    async def one(rank: int, trial: Trial) -> None:
        try:
            error = await _in_work(trial, plan, pool, run, rank, held, overseer, part)
            if error is not None:
                pending[rank] = Pending(trial, error)
        finally:
            gate.release()

    async with asyncio.TaskGroup() as group:
        for rank, trial in enumerate(trials):
            await gate.acquire()
            if part is None and overseer is not None and overseer.stopped is not None and not trial.folder.attempts():
                pending[rank] = Pending(trial, overseer.stopped)
                gate.release()
                continue
            group.create_task(one(rank, trial))
    return [pending[rank] for rank in sorted(pending)]


async def _in_work(
    trial: Trial,
    plan: Plan,
    pool: Pool,
    run: Run,
    rank: int,
    held: Held | None,
    overseer: Overseer | None,
    part: Part | None,
) -> Exception | None:
    """Hold a trial and run it, or a part of it; what left it pending."""
    try:
        async with holding_trial(trial) as (own, store, waited):
            ended: Exception | None = None
            try:
                for line in await in_order(settle, trial, plan) if waited or part is not None else []:
                    print_line(line)
                do = in_slots(pool, run, trial, plan, rank, [own] if held is None else [held, own], overseer)
                do = store.sending(do)
                do = do if part is None else part.limited(do, pool, trial, plan)
                async with while_held(own):
                    score = await run_trial(trial, plan, do)
                if overseer is not None:
                    overseer.done(trial, score)
            except Exception as error:
                ended = error
                if overseer is not None and not isinstance(error, HandedOver | LeaseLost):
                    overseer.pending(trial, error)
            if part is not None and not isinstance(ended, LeaseLost):
                part.note(trial, ended)
                await store.send()
            return None if isinstance(ended, HandedOver) else ended
    except Exception as error:
        if overseer is not None:
            overseer.pending(trial, error)
        return error


def settle_all(trials: Sequence[Trial], plan: Plan, tell: Callable[[str], None]) -> tuple[list[Trial], list[Pending]]:
    """The trials that can be run, and those that can not for what they have on record; what was set aside is told.

    One that somebody works on is left to them: it is settled when they are done.
    """
    ready, refused = [], []
    for trial in trials:
        try:
            for line in settle_free(trial, plan):
                tell(line)
            ready.append(trial)
        except BadInput as error:
            refused.append(Pending(trial, error))
    return ready, refused


def refuse_pending(pending: Sequence[Pending], total: int) -> None:
    """Raise what kept trials pending: a ``StoppedByGuard``, else a ``MachineryFault``, else a ``BadInput``."""
    if not pending:
        return
    for one in pending:
        stopped = spent_up(one.error) if isinstance(one.error, SpendingLimitReached) else one.error
        if isinstance(stopped, StoppedByGuard):
            raise left_over(stopped, len(pending), total, one.trial.run) from one.error
    first = next((one for one in pending if not isinstance(one.error, BadInput)), pending[0])
    what = f"{len(pending)} of {total} trials are pending; first {first.trial.name}: {first.reason}"
    if first.trial.folder.faults.is_file():
        what += f"; more in {first.trial.folder.faults}"
    if isinstance(first.error, BadInput):
        raise BadInput(what) from first.error
    told = isinstance(first.error, C4SError) and first.error.todo
    raise MachineryFault(what, todo="" if told else row_of(first.error).todo) from first.error
