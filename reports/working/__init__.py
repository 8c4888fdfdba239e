"""Worked scoring: every number of a case score from its parts, computed anew from what the verdicts hold."""

from __future__ import annotations

from reports.working.flow import Addend, Step, Working
from reports.working.score import worked_score

__all__ = ["Addend", "Step", "Working", "worked_score"]
