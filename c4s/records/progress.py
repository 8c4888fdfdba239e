"""How far a run is, as one record: for the terminal, the status page, programs and a scheduler's own pages."""

from __future__ import annotations

from typing import Literal

from c4s.records.base import Record

State = Literal["running", "paused", "stopping", "stopped", "done", "idle"]
"""``stopping``: no attempt starts any more. ``stopped``: a guard ended it. ``idle``: nobody works on it."""


class Running(Record):
    """A stage in work."""

    configuration: str
    case: str
    repeat: int
    stage: str
    attempt: int | None = None
    seconds: float
    """Since it started."""
    host: str
    calls: int | None = None
    """Tool calls of an attempt so far, of ``calls_budget``."""
    calls_budget: int | None = None
    wall_budget_s: float | None = None


class Standing(Record):
    """A configuration of the run so far."""

    configuration: str
    planned: int
    done: int
    pending: int
    """Trials that failed and are not begun again."""
    scored: int
    """Trials behind ``mean_score``: those that this run holds."""
    mean_score: float | None = None
    """Over what is done so far: no result, and never ranked."""
    cost_usd: float | None = None
    """Null where no attempt told a cost."""


class Trouble(Record):
    """Trials that are pending for one cause."""

    error: str
    trials: int
    line: str
    """Why, of the last one."""
    faults: str
    """Path of the last one's record of faults."""


class Slot(Record):
    """Slots of one kind."""

    kind: str
    count: int
    busy: int


class Snapshot(Record):
    """A run at one moment."""

    schema_version: Literal["c4s.progress.v1"] = "c4s.progress.v1"
    run_id: str
    suite_id: str
    state: State
    why: str = ""
    """Of a run that is paused, stopping or stopped."""
    time: float
    """Unix time, seconds."""
    holder: str | None = None
    """Who works on it."""
    planned: int
    done: int
    reused: int
    """Of ``done``: trials that another run holds."""
    pending: int
    waiting: int
    """Trials that are neither done, nor pending, nor in work."""
    running: list[Running]
    slots: list[Slot]
    standings: list[Standing]
    troubles: list[Trouble]
    spent_usd: float | None = None
    """As the run's spending is booked, open requests at their estimate; null where nothing is."""
    spend_limit_usd: float | None = None
    deadline: float | None = None
    """Unix time, seconds."""
    left_s: float | None = None
    """Estimate from the stage times of this run and its slots; null before a trial is done."""

    @property
    def going(self) -> bool:
        """Whether somebody works on it."""
        return self.state in ("running", "paused", "stopping")
