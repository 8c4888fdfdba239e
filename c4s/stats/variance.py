"""How much of the spread of scores lies between cases and how much between runs of one case (ours).

One-way random effects: a score is its case's own level and what the run adds. Mean squares give both variances without
bias, also where cases have unlike numbers of runs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from c4s.stats.bootstrap import Floats

ROUNDING: Final = 1e-24
"""Variances of scores in [0, 1] that are smaller are of equal scores."""


@dataclass(frozen=True)
class Spread:
    """Variances of scores. None where there is nothing to tell them by: one case, or no case with two runs."""

    cases: int
    runs: int
    between_cases: float | None
    """Estimated without bias, so it may fall below 0 where cases differ less than runs do."""
    between_runs: float | None
    intraclass: float | None
    """Share of the variance that is the cases', in [0, 1]; 1: every run of a case comes out the same."""


def spread(scores: object) -> Spread:
    """Variances of a table of runs.

    Args:
        scores: shape (cases, runs); NaN where a case has fewer runs. A case without any is left out.
    """
    given = np.asarray(scores, dtype=np.float64)
    known = ~np.isnan(given)
    table, known = given[known.any(axis=1)], known[known.any(axis=1)]
    runs = known.sum(axis=1)
    cases, total = len(table), int(runs.sum())
    if total == cases:
        return Spread(cases, total, None, None, None)
    filled = np.where(known, table, 0.0)
    means = filled.sum(axis=1) / runs
    within = float((np.where(known, table - means[:, None], 0.0) ** 2).sum() / (total - cases))
    if cases < 2:
        return Spread(cases, total, None, within, None)
    of_cases = float((runs * (means - filled.sum() / total) ** 2).sum() / (cases - 1))
    typical = (total - float((runs**2).sum()) / total) / (cases - 1)
    between = (of_cases - within) / typical
    kept = max(0.0, between)
    return Spread(cases, total, between, within, kept / (kept + within) if kept + within > ROUNDING else None)


def run_variances(scores: object) -> Floats:
    """Sample variance of each case's runs, shape (cases,); NaN where a case has fewer than two.

    Args:
        scores: shape (cases, runs), NaN where a case has fewer runs.
    """
    given = np.asarray(scores, dtype=np.float64)
    known = ~np.isnan(given)
    runs = known.sum(axis=1)
    filled = np.where(known, given, 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        means = filled.sum(axis=1) / runs
        squares = (np.where(known, given - means[:, None], 0.0) ** 2).sum(axis=1)
        return np.asarray(np.where(runs > 1, squares / (runs - 1), np.nan))
