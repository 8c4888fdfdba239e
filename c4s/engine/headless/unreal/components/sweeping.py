"""Moves that stop at what blocks: the component's bodies are swept along the way, as Unreal does it.

The hit's ``export_text()`` tells the penetration depth of a move that starts inside something.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.queries import cast
from c4s.engine.headless.queries.channels import Response
from c4s.engine.headless.queries.filters import Wanted
from c4s.engine.headless.queries.index import current
from c4s.engine.headless.unreal.components.collision import CollisionState
from c4s.engine.headless.unreal.components.frames import finite
from c4s.engine.headless.unreal.hits.results import HitResult
from c4s.engine.headless.unreal.structs import Vector


class SweptMoves(CollisionState):
    """Setters of the pose, with ``sweep``."""

    def _go(self, pose: Pose, sweep: bool) -> HitResult:
        if not sweep or not self._queries():
            return super()._go(pose, sweep)
        hit, reached = self._swept(finite(pose, self))
        self._set_world(reached)
        return hit

    def _go_relative(self, pose: Pose, sweep: bool) -> HitResult:
        if not sweep:
            return super()._go_relative(pose, sweep)
        return self._go(pose if self._parent is None else compose(pose, self._parent._world_pose()), sweep)

    def _swept(self, pose: Pose) -> tuple[HitResult, Pose]:
        """What blocks the way to a pose, and how far it gets; it turns and scales where it ends."""
        begin = self._world_pose()
        start, end = np.array(begin.location), np.array(pose.location)
        length = float(np.linalg.norm(end - start))
        if length <= 4 * cast.SHORTEST_CM:
            return HitResult(), pose
        hits = [
            hit
            for body in current().of_component(self, begin)
            for hit in cast.sweep(
                body, end - start, self._blocked_by(), many=True, all_hits=True, skipped=frozenset(self._ignored(False))
            )
            if hit.blocking and not (hit.initial and hit.normal @ (end - start) > 0)
        ]
        if not hits:
            return HitResult(), pose
        hit = min(hits, key=lambda one: one.rank)
        time = max(0.0, hit.distance / length - _pulled_back(length))
        reached = start + time * (end - start)
        made = HitResult._of(replace(hit, location=reached), Vector(*begin.location), Vector(*pose.location))
        made._put("time", time)
        x, y, z = reached.tolist()
        return made, pose.moved((x, y, z))

    def _blocked_by(self) -> Wanted:
        """What its moves see: components that block it and that it blocks, those of its own actor aside."""
        own = self._channel()
        return Wanted(
            lambda other: Response(min(other._answers(own), self._answers(other._channel()))),
            [self._outer, *self._ignored(True)],
        )


def _pulled_back(length: float) -> float:
    """Unreal stops moves a little (0.1 to 1 cm and 0.1 %) before the surface; as a share of the way."""
    return min(max(0.1, 0.1 / length), 1 / length) + 0.001
