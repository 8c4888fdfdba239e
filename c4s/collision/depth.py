"""Penetration depth of body pairs: the minimum translation that separates two convex bodies (cm).

Two boxes have a closed form. For all others coal's signed distance is the depth and python-fcl's collision test
confirms the touch. coal's answer is proven before it is used: its normal is a direction, the bodies can be pushed
apart along it by a length that is read from their corners, and the true depth is at most that. An answer that is not
that length (an expanding polytope that ran out of steps on a smooth hull, or that had no volume to start from on flat
and round bodies) is measured again with more steps, then a hair's breadth apart. What is still unproven, as of boxes
that are turned by next to nothing, is read from the faces of the Minkowski difference, or is not trusted.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.collision.boxes import box_depths
from c4s.collision.libraries import coal, fcl
from c4s.collision.mesh_body import Array
from c4s.collision.shapes import Body

NOISE_CM = 1e-6
"""Depths up to this are flush: rounding of exact contacts, also far from the origin."""
CONFIRM_CM = 1e-3
"""Below this depth python-fcl's touch test is within its own rounding and cannot contradict coal."""
PROOF_CM, PROOF_SHARE = 1e-4, 1e-6
"""How far the way out along coal's normal may be from its depth: absolute, and by the push-out of the boxes."""
NUDGE_CM = 1e-5
"""How far a degenerate pair is moved before it is measured again; its depth is wrong by at most this."""
NUDGES_CM = tuple(NUDGE_CM * np.array(step) for step in ((0.36, 0.48, 0.8), (-0.8, 0.36, 0.48), (0.48, -0.8, 0.36)))
MOST_STEPS = 4000
"""Steps of coal's expanding polytope when its usual 64 were not enough: one a corner of the Minkowski difference."""
MOST_DIFFERENCES = 20_000
"""Points of a Minkowski difference that are still made into a hull (some 10 ms)."""

Pairs = NDArray[np.int64]


class BodyTable:
    """The bodies of a scene as arrays, for work on many pairs at once."""

    def __init__(self, bodies: Sequence[Body]) -> None:
        self.bodies = bodies
        self.low = np.array([body.low for body in bodies]).reshape(-1, 3)
        self.high = np.array([body.high for body in bodies]).reshape(-1, 3)
        self._rotation = np.array([body.rotation for body in bodies]).reshape(-1, 3, 3)
        self._translation = np.array([body.translation for body in bodies]).reshape(-1, 3)
        self._half = np.array([body.form.half for body in bodies]).reshape(-1, 3)
        self._radius = np.array([body.form.radius for body in bodies])
        self._box = np.array([body.form.is_box for body in bodies], dtype=bool)
        forms: dict[int, int] = {}
        self._form = np.array([forms.setdefault(id(body.form), len(forms)) for body in bodies], dtype=np.int64)
        rows = np.concatenate([self.low, self.high, self._rotation.reshape(-1, 9)], axis=1)
        self.rank = np.empty(len(bodies), dtype=np.int64)
        self.rank[np.lexsort(rows.T)] = np.arange(len(bodies))
        """Order of the bodies by where they are: pairs are measured in it, so the order of actors changes nothing."""

    def depths(self, i: Pairs, j: Pairs, push_out: Array, minimum_cm: float) -> tuple[Array, NDArray[np.bool_]]:
        """Depth in cm of each pair, 0 when it is not above ``minimum_cm``; and whether it is trusted.

        ``push_out``: how far the pairs' world boxes overlap along their smallest axis.
        """
        first = np.where(self.rank[i] < self.rank[j], i, j)
        second = i + j - first
        depth, trusted = np.zeros(len(i)), np.ones(len(i), dtype=bool)
        boxes = self._box[first] & self._box[second]
        a, b = first[boxes], second[boxes]
        depth[boxes] = box_depths(
            self._half[a],
            self._rotation[a],
            self._half[b],
            self._rotation[b],
            self._translation[b] - self._translation[a],
        )
        others = np.flatnonzero(~boxes)
        depth[others], trusted[others] = self._measured(first[others], second[others], push_out[others], minimum_cm)
        return np.where(depth > max(minimum_cm, NOISE_CM), depth, 0.0), trusted

    def _measured(self, a: Pairs, b: Pairs, push_out: Array, minimum_cm: float) -> tuple[Array, NDArray[np.bool_]]:
        normal = np.empty((len(a), 3))
        depth = np.array(self._distances(a, b, normal))
        depth[~np.isfinite(depth)] = math.inf
        trusted = np.ones(len(a), dtype=bool)
        proven = _proves(depth, self._way_out(a, b, normal), push_out)
        meter = DepthMeter()
        for k in np.flatnonzero(~proven).tolist():
            depth[k], trusted[k] = meter(self.bodies[a[k]], self.bodies[b[k]], float(push_out[k]))
        for k in np.flatnonzero(proven & (depth > max(minimum_cm, CONFIRM_CM))).tolist():
            trusted[k] = _touch(self.bodies[a[k]], self.bodies[b[k]])
        return depth, trusted

    def _distances(self, a: Pairs, b: Pairs, normal: Array) -> list[float]:
        """coal's depth of each pair; fills in the normals, from a to b."""
        used = np.union1d(a, b).tolist()
        forms = {k: self.bodies[k].form.coal for k in used}
        poses = {k: self.bodies[k].coal_pose for k in used}
        request, result = coal.DistanceRequest(), coal.DistanceResult()
        distance, clear, found = coal.distance, result.clear, []
        for k, (one, other) in enumerate(zip(a.tolist(), b.tolist(), strict=True)):
            clear()
            found.append(-distance(forms[one], poses[one], forms[other], poses[other], request, result))
            normal[k] = result.normal
        return found

    def _way_out(self, a: Pairs, b: Pairs, normal: Array) -> Array:
        """How far b must move along ``normal`` to leave a, per pair (negative: so far it is already)."""
        offset = np.einsum("ni,ni->n", self._translation[a] - self._translation[b], normal)
        return np.asarray(offset + self._reach(a, normal) + self._reach(b, -normal))

    def _reach(self, index: Pairs, direction: Array) -> Array:
        """How far each body reaches from its own centre along a direction (unit, n x 3)."""
        local = np.einsum("nji,nj->ni", self._rotation[index], direction)
        reach = np.asarray((np.abs(local) * self._half[index]).sum(axis=1) + self._radius[index])
        form = self._form[index]
        order = np.argsort(form, kind="stable")
        for group in np.split(order, np.flatnonzero(np.diff(form[order])) + 1):
            corners = self.bodies[index[group[0]]].form.corners if len(group) else None
            if corners is not None:
                reach[group] = (local[group] @ corners.T).max(axis=1)
        return reach


class DepthMeter:
    """Measures ``(depth in cm, trusted)`` of two bodies; the depth is 0 when they do not overlap.

    A depth that cannot be proven is reported as the push-out of the two world boxes, which bounds it from above, and
    is not trusted.
    """

    def __init__(self) -> None:
        self._request, self._result = coal.DistanceRequest(), coal.DistanceResult()
        self._request.epa_max_iterations = MOST_STEPS
        self._request.gjk_max_iterations = MOST_STEPS

    def __call__(self, a: Body, b: Body, push_out: float | None = None) -> tuple[float, bool]:
        bound = float(np.minimum(a.high - b.low, b.high - a.low).min()) if push_out is None else push_out
        if bound <= NOISE_CM:
            return 0.0, True
        for depth, normal, other in self._answers(a, b):
            way_out = float((a.translation - other.translation) @ normal) + a.reach(normal) + other.reach(-normal)
            if _proves(np.array([depth]), np.array([way_out]), np.array([bound]))[0]:
                break
        else:
            return bound, False
        if depth <= NOISE_CM:
            return 0.0, True
        return depth, depth <= CONFIRM_CM or _touch(a, b)

    def _answers(self, a: Body, b: Body) -> Iterator[tuple[float, Array, Body]]:
        """Depth and normal from a to b, to be proven, each with b where it was measured."""
        for nudge in (None, *NUDGES_CM):
            other = b if nudge is None else b.moved(nudge)
            distance, normal = self.signed(a, other)
            yield -distance, normal, other
        if a.form.radius == b.form.radius == 0:
            yield from ((depth, normal, b) for depth, normal in _least_face(a.points, b.points))

    def signed(self, a: Body, b: Body) -> tuple[float, Array]:
        """Signed distance in cm, negative where the bodies overlap, and the unit normal from a to b along it; as coal
        finds them, without a proof."""
        self._result.clear()
        distance = float(coal.distance(a.form.coal, a.coal_pose, b.form.coal, b.coal_pose, self._request, self._result))
        return distance, np.array(self._result.normal)


def _proves(depth: Array, way_out: Array, push_out: Array) -> NDArray[np.bool_]:
    """Whether a way out proves that no pair is deeper, and the boxes that none is as deep as an impossible answer."""
    slack = PROOF_CM + PROOF_SHARE * push_out
    with np.errstate(invalid="ignore"):
        proven = (np.abs(way_out - depth) <= slack) | ((depth <= 0) & (way_out <= slack))
        return np.asarray(proven & (depth <= push_out + slack))


def _least_face(a: Array, b: Array) -> Iterator[tuple[float, Array]]:
    """Depth of two sharp-edged bodies by their corners: how deep the origin lies below the nearest face of a - b, and
    that face's normal; nothing where the difference is too large or flat."""
    from scipy.spatial import ConvexHull, QhullError

    if len(a) * len(b) > MOST_DIFFERENCES:
        return
    try:
        faces = ConvexHull((a[:, None] - b[None]).reshape(-1, 3)).equations
    except QhullError:
        return
    nearest = faces[faces[:, 3].argmax()]
    yield -float(nearest[3]), nearest[:3]


def _touch(a: Body, b: Body) -> bool:
    """Whether python-fcl finds the two bodies in touch."""
    return bool(fcl.collide(a.fcl_object, b.fcl_object, _touch_request(), fcl.CollisionResult()))


@functools.cache
def _touch_request() -> Any:
    return fcl.CollisionRequest(num_max_contacts=1, enable_contact=False)
