"""Moving one convex body against another until they touch, by conservative advancement.

As long as a plane with unit normal n separates two convex bodies by d, a move along u cannot touch before d / (n . u),
and never when n . u <= 0.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from c4s.collision.depth import NUDGES_CM, DepthMeter
from c4s.collision.libraries import coal
from c4s.collision.shapes import Body, Shape
from c4s.engine.headless.queries.solids import Array, surface_normal
from c4s.engine.headless.queries.triangles import facing, segment_meets

TOUCH_CM = 1e-3
"""Bodies this near touch; bodies that overlap by no more than this touch and do not penetrate."""
MOST_STEPS = 64
_FAN = ((0, 1, 2), (2, 1, 0))


@dataclass(frozen=True)
class SweepHit:
    """Where a moved body meets another."""

    distance: float
    """How far it gets, in cm."""
    point: Array
    """Where they touch."""
    normal: Array
    """Unit normal from the one that is hit towards the moved one; at the start the way out."""
    face_normal: Array
    """Normal of the surface that is hit."""
    depth: float = 0.0
    """How deep they overlap at the start (cm); 0 for a hit on the way."""


class Advance:
    """Sweeps convex bodies; keeps coal's buffers."""

    def __init__(self) -> None:
        self._request, self._result = coal.DistanceRequest(), coal.DistanceResult()
        self._meter = DepthMeter()

    def overlap(self, a: Body, b: Body) -> float:
        """How deep two bodies overlap in cm (0: not at all)."""
        push_out = float(np.minimum(a.high - b.low, b.high - a.low).min())
        return self._meter(a, b, push_out)[0] if push_out > 0 else 0.0

    def distance(self, a: Body, b: Body, moved: Array) -> tuple[float, Array, Array]:
        """Signed distance of ``a`` (moved by a vector) to ``b``, unit normal from a to b, nearest point of b."""
        self._result.clear()
        away = a.translation + moved
        found = float(
            coal.distance(
                a.shape,
                coal.Transform3s(a.rotation, np.zeros(3)),
                b.shape,
                coal.Transform3s(b.rotation, b.translation - away),
                self._request,
                self._result,
            )
        )
        return (
            found,
            np.asarray(self._result.normal, float).reshape(3),
            np.asarray(self._result.getNearestPoint2(), float).reshape(3) + away,
        )

    def sweep(self, a: Body, b: Body, direction: Array, length: float) -> SweepHit | None:
        """Where ``a`` meets ``b`` when it moves up to ``length`` cm along a unit direction; None when it does not."""
        travelled = 0.0
        for turn in range(MOST_STEPS):
            gap, normal, point = self.distance(a, b, travelled * direction)
            if not math.isfinite(gap) or not np.isfinite(normal).all():
                return self._inside(a, b, direction) if turn == 0 else None
            if turn == 0 and gap < -TOUCH_CM:
                return self._inside(a, b, direction)
            approach = float(normal @ direction)
            if approach <= 1e-9:
                return None
            if gap <= TOUCH_CM:
                break
            travelled += gap / approach
            if travelled > length:
                return None
        return SweepHit(travelled, point, -normal, surface_normal(b, point, direction, -normal))

    def _inside(self, a: Body, b: Body, direction: Array) -> SweepHit | None:
        """A hit at the start, when the bodies do overlap."""
        depth = self.overlap(a, b)
        if depth <= TOUCH_CM:
            return None
        out = self._way_out(a, b, depth, direction)
        return SweepHit(0.0, a.translation, out, out, depth)

    def _way_out(self, a: Body, b: Body, depth: float, direction: Array) -> Array:
        """The direction in which a move by ``depth`` frees ``a``; straight back where none is found.

        coal's normal has no sign where the core of a round body lies exactly on a face: such a pair is asked again
        a hair's breadth apart, and every answer is tried.
        """
        for nudge in (np.zeros(3), *NUDGES_CM):
            _, normal, _ = self.distance(a, b, nudge)
            if not np.isfinite(normal).all():
                continue
            for out in (-normal, normal):
                if self.distance(a, b, (depth + TOUCH_CM) * out)[0] >= -TOUCH_CM:
                    return out
        return -direction

    def sweep_triangles(self, a: Body, corners: Array, direction: Array, length: float) -> tuple[SweepHit, int] | None:
        """First of many triangles (n, 3, 3) that a moved body meets, with its row; nearest boxes are tried first."""
        half, middle = (a.high - a.low) / 2, (a.high + a.low) / 2
        meets, earliest = segment_meets(
            corners.min(axis=1) - half - TOUCH_CM,
            corners.max(axis=1) + half + TOUCH_CM,
            middle,
            direction * max(length, 1e-9),
        )
        best: tuple[SweepHit, int] | None = None
        for row in sorted(np.flatnonzero(meets).tolist(), key=lambda i: float(earliest[i])):
            if best is not None and earliest[row] * length > best[0].distance:
                break
            hit = self.sweep(a, triangle_body(corners[row]), direction, length)
            if hit is None:
                continue
            if best is None or (hit.distance, -hit.depth) < (best[0].distance, -best[0].depth):
                face = facing(corners[row], direction)
                best = SweepHit(hit.distance, hit.point, hit.normal, hit.normal if hit.depth else face, hit.depth), row
        return best


def triangle_body(corners: Array) -> Body:
    """A triangle (3, 3) as a flat convex body."""
    points, faces = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    centre = corners.mean(axis=0)
    for corner in corners - centre:
        points.append(corner)
    for face in _FAN:
        faces.append(coal.Triangle(*face))
    shape = Shape(coal.Convex(points, faces), None, np.eye(3), np.zeros(3), corners - centre)
    return Body(shape, np.eye(3), centre, corners.min(axis=0), corners.max(axis=0))
