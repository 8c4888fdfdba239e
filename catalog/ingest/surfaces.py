"""The connected pieces of a mesh, and whether each of them bounds a solid.

Corners at one place are one corner; triangles without an area, and all but one of triangles with the same corners (the
two sides of a double-sided plane), are left out. Neighbours are turned to one winding before a volume is taken.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull, QhullError

Points = NDArray[np.float64]
Faces = NDArray[np.int64]
WELD_DIGITS = 2
"""Corners are welded to 0.01 cm."""
FLAT_CM = 0.5
"""A piece with no more thickness than this is a sheet."""


@dataclass(frozen=True)
class Hole:
    """An opening in a surface: the area of its straightest lid, its outward direction and its middle (cm)."""

    area: float
    direction: Points
    middle: Points


@dataclass(frozen=True, eq=False)
class SurfacePiece:
    """A connected surface: its corners (n, 3) in cm and its triangles, wound alike where that is possible."""

    points: Points
    faces: Faces
    two_sided: bool = False
    """It was given with both windings."""

    @property
    def triangles(self) -> Points:
        """(m, 3 corners, 3)."""
        return self.points[self.faces]

    @property
    def size(self) -> float:
        """Diagonal of its box."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    @cached_property
    def hull(self) -> ConvexHull | None:
        """Its convex hull; None when it is flat."""
        centred = self.points - self.points.mean(axis=0)
        axes = np.linalg.eigh(centred.T @ centred)[1]
        if float(np.ptp(centred @ axes, axis=0).min()) <= FLAT_CM:
            return None
        try:
            return ConvexHull(self.points)
        except QhullError:
            return None

    @cached_property
    def _rims(self) -> list[Faces]:
        """Directed edges (n, 2) without a neighbour, a set for each opening."""
        edges = self.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        low, high = edges.min(axis=1), edges.max(axis=1)
        _, which, count = np.unique(low * len(self.points) + high, return_inverse=True, return_counts=True)
        rim = edges[(count % 2 == 1)[which.reshape(-1)]]
        if not len(rim):
            return []
        used, named = np.unique(rim, return_inverse=True)
        named = named.reshape(-1, 2)
        joins = coo_array((np.ones(len(named), np.int8), (named[:, 0], named[:, 1])), shape=(len(used), len(used)))
        label = connected_components(joins, directed=False)[1][named[:, 0]]
        return [rim[label == one] for one in np.unique(label)]

    @cached_property
    def holes(self) -> list[Hole]:
        """Its openings; none when it is watertight."""
        found = []
        for rim in self._rims:
            start, end = self.points[rim[:, 0]], self.points[rim[:, 1]]
            middle = start.mean(axis=0)
            lid = -np.cross(start - middle, end - middle).sum(axis=0) / 2
            area = float(np.linalg.norm(lid))
            found.append(Hole(area, lid / area if area > 0 else np.zeros(3), middle))
        return found

    @cached_property
    def volume(self) -> float:
        """Signed volume (cm3) with a lid on every opening; negative when its triangles face inwards."""
        centre = self.points.mean(axis=0)
        a, b, c = (self.points[self.faces[:, i]] - centre for i in range(3))
        total = float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum())
        for rim in self._rims:
            start, end = self.points[rim[:, 0]] - centre, self.points[rim[:, 1]] - centre
            total += float(np.einsum("ij,ij->i", end, np.cross(start, start.mean(axis=0)[None])).sum())
        return total / 6

    @property
    def hole_share(self) -> float:
        """Area of the openings by that of the hull."""
        return sum(hole.area for hole in self.holes) / float(self.hull.area) if self.hull is not None else 1.0

    def lidded(self) -> SurfacePiece:
        """The piece with a lid on every opening."""
        points, faces = [self.points], [self.faces]
        for number, rim in enumerate(self._rims):
            points.append(self.points[rim[:, 0]].mean(axis=0, keepdims=True))
            tip = np.full(len(rim), len(self.points) + number)
            faces.append(np.column_stack([rim[:, 1], rim[:, 0], tip]))
        return SurfacePiece(np.concatenate(points), np.concatenate(faces))

    def turned(self) -> SurfacePiece:
        """The piece inside out."""
        return SurfacePiece(self.points, self.faces[:, ::-1], self.two_sided)


def connected(welded: Faces, group: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """Indices of the faces of each set that hangs together by corners of the same group."""
    if not len(welded):
        return []
    keys = welded.astype(np.int64) * (int(group.max()) + 1) + group[:, None]
    _, corner = np.unique(keys, return_inverse=True)
    corner = corner.reshape(keys.shape)
    edges = np.concatenate([corner[:, [0, 1]], corner[:, [1, 2]]])
    count = int(corner.max()) + 1
    joins = coo_array((np.ones(len(edges), np.int8), (edges[:, 0], edges[:, 1])), shape=(count, count))
    label = connected_components(joins, directed=False)[1][corner[:, 0]]
    order = np.argsort(label, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(label[order])) + 1)


def weld(vertices: Points, faces: Faces) -> tuple[Points, Faces]:
    """One corner a place; triangles that have no area are left out."""
    corners, same = np.unique(np.round(vertices, WELD_DIGITS) + 0.0, axis=0, return_inverse=True)
    welded = same.reshape(-1)[faces].astype(np.int64)
    across = np.cross(corners[welded[:, 1]] - corners[welded[:, 0]], corners[welded[:, 2]] - corners[welded[:, 0]])
    return corners, welded[np.linalg.norm(across, axis=1) > 1e-9]


def pieces(vertices: Points, faces: Faces) -> list[SurfacePiece]:
    """The connected pieces of a surface (cm), the largest first."""
    corners, welded = weld(vertices, faces)
    _, first, count = np.unique(np.sort(welded, axis=1), axis=0, return_index=True, return_counts=True)
    twice = np.zeros(len(welded), dtype=bool)
    twice[first] = count > 1
    kept = np.sort(first)
    welded, twice = welded[kept], twice[kept]
    found = []
    for rows in connected(welded, np.zeros(len(welded), np.int64)):
        used, named = np.unique(welded[rows], return_inverse=True)
        own = _wound_alike(named.reshape(-1, 3).astype(np.int64), len(used))
        found.append(SurfacePiece(corners[used], own, bool(twice[rows].mean() > 0.5)))
    found.sort(key=lambda piece: (-piece.size, piece.points[0].tolist(), len(piece.faces)))
    return found


def _wound_alike(faces: Faces, count: int) -> Faces:
    """The faces with neighbours across an edge of two turned to one winding, the first of each patch as it is."""
    edges = faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    keys = edges[:, 0] * count + edges[:, 1]
    if len(np.unique(keys)) == len(keys):
        return faces
    low, high = edges.min(axis=1), edges.max(axis=1)
    order = np.lexsort((low, high))
    same = (low[order][1:] == low[order][:-1]) & (high[order][1:] == high[order][:-1])
    alone = same & ~np.concatenate([[False], same[:-1]]) & ~np.concatenate([same[1:], [False]])
    at = np.flatnonzero(alone)
    one, other = order[at], order[at + 1]
    against = edges[one, 0] == edges[other, 0]
    neighbours: list[list[tuple[int, bool]]] = [[] for _ in faces]
    for a, b, turn in zip((one // 3).tolist(), (other // 3).tolist(), against.tolist(), strict=True):
        neighbours[a].append((b, turn))
        neighbours[b].append((a, turn))
    turned = np.full(len(faces), -1, dtype=np.int8)
    for start in range(len(faces)):
        if turned[start] >= 0:
            continue
        turned[start] = 0
        queue = deque([start])
        while queue:
            face = queue.popleft()
            for other_face, turn in neighbours[face]:
                if turned[other_face] < 0:
                    turned[other_face] = turned[face] ^ turn
                    queue.append(other_face)
    return np.where(turned[:, None] == 1, faces[:, ::-1], faces)
