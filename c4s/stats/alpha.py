"""Krippendorff's alpha: one less the disagreement that was observed by the one that chance would give.

Within a unit each ordered pair of its n values counts 1/(n - 1); by chance each pair of all N values of units that have
two or more counts 1/(N - 1). 1 is full agreement, 0 what chance gives.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from c4s.stats.bootstrap import Floats


def interval_alpha(scores: Floats) -> float | None:
    """Of judges on an interval scale, where two values disagree by the square of their difference.

    Args:
        scores: a row a judge, shape (judges, things), finite, two judges or more.

    Returns:
        None where all scores are equal.
    """
    if np.ptp(scores) == 0:
        return None
    judges, everything = scores.shape[0], scores.size
    observed = (judges / (judges - 1)) * ((scores - scores.mean(axis=0)) ** 2).sum()
    expected = (everything / (everything - 1)) * ((scores - scores.mean()) ** 2).sum()
    return float(1 - observed / expected)


def nominal_alphas(counts: Floats, group: NDArray[np.int64], drawn: NDArray[np.int64]) -> Floats:
    """Of labels, where two values disagree or do not: one alpha a draw of whole groups of units.

    Args:
        counts: how often a unit was given each label, shape (units, labels).
        group: the group of each unit, shape (units,), from 0.
        drawn: the groups of each draw, shape (draws, groups of it); a group may come more than once.

    Returns:
        Shape (draws,); NaN where no unit has two values, or all of them have one label.
    """
    given = counts.sum(axis=1)
    pairable = given > 1
    disagreement = np.zeros(len(counts))
    some, size = counts[pairable], given[pairable]
    disagreement[pairable] = (size**2 - (some**2).sum(axis=1)) / (size - 1)
    labels = np.where(pairable[:, None], counts, 0.0)
    by_group = np.zeros((int(group.max(initial=-1)) + 1, 1 + labels.shape[1]))
    np.add.at(by_group, group, np.column_stack([disagreement, labels]))
    sums = by_group[drawn].sum(axis=1)
    observed, labels = sums[:, 0], sums[:, 1:]
    everything = labels.sum(axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        expected = (everything**2 - (labels**2).sum(axis=1)) / (everything - 1)
        return np.asarray(np.where(expected > 0, 1 - observed / expected, np.nan))
