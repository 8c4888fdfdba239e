"""Where the stages of trials run: worker processes behind slots of three kinds.

*Engine* slots hold attempt, integrity and look; *processor* slots verify, score and persist; *request* slots a judge
that asks a model. A stage waits for a slot of its kind, then takes an idle worker process, whichever stage that ran
before. A worker that dies, or is ended for what it does, costs its own job only, and the next job gets another one.
"""

from __future__ import annotations

import os
import time
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from types import TracebackType
from typing import Self, TypeVar, TypeVarTuple

from c4s.errors import OverLimit, Unforeseen
from c4s.judge.registry import is_online
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.faults import SceneFault, may_be_the_scenes, of_scene
from c4s.run.forking import Template
from c4s.run.headroom import Headroom, raise_descriptors
from c4s.run.leftovers import sweep
from c4s.run.limits import LIMITS, ONLINE_JUDGE, Kind, Limit, Stage
from c4s.run.plan import Trial
from c4s.run.processes import Process, WorkerDied
from c4s.run.slots import Slots
from c4s.run.stages import record_time

Args = TypeVarTuple("Args")
R = TypeVar("R")
REQUESTS = 8
"""Open requests to a model judge at once."""
IN_FLIGHT = 2
"""Trials in flight for each slot of any kind. So where an engine is free and nobody waits for it, another kind is all
taken, with more jobs waiting for it than it has slots."""


@dataclass
class _Turn:
    """A stage that holds its slot."""

    pool: Pool
    limit: Limit
    name: str
    spent_s: float = 0.0
    """What the stage itself took, and the start of a process for it."""


_turn: ContextVar[_Turn] = ContextVar("turn")


class Pool:
    """Slots and worker processes for as long as the block runs.

    Args:
        engines: engine slots (default: one a processor).
        processors: processor slots (default: one a processor).
        limits: another table of limits.
        headroom: another watch over room to work.
    """

    def __init__(
        self,
        engines: int | None = None,
        *,
        processors: int | None = None,
        requests: int = REQUESTS,
        limits: Mapping[Stage, Limit] = LIMITS,
        headroom: Headroom | None = None,
    ) -> None:
        self.headroom = headroom or Headroom()
        cores = os.cpu_count() or 1
        self.slots: dict[Kind, Slots] = {
            "engine": Slots(engines or cores),
            "processor": Slots(processors or cores),
            "request": Slots(requests),
        }
        self._limits = limits
        self._idle: list[Process] = []
        self._all: set[Process] = set()
        self._template: Template | None = None

    @property
    def in_flight(self) -> int:
        """How many trials are worked on at once."""
        return IN_FLIGHT * sum(slots.count for slots in self.slots.values())

    async def __aenter__(self) -> Self:
        raise_descriptors()
        sweep()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        while self._all:
            self._all.pop().end()
        self._idle.clear()
        if self._template is not None:
            self._template.end()
            self._template = None

    def limit(self, stage: Stage, trial: Trial, plan: Plan) -> Limit:
        """What a stage of a trial occupies, and where it is ended."""
        found = self._limits[stage]
        if stage == "attempt":
            budget = SuiteFolder(trial.suite).agent_case(trial.case.alias).budget
            return Limit(found.kind, found.seconds + 60.0 * budget.wall_minutes, found.of_scene, found.memory_bytes)
        return ONLINE_JUDGE if stage == "judge" and is_online(plan.judge_configuration) else found

    @asynccontextmanager
    async def turn(self, stage: Stage, trial: Trial, plan: Plan, rank: int) -> AsyncIterator[None]:
        """A slot for a stage; the trial of the lowest rank goes first. ``work`` in the block belongs to it.

        What the block took beyond the stage itself is recorded as the trial's orchestration; waiting for a slot, and
        the start of a worker process, are not counted.
        """
        limit = self.limit(stage, trial, plan)
        async with self.slots[limit.kind].slot(rank):
            started, turn = time.perf_counter(), _Turn(self, limit, f"{stage} of {trial.name}")
            token = _turn.set(turn)
            try:
                yield
            finally:
                _turn.reset(token)
            record_time(trial, "orchestration", time.perf_counter() - started - turn.spent_s)

    async def run(self, limit: Limit, function: Callable[[*Args], R], *arguments: *Args) -> tuple[R, float]:
        """What a function returns in a worker process, and how long it and the start of its process took.

        What it raises is raised; ``SceneFault`` where the scene may be why and a fresh worker came to the same end.
        """
        try:
            return await self._run(limit, False, function, *arguments)
        except Exception as error:
            if not (limit.of_scene and may_be_the_scenes(error)):
                raise
        try:
            return await self._run(limit, True, function, *arguments)
        except Exception as again:
            raise of_scene(again) from None

    async def _run(
        self, limit: Limit, fresh: bool, function: Callable[[*Args], R], *arguments: *Args
    ) -> tuple[R, float]:
        started = time.perf_counter()
        process = await self._process(fresh)
        ready_s = time.perf_counter() - started
        try:
            result, seconds = await process.run(function, arguments, limit.seconds, limit.memory_bytes)
        finally:
            if process.alive:
                self._idle.append(process)
            else:
                self._all.discard(process)
        return result, seconds + ready_s

    async def _process(self, fresh: bool) -> Process:
        while self._idle and not fresh:
            process = self._idle.pop()
            if process.alive:
                return process
            self._all.discard(process)
            process.end()
        if self._template is None or not self._template.alive:
            if self._template is not None:
                self._template.end()
            self._template = Template.start()
        process = await Process.start(self._template)
        self._all.add(process)
        return process


async def work(function: Callable[[*Args], R], *arguments: *Args) -> R:
    """Run a stage in a worker process of the turn that is held. Without one (a task run by hand) it runs here."""
    turn = _turn.get(None)
    if turn is None:
        return function(*arguments)
    try:
        result, seconds = await turn.pool.run(turn.limit, function, *arguments)
    except (OverLimit, SceneFault, Unforeseen, WorkerDied) as error:
        error.where = turn.name
        raise
    turn.spent_s += seconds
    return result
