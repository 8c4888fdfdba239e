"""How far each actor hangs above the next collision surface below it.

Exact for convex bodies: a body is moved straight down by conservative advancement. As long as a plane with unit normal
n separates two bodies by d, a move along u cannot touch before d / (n . u), and never when n . u <= 0.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np
import shapely

from c4s.collision.libraries import coal
from c4s.collision.scene import SceneBodies
from c4s.collision.shapes import Body

TOUCH_CM = 1e-3
MOST_STEPS = 64
DOWN = np.array((0.0, 0.0, -1.0))


class _Drop:
    """Distance (cm) that one body can fall until it meets another."""

    def __init__(self) -> None:
        self._request = coal.DistanceRequest()
        self._result = coal.DistanceResult()

    def __call__(self, body: Body, other: Body) -> float | None:
        offset = other.translation - body.translation
        fallen = 0.0
        for _ in range(MOST_STEPS):
            self._result.clear()
            distance = float(
                coal.distance(
                    body.shape,
                    coal.Transform3s(body.rotation, np.zeros(3)),
                    other.shape,
                    coal.Transform3s(other.rotation, offset - fallen * DOWN),
                    self._request,
                    self._result,
                )
            )
            if distance <= TOUCH_CM:
                return fallen
            approach = float(np.asarray(self._result.normal).reshape(3) @ DOWN)
            if approach <= 0:
                return None
            fallen += distance / approach
            if body.high[2] - fallen < other.low[2]:
                return None
        return fallen


def gaps_below(
    snapshot: Mapping[str, Any], scene: SceneBodies, actors: Collection[int], *, ground_plane: bool
) -> dict[int, float | None]:
    """Gap in cm below each actor (an index) that has bodies: 0 when it touches, ``None`` when nothing is below.

    ``ground_plane`` counts the plane z = 0 as a surface, as the text-to-scene rule does.
    """
    tree = shapely.STRtree([shapely.box(*body.low[:2], *body.high[:2]) for body in scene.bodies])
    drop = _Drop()
    gaps: dict[int, float | None] = {}
    for body, owner in zip(scene.bodies, scene.owners, strict=True):
        if owner not in actors:
            continue
        found = [max(0.0, float(body.low[2]))] if ground_plane else []
        for index in tree.query(shapely.box(*body.low[:2], *body.high[:2])).tolist():
            other = scene.bodies[index]
            if scene.owners[index] != owner and other.low[2] <= body.high[2]:
                fall = drop(body, other)
                found += [] if fall is None else [fall]
        best = min(found, default=None)
        known = gaps.get(owner)
        gaps[owner] = best if known is None else known if best is None else min(best, known)
    return gaps
