"""Choosing few cases whose plain means stand for those of all (paper, "Public and Private Sets", Selection).

Values have a row a case; columns are configurations and their scores. A choice is a row of shares over the cases that
sums to 1, so a choice of several draws is a matrix, and all means are one product.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import Final

import numpy as np

from c4s.stats.bootstrap import Floats, Integers

Choose = Callable[[Floats], Floats]
"""From values of a pool, shape (cases, configurations, columns), to choices, shape (draws, cases)."""
MIDDLE: Final = (0.3, 0.7)
"""Mean scores that the filter keeps."""


def greedy_order(values: Floats) -> Integers:
    """All cases in the order in which they are added, so that every set holds the smaller ones.

    Each step adds the case after which the largest error of a column's mean is least; errors are in units of the
    column's spread, which is what random sets of one size differ by up to a common factor. Of equals, the first.

    Args:
        values: shape (cases, columns). Columns of equal numbers say nothing.
    """
    spread = values.std(axis=0, ddof=1) if len(values) > 1 else np.zeros(values.shape[1])
    scaled = (values - values.mean(axis=0))[:, spread > 0] / spread[spread > 0]
    left, order, total = np.ones(len(values), dtype=bool), [], np.zeros(scaled.shape[1])
    for _ in range(len(values)):
        (free,) = np.nonzero(left)
        worst = np.abs(total + scaled[free]).max(axis=1, initial=0.0)
        best = free[int(np.argmin(worst))]
        left[best] = False
        total += scaled[best]
        order.append(best)
    return np.array(order, dtype=np.int64)


def normalised_error(values: Floats, chosen: Integers) -> float:
    """The largest error of a column's mean over some cases, in deviations of means of random sets of that size.

    Args:
        values: shape (cases, columns). Columns of equal numbers say nothing.
        chosen: places of the cases, each once. All of them err by nothing.
    """
    cases, size = values.shape[0], len(chosen)
    if size == cases:
        return 0.0
    spread = values.std(axis=0, ddof=1) * np.sqrt(1 / size - 1 / cases)
    error = np.abs(values[chosen].mean(axis=0) - values.mean(axis=0))
    return float((error[spread > 0] / spread[spread > 0]).max(initial=0.0))


def replaced(values: Floats, order: Integers, withdrawn: int, size: int) -> Integers:
    """An order without a case; in the set of one size another takes its place, so no case of that set runs again.

    The one that takes its place is that after which the set's largest error is least, held against the cases that
    remain. Sets are the order's beginnings as before, so they stay nested.

    Args:
        values: shape (cases, columns), the withdrawn case's among them.
        order: places of all cases, as ``greedy_order`` gives them.
        withdrawn: place of the case.
        size: of the set that keeps its size.
    """
    place = int(np.flatnonzero(order == withdrawn)[0])
    waiting = order[size:]
    if place >= size or not len(waiting):
        return np.delete(order, place)
    left = np.delete(np.arange(len(values)), withdrawn)
    renamed = np.searchsorted(left, order)
    kept = np.delete(renamed[:size], place)
    errors = [normalised_error(values[left], np.append(kept, one)) for one in renamed[size:]]
    taken = int(waiting[int(np.argmin(errors))])
    return np.concatenate([order[:place], [taken], order[place + 1 : size], waiting[waiting != taken]])


def apportioned(size: int, counts: Sequence[int]) -> list[int]:
    """A size shared out by numbers of cases (Sainte-Laguë), so that larger sizes hold smaller ones."""
    given = [0] * len(counts)
    for _ in range(min(size, sum(counts))):
        claims = [count / (2 * had + 1) if had < count else -1.0 for had, count in zip(given, counts, strict=True)]
        given[int(np.argmax(claims))] += 1
    return given


def plain(cases: int, chosen: Integers) -> Floats:
    """The choice of some cases at equal shares, shape (1, cases)."""
    shares = np.zeros((1, cases))
    shares[0, chosen] = 1 / len(chosen)
    return shares


def lowest(keys: Floats, size: int) -> Floats:
    """Choices of the cases with the lowest keys of each draw, shape (draws, cases); infinite keys are never chosen."""
    order = np.argsort(keys, axis=1)[:, :size]
    shares = np.zeros_like(keys)
    np.put_along_axis(shares, order, 1.0, axis=1)
    shares[np.isinf(keys)] = 0.0
    return np.asarray(shares / shares.sum(axis=1, keepdims=True), dtype=np.float64)


def stratified_keys(strata: Sequence[Hashable], random: np.random.Generator, draws: int) -> Floats:
    """Keys whose lowest are spread over the strata by their sizes, shape (draws, cases)."""
    keys = np.empty((draws, len(strata)))
    for name in dict.fromkeys(strata):
        own = [place for place, stratum in enumerate(strata) if stratum == name]
        places = random.random((draws, len(own))).argsort(axis=1).argsort(axis=1)
        keys[:, own] = (places + random.random((draws, 1))) / len(own)
    return keys


def filtered_keys(means: Floats, random: np.random.Generator, draws: int) -> Floats:
    """Random keys of the cases whose mean score is in the middle (``MIDDLE``), infinite ones of the others.

    All cases are kept where none is in the middle.
    """
    inside = (means >= MIDDLE[0]) & (means <= MIDDLE[1])
    keys = random.random((draws, len(means)))
    return np.where(inside, keys, np.inf) if inside.any() else keys


def anchors(values: Floats, size: int) -> Floats:
    """Medoids of the cases at their clusters' shares, shape (1, cases): k-medoids by the Euclidean distance of rows.

    Medoids are added one by one where they shorten distances most, then exchanged as long as that shortens them.
    """
    distances = np.linalg.norm(values[:, None] - values[None], axis=-1)
    medoids = [int(np.argmin(distances.sum(axis=0)))]
    while len(medoids) < size:
        nearest = distances[:, medoids].min(axis=1)
        gain = np.maximum(nearest[:, None] - distances, 0.0).sum(axis=0)
        gain[medoids] = -1.0
        medoids.append(int(np.argmax(gain)))
    medoids = _exchanged(distances, medoids)
    owner = np.argmin(distances[:, medoids], axis=1)
    owner[medoids] = np.arange(size)
    shares = np.zeros((1, len(values)))
    shares[0, medoids] = np.bincount(owner, minlength=size) / len(values)
    return shares


def _exchanged(distances: Floats, medoids: list[int]) -> list[int]:
    cost = distances[:, medoids].min(axis=1).sum()
    while len(medoids) < len(distances):
        own = distances[:, medoids]
        order = np.argsort(own, axis=1)[:, :2]
        nearest = np.take_along_axis(own, order[:, :1], axis=1)[:, 0]
        second = np.take_along_axis(own, order[:, 1:], axis=1)[:, 0] if len(medoids) > 1 else np.full(len(own), np.inf)
        without = np.where(order[:, :1] == np.arange(len(medoids)), second[:, None], nearest[:, None])
        costs = np.array([np.minimum(without, distances[:, [other]]).sum(axis=0) for other in range(len(distances))])
        costs[medoids] = np.inf
        other, place = np.unravel_index(int(np.argmin(costs)), costs.shape)
        if costs[other, place] >= cost - 1e-12:
            break
        cost = costs[other, place]
        medoids = [*medoids[:place], int(other), *medoids[place + 1 :]]
    return medoids


def left_out(values: Floats, choose: Choose) -> Floats:
    """What each configuration's means are taken for by cases that were chosen without it.

    Args:
        values: shape (cases, configurations, columns), at least two configurations.

    Returns:
        Shape (draws, configurations, columns).
    """
    found = []
    for place in range(values.shape[1]):
        shares = choose(np.delete(values, place, axis=1))
        found.append(shares @ values[:, place])
    return np.stack(found, axis=1)
