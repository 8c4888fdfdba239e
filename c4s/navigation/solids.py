"""The triangles of collision bodies, and the box in which a scene is walked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from c4s.collision.mesh_body import Array
from c4s.collision.scene import SceneBodies
from c4s.collision.shapes import SIGNS, Body, Shape
from c4s.protocol.navigation import PLATE_CM, TOWER_CM

MARGIN_CM = 200.0
"""How far in plan the mesh reaches beyond what bounds it, so that things at the edge can be approached."""
_BOX = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                 [0, 6, 4], [1, 5, 7], [1, 7, 3]], dtype=np.int64)  # fmt: skip
_ROUND, _RINGS = 24, 6
"""Corners of a round body's ring, and rings of each of its ends."""


@dataclass(frozen=True)
class BodyTriangles:
    """Triangles of convex bodies (cm), those of a body in a row and looking outward."""

    triangles: Array
    """(m, 3, 3)."""
    first: NDArray[np.int64]
    """(bodies + 1) where each body's triangles begin."""
    low: Array
    """(bodies, 3) world boxes."""
    high: Array


def solids_of(bodies: Sequence[Body]) -> BodyTriangles:
    """The triangles of bodies, in their order."""
    groups: dict[int, list[int]] = {}
    for index, body in enumerate(bodies):
        groups.setdefault(id(body.form), []).append(index)
    local = {key: _local(bodies[members[0]].form) for key, members in groups.items()}
    counts = np.array([len(local[id(body.form)]) for body in bodies], dtype=np.int64)
    first = np.concatenate([np.zeros(1, np.int64), np.cumsum(counts)])
    triangles = np.empty((int(first[-1]), 3, 3))
    for key, members in groups.items():
        shape = local[key]
        rotation = np.array([bodies[index].rotation for index in members])
        centre = np.array([bodies[index].translation for index in members])
        rows = first[members][:, None] + np.arange(len(shape))
        for some in np.array_split(np.arange(len(members)), max(1, len(members) * len(shape) // 200_000)):
            world = np.einsum("bij,tcj->btci", rotation[some], shape) + centre[some][:, None, None, :]
            triangles[rows[some].ravel()] = world.reshape(-1, 3, 3)
    low = np.array([body.low for body in bodies]).reshape(-1, 3)
    high = np.array([body.high for body in bodies]).reshape(-1, 3)
    return BodyTriangles(triangles, first, low, high)


def is_walkable(triangles: Array, slope_deg: float) -> NDArray[np.bool_]:
    """Which triangles look up and are flat enough to stand on."""
    sides = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(sides, axis=1)
    up = np.divide(sides[:, 2], length, out=np.zeros(len(sides)), where=length > 0)
    return np.asarray(up > np.cos(np.radians(slope_deg)))


def navigation_bounds(scene: SceneBodies) -> tuple[Array, Array] | None:
    """The box that the bodies span (cm), without components that would dominate it; None without a body."""
    owners: dict[tuple[int, int], list[int]] = {}
    for index, key in enumerate(zip(scene.owners, scene.components, strict=True)):
        owners.setdefault(key, []).append(index)
    low = np.array([body.low for body in scene.bodies]).reshape(-1, 3)
    high = np.array([body.high for body in scene.bodies]).reshape(-1, 3)
    boxes = [(low[rows].min(axis=0), high[rows].max(axis=0)) for rows in owners.values()]
    kept = [(a, b) for a, b in boxes if (b - a)[:2].max() <= PLATE_CM and (b - a)[2] <= TOWER_CM]
    if not kept:
        return None
    margin = np.array([MARGIN_CM, MARGIN_CM, 0.0])
    return np.min([a for a, _ in kept], axis=0) - margin, np.max([b for _, b in kept], axis=0) + margin


def _local(shape: Shape) -> Array:
    """Triangles (m, 3, 3) of a shape in its own frame, looking outward."""
    if shape.corners is not None:
        assert shape.triangles is not None
        return np.asarray(shape.corners[shape.triangles])
    if shape.radius == 0:
        return _outward((SIGNS * shape.half)[_BOX])
    return _round(shape.radius, float(shape.half[2]))


@lru_cache(maxsize=256)
def _round(radius: float, half: float) -> Array:
    """A capsule along Z, or a sphere where ``half`` is 0, from just outside."""
    angles = np.linspace(0, np.pi / 2, _RINGS + 1)
    levels = [(radius * np.sin(a), half + radius * np.cos(a)) for a in angles]
    levels += [(r, -z) for r, z in reversed(levels)]
    turn = np.arange(_ROUND) * 2 * np.pi / _ROUND
    rings = np.array([np.column_stack([r * np.cos(turn), r * np.sin(turn), np.full(_ROUND, z)]) for r, z in levels])
    after = np.roll(rings, -1, axis=1)
    quads = [(rings[k], after[k], rings[k + 1], after[k + 1]) for k in range(len(rings) - 1)]
    faces = [np.stack(three, axis=1) for a, b, c, d in quads for three in ((a, c, b), (b, c, d))]
    return _outward(np.concatenate(faces))


def _outward(triangles: Array) -> Array:
    """The same triangles of a body around its origin, each turned to look away from it."""
    sides = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    inward = (sides * triangles.mean(axis=1)).sum(axis=1) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return triangles
