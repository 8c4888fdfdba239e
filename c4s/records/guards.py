"""What may stop a whole run, and what its operator asks of it: two small files of the run folder."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from c4s.records.base import Record

Word = Literal["go", "pause", "drain"]
"""``pause``: no stage starts until ``go``. ``drain``: no attempt starts, what is in work ends, then the run does."""


class Guards(Record):
    """The bounds of a run, as the command that works on it was given them."""

    schema_version: Literal["c4s.guards.v1"] = "c4s.guards.v1"
    since: float
    """When they were set: Unix time, seconds. What failed before does not count."""
    deadline: float | None = None
    """No attempt starts after it: Unix time, seconds."""
    spend_usd: float | None = Field(default=None, ge=0)
    """US dollars that the whole run may spend on models."""
    judge_usd: float | None = Field(default=None, ge=0)
    """US dollars that the whole run may spend on its judge."""
    judge_tokens: int | None = Field(default=None, ge=0)
    """Tokens that the whole run's judge may use."""
    accept_faults: bool = False
    """Whether a claim whose request fails for good is put on record as an error, worth 0."""
    most_faults: int = Field(ge=1)
    """So many trials in a row may fail for one cause."""


class Instruction(Record):
    """What somebody asked of a run, the last time that somebody did."""

    schema_version: Literal["c4s.asked.v1"] = "c4s.asked.v1"
    word: Word
    of: float
    """The bounds that it was asked under, by their ``since``: it says nothing of a later start."""
    time: float
    """Unix time, seconds."""
    by: str
    """User and machine, for people."""
