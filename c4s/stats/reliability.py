"""Consistency of an agent over runs of one case, as HAL publishes it (Rabanser et al., arXiv 2602.16666, "Consistency";
princeton-pli/hal-harness, ``reliability_eval/metrics``).

Their preprint divided the sample variance by p (1 - p): that quotient is K / (K - 1) for every case that is not always
solved or always failed, so it told only whether runs ever differed. The corrected formula divides p (1 - p) by its
largest value, 1/4. Each number is of one case; a configuration's is the mean over cases that have one.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations
from statistics import fmean

import numpy as np

from c4s.stats.bootstrap import Floats


def outcome_consistency(successes: object, runs: object) -> Floats:
    """(2 p - 1)^2 = 1 - 4 p (1 - p), with the share p of runs that succeed: the corrected formula.

    Args:
        successes: of each case, shape (cases,).
        runs: of each case, same shape.

    Returns:
        In [0, 1]; NaN for fewer than two runs. With K runs its mean is 4 p (1 - p) / K too high.
    """
    share = _share(successes, runs)
    return np.asarray((2 * share - 1) ** 2)


def unbiased_outcome_consistency(successes: object, runs: object) -> Floats:
    """The same without that bias, by the sample variance: 1 - 4 p (1 - p) K / (K - 1). One case may fall below 0."""
    share = _share(successes, runs)
    count = np.asarray(runs, dtype=np.float64)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(1 - 4 * share * (1 - share) * count / (count - 1))


def resource_consistency(resources: Iterable[object]) -> float:
    """exp(-CV), the coefficients of variation (n - 1) averaged over kinds of resource.

    Args:
        resources: of each kind the amounts of a case's runs. What is not above 0 or not known is left out; a kind with
            fewer than two amounts is not measured.

    Returns:
        In (0, 1]; NaN where no kind was measured.
    """
    variations = []
    for amounts in resources:
        given = np.asarray(amounts, dtype=np.float64)
        known = given[given > 0]
        if len(known) > 1:
            variations.append(float(known.std(ddof=1) / known.mean()))
    return float(np.exp(-fmean(variations))) if variations else float("nan")


def trajectory_consistency(calls: object) -> float:
    """1 less the mean Jensen-Shannon distance (natural logarithm) of each two runs' shares of tools.

    Args:
        calls: how often each run called each tool, shape (runs, tools): of the runs that succeeded. A run without a
            call is left out.

    Returns:
        From 1 - sqrt(ln 2) = 0.17, no tool in common, to 1; NaN for fewer than two runs.
    """
    given = np.asarray(calls, dtype=np.float64)
    rows = given[given.sum(axis=1) > 0]
    if len(rows) < 2:
        return float("nan")
    return 1 - fmean(_distance(one, two) for one, two in combinations(rows / rows.sum(axis=1, keepdims=True), 2))


def overall_consistency(aspects: Sequence[float]) -> float:
    """Mean of outcome, trajectory and resource consistency, which weigh alike; NaN is not measured and left out.

    NaN where none was measured.
    """
    known = [value for value in aspects if not np.isnan(value)]
    return fmean(known) if known else float("nan")


def _share(successes: object, runs: object) -> Floats:
    count = np.asarray(runs, dtype=np.float64)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.where(count > 1, np.asarray(successes, dtype=np.float64) / count, np.nan))


def _distance(one: Floats, two: Floats) -> float:
    from scipy.spatial.distance import jensenshannon

    return 0.0 if np.array_equal(one, two) else float(jensenshannon(one, two))
