"""How many sources, cases or repeats tell two configurations apart (ours; after Miller, arXiv 2411.00640, and Bloom
1995 for few groups).

The mean of paired differences varies because other sources could have been drawn, and because every run falls out
otherwise. More sources lessen both parts, more repeats of the same cases only the second.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

import numpy as np

from c4s.stats.bootstrap import LEVEL, Design, Floats

POWER: Final = 0.8
"""How probable it is to be that a true difference is found."""
MOST: Final = 100_000
"""Beyond so many sources or repeats the answer is: none."""


def clustered_variances(design: Design, values: object) -> Floats:
    """Variance of each domain's mean over draws of clusters: residuals of clusters, linearised, n / (n - 1).

    Args:
        values: shape (cases,) or (cases, columns), finite.

    Returns:
        Shape (domains, columns). NaN for a domain of one cluster.
    """
    given = np.asarray(values, dtype=np.float64)
    table = given.reshape(len(given), -1)
    variances = np.full((len(design.domains), table.shape[1]), np.nan)
    domain_of_case = design.domain_of[design.cluster_of]
    for domain in range(len(design.domains)):
        own = domain_of_case == domain
        _, numbers = np.unique(design.cluster_of[own], return_inverse=True)
        count = int(numbers.max()) + 1
        if count > 1:
            sums = np.zeros((count, table.shape[1]))
            np.add.at(sums, numbers, table[own] - table[own].mean(axis=0))
            variances[domain] = count / (count - 1) * (sums**2).sum(axis=0) / own.sum() ** 2
    return variances


def multiplier(freedom: float, level: float = LEVEL, power: float = POWER) -> float:
    """How many standard errors a true difference has to be so as to be found with this power, two-sided."""
    from scipy.special import stdtrit

    return float(stdtrit(freedom, (1 + level) / 2) + stdtrit(freedom, power))


def detectable(variance: float, freedom: float, level: float = LEVEL, power: float = POWER) -> float:
    """The least true difference that is found with this power.

    Args:
        variance: of the mean difference.
        freedom: degrees of freedom: clusters less domains.
    """
    return multiplier(freedom, level, power) * math.sqrt(variance)


def sources_needed(
    difference: float, variance: float, sources: int, domains: int, level: float = LEVEL, power: float = POWER
) -> int | None:
    """How many sources in all, shared among domains as now, find a true difference; None beyond ``MOST``.

    Args:
        variance: of the mean difference with ``sources``, above 0; it falls as their number grows.
    """

    def enough(count: int) -> bool:
        return detectable(variance * sources / count, count - domains, level, power) <= abs(difference)

    return _least(enough, domains + 1)


def repeats_needed(
    difference: float,
    variance: float,
    of_runs: float,
    repeats: int,
    freedom: float,
    *,
    level: float = LEVEL,
    power: float = POWER,
) -> int | None:
    """How many repeats of the same cases find a true difference; None where no number of them does.

    Args:
        variance: of the mean difference with ``repeats``.
        of_runs: the part of it that comes of runs; it falls as repeats grow.
    """

    def enough(count: int) -> bool:
        left = max(0.0, variance - of_runs) + of_runs * repeats / count
        return detectable(left, freedom, level, power) <= abs(difference)

    return _least(enough, 1)


def _least(enough: Callable[[int], bool], first: int) -> int | None:
    """The first whole number from ``first`` on that is enough, where all after it are; None beyond ``MOST``."""
    if not enough(MOST):
        return None
    low, high = first - 1, MOST
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if enough(middle) else (middle, high)
    return high
