"""What the pages of cases and trials are made of: runs and their ranks, comparisons, judgements, timelines."""

from __future__ import annotations

from reports.case.asked import CaseRows, case_rows
from reports.case.matrix import Matrix, matrix_of
from reports.case.pair import RunPair, pair_of
from reports.case.renders import Renders, renders_of
from reports.case.requirements import requirement_rows
from reports.case.runs import CaseRun, case_runs, higher_and_lower
from reports.case.timeline import Attempt, attempts_of
from reports.case.trace import trace_of
from reports.case.walk import FALLS, WalkMap, astray, walk_of

__all__ = [
    "FALLS",
    "Attempt",
    "CaseRows",
    "CaseRun",
    "Matrix",
    "Renders",
    "RunPair",
    "WalkMap",
    "astray",
    "attempts_of",
    "case_rows",
    "case_runs",
    "higher_and_lower",
    "matrix_of",
    "pair_of",
    "renders_of",
    "requirement_rows",
    "trace_of",
    "walk_of",
]
