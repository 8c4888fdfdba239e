"""Rays and sweeps through the open level."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from c4s.collision.shapes import Body
from c4s.engine.headless.queries.advance import Advance, SweepHit
from c4s.engine.headless.queries.channels import Response
from c4s.engine.headless.queries.filters import Wanted
from c4s.engine.headless.queries.index import QueryTarget, SpatialIndex, current
from c4s.engine.headless.queries.solids import Array, ray_body
from c4s.engine.headless.queries.triangles import Rows, Triangles, facing, first_on_segment

SHORTEST_CM = 1e-4
"""Rays and shapes smaller than this are nothing, as in Unreal."""


@dataclass(frozen=True)
class Hit:
    """Where a query met a target. Lengths in cm."""

    target: QueryTarget
    distance: float
    location: Array
    """Where the ray, or the middle of the moved shape, is at that moment."""
    point: Array
    normal: Array
    face_normal: Array
    initial: bool = False
    """The query starts inside the target."""
    depth: float = 0.0
    """How deep the shape overlaps at the start."""
    element: int = -1
    """Which body of the target; -1 for triangles."""
    face: int = -1
    """Triangle of the mesh; -1 for bodies."""
    blocking: bool = True

    @property
    def rank(self) -> tuple[float, float]:
        """Order of hits: the nearest first, of overlaps at the start the deepest."""
        return self.distance, -self.depth


def ray(start: Array, end: Array, wanted: Wanted, *, many: bool = False, all_hits: bool = False) -> list[Hit]:
    """Hits of a line, nearest first: the first that blocks, and with ``many`` the overlaps before it (or all)."""
    step = end - start
    length = float(np.linalg.norm(step))
    if length <= SHORTEST_CM:
        return []
    index, direction = current(), step / length

    def meet(target: QueryTarget) -> Hit | None:
        found = _ray_triangles if wanted.triangles and target.asset is not None else _ray_bodies
        return found(index, target, start, direction, length)

    near = index.crossing(start, step, np.full(3, 1e-6))
    return _kept(_answered(near, wanted, meet, length, many), many, all_hits)


def sweep(
    moving: Body,
    end_offset: Array,
    wanted: Wanted,
    *,
    many: bool = False,
    all_hits: bool = False,
    skipped: frozenset[object] = frozenset(),
) -> list[Hit]:
    """Hits of a convex body that moves by a vector (cm), as ``ray``. A move of no length finds overlaps only.

    ``skipped``: components that are not met.
    """
    length = float(np.linalg.norm(end_offset))
    direction = end_offset / length if length > SHORTEST_CM else np.array([1.0, 0.0, 0.0])
    length = length if length > SHORTEST_CM else 0.0
    index = current()

    def meet(target: QueryTarget) -> Hit | None:
        if target.component in skipped:
            return None
        found = _sweep_triangles if wanted.triangles and target.asset is not None else _sweep_bodies
        return found(index, target, moving, direction, length)

    near = index.crossing((moving.low + moving.high) / 2, direction * length, (moving.high - moving.low) / 2 + 1e-3)
    return _kept(_answered(near, wanted, meet, length, many), many, all_hits)


def _answered(
    near: list[tuple[float, QueryTarget]],
    wanted: Wanted,
    meet: Callable[[QueryTarget], Hit | None],
    length: float,
    many: bool,
) -> Iterator[Hit]:
    """Hits on targets that answer; for a single hit nothing behind the nearest block is looked at."""
    best = np.inf
    for fraction, target in near:
        if fraction * length > best + 1e-6:
            break
        answer = wanted.sees(target)
        if answer is Response.IGNORE or (answer is Response.OVERLAP and not many):
            continue
        hit = meet(target)
        if hit is None:
            continue
        if answer is Response.BLOCK:
            best = min(best, hit.distance) if not many else best
            yield hit
        else:
            yield replace(hit, blocking=False)


def _kept(hits: Iterator[Hit], many: bool, all_hits: bool) -> list[Hit]:
    ordered = sorted(hits, key=lambda hit: (hit.distance, hit.blocking, -hit.depth))
    if all_hits:
        return ordered
    if not many:
        return sorted(ordered, key=lambda hit: hit.rank)[:1]
    first = next((i for i, hit in enumerate(ordered) if hit.blocking), None)
    return (
        ordered if first is None else [hit for hit in ordered[: first + 1] if not hit.blocking or hit is ordered[first]]
    )


def _ray_bodies(index: SpatialIndex, target: QueryTarget, start: Array, direction: Array, length: float) -> Hit | None:
    best: Hit | None = None
    for number, body in enumerate(index.bodies(target)):
        found = ray_body(body, start, direction, length)
        if found is not None and (best is None or found.distance < best.distance):
            place = start + found.distance * direction
            best = Hit(target, found.distance, place, place, found.normal, found.normal, found.inside, element=number)
    return best


def _world_corners(triangles: Triangles, rows: Rows, matrix: Array) -> Array:
    corners: Array = triangles.corners[rows] @ matrix[:3, :3].T + matrix[:3, 3]
    return corners


def _ray_triangles(
    index: SpatialIndex, target: QueryTarget, start: Array, direction: Array, length: float
) -> Hit | None:
    triangles = index.triangles(target)
    if triangles is None:
        return None
    matrix, inverse = target.matrices()
    step = direction * length
    if inverse is None:
        rows = np.arange(len(triangles.faces))
        found = first_on_segment(_world_corners(triangles, rows, matrix), start, step) if len(rows) else None
    else:  # the fraction of the way is the same in the frame of the mesh
        begin, way = inverse @ (start - matrix[:3, 3]), inverse @ step
        rows = triangles.along(begin, way)
        found = first_on_segment(triangles.corners[rows], begin, way) if len(rows) else None
    if found is None:
        return None
    fraction, row = found
    place = start + fraction * step
    normal = facing(_world_corners(triangles, rows[row : row + 1], matrix)[0], direction)
    return Hit(target, fraction * length, place, place, normal, normal, face=int(triangles.faces[rows[row]]))


def _swept(target: QueryTarget, moving: Body, direction: Array, hit: SweepHit, element: int, face: int) -> Hit:
    return Hit(
        target,
        hit.distance,
        moving.translation + hit.distance * direction,
        hit.point,
        hit.normal,
        hit.face_normal,
        hit.depth > 0,
        hit.depth,
        element,
        face,
    )


def _sweep_bodies(
    index: SpatialIndex, target: QueryTarget, moving: Body, direction: Array, length: float
) -> Hit | None:
    best: Hit | None = None
    for number, body in enumerate(index.bodies(target)):
        found = _advance().sweep(moving, body, direction, length)
        if found is not None:
            hit = _swept(target, moving, direction, found, number, -1)
            best = hit if best is None or hit.rank < best.rank else best
    return best


def _sweep_triangles(
    index: SpatialIndex, target: QueryTarget, moving: Body, direction: Array, length: float
) -> Hit | None:
    triangles = index.triangles(target)
    if triangles is None:
        return None
    (matrix, inverse), reach = target.matrices(), direction * length
    low, high = np.minimum(moving.low, moving.low + reach), np.maximum(moving.high, moving.high + reach)
    rows = (
        np.arange(len(triangles.faces))
        if inverse is None
        else triangles.within(*_local_box(matrix, inverse, low, high))
    )
    if not len(rows):
        return None
    corners = _world_corners(triangles, rows, matrix)
    corners, rows = _not_flattened(corners, rows)
    found = _advance().sweep_triangles(moving, corners, direction, length)
    return (
        None if found is None else _swept(target, moving, direction, found[0], -1, int(triangles.faces[rows[found[1]]]))
    )


def _not_flattened(corners: Array, rows: Rows) -> tuple[Array, Rows]:
    """Without the triangles that a scale of zero leaves no area."""
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    solid = np.linalg.norm(across, axis=1) > 1e-12
    return corners[solid], rows[solid]


def _local_box(matrix: Array, inverse: Array, low: Array, high: Array) -> tuple[Array, Array]:
    """Local box that holds a world box."""
    middle = inverse @ ((low + high) / 2 - matrix[:3, 3])
    half = np.abs(inverse) @ ((high - low) / 2) + 1e-3
    return middle - half, middle + half


def overlaps(bodies: list[Body], wanted: Wanted) -> list[QueryTarget]:
    """Targets that any of the bodies overlaps (touching is no overlap), in a steady order."""
    if not bodies:
        return []
    index = current()
    low = np.min([body.low for body in bodies], axis=0)
    high = np.max([body.high for body in bodies], axis=0)
    return [
        target
        for target in index.meeting(low, high)
        if wanted.sees(target) is not Response.IGNORE
        and any(_advance().overlap(mine, other) > SHORTEST_CM for mine in bodies for other in index.bodies(target))
    ]


def gap(a: Body, b: Body) -> tuple[float, Array]:
    """Signed distance of two bodies (cm) and the point of the second that is nearest."""
    distance, _, point = _advance().distance(a, b, np.zeros(3))
    return distance, point


@functools.cache
def _advance() -> Advance:
    return Advance()
