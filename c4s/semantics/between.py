"""Which plan points lie between two of many reference points.

A point ``p`` is between ``a`` and ``b`` when its foot on the line from a to b lies in the middle four fifths of the
way, and p at most a quarter of the way's length aside. With ``u = p - a`` and ``v = b - p`` (so ``u + v`` is the way)
that is ``u·(u + v)`` and ``v·(u + v)`` at least a tenth of the squared length, and ``|u x v|`` at most a quarter of it.
Branches of a tree over the references are bounded in these terms by interval arithmetic, pair by pair.
"""

from __future__ import annotations

import itertools
from typing import TypeAlias

import numpy as np

from c4s.semantics.boxes import BoundsTree, Flags, Rows
from c4s.semantics.inventory import Array

Interval: TypeAlias = tuple[Array, Array]
CLOSE = 8
"""References next to a point that are tried first: in a crowd two of them have it between them."""
END_SHARE = 0.1
"""The share of the way at each end that is not between."""
ASIDE_SHARE = 0.25
LEAST_COSINE = 0.109
"""A little less than the cosine of the widest angle between u and v: p a tenth along and a quarter aside (0.1093)."""
CHUNK = 1 << 12
"""Pairs that are looked at together; few, so that a hit is found before all pairs are."""
_SLACK = 1e-9
"""Relative room for rounding: what is this close to a limit is decided pair by pair."""


def between_any(points: Array, references: Array) -> Flags:
    """Whether each plan point (n, 2) is between any two of the reference points (m, 2)."""
    places, first = np.unique(references, axis=0, return_index=True)
    found = np.zeros(len(points), dtype=bool)
    if len(places) < 2:
        return found
    from scipy.spatial import KDTree

    close = KDTree(places).query(points, k=min(CLOSE, len(places)))[1]
    for one, other in itertools.combinations(range(close.shape[1]), 2):
        rows = np.flatnonzero(~found)
        found[rows] = _holds(points[rows], places, first, close[rows, one], close[rows, other])
    tree = BoundsTree(places, places)
    rows = np.flatnonzero(~found)
    stack: list[tuple[int, Rows, Rows, Rows]] = [(0, rows, np.zeros_like(rows), np.zeros_like(rows))]
    while stack:
        level, rows, left, right = stack.pop()
        open_ = ~found[rows]
        rows, left, right = rows[open_], left[open_], right[open_]
        if level == len(tree.levels) - 1:
            found[rows[_holds(points[rows], places, first, tree.order[left], tree.order[right])]] = True
            continue
        least, most, _ = tree.levels[level]
        possible, sure = _bounded(points[rows], (least[left], most[left]), (least[right], most[right]))
        found[rows[sure]] = True
        kept = possible & ~sure
        rows, left, right = _children(rows[kept], left[kept], right[kept], tree.levels[level + 1][2])
        stack += [
            (level + 1, rows[i : i + CHUNK], left[i : i + CHUNK], right[i : i + CHUNK])
            for i in range(0, len(rows), CHUNK)
        ]
    return found


def _children(rows: Rows, left: Rows, right: Rows, count: Rows) -> tuple[Rows, Rows, Rows]:
    """The pairs of branches below pairs of branches, each unordered pair once, none that is empty."""
    rows = np.repeat(rows, 4)
    left = (2 * left[:, None] + np.array([0, 0, 1, 1])).ravel()
    right = (2 * right[:, None] + np.array([0, 1, 0, 1])).ravel()
    kept = (left <= right) & (count[left] > 0) & (count[right] > 0)
    return rows[kept], left[kept], right[kept]


def _holds(points: Array, places: Array, first: Rows, one: Rows, other: Rows) -> Flags:
    """Whether each point is between its two places; the way goes from the one that is named first."""
    swap = first[one] > first[other]
    start = places[np.where(swap, other, one)]
    way, offset = places[np.where(swap, one, other)] - start, points - start
    length = np.hypot(way[:, 0], way[:, 1])
    apart = length**2 > 0
    length = np.where(apart, length, 1.0)
    share = (offset[:, None, :] @ way[:, :, None])[:, 0, 0] / length**2
    aside = np.abs(way[:, 0] * offset[:, 1] - way[:, 1] * offset[:, 0]) / length
    return np.asarray(apart & (share >= END_SHARE) & (share <= 1 - END_SHARE) & (aside <= ASIDE_SHARE * length))


def _times(a: Interval, b: Interval) -> Interval:
    products = np.stack([x * y for x in a for y in b])
    return products.min(axis=0), products.max(axis=0)


def _square(a: Interval) -> Interval:
    low, high = a[0] ** 2, a[1] ** 2
    return np.where((a[0] <= 0) & (a[1] >= 0), 0.0, np.minimum(low, high)), np.maximum(low, high)


def _bounded(points: Array, a: Interval, b: Interval) -> tuple[Flags, Flags]:
    """Whether a point can be between a place in box a and one in box b, and whether it must be."""
    ux, uy = ((points[:, k] - a[1][:, k], points[:, k] - a[0][:, k]) for k in (0, 1))
    vx, vy = ((b[0][:, k] - points[:, k], b[1][:, k] - points[:, k]) for k in (0, 1))
    wx, wy = ((b[0][:, k] - a[1][:, k], b[1][:, k] - a[0][:, k]) for k in (0, 1))
    uu, vv, ww, dot = (
        (x[0] + y[0], x[1] + y[1])
        for x, y in (
            (_square(ux), _square(uy)),
            (_square(vx), _square(vy)),
            (_square(wx), _square(wy)),
            (_times(ux, vx), _times(uy, vy)),
        )
    )
    left, right = _times(ux, vy), _times(uy, vx)
    cross = left[0] - right[1], left[1] - right[0]
    least_cross = np.maximum(np.maximum(cross[0], -cross[1]), 0.0)
    most_cross = np.maximum(np.abs(cross[0]), np.abs(cross[1]))
    room = _SLACK * (uu[1] + vv[1])
    near, both = 1 - END_SHARE, 1 - 2 * END_SHARE
    possible = (
        (near * uu[1] + both * dot[1] - END_SHARE * vv[0] >= -room)
        & (near * vv[1] + both * dot[1] - END_SHARE * uu[0] >= -room)
        & (ASIDE_SHARE * ww[1] - least_cross >= -room)
        & (dot[1] - LEAST_COSINE * np.sqrt(uu[0] * vv[0]) >= -room)
    )
    sure = (
        (near * uu[0] + both * dot[0] - END_SHARE * vv[1] > room)
        & (near * vv[0] + both * dot[0] - END_SHARE * uu[1] > room)
        & (ASIDE_SHARE * ww[0] - most_cross > room)
    )
    return possible, sure
