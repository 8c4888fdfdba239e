"""One line of a run's journal: what was begun, ended or failed, when and where.

A process that works on the run writes a journal of its own, so nobody waits for a lock and no line is torn by another
one. Journals are for watching: what is done is decided by the files of the trials, and a run without them is whole.
"""

from __future__ import annotations

from typing import Literal

from c4s.errors import Whose
from c4s.records.base import Record
from c4s.records.lease import Owner

What = Literal["begun", "started", "ended", "failed", "done", "pending", "paused", "going", "stopped", "over"]
"""``begun``, ``over``: a process began or ended its work on the run. ``started``, ``ended``, ``failed``: a stage.
``done``, ``pending``: a trial. ``paused``, ``going``, ``stopped``: the run, and why."""


class Event(Record):
    """A line. What does not belong to its kind is absent from the file."""

    time: float
    """Unix time, seconds."""
    event: What
    owner: Owner | None = None
    """``begun``: the process that writes."""
    slots: dict[str, int] | None = None
    """``begun``: slots by kind."""
    reused: dict[str, int] | None = None
    """``begun``: trials that another run holds, by configuration."""
    trial: str | None = None
    """``configuration/alias/r<k>``: the trial's folder below the run's."""
    stage: str | None = None
    attempt: int | None = None
    """1 or 2, of a stage that belongs to an attempt."""
    verifier: str | None = None
    """Of the stage that verifies."""
    kind: str | None = None
    """Which kind of slot the stage holds."""
    seconds: float | None = None
    """What the stage took in its slot."""
    ended_by: str | None = None
    """How an attempt ended."""
    cost_usd: float | None = None
    """What an attempt cost; absent where that is unknown, or nothing was asked of a model."""
    score: float | None = None
    status: str | None = None
    """Status of a trial's score."""
    error: str | None = None
    """Class of an error, or name of what the machine was short of."""
    whose: Whose | None = None
    line: str | None = None
    """Why, as one line."""

    def line_of_file(self) -> bytes:
        """It, as a line of a journal."""
        return self.model_dump_json(exclude_none=True).encode("utf-8", "replace") + b"\n"
