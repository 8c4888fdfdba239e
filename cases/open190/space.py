"""What room is taken: the collision bodies of placed things, seen in plan with their heights.

A body counts as the convex hull of its plan and its lowest and highest point, which holds at least the body itself:
what does not meet here does not penetrate there.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from c4s.geometry.transform import affine
from c4s.records.pack import BoxBody, CapsuleBody, CollisionBody, HullBody

CELL_CM = 300.0
Point = tuple[float, float]


@dataclass(frozen=True)
class Solid:
    """The plan of a body (corners in order, cm) and its heights."""

    plan: tuple[Point, ...]
    low: float
    high: float


def _corners(body: CollisionBody) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    if isinstance(body, HullBody):
        return np.asarray(body.vertices, dtype=float)
    if isinstance(body, BoxBody):
        half = np.asarray(body.half_extent)
    elif isinstance(body, CapsuleBody):
        half = np.array([body.radius, body.radius, body.radius + body.length / 2])
    else:
        half = np.full(3, body.radius)
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    turn = getattr(body, "rotation_deg", (0.0, 0.0, 0.0))
    matrix = affine(body.center, turn, (1, 1, 1))
    return np.asarray((signs * half) @ matrix[:3, :3].T + matrix[:3, 3], dtype=float)


def solids(bodies: Iterable[CollisionBody]) -> list[Solid]:
    """The solids of an asset in its own axes."""
    found = []
    for body in bodies:
        points = _corners(body)
        try:
            plan = points[ConvexHull(points[:, :2]).vertices, :2]
        except QhullError:
            continue
        found.append(
            Solid(tuple((float(x), float(y)) for x, y in plan), float(points[:, 2].min()), float(points[:, 2].max()))
        )
    return found


def placed(solid: Solid, x: float, y: float, z: float, yaw_deg: float, scale: Sequence[float]) -> Solid:
    """A solid of an asset that stands at a place."""
    c, s = math.cos(math.radians(yaw_deg)), math.sin(math.radians(yaw_deg))
    plan = tuple(
        (x + px * scale[0] * c - py * scale[1] * s, y + px * scale[0] * s + py * scale[1] * c) for px, py in solid.plan
    )
    return Solid(plan, z + solid.low * scale[2], z + solid.high * scale[2])


def _apart(a: tuple[Point, ...], b: tuple[Point, ...], slack: float) -> bool:
    for plan in (a, b):
        for (x0, y0), (x1, y1) in zip(plan, plan[1:] + plan[:1], strict=True):
            nx, ny = y1 - y0, x0 - x1
            length = math.hypot(nx, ny)
            if length < 1e-9:
                continue
            first = [(px * nx + py * ny) / length for px, py in a]
            second = [(px * nx + py * ny) / length for px, py in b]
            if min(max(first), max(second)) - max(min(first), min(second)) <= slack:
                return True
    return False


class Space:
    """The taken room of a place."""

    def __init__(self) -> None:
        self._cells: dict[tuple[int, int], list[Solid]] = {}

    @staticmethod
    def _reach(solid: Solid, margin: float) -> list[tuple[int, int]]:
        xs, ys = [p[0] for p in solid.plan], [p[1] for p in solid.plan]
        return [
            (i, j)
            for i in range(int((min(xs) - margin) // CELL_CM), int((max(xs) + margin) // CELL_CM) + 1)
            for j in range(int((min(ys) - margin) // CELL_CM), int((max(ys) + margin) // CELL_CM) + 1)
        ]

    def free(self, wanted: Iterable[Solid], *, slack: float = 0.4, margin: float = 0.0) -> bool:
        """Whether solids meet nothing by more than ``slack`` cm, or keep ``margin`` cm of distance in plan."""
        for solid in wanted:
            for cell in self._reach(solid, margin):
                for other in self._cells.get(cell, ()):
                    if min(solid.high, other.high) - max(solid.low, other.low) <= slack:
                        continue
                    if not _apart(solid.plan, other.plan, slack if not margin else -margin):
                        return False
        return True

    def take(self, wanted: Iterable[Solid]) -> None:
        """Take the room of solids."""
        for solid in wanted:
            for cell in self._reach(solid, 0.0):
                self._cells.setdefault(cell, []).append(solid)
