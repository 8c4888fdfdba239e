"""A benchmark's result, as one row of the table that ``python -m bench`` prints."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Row:
    """``ours`` and ``theirs`` in ``unit``; ``ratio`` is how many times better ours is, None without a rival."""

    name: str
    ours: float
    goal: str
    met: bool
    unit: str = "s"
    rival: str = ""
    theirs: float | None = None
    ratio: float | None = None
