"""Where a trial stands when a work pool lets go of it."""

from __future__ import annotations

from typing import Literal

from c4s.records.base import Record

WorkPool = Literal["engines", "verifiers", "judges"]
"""A kind of worker: attempts and evidence; verifiers, scores and rows; requests to a model judge."""


class Handover(Record):
    """What became of a trial in one part of its work. The last one replaces those before."""

    schema_version: Literal["c4s.handover.v1"] = "c4s.handover.v1"
    part: str
    """Id of the part of the work, given by who asked for it."""
    ended: Literal["done", "handed_over", "pending", "stopped"]
    """``stopped``: a guard kept it from its next attempt."""
    pool: WorkPool | None = None
    """Which pool has the next stage, where it was handed over."""
    whole: bool = False
    """Whether that pool finishes the trial, whatever the kind of its stages."""
    line: str = ""
    """What keeps it pending, in a line."""
    bad_input: bool = False
    """Whether what the user gave keeps it pending."""
