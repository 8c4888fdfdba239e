"""How two scorings of the same configurations agree: differences, correlations, reversed pairs (paper, "Public and
Private Sets" and "Repair-weight sensitivity").

Scores are arrays with a number a configuration, in the same order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Final

import numpy as np

from c4s.stats.bootstrap import Floats, Integers
from c4s.stats.ranks import settled
from c4s.stats.repeats import tau_b

REVERSED_GAP: Final = 0.02
"""Least difference of two configurations whose order counts as known (paper, tab:public-set-size)."""


@dataclass(frozen=True)
class Differences:
    """What estimates are off by."""

    mean_absolute: float
    largest: float
    mean: float
    """Signed: estimate less truth."""


def differences(estimate: Floats, truth: Floats) -> Differences:
    """What an estimate of each configuration's score is off by; shape (configurations,), at least one."""
    delta = estimate - truth
    return Differences(float(np.abs(delta).mean()), float(np.abs(delta).max()), float(delta.mean()))


def reversed_pairs(estimate: Floats, truth: Floats, gap: float = REVERSED_GAP) -> list[tuple[int, int]]:
    """Pairs that differ by at least ``gap`` in truth and strictly the other way round in the estimate."""
    return [
        (one, two)
        for one, two in combinations(range(len(truth)), 2)
        if abs(truth[one] - truth[two]) >= gap and (truth[one] - truth[two]) * (estimate[one] - estimate[two]) < 0
    ]


def reversed_counts(estimates: Floats, truth: Floats, gap: float = REVERSED_GAP) -> Integers:
    """How many ``reversed_pairs`` each of several estimates has.

    Args:
        estimates: shape (estimates, configurations).
    """
    known = truth[:, None] - truth[None] >= gap
    found = estimates[:, :, None] < estimates[:, None, :]
    return np.asarray((found & known).sum(axis=(1, 2)), dtype=np.int64)


def average_ranks(scores: Floats) -> Floats:
    """Ranks from 1, the highest score first; equal scores share the mean of theirs (for correlations).

    Args:
        scores: shape (configurations,), finite.
    """
    _, place, counts = np.unique(-settled(scores), return_inverse=True, return_counts=True)
    last = np.cumsum(counts)
    return np.asarray((last - (counts - 1) / 2)[place], dtype=np.float64)


def spearman(one: Floats, two: Floats) -> float | None:
    """Spearman's rank correlation; None where it has no value: under three things, or all equal in one of the two."""
    return _correlation(average_ranks(one), average_ranks(two))


def pearson(one: Floats, two: Floats) -> float | None:
    """Pearson's correlation; None where it has no value, as of ``spearman``."""
    return _correlation(one, two)


@dataclass(frozen=True)
class WeightEffect:
    """How the order of configurations by one weight differs from that by the reference weight."""

    weight: float
    scores: Floats
    """Of each configuration."""
    spearman: float | None
    tau_b: float | None
    largest_shift: float
    """Most ranks that a configuration moves; halves where equal scores share a rank."""
    leaders: tuple[int, ...]
    """Configurations with the highest score."""


def weight_effects(first: Floats, second: Floats, weights: Sequence[float], reference: float) -> list[WeightEffect]:
    """The order by ``weight * first + (1 - weight) * second`` against that by the reference weight.

    Args:
        first: the part whose weight varies, shape (configurations,).
        second: the other part.
        weights: each in [0, 1].
    """
    base = reference * first + (1 - reference) * second
    found = []
    for weight in weights:
        scores = weight * first + (1 - weight) * second
        found.append(
            WeightEffect(
                weight=weight,
                scores=scores,
                spearman=spearman(scores, base),
                tau_b=tau_b(scores, base),
                largest_shift=float(np.abs(average_ranks(scores) - average_ranks(base)).max()),
                leaders=tuple(int(place) for place in np.flatnonzero(settled(scores) == settled(scores).max())),
            )
        )
    return found


def frontier(score: Floats, cost: Floats) -> list[int]:
    """Places of those that no other beats: at least as good in both, better in one; the cheapest first.

    Args:
        score: the more the better. Where it or the cost is NaN, the place is left out.
        cost: the less the better.
    """
    score, cost = settled(score), settled(cost)
    known = [place for place in range(len(score)) if np.isfinite(score[place]) and np.isfinite(cost[place])]
    kept = [
        place
        for place in known
        if not any(
            score[other] >= score[place]
            and cost[other] <= cost[place]
            and (score[other] > score[place] or cost[other] < cost[place])
            for other in known
        )
    ]
    return sorted(kept, key=lambda place: (cost[place], place))


def _correlation(one: Floats, two: Floats) -> float | None:
    if len(one) < 3 or np.ptp(settled(one)) == 0 or np.ptp(settled(two)) == 0:
        return None
    first, second = one - one.mean(), two - two.mean()
    return min(1.0, max(-1.0, float(first @ second / np.sqrt((first @ first) * (second @ second)))))
