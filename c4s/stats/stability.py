"""How firmly a leaderboard stands when its sources are drawn again (ours)."""

from __future__ import annotations

import numpy as np

from c4s.stats.bootstrap import Floats
from c4s.stats.ranks import competition_ranks


def rank_shares(drawn: Floats) -> Floats:
    """Share of draws in which each configuration has each rank; shared ranks count at their smallest.

    Args:
        drawn: scores, shape (draws, configurations).

    Returns:
        Shape (configurations, ranks): rows sum to 1.
    """
    ranks = competition_ranks(drawn)
    count = drawn.shape[1]
    return np.stack([(ranks == rank).mean(axis=0) for rank in range(1, count + 1)], axis=1)


def above_shares(drawn: Floats) -> Floats:
    """Share of draws in which the row's configuration scores above the column's; a tie is half of each.

    Args:
        drawn: scores, shape (draws, configurations).

    Returns:
        Shape (configurations, configurations): with its transpose it sums to 1, on the diagonal it is 1/2.
    """
    count = drawn.shape[1]
    shares = np.empty((count, count))
    for place in range(count):
        difference = drawn[:, place, None] - drawn
        shares[place] = (difference > 0).mean(axis=0) + 0.5 * (difference == 0).mean(axis=0)
    return shares


def order_agreements(observed: Floats, drawn: Floats) -> Floats:
    """Agreement of each draw with the observed order: pairs in the same order less turned ones, by all pairs.

    A pair that is tied in both is in the same order, one that is tied in one of them counts for neither;
    without ties it is Kendall's tau.

    Args:
        observed: scores, shape (configurations,), two or more.
        drawn: shape (draws, configurations).

    Returns:
        Shape (draws,), in [-1, 1].
    """
    upper, lower = np.triu_indices(len(observed), 1)
    seen = np.sign(observed[upper] - observed[lower])
    found = np.sign(drawn[:, upper] - drawn[:, lower])
    return np.asarray(np.where((found == 0) & (seen == 0), 1.0, found * seen).mean(axis=1))
