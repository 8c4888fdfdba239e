"""Whether the triangles of two actors truly penetrate each other, found without c4s's collision bodies.

Two things penetrate by at most ``t`` when a straight move of at most ``t`` frees their triangles of each other. So
every direction of an even set, and the axes, is tried at a few lengths with python-fcl's triangle test (which says
whether, not how deep, and is right in that), and what lies inside a closed surface is found by the parity of rays.
The way that would free them is searched, never proven absent: a penetration that is called true may be shallower.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import fcl
import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from c4s.packs.store import PackStore

Array = NDArray[np.float64]
SHARES = (0.1, 0.4, 0.7, 1.0)
"""Lengths that are tried, by the tolerance."""
EVEN_DIRECTIONS = 120
RAY = np.array([0.5773, 0.5221, 0.6279])
"""A direction that no edge of made things has."""


def _directions() -> Array:
    height = 1 - 2 * (np.arange(EVEN_DIRECTIONS) + 0.5) / EVEN_DIRECTIONS
    turn = np.arange(EVEN_DIRECTIONS) * np.pi * (3 - 5**0.5)
    flat = np.sqrt(1 - height**2)
    even = np.stack([flat * np.cos(turn), flat * np.sin(turn), height], axis=1)
    return np.concatenate([np.eye(3)[[2, 0, 1]], -np.eye(3)[[0, 1, 2]], even])


WAYS = _directions()


@dataclass(frozen=True)
class WorldTriangles:
    """The world triangles of an actor (cm)."""

    vertices: Array
    faces: NDArray[np.int64]

    @cached_property
    def low(self) -> Array:
        return np.asarray(self.vertices.min(axis=0))

    @cached_property
    def high(self) -> Array:
        return np.asarray(self.vertices.max(axis=0))

    @cached_property
    def bvh(self) -> Any:
        """python-fcl's tree."""
        model = fcl.BVHModel()
        model.beginModel(len(self.vertices), len(self.faces))
        model.addSubModel(self.vertices, self.faces)
        model.endModel()
        return model

    @cached_property
    def _pieces(self) -> NDArray[np.int64]:
        """The connected piece of each corner."""
        edges = np.concatenate([self.faces[:, [0, 1]], self.faces[:, [1, 2]]])
        count = len(self.vertices)
        joins = coo_array((np.ones(len(edges), np.int8), (edges[:, 0], edges[:, 1])), shape=(count, count))
        return np.asarray(connected_components(joins, directed=False)[1])

    @cached_property
    def probes(self) -> Array:
        """One corner of each connected piece."""
        return np.asarray(self.vertices[np.unique(self._pieces, return_index=True)[1]])

    @cached_property
    def closed(self) -> Any:
        """The closed pieces, as a caster of rays; None when there are none."""
        piece = self._pieces[self.faces[:, 0]]
        edges = np.sort(self.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        _, which, count = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
        odd = (count % 2 == 1)[which.reshape(-1)].reshape(-1, 3).any(axis=1)
        whole = ~np.isin(piece, piece[odd])
        if not whole.any():
            return None
        return trimesh.Trimesh(self.vertices, self.faces[whole], process=False)

    def holds(self, points: Array) -> bool:
        """Whether a point lies inside the closed pieces."""
        near = points[((points > self.low) & (points < self.high)).all(axis=1)]
        if not len(near) or self.closed is None:
            return False
        _, rays = self.closed.ray.intersects_id(near, np.tile(RAY, (len(near), 1)), multiple_hits=True)
        return bool((np.bincount(rays, minlength=len(near)) % 2 == 1).any())


def welded(vertices: Array, faces: NDArray[np.int64]) -> WorldTriangles:
    """One corner a place; triangles without an area left out."""
    corners, same = np.unique(np.round(vertices, 3) + 0.0, axis=0, return_inverse=True)
    faces = same.reshape(-1)[faces].astype(np.int64)
    across = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    return WorldTriangles(corners, faces[np.linalg.norm(across, axis=1) > 1e-9])


def touch(a: WorldTriangles, b: WorldTriangles, step: Array) -> bool:
    """Whether a, moved by ``step`` (cm), meets b: their triangles cross, or one lies inside the other."""
    if (a.low + step > b.high).any() or (a.high + step < b.low).any():
        return False
    request, result = fcl.CollisionRequest(), fcl.CollisionResult()
    one = fcl.CollisionObject(a.bvh, fcl.Transform(np.eye(3), step))
    if fcl.collide(one, fcl.CollisionObject(b.bvh), request, result):
        return True
    return b.holds(a.probes + step) or a.holds(b.probes - step)


def penetrates(a: WorldTriangles, b: WorldTriangles, tolerance_cm: float) -> bool:
    """Whether no move of at most the tolerance that was tried frees the two."""
    if not touch(a, b, np.zeros(3)):
        return False
    return all(touch(a, b, way * share * tolerance_cm) for share in SHARES for way in WAYS)


def world_triangles(actor: Mapping[str, Any], store: PackStore, meshes: Mapping[str, Any]) -> WorldTriangles | None:
    """The triangles of an exported actor that collide; None when it has none."""
    from c4s.verify.physics.surfaces import read_component

    points, faces, count = [], [], 0
    for part in (actor.get("c4s") or {}).get("components") or []:
        component = read_component(part)
        if component is None or not component.collides:
            continue
        mesh = store.recorded_mesh(component.mesh, meshes.get(component.mesh) or {})
        if mesh is None:
            continue
        for place in component.places:
            points.append(np.asarray(mesh.vertices, float) @ place[:3, :3].T + place[:3, 3])
            faces.append(np.asarray(mesh.faces, np.int64) + count)
            count += len(mesh.vertices)
    return welded(np.concatenate(points), np.concatenate(faces)) if points else None
