"""Contacts between the actors of a scene, with their exact minimum-translation depth.

Broad phase: an STR tree over plan boxes, then height, then the push-out of the two boxes, which bounds the depth from
above. Narrow phase: coal's signed distance is the depth, python-fcl's collision test confirms the touch; a contact on
which they disagree is reported as not trusted. The depth of two actors is the largest depth of their convex bodies,
which is what an engine with separate shapes reports.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import coal
import fcl
import numpy as np
import shapely
from numpy.typing import NDArray

from c4s.collision.scene import SceneBodies, scene_bodies
from c4s.collision.shapes import Body

CHUNK = 1024
"""Bodies that are searched for partners at a time: bounds the memory of a crowded scene."""
CONFIRM_CM = 1e-3
"""Below this depth python-fcl's touch test is within its own rounding and cannot contradict coal."""
NUDGE_CM = 1e-5
"""How far a degenerate pair is moved before it is measured again; its depth is wrong by at most this."""
NUDGES_CM = tuple(NUDGE_CM * np.array(step) for step in ((0.36, 0.48, 0.8), (-0.8, 0.36, 0.48), (0.48, -0.8, 0.36)))


@dataclass(frozen=True)
class Contact:
    """Two actors that overlap. ``depth_cm`` is the minimum translation (cm) that separates their deepest bodies."""

    a: str
    """Object name of the actor that comes first in the snapshot."""
    b: str
    depth_cm: float
    trusted: bool
    """False when the touch or the depth could not be confirmed."""
    a_index: int = -1
    """Position of the actor in the snapshot."""
    b_index: int = -1


def contacts(snapshot: Mapping[str, Any], *, minimum_depth_cm: float = 0.0,
             actors: Collection[str] | None = None) -> list[Contact]:
    """Contacts deeper than ``minimum_depth_cm``, in snapshot order; ``actors``: only those of these object names."""
    return scene_contacts(snapshot, scene_bodies(snapshot), minimum_depth_cm=minimum_depth_cm, actors=actors)


def scene_contacts(snapshot: Mapping[str, Any], scene: SceneBodies, *, minimum_depth_cm: float = 0.0,
                   actors: Collection[str] | None = None) -> list[Contact]:
    """``contacts`` for bodies that are already placed."""
    names = [str(actor.get("name") or actor.get("label") or f"#{i}")
             for i, actor in enumerate(snapshot.get("actors") or [])]
    chosen = None if actors is None else np.array([names[owner] in actors for owner in scene.owners], dtype=bool)
    deepest: dict[tuple[int, int], tuple[float, bool]] = {}
    measure = DepthMeter()
    for i, j, push_out in _candidates(scene, minimum_depth_cm, chosen):
        depth, trusted = measure(scene.bodies[i], scene.bodies[j], push_out)
        if depth > minimum_depth_cm:
            first, second = scene.owners[i], scene.owners[j]
            pair = (first, second) if first < second else (second, first)
            before = deepest.get(pair)
            if before is None or (trusted, depth) > (before[1], before[0]):
                deepest[pair] = depth, trusted
    return [Contact(names[a], names[b], depth, trusted, a, b)
            for (a, b), (depth, trusted) in sorted(deepest.items())]


def _candidates(scene: SceneBodies, minimum_depth_cm: float, chosen: NDArray[np.bool_] | None
                ) -> Iterator[tuple[int, int, float]]:
    """Body pairs of different actors whose boxes overlap by more than ``minimum_depth_cm``, with that push-out."""
    if len(scene.bodies) < 2:
        return
    low = np.array([body.low for body in scene.bodies])
    high = np.array([body.high for body in scene.bodies])
    owners = np.array(scene.owners)
    boxes = shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1])
    tree = shapely.STRtree(boxes)
    searching = np.arange(len(boxes)) if chosen is None else np.flatnonzero(chosen)
    for start in range(0, len(searching), CHUNK):
        part = searching[start:start + CHUNK]
        found, j = tree.query(boxes[part])
        i = part[found]
        keep = owners[i] != owners[j]
        keep &= (i < j) if chosen is None else ((i < j) | ~chosen[j])
        i, j = i[keep], j[keep]
        push_out = np.minimum(high[i] - low[j], high[j] - low[i]).min(axis=1)
        keep = push_out > minimum_depth_cm
        yield from zip(i[keep].tolist(), j[keep].tolist(), push_out[keep].tolist(), strict=True)


class DepthMeter:
    """Measures ``(depth in cm, trusted)`` of two bodies; the depth is 0 when they do not overlap.

    The push-out of the two world boxes bounds the true depth from above. coal's expanding polytope has no volume to
    start from when a round body's core lies exactly in a flat one; a depth above the bound shows that, and the pair is
    measured again a hair's breadth (``NUDGE_CM``) apart.
    """

    def __init__(self) -> None:
        self._distance_request, self._distance = coal.DistanceRequest(), coal.DistanceResult()
        self._collision_request = fcl.CollisionRequest(num_max_contacts=1, enable_contact=False)

    def __call__(self, a: Body, b: Body, push_out: float | None = None) -> tuple[float, bool]:
        bound = float(np.minimum(a.high - b.low, b.high - a.low).min()) if push_out is None else push_out
        for nudge in (None, *NUDGES_CM):
            depth = self._depth(a, b if nudge is None else b.moved(nudge))
            if depth <= bound * (1 + 1e-6) + CONFIRM_CM:
                break
        else:
            return bound, False
        if depth <= 0:
            return 0.0, True
        return depth, depth <= CONFIRM_CM or bool(
            fcl.collide(a.fcl_object, b.fcl_object, self._collision_request, fcl.CollisionResult()))

    def _depth(self, a: Body, b: Body) -> float:
        """coal's signed distance, turned; infinite when it is no number."""
        self._distance.clear()
        depth = -float(coal.distance(a.shape, a.coal_pose, b.shape, b.coal_pose,
                                     self._distance_request, self._distance))
        return depth if math.isfinite(depth) else math.inf
