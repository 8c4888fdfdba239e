"""Rays against single convex bodies. Distances are in cm; a ray is a start, a unit direction and a length."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.collision.libraries import coal
from c4s.collision.shapes import Body, Shape

Array: TypeAlias = NDArray[np.float64]
PARALLEL = 1e-12


@dataclass(frozen=True)
class RayHit:
    """Where a ray meets a surface."""

    distance: float
    normal: Array
    """Unit normal of the surface in the world, towards the start."""
    inside: bool = False
    """The ray starts inside the body."""


@lru_cache(maxsize=16384)
def planes(shape: Shape) -> Array | None:
    """Faces of a box or hull in its own frame, rows of normal and offset (``n . p + offset <= 0`` inside).

    None for round shapes. A flat hull has two opposite faces and its edges.
    """
    if isinstance(shape.coal, coal.Box):
        return np.column_stack([np.concatenate([np.eye(3), -np.eye(3)]), -np.concatenate([shape.half, shape.half])])
    if shape.corners is None:
        return None
    from scipy.spatial import ConvexHull, QhullError  # takes as long to load as all else that an engine does

    try:
        return np.unique(np.round(ConvexHull(shape.corners).equations, 12), axis=0)
    except QhullError:
        return _flat_planes(shape.corners)


def _flat_planes(corners: Array) -> Array:
    centre = corners.mean(axis=0)
    normal = np.linalg.svd(corners - centre, full_matrices=False)[2][2]
    rows = [[*normal, -float(normal @ centre)], [*-normal, float(normal @ centre)]]
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        outward = np.cross(b - a, normal)
        outward = outward / np.linalg.norm(outward)
        if outward @ (centre - a) > 0:
            outward = -outward
        rows.append([*outward, -float(outward @ a)])
    return np.array(rows)


def ray_body(body: Body, start: Array, direction: Array, length: float) -> RayHit | None:
    """First point of a body along a ray; a start inside it is a hit at distance 0 whose normal is turned back."""
    local, way = (start - body.translation) @ body.rotation, direction @ body.rotation
    faces = planes(body.form)
    if faces is None:
        return _ray_round(body, local, way, direction, length)
    heights, speeds = faces[:, :3] @ local + faces[:, 3], faces[:, :3] @ way
    if (heights <= 0).all():
        return (
            RayHit(0.0, -direction, True)
            if (heights < 0).all() or _thick(body.form)
            else _flat_start(body, faces, speeds, direction)
        )
    still = np.abs(speeds) < PARALLEL
    if (still & (heights > 0)).any():
        return None
    times = -heights / np.where(still, 1.0, speeds)
    entering = ~still & (speeds < 0)
    leaving = ~still & (speeds > 0)
    face = int(np.argmax(np.where(entering, times, -np.inf)))
    first = float(times[face]) if entering.any() else -math.inf
    last = float(times[leaving].min()) if leaving.any() else math.inf
    if first < 0 or first > last + 1e-9 or first > length:
        return None
    return RayHit(first, body.rotation @ faces[face, :3])


def _thick(shape: Shape) -> bool:
    return shape.corners is None or bool(np.linalg.svd(shape.corners - shape.corners.mean(axis=0))[1][-1] > 1e-9)


def _flat_start(body: Body, faces: Array, speeds: Array, direction: Array) -> RayHit | None:
    """A start on a flat hull: a hit at distance 0 unless the ray runs along it."""
    face = int(np.argmin(speeds[:2]))
    return RayHit(0.0, body.rotation @ faces[face, :3]) if speeds[face] < -PARALLEL else None


def _ray_round(body: Body, local: Array, way: Array, direction: Array, length: float) -> RayHit | None:
    """A sphere, or a capsule along the body's Z."""
    shape = body.form
    half, radius = float(shape.half[2]), shape.radius
    x, y, z = local.tolist()
    axis = z - min(max(z, -half), half)
    if x * x + y * y + axis * axis <= radius * radius:
        return RayHit(0.0, -direction, True)
    found = [_ball(local - (0.0, 0.0, end), way, radius) for end in ({0.0} if half == 0 else {-half, half})]
    if half > 0:
        u, v, w = way.tolist()
        a, b, c = u * u + v * v, x * u + y * v, x * x + y * y - radius * radius
        if a > PARALLEL and b * b - a * c >= 0:
            t = (-b - math.sqrt(b * b - a * c)) / a
            found.append(t if abs(z + t * w) <= half else math.inf)
    first = min(found)
    if not 0 <= first <= length:
        return None
    point = local + first * way
    point[2] -= min(max(float(point[2]), -half), half)
    return RayHit(first, body.rotation @ (point / radius))


def _ball(local: Array, way: Array, radius: float) -> float:
    b = float(local @ way)
    root = b * b - float(local @ local) + radius * radius
    return -b - math.sqrt(root) if root >= 0 else math.inf


def surface_normal(body: Body, point: Array, direction: Array, fallback: Array) -> Array:
    """Normal of the body's surface at a point of it: of the faces that meet there, the one most against a direction."""
    faces = planes(body.form)
    if faces is None:
        return fallback
    on = np.abs(faces[:, :3] @ ((point - body.translation) @ body.rotation) + faces[:, 3]) < 0.01
    if not on.any():
        return fallback
    normals: Array = faces[on][:, :3] @ body.rotation.T
    found: Array = normals[int(np.argmin(normals @ direction))]
    return found
