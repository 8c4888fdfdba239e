"""Many straight lines at once against the triangles of a mesh or a convex body, in the frame of that mesh or body.

A line is a start and a step (cm); what it meets is told as the fraction of the step. Triangles are met from both sides;
a line that starts inside a body meets it at once.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from c4s.collision.hulls import convex_hull
from c4s.collision.mesh_body import Array
from c4s.collision.shapes import SIGNS, Shape

EDGE = 1e-9
"""Barycentric slack: a line through an edge meets both triangles."""
ALONG = 1e-12
"""Lines whose direction is this near to a plane's run along it."""
MOST_TRIANGLES = 500_000
"""Lines and triangles that are paired at a time: bounds the memory."""
_BOX_CM = 1e-6


class Meetings(NamedTuple):
    """What n lines meet first."""

    fraction: Array
    """Of the step; infinite where nothing is met."""
    normal: Array
    """(n, 3) of the surface that is met: of any length, towards either side."""
    inside: NDArray[np.bool_]
    """The line starts inside a body; it has no normal then."""

    @classmethod
    def none(cls, lines: int) -> Meetings:
        """Nothing is met."""
        return cls(np.full(lines, np.inf), np.zeros((lines, 3)), np.zeros(lines, dtype=bool))


class TriangleSet:
    """Triangles (m, 3 corners, 3) in one frame, found by where they lie in its XY plane."""

    def __init__(self, corners: Array) -> None:
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        solid = np.linalg.norm(across, axis=1) > 0
        self.corners, self.normals = corners[solid], across[solid]
        low, high = self.corners.min(axis=1) - _BOX_CM, self.corners.max(axis=1) + _BOX_CM
        self._low, self._high = low[:, 2], high[:, 2]
        self.box: tuple[Array, Array] = (np.zeros(3), np.zeros(3))
        """Lowest and highest corner."""
        if len(low):
            self.box = low.min(axis=0), high.max(axis=0)
        self._tree = shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))

    def meet(self, start: Array, step: Array) -> Meetings:
        """The nearest triangle on each of n lines."""
        found = Meetings.none(len(start))
        first, last = within_box(*self.box, start, step)
        crossing = np.flatnonzero(first <= last)
        if not len(crossing):
            return found
        ends = start[crossing] + np.stack([first[crossing], last[crossing]])[:, :, None] * step[crossing]
        low, high = ends.min(axis=0) - _BOX_CM, ends.max(axis=0) + _BOX_CM
        line, triangle = self._tree.query(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
        near = (self._low[triangle] <= high[line, 2]) & (self._high[triangle] >= low[line, 2])
        line, triangle = crossing[line[near]], triangle[near]
        for begin in range(0, len(line), MOST_TRIANGLES):
            part = slice(begin, begin + MOST_TRIANGLES)
            self._nearest(line[part], triangle[part], start, step, found)
        return found

    def _nearest(
        self, line: NDArray[np.int64], triangle: NDArray[np.int64], start: Array, step: Array, found: Meetings
    ) -> None:
        fraction = triangle_fractions(self.corners[triangle], start[line], step[line])
        order = np.lexsort((triangle, fraction, line))
        line, triangle, fraction = line[order], triangle[order], fraction[order]
        nearest = np.flatnonzero(np.concatenate([[True], line[1:] != line[:-1]]))
        nearest = nearest[fraction[nearest] < found.fraction[line[nearest]]]
        found.fraction[line[nearest]] = fraction[nearest]
        found.normal[line[nearest]] = self.normals[triangle[nearest]]


def triangle_fractions(corners: Array, start: Array, step: Array) -> Array:
    """Where each of n lines meets its own triangle (n, 3, 3), as a fraction of its step; infinite where it does not."""
    a, b, c = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(step, c)
    det = np.einsum("ij,ij->i", b, across)
    sizes = np.einsum("ij,ij->i", b, b) * np.einsum("ij,ij->i", across, across)
    safe = np.where((det * det > 1e-24 * sizes) & (det != 0), det, np.inf)
    offset = start - a
    turned = np.cross(offset, b)
    u = np.einsum("ij,ij->i", offset, across) / safe
    v = np.einsum("ij,ij->i", turned, step) / safe
    t = np.einsum("ij,ij->i", turned, c) / safe
    meets = np.isfinite(safe) & (u >= -EDGE) & (v >= -EDGE) & (u + v <= 1 + EDGE) & (t >= 0) & (t <= 1)
    return np.where(meets, t, np.inf)


def within_box(low: Array, high: Array, start: Array, step: Array) -> tuple[Array, Array]:
    """Fractions between which each line is in a box; the first is beyond the last where it misses."""
    first, last = np.zeros(len(start)), np.ones(len(start))
    with np.errstate(divide="ignore", invalid="ignore"):
        for axis in range(3):
            a, b = (low[axis] - start[:, axis]) / step[:, axis], (high[axis] - start[:, axis]) / step[:, axis]
            still = step[:, axis] == 0
            beside = still & ((start[:, axis] < low[axis]) | (start[:, axis] > high[axis]))
            first = np.where(still, first, np.fmax(first, np.minimum(a, b)))
            last = np.where(still, np.where(beside, -np.inf, last), np.fmin(last, np.maximum(a, b)))
    return first, last


def meet_shape(shape: Shape, start: Array, step: Array) -> Meetings:
    """Where n lines meet a convex shape, in the frame of its bodies."""
    surface = _surface(shape)
    if surface is None:
        return _meet_round(float(shape.half[2]), shape.radius, start, step)
    return surface.meet(start, step) if isinstance(surface, TriangleSet) else _meet_planes(surface, start, step)


@lru_cache(maxsize=16384)
def _surface(shape: Shape) -> Array | TriangleSet | None:
    """Planes (normal and offset, ``n . p + offset <= 0`` inside) of a shape; triangles of a flat one; None: round."""
    if shape.radius:
        return None
    corners = SIGNS * shape.half if shape.corners is None else shape.corners
    hull = convex_hull(corners)
    if hull is None:
        return TriangleSet(np.zeros((0, 3, 3)))
    triangles = (hull.corners + hull.centre)[hull.faces.triangles]
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    if float(np.abs(np.einsum("ij,kj->ik", normal, corners - corners.mean(axis=0))).max()) < 1e-9 * float(
        np.abs(normal).max()
    ):
        return TriangleSet(triangles)
    length = np.linalg.norm(normal, axis=1)
    wide = length > 0
    if not wide.any():
        return TriangleSet(np.zeros((0, 3, 3)))
    normal = normal[wide] / length[wide, None]
    planes = np.column_stack([normal, -np.einsum("ij,ij->i", normal, triangles[wide, 0])])
    return np.unique(np.round(planes, 12), axis=0)


def _meet_planes(planes: Array, start: Array, step: Array) -> Meetings:
    heights, speeds = start @ planes[:, :3].T + planes[:, 3], step @ planes[:, :3].T
    inside = np.asarray((heights <= 0).all(axis=1))
    still = np.abs(speeds) <= ALONG * np.linalg.norm(step, axis=1)[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        times = np.where(still, 0.0, -heights / speeds)
    entering, leaving = ~still & (speeds < 0), ~still & (speeds > 0)
    entry = np.where(entering, times, -np.inf)
    face = entry.argmax(axis=1)
    first = entry[np.arange(len(start)), face]
    last = np.where(leaving, times, np.inf).min(axis=1)
    meets = ~(still & (heights > 0)).any(axis=1) & (first >= 0) & (first <= last + EDGE) & (first <= 1)
    return Meetings(np.where(inside, 0.0, np.where(meets, first, np.inf)), planes[face, :3], inside)


def _meet_round(half: float, radius: float, start: Array, step: Array) -> Meetings:
    """A sphere, or a capsule along Z whose straight part is twice ``half`` long."""
    axis = start[:, 2] - np.clip(start[:, 2], -half, half)
    inside = np.asarray(start[:, 0] ** 2 + start[:, 1] ** 2 + axis**2 <= radius * radius)
    found = np.full(len(start), np.inf)
    for end in {-half, half}:
        times = _root(start - (0.0, 0.0, end), step, radius)
        found = np.fmin(found, np.where(times >= 0, times, np.inf))
    if half > 0:
        times = _root(start[:, :2], step[:, :2], radius)
        on = (times >= 0) & (np.abs(start[:, 2] + times * step[:, 2]) <= half)
        found = np.fmin(found, np.where(on, times, np.inf))
    found = np.where(inside, 0.0, np.where(found <= 1, found, np.inf))
    point = start + np.where(np.isfinite(found), found, 0.0)[:, None] * step
    point[:, 2] -= np.clip(point[:, 2], -half, half)
    return Meetings(found, point, inside)


def _root(start: Array, step: Array, radius: float) -> Array:
    """Fraction at which each line enters a ball (or, in a plane, a circle) around the origin; NaN where it misses."""
    a, b = np.einsum("ij,ij->i", step, step), np.einsum("ij,ij->i", start, step)
    c = np.einsum("ij,ij->i", start, start) - radius * radius
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray((-b - np.sqrt(b * b - a * c)) / a)
