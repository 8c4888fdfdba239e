"""Who works on a run tells the overseer what is begun and ended, and asks it whether more may be.

It writes the journal, hands each event to those who listen (logs, telemetry, notices), and looks at the guards.
"""

from __future__ import annotations

import asyncio
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from c4s.meter.spending import SpendingLimitReached
from c4s.records.folder import RunFolder
from c4s.records.journal import Event, What
from c4s.records.score import TrialScore
from c4s.run.faults import whose
from c4s.run.guards import StoppedByGuard, Watchman, cause_of, fetch_guards, reason_of, spent_up, stop
from c4s.run.headroom import LOOK_S, print_line
from c4s.run.journal import Journal, now
from c4s.run.limits import Kind, Stage
from c4s.run.plan import Trial
from c4s.run.sharing import FETCH_S, Sharing
from c4s.run.slots import Slots
from c4s.run.store import StoreFault, open_store

Listener = Callable[[Event], None]
"""Is given every event of this process, on the thread that works on the run: it returns at once and raises nothing."""


def folder_name(trial: Trial) -> str:
    """``configuration/alias/r<k>``: the trial's folder below the run's."""
    return trial.folder.root.relative_to(trial.run).as_posix()


class Overseer:
    """The watch over a run for as long as this process works on it.

    Args:
        run: the run folder, which has its plan and its guards.
        listeners: who is told each event.
        tell: is given a line where the run pauses, goes on, or is stopped.
    """

    def __init__(self, run: Path, listeners: Sequence[Listener] = (), tell: Callable[[str], None] = print_line) -> None:
        self._run = RunFolder(run)
        self._journal = Journal(self._run)
        self._sharing = Sharing(self._run, self._journal.path)
        self._listeners = (*listeners,)
        self._tell = tell
        self._watchman = Watchman(self._run)
        self._deaf = False
        self._fetch_at = 0.0
        self.paused = False
        self.stopped: StoppedByGuard | None = None

    def begin(self, slots: Mapping[Kind, Slots], reused: Counter[str] | None = None) -> None:
        """This process begins its work on the run.

        Args:
            slots: what it has.
            reused: trials of the plan that another run holds, by configuration.
        """
        counts = {kind: one.count for kind, one in slots.items()}
        self._note("begun", owner=self._journal.owner, slots=counts, reused=dict(reused or {}))
        self.look()

    def end(self) -> None:
        """This process's work on the run is over."""
        self._note("over")
        self._journal.close()
        with suppress(StoreFault):
            self._sharing.send()

    def look(self) -> None:
        """Look at the guards. What stopped the run once stops it for good."""
        if self.stopped is not None:
            return
        paused, stopped = self._watchman.look()
        if stopped is not None:
            self.stop(stopped)
        elif paused != self.paused:
            self.paused = paused
            self._note("paused" if paused else "going")
            self._tell("paused, as asked: no stage starts (`c4s runs go-on` ends that)" if paused else "going on")

    async def look_beside(self) -> None:
        """``look``, now and then with what other machines asked, did and spent, where they share a store. One that does
        not answer for a while is asked again: what hangs on it is the lease."""
        if open_store().apart and time.monotonic() >= self._fetch_at:
            self._fetch_at = time.monotonic() + FETCH_S
            with suppress(StoreFault):
                await asyncio.to_thread(self._exchange)
        self.look()

    def _exchange(self) -> None:
        fetch_guards(self._run)
        self._sharing.exchange()

    def stop(self, stopped: StoppedByGuard) -> None:
        """No attempt starts from now on."""
        if self.stopped is None:
            self.stopped, self.paused = stopped, False
            self._note("stopped", error=stopped.guard, line=stopped.what)
            self._tell(f"stopping: {stopped.what}; attempts in work end and are scored, none is started")

    def holds(self, stage: Stage, trial: Trial, arguments: tuple[Any, ...]) -> bool:
        """Whether the stage may not start now: the run is paused, or stopped and the stage is a new attempt."""
        return self.paused or (
            stage == "attempt" and self.stopped is not None and not trial.folder.attempt(*arguments).done
        )

    async def may_start(self, stage: Stage, trial: Trial, arguments: tuple[Any, ...]) -> None:
        """Wait while the run is paused. ``StoppedByGuard`` for a new attempt of a run that is stopped."""
        while self.paused:
            await asyncio.sleep(LOOK_S)
            self.look()
        if self.stopped is not None and self.holds(stage, trial, arguments):
            raise self.stopped

    @contextmanager
    def stage(
        self, stage: Stage, trial: Trial, arguments: tuple[Any, ...], kind: Kind
    ) -> Iterator[Callable[[Any], None]]:
        """A stage that holds its slot; the block gives what the stage returned to what it is given."""
        told: dict[str, Any] = {"trial": folder_name(trial), "stage": stage, "kind": kind}
        told |= {"attempt" if isinstance(one, int) else "verifier": one for one in arguments[:1] if stage != "control"}
        made: list[Any] = []
        self._note("started", **told)
        started = time.perf_counter()
        try:
            yield made.append
        except asyncio.CancelledError:
            raise
        except Exception as error:
            took = round(time.perf_counter() - started, 3)
            self._note("failed", **told, seconds=took, error=cause_of(error), line=reason_of(error))
            raise
        if stage == "attempt" and made:
            told |= {"ended_by": made[0].ended_by, "cost_usd": made[0].cost_usd}
        self._note("ended", **told, seconds=round(time.perf_counter() - started, 3))

    def done(self, trial: Trial, score: TrialScore) -> None:
        """A trial is done."""
        self._note("done", trial=folder_name(trial), score=score.score, status=score.status)

    def pending(self, trial: Trial, error: Exception) -> None:
        """A trial could not be finished. One that was not begun, or not repeated, for a guard is no failure."""
        if isinstance(error, StoppedByGuard):
            return
        told = {"error": cause_of(error), "whose": whose(error, "elsewhere"), "line": reason_of(error)}
        self._note("pending", trial=folder_name(trial), **told)
        if isinstance(error, SpendingLimitReached):
            self.stop(spent_up(error))
        self.look()

    def _note(self, what: What, **fields: Any) -> None:
        event = Event(time=now(), event=what, **fields)
        try:
            self._journal(event)
        except OSError as error:
            if not self._deaf:
                self._tell(f"the journal takes nothing, so what is shown of this run is incomplete: {error}")
            self._deaf = True
        for listener in self._listeners:
            listener(event)


def signalled(name: str) -> StoppedByGuard:
    """What a signal to end stops a run with."""
    return stop("signal", f"{name} asked it to end")
