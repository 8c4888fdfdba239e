"""Trials on work pools: flow runs of the deployments ``trial/<pool>``, as many ahead as keeps the workers busy.

A coordinator knows what became of a part of the work by what is on record in the trial's folder, never by what Prefect
says; Prefect tells it only when to look. A part that ended without a record was lost with its worker, and is asked for
again.
"""

from __future__ import annotations

import asyncio
import time
import uuid
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import islice, takewhile
from typing import Any, Final

from prefect import runtime
from prefect.client.orchestration import PrefectClient, get_client
from prefect.client.schemas.filters import (
    FlowFilter,
    FlowFilterName,
    FlowRunFilter,
    FlowRunFilterId,
    FlowRunFilterState,
    FlowRunFilterStateType,
    FlowRunFilterTags,
)
from prefect.client.schemas.objects import FlowRun, StateType
from prefect.deployments import run_deployment
from prefect.states import Cancelled, Crashed

from c4s.agents.base import ModelClient, agent_of
from c4s.errors import BadInput, MachineryFault
from c4s.records.folder import HANDOVER, is_result
from c4s.records.handover import Handover, WorkPool
from c4s.records.plan import Plan
from c4s.run.drive import Pending
from c4s.run.guards import StoppedByGuard
from c4s.run.lease import Held, in_force
from c4s.run.overseer import Overseer
from c4s.run.plan import Trial
from c4s.run.repeats import note_lost
from c4s.run.store import open_store

LOOK_S: Final = 2.0
MOST_LOST: Final = 3
"""How often one trial's work may be lost with a worker before the trial is left pending."""
SILENT_S: Final = 90.0
"""After so long without a sign of life from any of its trials, a flow run that is said to run is lost."""
BATCH: Final[dict[WorkPool, int]] = {"engines": 8, "verifiers": 16, "judges": 4}
"""Most trials of one flow run. A trial whose agent is a program with a model has a flow run of its own."""
AHEAD: Final[dict[WorkPool, int]] = {"engines": 4, "verifiers": 1, "judges": 1}
"""Flow runs that wait for a worker, beside as many as run. Where few wait, they carry more trials each."""
PAGE: Final = 200
"""Flow runs of one answer: the server's most."""
_OVER: Final = frozenset({StateType.COMPLETED, StateType.FAILED, StateType.CRASHED, StateType.CANCELLED})
_WAITING: Final = [StateType.SCHEDULED, StateType.PENDING]


class WorkerLost(MachineryFault):
    """A worker ended, or was cut off, in the middle of its part of a trial."""


@dataclass
class _Sent:
    """A flow run, and the trials that were given to it."""

    part: str
    pool: WorkPool
    trials: list[Trial]
    running: bool = False
    silent_since: float = field(default_factory=time.monotonic)


@dataclass
class Coordinator:
    """Brings the trials of a run to their end on work pools.

    Args:
        plan: the run's plan.
        held: the lease of the run.
        overseer: the watch over the run: while it is paused nothing is sent, and where it is stopped no attempt.
        tell: is given a line when something happens that an operator wants to know.
    """

    plan: Plan
    held: Held
    overseer: Overseer
    tell: Callable[[str], None]
    _queue: dict[WorkPool, list[tuple[Trial, bool]]] = field(
        default_factory=lambda: {"engines": [], "verifiers": [], "judges": []}
    )
    _sent: dict[Any, _Sent] = field(default_factory=dict)
    _lost: Counter[str] = field(default_factory=Counter)
    _pending: dict[str, Pending] = field(default_factory=dict)

    async def run(self, trials: Sequence[Trial]) -> list[Pending]:
        """Run trials, best first; those that are pending at the end, in their order."""
        async with get_client() as client:
            await self._end_earlier(client)
            given = await self._adopt(client, {trial.name: trial for trial in trials})
            for trial in trials:
                if trial.name not in given:
                    pool, whole = _first_pool(trial)
                    self._queue[pool].append((trial, whole))
            while self._sent or any(self._queue.values()):
                await self.held.check_beside()
                await self.overseer.look_beside()
                if self.overseer.stopped is not None:
                    self._leave(self.overseer.stopped)
                if not self.overseer.paused:
                    await self._send(client)
                await asyncio.sleep(LOOK_S)
                await self._look(client)
        return [self._pending[trial.name] for trial in trials if trial.name in self._pending]

    async def _adopt(self, client: PrefectClient, trials: dict[str, Trial]) -> set[str]:
        """Go on with what an earlier coordinator of the run left in work; take back what no worker has begun."""
        given: set[str] = set()
        for run in await self._left(client):
            names = [name for name in run.parameters.get("trials", ()) if name in trials]
            if run.state_type in _WAITING or not names:
                await client.set_flow_run_state(run.id, Cancelled(message="another coordinator took over"), force=True)
                continue
            sent = _Sent(run.parameters["part"], run.parameters["pool"], [trials[name] for name in names])
            self._sent[run.id] = sent
            given |= set(names)
        return given

    async def _end_earlier(self, client: PrefectClient) -> None:
        """Earlier flow runs that led this run have ended, as its lease is here: where the server does not know it, a
        process was killed with whoever would have told."""
        leading = await client.read_flow_runs(
            flow_filter=FlowFilter(name=FlowFilterName(any_=["evaluate"])),
            flow_run_filter=FlowRunFilter(
                state=FlowRunFilterState(type=FlowRunFilterStateType(any_=[StateType.RUNNING]))
            ),
        )
        for run in leading:
            led = run.parameters.get("run_id") or run.parameters.get("suite")
            if led == self.plan.run_id and str(run.id) != runtime.flow_run.id:
                await client.set_flow_run_state(run.id, Crashed(message="another coordinator took over"), force=True)

    async def _left(self, client: PrefectClient) -> list[FlowRun]:
        """The flow runs of this run that are not over."""
        found: list[FlowRun] = []
        while True:
            page = await client.read_flow_runs(
                flow_filter=FlowFilter(name=FlowFilterName(any_=["trial"])),
                flow_run_filter=FlowRunFilter(
                    tags=FlowRunFilterTags(all_=[self._tag]),
                    state=FlowRunFilterState(type=FlowRunFilterStateType(any_=[*_WAITING, StateType.RUNNING])),
                ),
                limit=PAGE,
                offset=len(found),
            )
            found += page
            if len(page) < PAGE:
                return found

    async def _send(self, client: PrefectClient) -> None:
        """Give work to the pools, as long as there is some and not much waits already."""
        for pool, queue in self._queue.items():
            while queue and self._wants(pool):
                batch = self._next(pool)
                del queue[: len(batch)]
                await self._start(pool, [trial for trial, _ in batch], batch[0][1])

    def _leave(self, stopped: StoppedByGuard) -> None:
        """Leave the trials whose next stage is an engine's; what is in work ends, is verified and scored."""
        for trial, _ in self._queue["engines"]:
            self._pending[trial.name] = Pending(trial, stopped)
        self._queue["engines"].clear()

    def _wants(self, pool: WorkPool) -> bool:
        """Whether a flow run more is of use: some wait for a worker, and as many more as workers have."""
        sent = [one for one in self._sent.values() if one.pool == pool]
        running = sum(one.running for one in sent)
        return len(sent) - running < AHEAD[pool] + running

    def _next(self, pool: WorkPool) -> list[tuple[Trial, bool]]:
        """The next trials for one flow run: of one kind, and so many that every worker gets its share of the rest."""
        queue = self._queue[pool]
        first, whole = queue[0]
        if whole or _is_long(first, pool):
            return queue[:1]
        most = max(1, min(BATCH[pool], len(queue) // AHEAD[pool]))
        same = takewhile(lambda entry: not entry[1] and not _is_long(entry[0], pool), queue)
        return list(islice(same, most))

    async def _start(self, pool: WorkPool, trials: list[Trial], whole: bool) -> None:
        part = uuid.uuid4().hex
        run: FlowRun = await run_deployment(  # type: ignore[misc]
            f"trial/{pool}",
            parameters={
                "run_id": self.plan.run_id,
                "trials": [trial.name for trial in trials],
                "pool": pool,
                "part": part,
                "whole": whole,
            },
            flow_run_name=trials[0].name if len(trials) == 1 else f"{trials[0].name} and {len(trials) - 1} more",
            tags=[self._tag],
            timeout=0,
            as_subflow=False,
            idempotency_key=part,
        )
        self._sent[run.id] = _Sent(part, pool, trials)

    async def _look(self, client: PrefectClient) -> None:
        """See which flow runs have ended, and what became of their trials."""
        ids = list(self._sent)
        by_id: dict[Any, FlowRun] = {}
        for first in range(0, len(ids), PAGE):
            asked = FlowRunFilter(id=FlowRunFilterId(any_=ids[first : first + PAGE]))
            by_id |= {run.id: run for run in await client.read_flow_runs(flow_run_filter=asked, limit=PAGE)}
        for id_ in ids:
            run = by_id.get(id_)
            if run is None or run.state_type in _OVER:
                self._ended(self._sent.pop(id_), "no flow run" if run is None else str(run.state_name))
            elif run.state_type in (StateType.RUNNING, StateType.PENDING) and await self._is_silent(self._sent[id_]):
                await client.set_flow_run_state(id_, Crashed(message="no sign of life"), force=True)
                self._ended(self._sent.pop(id_), "no sign of life")
            else:
                self._sent[id_].running = run.state_type == StateType.RUNNING
                if run.state_type == StateType.SCHEDULED:
                    self._sent[id_].silent_since = time.monotonic()

    async def _is_silent(self, sent: _Sent) -> bool:
        """Whether none of its trials has been held for too long."""
        if await asyncio.to_thread(_any_held, sent.trials):
            sent.silent_since = time.monotonic()
        return time.monotonic() - sent.silent_since > SILENT_S

    def _ended(self, sent: _Sent, how: str) -> None:
        store = open_store()
        for trial in sent.trials:
            store.pull(trial.folder.root, lambda name: name == HANDOVER or is_result(name))
            handover = _handover(trial)
            if handover is None or handover.part != sent.part:
                self._lose(trial, sent.pool, how)
            elif handover.ended == "handed_over" and handover.pool is not None:
                self._queue[handover.pool].append((trial, handover.whole))
            elif handover.ended == "stopped":
                self.overseer.look()
                if self.overseer.stopped is None:
                    self._lose(trial, sent.pool, handover.line)
                else:
                    self._pending[trial.name] = Pending(trial, self.overseer.stopped)
            elif handover.ended == "pending":
                kind = BadInput if handover.bad_input else MachineryFault
                self._pending[trial.name] = Pending(trial, self.overseer.stopped or kind(handover.line))

    def _lose(self, trial: Trial, pool: WorkPool, how: str) -> None:
        """Ask again for what was lost, unless it was lost too often. It is the machinery's, and counts no attempt."""
        self._lost[trial.name] += 1
        error = WorkerLost(f"a worker of the pool {pool!r} was lost at work ({how})", where=trial.name)
        if not open_store().apart:
            note_lost(trial, error)
        if self._lost[trial.name] > MOST_LOST:
            self._pending[trial.name] = Pending(trial, error)
            return
        self.tell(f"{error.line()}: asked for again")
        self._queue[pool].insert(0, (trial, False))

    @property
    def _tag(self) -> str:
        return f"run:{self.plan.run_id}"


def _first_pool(trial: Trial) -> tuple[WorkPool, bool]:
    """Where a trial goes on, and whether it is finished there: where it was handed over to, else with an engine."""
    handover = _handover(trial)
    return ("engines", False) if handover is None or handover.pool is None else (handover.pool, handover.whole)


def _handover(trial: Trial) -> Handover | None:
    try:
        return Handover.read(trial.folder.handover)
    except BadInput:
        return None


def _is_long(trial: Trial, pool: WorkPool) -> bool:
    """Whether a flow run of its own is worth its start: an agent with a model works for minutes to hours."""
    return pool == "engines" and isinstance(agent_of(trial.working), ModelClient)


def _any_held(trials: Sequence[Trial]) -> bool:
    return any(in_force(open_store().leases(trial.folder.leases)) for trial in trials)
