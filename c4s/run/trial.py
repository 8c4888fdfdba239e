"""A trial, as the one program that every driver runs: in worker processes, as Prefect tasks, with a live view.

The driver gives ``do``, which runs a stage by its name and waits for it; this module knows their order and nothing of
where they run. Stages that are done only read what is on record, so the program goes on where it stopped.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Sequence
from typing import Any, Protocol

from c4s.records.handover import WorkPool
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.run import overrun, repeats
from c4s.run.faults import SceneFault
from c4s.run.guards import StoppedByGuard
from c4s.run.lease import LeaseLost
from c4s.run.limits import Stage
from c4s.run.plan import Trial
from c4s.run.stages import ATTEMPTS
from c4s.verify.registry import is_judged, verifiers_of

Needed = Sequence[asyncio.Task[None]]


class HandedOver(Exception):
    """No failure: the next stage is for another work pool.

    Args:
        pool: which.
        whole: whether it has to finish the trial.
    """

    def __init__(self, pool: WorkPool, *, whole: bool) -> None:
        super().__init__(f"the next stage is for the pool {pool!r}")
        self.pool, self.whole = pool, whole


class Do(Protocol):
    """Runs a stage of one trial with what it takes beside trial and plan."""

    def __call__(self, stage: Stage, *arguments: Any) -> Awaitable[Any]:
        """What the stage returns."""
        ...


async def run_trial(trial: Trial, plan: Plan, do: Do, *, attempts: int = ATTEMPTS) -> TrialScore:
    """Attempt and integrity, once more if invalid; then the verifiers side by side; then score and persist.

    What the scene makes fail is an outcome (``c4s.run.overrun``), once the control has shown that the machinery can do
    it. All else passes through, on record, and leaves the trial pending, after what ran beside it has ended.
    """
    do = _recording(trial, do)
    for number in range(1, attempts + 1):
        await _attempt(trial, number, do)
        if await _is_valid(trial, number, do):
            await _verify(trial, plan, do)
            break
    score: TrialScore = await do("score")
    await do("persist")
    return score


def _recording(trial: Trial, do: Do) -> Do:
    """The same, with what leaves the trial pending on record."""

    async def recorded(stage: Stage, *arguments: Any) -> Any:
        try:
            return await do(stage, *arguments)
        except (SceneFault, HandedOver, StoppedByGuard, LeaseLost):
            raise
        except Exception as error:
            repeats.note(trial, stage, arguments, error)
            raise

    return recorded


async def _attempt(trial: Trial, number: int, do: Do) -> None:
    """An attempt. One that has spent its repeats ends without a submission, unless the machinery fails by itself."""
    try:
        await do("attempt", number)
    except (HandedOver, StoppedByGuard, LeaseLost):
        raise
    except Exception:
        if not repeats.spent(trial, number):
            raise
        await do("control", "attempt", number)
        repeats.end(trial, number)


async def _of_scene(do: Do, stage: Stage, *arguments: Any) -> Any:
    """A stage that reads one scene. ``SceneFault`` where the control does not fail as it does."""
    try:
        return await do(stage, *arguments)
    except SceneFault:
        await do("control", stage, *arguments)
        raise


async def _is_valid(trial: Trial, number: int, do: Do) -> bool:
    try:
        return bool(await _of_scene(do, "integrity", number))
    except SceneFault as reason:
        overrun.write_invalid(trial, number, reason)
        return False


async def _verify(trial: Trial, plan: Plan, do: Do) -> None:
    """Start each verifier of the setting as soon as what it needs is there. Pictures are taken whoever needs them."""
    look = asyncio.create_task(_look(trial, plan, do))
    made = {"captures": look}
    if is_judged(trial.case.setting):
        made["judgements"] = asyncio.create_task(_judge(do, [look]))
    verdicts = [
        asyncio.create_task(
            _verdict(trial, plan, do, verifier.name, [made[name] for name in sorted(verifier.needs & made.keys())])
        )
        for verifier in verifiers_of(trial.case.setting)
    ]
    faults = await asyncio.gather(*made.values(), *verdicts, return_exceptions=True)
    handed_over = [fault for fault in faults if isinstance(fault, HandedOver)]
    for fault in faults:
        if isinstance(fault, BaseException) and not isinstance(fault, SceneFault | HandedOver):
            raise fault
    for over in sorted(handed_over, key=lambda over: not over.whole):
        raise over


async def _look(trial: Trial, plan: Plan, do: Do) -> None:
    try:
        await _of_scene(do, "look")
    except SceneFault as reason:
        overrun.write_not_looked(trial, plan, reason)


async def _judge(do: Do, needed: Needed) -> None:
    for made in needed:
        await made
    await _of_scene(do, "judge")


async def _verdict(trial: Trial, plan: Plan, do: Do, name: str, needed: Needed) -> None:
    try:
        for made in needed:
            await made
        await _of_scene(do, "verify", name)
    except SceneFault as reason:
        overrun.write_not_evaluated(trial, plan, name, reason)
