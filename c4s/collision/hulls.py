"""Convex hulls, solid and flat.

The faces of a hull stay its faces under any scale that does not flatten it, so they are found once a mesh and only the
corners are scaled.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.collision.libraries import coal, fcl
from c4s.collision.mesh_body import Array

Triangles: TypeAlias = NDArray[np.int64]
POINT_CM = 1e-9
"""Smaller than this is a point: Qhull cannot tell its sides."""
FLAT = 1e-9
"""Relative thickness under which a dimension counts as zero."""
STURDY = 1e-6
"""Relative thickness that a scale must leave for the faces to be kept; thinner hulls are built from their corners."""


@dataclass(frozen=True, eq=False)
class Faces:
    """Triangles (m, 3) of a hull by corner, looking outward; shared by all scales of a mesh."""

    triangles: Triangles

    @cached_property
    def mirrored(self) -> Faces:
        """The faces of the mirrored hull."""
        return Faces(np.ascontiguousarray(self.triangles[:, ::-1]))

    @cached_property
    def for_coal(self) -> Any:
        """As coal's list of triangles."""
        listed = coal.StdVec_Triangle()
        listed.extend([coal.Triangle(*face) for face in self.triangles.tolist()])
        return listed

    @cached_property
    def for_fcl(self) -> NDArray[np.int64]:
        """As python-fcl reads them: the number of corners before each face."""
        return np.column_stack([np.full(len(self.triangles), 3, dtype=np.int64), self.triangles]).ravel()


@dataclass(frozen=True, eq=False)
class Hull:
    """Corners (n, 3) around ``centre`` (cm) and faces; a flat hull is a two-sided polygon."""

    centre: Array
    corners: Array
    faces: Faces
    thickness: float
    """Smallest by largest extent along the principal axes; of a flat hull, within its plane."""

    def scaled(self, scale: Array) -> Hull | None:
        """The hull under a scale by axis; None when no area is left."""
        factors = np.abs(scale)
        if float(factors.min()) * self.thickness <= STURDY * float(factors.max()):
            return convex_hull((self.corners + self.centre) * scale)
        return Hull(
            self.centre * scale,
            self.corners * scale,
            self.faces.mirrored if float(np.prod(np.sign(scale))) < 0 else self.faces,
            self.thickness,
        )

    def geometries(self) -> tuple[Any, Any]:
        """The hull as coal's and as python-fcl's convex geometry, in the frame of its centre."""
        points = coal.StdVec_Vec3s()
        points.extend(list(self.corners))
        return (
            coal.Convex(points, self.faces.for_coal),
            fcl.Convex(self.corners, len(self.faces.triangles), self.faces.for_fcl),
        )


def convex_hull(points: Array) -> Hull | None:
    """The convex hull of points (n, 3) in cm; None when they span no area (a point, a line, none)."""
    if len(points) < 3:
        return None
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    centred = points - centre
    size = float(np.abs(centred).max())
    if size < POINT_CM:
        return None
    _, extents, axes = np.linalg.svd((centred - centred.mean(axis=0)) / size, full_matrices=False)
    rank = int((extents > FLAT * math.sqrt(len(points))).sum())
    if rank < 2:
        return None
    plane = centred @ axes[:2].T
    corners, faces = _solid(centred, plane) if rank == 3 else _flat(centred, plane)
    return Hull(centre, corners, Faces(faces), float(extents[rank - 1] / extents[0]))


def _solid(points: Array, plane: Array) -> tuple[Array, Triangles]:
    """Corners and outward triangles of a solid hull; a hull too thin for Qhull is built as a flat one."""
    from scipy.spatial import ConvexHull, QhullError  # takes as long to load as all else that an engine does

    try:
        hull = ConvexHull(points)
    except QhullError:
        return _flat(points, plane)
    used, faces = np.unique(hull.simplices, return_inverse=True)
    corners, faces = points[used], np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    sides = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    inward = (sides * hull.equations[:, :3]).sum(axis=1) < 0
    faces[inward] = faces[inward][:, ::-1]
    return corners, faces


def _flat(points: Array, plane: Array) -> tuple[Array, Triangles]:
    """The polygon of flat points, given in their plane too, as a two-sided fan of triangles."""
    from scipy.spatial import ConvexHull

    corners = points[ConvexHull(plane).vertices]
    fan = np.array([[0, i, i + 1] for i in range(1, len(corners) - 1)], dtype=np.int64)
    return corners, np.concatenate([fan, fan[:, ::-1]])
