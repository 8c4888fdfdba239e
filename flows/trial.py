"""A trial's stages as Prefect tasks, for the one program of a trial (``c4s.run.trial``)."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, Final

from prefect.utilities.annotations import opaque

from c4s.records.plan import Plan
from c4s.run.drive import Run
from c4s.run.limits import Stage
from c4s.run.plan import Trial
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


def as_tasks(warehouse: Path) -> Run:
    """Runs each stage as a task of its own, seen by Prefect while it runs and not while it waits."""

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage == "persist":
            arguments = (*arguments, warehouse)
        return await TASKS[stage](opaque(trial), opaque(plan), *arguments)

    return run
