"""Chances of success in several runs, without bias: pass@k (Chen et al., arXiv 2107.03374), pass^k (tau-bench)."""

from __future__ import annotations

import numpy as np

from c4s.stats.bootstrap import Floats


def pass_at(successes: object, runs: object, k: int) -> Floats:
    """Chance that at least one of k runs succeeds: 1 - C(n - c, k) / C(n, k).

    Args:
        successes: c of each case, whole numbers, shape (cases, ...).
        runs: n of each case, of a shape that fits.
        k: how many runs, from 1.

    Returns:
        The shape of both; NaN where a case has fewer than k runs.
    """
    return _share(1.0, -1.0, np.asarray(runs) - np.asarray(successes), np.asarray(runs), k)


def pass_all(successes: object, runs: object, k: int) -> Floats:
    """Chance that each of k runs succeeds: C(c, k) / C(n, k). Arguments and answer as of ``pass_at``."""
    return _share(0.0, 1.0, np.asarray(successes), np.asarray(runs), k)


def _share(start: float, sign: float, hits: Floats, runs: Floats, k: int) -> Floats:
    if k < 1:
        raise ValueError("one run or more is expected")
    from scipy.special import comb

    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.where(runs >= k, start + sign * comb(hits, k) / comb(runs, k), np.nan))
