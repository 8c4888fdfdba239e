"""A failure that left a trial pending: one line of the trial's ``faults.jsonl``."""

from __future__ import annotations

from typing import Literal

from c4s.errors import Whose
from c4s.records.base import Record


class FaultRecord(Record):
    """What failed in which stage, and whose fault it was. Every repeat of an attempt after one has its cause here."""

    schema_version: Literal["c4s.fault.v1"] = "c4s.fault.v1"
    time: float
    """Unix time, seconds."""
    stage: str
    attempt: int | None = None
    """1 or 2, where the stage belongs to an attempt."""
    whose: Whose
    counted: bool = False
    """Whether it is one of the repeats that an attempt may have: in doubt, and the agent had acted."""
    error: str
    """Class of the error."""
    line: str
    """What went wrong and what to do, as one line."""
    traceback: str = ""
    """Where it was raised, of an error that crossed a process border."""
