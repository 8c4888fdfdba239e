"""What an agent got in a harness."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Made:
    """A reward as it arrived in the harness, and the one that c4s gives."""

    agent: str
    reward: float | None
    expected: float
    note: str = ""
