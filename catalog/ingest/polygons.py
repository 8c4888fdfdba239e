"""Triangles of polygons: convex ones as fans, others by cutting ears off, so that no triangle lies outside."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
MOST_CORNERS = 4000
"""Polygons with more corners are fans, whatever their shape: cutting ears takes time by the square of the corners."""


def triangulated(points: Floats, sizes: Ints) -> tuple[Ints, Ints]:
    """Triangles of polygons that lie one behind the other.

    Args:
        points: (n, 3) the corners of all polygons.
        sizes: (p,) how many corners each polygon has; those with less than three give nothing.

    Returns:
        (t, 3) corners of each triangle as rows of ``points``, in the order of the polygons, and (t,) its polygon.
    """
    starts = np.cumsum(sizes) - sizes
    made: list[Ints] = []
    owners: list[Ints] = []
    for size in np.unique(sizes[sizes >= 3]).tolist():
        which = np.flatnonzero(sizes == size)
        corners = starts[which, None] + np.arange(size)
        triangles = _of_one_size(points, corners)
        made.append(triangles.reshape(-1, 3))
        owners.append(np.repeat(which, size - 2))
    if not made:
        return np.zeros((0, 3), np.int64), np.zeros(0, np.int64)
    owner = np.concatenate(owners)
    order = np.argsort(owner, kind="stable")
    return np.concatenate(made)[order], owner[order]


def _of_one_size(points: Floats, corners: Ints) -> Ints:
    """(p, size - 2, 3) triangles of polygons with (p, size) corners."""
    count, size = corners.shape
    steps = np.arange(1, size - 1)
    fan = np.stack([np.zeros(size - 2, np.int64), steps, steps + 1], axis=1)
    local = np.broadcast_to(fan, (count, size - 2, 3)).copy()
    places = points[corners]
    if size == 4:
        local[_bent(places)] = [[0, 1, 3], [1, 2, 3]]
    elif size > 4:
        for index in np.flatnonzero(~_convex(places)).tolist():
            if size <= MOST_CORNERS:
                local[index] = _ears(places[index], fan)
    triangles: Ints = corners[np.arange(count)[:, None, None], local]
    return triangles


def _bent(places: Floats) -> NDArray[np.bool_]:
    """Which of (p, 4, 3) quads have a corner that the first diagonal cannot leave alone."""
    a, b, c, d = places.transpose(1, 0, 2)
    across = np.einsum("pi,pi->p", np.cross(b - a, c - a), np.cross(c - a, d - a))
    other = np.einsum("pi,pi->p", np.cross(b - a, d - a), np.cross(c - b, d - b))
    bent: NDArray[np.bool_] = (across < 0) & (other > across)
    return bent


def _normals(places: Floats) -> Floats:
    """(p, 3) normals of (p, size, 3) polygons, as long as twice the area (Newell)."""
    ahead = np.roll(places, -1, axis=1)
    summed: Floats = np.cross(places, ahead).sum(axis=1)
    return summed


def _convex(places: Floats) -> NDArray[np.bool_]:
    """Which of (p, size, 3) polygons turn one way at every corner."""
    places = places - places[:, :1]
    edges = np.roll(places, -1, axis=1) - places
    turns = np.einsum("psi,pi->ps", np.cross(np.roll(edges, 1, axis=1), edges), _normals(places))
    inward: NDArray[np.bool_] = (turns >= -1e-12 * np.abs(turns).max(axis=1, keepdims=True)).all(axis=1)
    return inward


def _ears(place: Floats, fan: Ints) -> Ints:
    """(size - 2, 3) triangles of one polygon; a fan where it crosses itself so that no ear is left."""
    normal = _normals(place[None])[0]
    axis = int(np.argmax(np.abs(normal)))
    flat = np.delete(place, axis, axis=1) * (1 if (normal[axis] > 0) == (axis != 1) else [-1, 1])
    rest, made = list(range(len(flat))), []
    while len(rest) > 3:
        ear = _ear(flat, rest)
        if ear is None:
            return fan
        made.append([rest[ear - 1], rest[ear], rest[(ear + 1) % len(rest)]])
        del rest[ear]
    return np.asarray([*made, rest], np.int64)


def _ear(flat: Floats, rest: list[int]) -> int | None:
    """Place in ``rest`` of a corner whose triangle holds no other corner; corners turn left."""
    here = flat[rest]
    before, after = np.roll(here, 1, axis=0), np.roll(here, -1, axis=0)
    turn = _area(before, here, after)
    small = 1e-12 * float(np.abs(turn).max(initial=0.0))
    for index in np.flatnonzero(np.abs(turn) <= small).tolist():
        if not (before[index] == after[index]).all():
            return int(index)  # a corner on a straight line takes nothing away
    blunt = here[turn <= small]
    for index in np.argsort(-turn, kind="stable").tolist():
        if turn[index] <= small:
            break
        a, b, c = before[index], here[index], after[index]
        inside = (_area(a, b, blunt) >= 0) & (_area(b, c, blunt) >= 0) & (_area(c, a, blunt) >= 0)
        own = (blunt == a).all(axis=1) | (blunt == b).all(axis=1) | (blunt == c).all(axis=1)
        if not (inside & ~own).any():
            return int(index)
    return None


def _area(a: Floats, b: Floats, c: Floats) -> Floats:
    """Twice the signed area of triangles in the plane."""
    twice: Floats = (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (
        c[..., 0] - a[..., 0]
    )
    return twice
