"""Convex hulls of plan points: which points lie in the ring that other points form."""

from __future__ import annotations

import numpy as np

from c4s.semantics.boxes import Flags
from c4s.semantics.inventory import Array

TOLERANCE_CM = 1e-6


def in_ring(points: Array, corners: Array) -> Flags:
    """Whether each plan point lies in the convex hull of the corners; nothing lies in a ring without an area."""
    ring = _ring(corners)
    if ring is None:
        return np.zeros(len(points), dtype=bool)
    middle = ring.mean(axis=0)
    ring, points = ring - middle, points - middle
    normals, offsets = _sides(ring)
    turns = np.unwrap(np.arctan2(ring[:, 1], ring[:, 0]))
    angles = np.arctan2(points[:, 1], points[:, 0])
    angles = turns[0] + np.mod(angles - turns[0], 2 * np.pi)
    side = np.searchsorted(turns, angles, side="right") - 1
    holds = np.ones(len(points), dtype=bool)
    for near in (side - 1, side, side + 1):
        row = np.mod(near, len(ring))
        holds &= (normals[row] * points).sum(axis=1) + offsets[row] <= TOLERANCE_CM
    return holds


def in_ring_of_others(points: Array) -> Flags:
    """Whether each plan point lies in the convex hull of the other points."""
    places, inverse, count = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    ring = _ring(places)
    if ring is None:
        return np.zeros(len(points), dtype=bool)
    inside = np.ones(len(places), dtype=bool)
    corner = {tuple(place): number for number, place in enumerate(ring.tolist())}
    for number, place in enumerate(places.tolist()):
        at = corner.get(tuple(place))
        if at is not None and count[number] == 1:
            inside[number] = len(ring) > 3 and _sticks_out(ring, at) <= TOLERANCE_CM
    return inside[inverse.ravel()]


def _ring(corners: Array) -> Array | None:
    """Corners of the hull, counter-clockwise."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return np.asarray(corners[ConvexHull(corners).vertices])
    except (QhullError, ValueError):
        return None


def _sides(ring: Array) -> tuple[Array, Array]:
    """Outward normals and offsets of the sides from each corner to the next."""
    along = np.roll(ring, -1, axis=0) - ring
    normals = np.column_stack([along[:, 1], -along[:, 0]]) / np.hypot(along[:, 0], along[:, 1])[:, None]
    return normals, -(normals * ring).sum(axis=1)


def _sticks_out(ring: Array, at: int) -> float:
    """How far (cm) a corner stands out from the line between its neighbours."""
    before, place, after = ring[at - 1], ring[at], ring[(at + 1) % len(ring)]
    way, offset = after - before, place - before
    return float(abs(way[0] * offset[1] - way[1] * offset[0]) / np.hypot(*way))
