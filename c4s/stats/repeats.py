"""How far repeated measurements of the same things agree (paper, "Detailed Alignment repeatability").

A table has a row a repeat and a column a configuration; its numbers are the configurations' means in that repeat.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from c4s.stats.ranks import DIGITS, settled

Table = NDArray[np.float64]
"""Repeats x configurations."""


@dataclass(frozen=True)
class Agreement:
    """How two repeats agree on the order of the configurations; repeats count from 1."""

    repeats: tuple[int, int]
    tau_b: float | None
    """Kendall's tau-b in [-1, 1]; None where it has no value: one configuration, or all equal in one of them."""


@dataclass(frozen=True)
class Band:
    """Neighbouring ranks, from the first to the last, among which repeats disagree on the order."""

    first: int
    last: int


@dataclass(frozen=True)
class RankStability:
    """Which ranks keep their order in every repeat. Ranks count from 1, by the mean over all repeats."""

    order: tuple[int, ...]
    """Columns of the table, the best first; those of equal means in the table's order."""
    kept: tuple[int, ...]
    """Ranks outside all bands: whoever holds one stands above and below the same others in every repeat."""
    leading: int
    """How many of them from the first rank on without a gap."""
    bands: tuple[Band, ...]
    reversals: int
    """Pairs of configurations of which one repeat puts the one first and another repeat the other."""


def as_table(means: object) -> Table:
    """Means as a table. ``ValueError`` for anything but finite numbers, a row a repeat, at least one of each."""
    table = np.asarray(means, dtype=np.float64)
    if table.ndim != 2 or 0 in table.shape or not np.isfinite(table).all():
        raise ValueError("a row of finite numbers a repeat is expected")
    return table


def agreements(means: Table) -> list[Agreement]:
    """Kendall's tau-b of each two repeats over the configurations' means."""
    return [
        Agreement((one + 1, two + 1), tau_b(means[one], means[two])) for one, two in combinations(range(len(means)), 2)
    ]


def tau_b(one: NDArray[np.float64], two: NDArray[np.float64]) -> float | None:
    """Kendall's tau-b of two rankings of the same things, to twelve decimals; None where it has no value."""
    first, second = settled(one), settled(two)
    if len(first) < 2 or np.ptp(first) == 0 or np.ptp(second) == 0:
        return None
    agreeing, apart_first, apart_second = 0.0, 0.0, 0.0
    for place in range(len(first) - 1):
        one_way = np.sign(first[place + 1 :] - first[place])
        other_way = np.sign(second[place + 1 :] - second[place])
        agreeing += float(one_way @ other_way)
        apart_first += float(np.abs(one_way).sum())
        apart_second += float(np.abs(other_way).sum())
    return round(agreeing / math.sqrt(apart_first * apart_second), DIGITS)


def sample_deviations(means: Table) -> list[float] | None:
    """Sample standard deviation (n - 1) of each configuration's means; None for one repeat."""
    if len(means) < 2:
        return None
    return [float(value) for value in means.std(axis=0, ddof=1)]


def centred(means: Table) -> Table:
    """Each repeat's means less the configurations' means over all repeats."""
    centre: Table = means - means.mean(axis=0)
    return centre


def rank_stability(means: Table) -> RankStability:
    """The order by the mean over all repeats, and where in it repeats disagree.

    Two configurations are reversed where one repeat puts the first strictly above and another strictly below; a tie
    reverses nothing. A band covers the ranks from the one to the other; bands that share a rank are one.
    """
    order = np.argsort(-means.mean(axis=0), kind="stable")
    ranked = means[:, order]
    spans = []
    for upper, lower in combinations(range(len(order)), 2):
        sign = np.sign(ranked[:, upper] - ranked[:, lower])
        if sign.min() < 0 < sign.max():
            spans.append((upper + 1, lower + 1))
    bands: list[Band] = []
    for first, last in sorted(spans):
        if bands and first <= bands[-1].last:
            bands[-1] = Band(bands[-1].first, max(bands[-1].last, last))
        else:
            bands.append(Band(first, last))
    ranks = range(1, len(order) + 1)
    return RankStability(
        order=tuple(int(column) for column in order),
        kept=tuple(rank for rank in ranks if not any(band.first <= rank <= band.last for band in bands)),
        leading=bands[0].first - 1 if bands else len(order),
        bands=tuple(bands),
        reversals=len(spans),
    )
