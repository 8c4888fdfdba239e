"""A capsule that follows a route among collision bodies, and the rule that ends and judges its walk (EU21 to EU23)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import coal
import numpy as np
import shapely

from c4s.collision.mesh_body import Array
from c4s.collision.shapes import Body
from c4s.navigation.compiled import kernel
from c4s.navigation.settings import NavigationSettings
from c4s.navigation.solids import solids_of
from c4s.protocol.navigation import SPEED_CM_S, STALL_CM, STALL_S, STALLS

TICK_S = 0.05
RECORD_S = 0.5
"""A walk is recorded this often."""
_SKIN_CM = 1.0
"""So much a capsule may lean into what it slides along."""
_FALL_CM = 400.0
_AT_CM = 5.0
_PATIENCE = 3.0
"""A walk may take so many times as long as its route does at full speed, and both windows of a stall."""


@dataclass(frozen=True)
class Walk:
    """How a walk went: feet of the capsule (n, 3) in cm every ``RECORD_S``, and how far it then still had to go."""

    trace: Array
    left_cm: Array
    stalled: bool
    arrived: bool
    short_cm: float
    """From its end to the goal."""

    @property
    def seconds(self) -> float:
        """How long it took."""
        return RECORD_S * (len(self.trace) - 1)


def judge_walk(trace: Array, left_cm: Array, goal: Array, radius_cm: float) -> Walk:
    """The walk as the rule ends it: after two windows of five seconds in a row with too little progress.

    It has arrived when it ends within the radius of its goal, wherever it passed before.
    """
    window, slow, end, stalled = round(STALL_S / RECORD_S), 0, len(trace) - 1, False
    for at in range(window, len(trace), window):
        slow = slow + 1 if left_cm[at - window] - left_cm[at] < STALL_CM else 0
        if slow == STALLS:
            end, stalled = at, True
            break
    short = float(np.linalg.norm(trace[end] - goal))
    return Walk(trace[: end + 1], left_cm[: end + 1], stalled, short <= radius_cm, short)


class BodyWorld:
    """Collision bodies as what a walking capsule meets."""

    def __init__(self, bodies: Sequence[Body], settings: NavigationSettings) -> None:
        self._bodies, self._settings = bodies, settings
        self._solids = solids_of(bodies)
        low, high = self._solids.low, self._solids.high
        self._tree = shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
        radius, step = settings.radius_cm, settings.step_cm
        straight = max(settings.height_cm - step - 2 * radius, 1.0)
        self._capsule: Any = coal.Capsule(radius, straight)
        self._middle = step + radius + straight / 2
        self._request: Any = coal.DistanceRequest()
        self._request.enable_signed_distance = True

    def _near(self, x: float, y: float, reach: float) -> Any:
        return self._tree.query(shapely.box(x - reach, y - reach, x + reach, y + reach))

    def floor(self, place: Array, above: float, below: float) -> float | None:
        """Height of the highest surface at a place, from ``above`` over it to ``below`` under it; None for none."""
        near = np.asarray(self._near(place[0], place[1], 0.0), dtype=np.int64)
        top = _drop(self._solids.triangles, self._solids.first, near, place[0], place[1], place[2] + above)
        return None if top < place[2] - below else float(top)

    def free(self, place: Array) -> Array | None:
        """The place, or one beside it, where the capsule fits; None where it does not."""
        settings, at = self._settings, place.copy()
        near = self._near(at[0], at[1], 2 * settings.radius_cm)
        low, high = at[2] + settings.step_cm, at[2] + settings.height_cm
        near = [i for i in near if self._solids.high[i, 2] > low and self._solids.low[i, 2] < high]
        for _ in range(4):
            pose = coal.Transform3s(np.eye(3), np.array([at[0], at[1], at[2] + self._middle]))
            deepest, away = -_SKIN_CM, None
            for index in near:
                result = coal.DistanceResult()
                body = self._bodies[index]
                distance = coal.distance(self._capsule, pose, body.shape, body.coal_pose, self._request, result)
                if distance < deepest:
                    deepest, away = distance, -np.asarray(result.normal)
            if away is None:
                return at
            level = float(np.hypot(away[0], away[1]))
            if level < 0.2:
                return None
            at[:2] += away[:2] / level * min((-deepest - _SKIN_CM / 2) / level, settings.radius_cm)
        return None


@kernel
def _drop(triangles: Any, first: Any, bodies: Any, x: float, y: float, z: float) -> float:
    """Height of the highest surface under a point that looks up; -inf for none."""
    best = -np.inf
    for body in bodies:
        for index in range(first[body], first[body + 1]):
            a, b, c = triangles[index, 0], triangles[index, 1], triangles[index, 2]
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if area <= 1e-9:
                continue
            u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
            v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
            if u >= -1e-9 and v >= -1e-9 and u + v <= 1.0 + 1e-9:
                top = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])
                if top <= z and top > best:
                    best = top
    return best


def walk(world: BodyWorld, route: Array, settings: NavigationSettings) -> tuple[Array, Array]:
    """Follow the corners (k, 3) of a route until its end, or until patience ends: trace and what was left to go.

    Each tick goes straight for the next corner, slides along what is in the way, and stands on what is below.
    """
    lengths = np.linalg.norm(np.diff(route, axis=0), axis=1)
    after = np.concatenate([np.cumsum(lengths[::-1])[::-1], [0.0]])
    floor = world.floor(route[0], settings.step_cm, _FALL_CM)
    at = np.array([*route[0][:2], route[0][2] if floor is None else floor])
    corner, tick = 1, SPEED_CM_S * TICK_S
    most = int((_PATIENCE * after[0] / SPEED_CM_S + STALLS * STALL_S + 2 * STALL_S) / TICK_S)
    every = round(RECORD_S / TICK_S)
    trace, left = [at.copy()], [float(after[0])]
    for number in range(1, most + 1):
        ahead = route[corner][:2] - at[:2]
        while np.hypot(*ahead) <= _AT_CM and corner < len(route) - 1:
            corner += 1
            ahead = route[corner][:2] - at[:2]
        away = float(np.hypot(*ahead))
        if away > _AT_CM:
            at = _step(world, at, ahead / away * min(tick, away), settings)
        gone = away <= _AT_CM and corner == len(route) - 1
        if number % every == 0 or gone:
            trace.append(at.copy())
            left.append(float(np.hypot(*(route[corner][:2] - at[:2])) + after[corner]))
        if gone:
            break
    return np.array(trace), np.array(left)


def _step(world: BodyWorld, at: Array, move: Array, settings: NavigationSettings) -> Array:
    """Where a tick leads; the same place where there is no way."""
    wanted = at + np.array([move[0], move[1], 0.0])
    ground = world.floor(wanted, settings.step_cm, _FALL_CM)
    if ground is None:
        return at
    wanted[2] = ground
    free = world.free(wanted)
    if free is None or np.hypot(*(free - at)[:2]) > 2 * SPEED_CM_S * TICK_S:
        return at
    ground = world.floor(free, settings.step_cm, _FALL_CM)
    if ground is None:
        return at
    free[2] = ground
    return free
