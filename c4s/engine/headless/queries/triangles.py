"""The triangles of a mesh, ordered in blocks that lie close together, so that few are looked at."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.engine.headless.queries.solids import Array
from c4s.packs.meshes import Mesh

BLOCK = 64
EDGE = 1e-9
Rows = NDArray[np.int64]


class Triangles:
    """Triangles of one mesh in its local frame (cm)."""

    def __init__(self, mesh: Mesh) -> None:
        corners = mesh.vertices.astype(np.float64)[mesh.faces]
        solid = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) > 0
        order = np.flatnonzero(solid)[_along_a_curve(corners[solid].mean(axis=1))]
        self.faces = order
        """Index of each triangle in the mesh."""
        self.corners = corners[order]
        """(n, 3 corners, 3) cm."""
        self._low, self._high = self.corners.min(axis=1), self.corners.max(axis=1)
        starts = np.arange(0, len(order), BLOCK)
        self._block_low = np.minimum.reduceat(self._low, starts) if len(order) else np.zeros((0, 3))
        self._block_high = np.maximum.reduceat(self._high, starts) if len(order) else np.zeros((0, 3))

    def along(self, start: Array, step: Array) -> Rows:
        """Triangles in blocks whose box a segment meets."""
        return self._members(segment_meets(self._block_low - 1e-6, self._block_high + 1e-6, start, step)[0])

    def within(self, low: Array, high: Array) -> Rows:
        """Triangles whose box meets a box."""
        near = self._members(boxes_meet(self._block_low, self._block_high, low, high))
        rows: Rows = near[boxes_meet(self._low[near], self._high[near], low, high)]
        return rows

    def _members(self, blocks: NDArray[np.bool_]) -> Rows:
        rows = (np.flatnonzero(blocks)[:, None] * BLOCK + np.arange(BLOCK)).ravel()
        return rows[rows < len(self.faces)]


def _along_a_curve(points: Array) -> Rows:
    """Order of points along a Z curve."""
    if not len(points):
        return np.zeros(0, np.int64)
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    cells = np.minimum((points - low) / np.where(size > 0, size, 1.0) * 1024, 1023).astype(np.int64)
    key = np.zeros(len(points), np.int64)
    for bit in range(10):
        for axis in range(3):
            key |= ((cells[:, axis] >> bit) & 1) << (3 * bit + axis)
    return np.argsort(key, kind="stable")


def boxes_meet(low: Array, high: Array, other_low: Array, other_high: Array) -> NDArray[np.bool_]:
    """Which boxes (n, 3) meet one box."""
    return np.asarray(((low <= other_high) & (high >= other_low)).all(axis=1))


def segment_meets(low: Array, high: Array, start: Array, step: Array) -> tuple[NDArray[np.bool_], Array]:
    """Which boxes (n, 3) the segment ``start .. start + step`` meets, and the fraction of the way to each."""
    first, last = np.zeros(len(low)), np.ones(len(low))
    meets = np.ones(len(low), np.bool_)
    for axis in range(3):
        if abs(float(step[axis])) < 1e-12:
            meets &= (low[:, axis] <= start[axis]) & (high[:, axis] >= start[axis])
            continue
        a, b = (low[:, axis] - start[axis]) / step[axis], (high[:, axis] - start[axis]) / step[axis]
        np.maximum(first, np.minimum(a, b), out=first)
        np.minimum(last, np.maximum(a, b), out=last)
    return meets & (first <= last), first


def cross(a: Array, b: Array) -> Array:
    """Vector products of rows: ``numpy.cross`` without what it does to small arrays first."""
    return np.stack(
        [
            a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1],
            a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2],
            a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0],
        ],
        axis=1,
    )


def first_on_segment(corners: Array, start: Array, step: Array) -> tuple[float, int] | None:
    """Fraction of the way and row of the first triangle (n, 3, 3) that a segment meets, from either side."""
    a, b, c = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = cross(step[None], c)
    det = np.einsum("ij,ij->i", b, across)
    sizes = np.einsum("ij,ij->i", b, b) * np.einsum("ij,ij->i", across, across)
    safe = np.where((det * det > 1e-24 * sizes) & (det != 0), det, np.inf)
    offset = start - a
    u = np.einsum("ij,ij->i", offset, across) / safe
    turned = cross(offset, b)
    v = turned @ step / safe
    t = np.einsum("ij,ij->i", turned, c) / safe
    hit = np.isfinite(safe) & (u >= -EDGE) & (v >= -EDGE) & (u + v <= 1 + EDGE) & (t >= 0) & (t <= 1)
    if not hit.any():
        return None
    row = int(np.argmin(np.where(hit, t, np.inf)))
    return float(t[row]), row


def facing(triangle: Array, direction: Array) -> Array:
    """Unit normal of a triangle (3, 3) against a direction."""
    normal = cross((triangle[1] - triangle[0])[None], (triangle[2] - triangle[0])[None])[0]
    normal /= math.sqrt(float(normal @ normal))
    turned: Array = -normal if normal @ direction > 0 else normal
    return turned
