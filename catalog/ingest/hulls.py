"""Convex collision bodies from triangles."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull, QhullError

from c4s.records.pack import HullBody

Points = NDArray[np.float64]
HullPer = Literal["asset", "node", "piece"]
"""One hull for all of an asset, one a node of its file, or one a connected piece of its surface."""
MAX_VERTICES = 128
MAX_PIECES = 1024
HOLLOW_CM3 = 1_000_000.0
"""Smaller things keep one hull."""
THIN_CM = 0.05
"""Flat things get this half thickness."""


def hull(points: Points) -> HullBody:
    """Convex hull of points (cm); flat or straight sets are thickened by ``THIN_CM``.

    Hulls of more than ``MAX_VERTICES`` vertices are replaced by the extreme points in that many even directions,
    the six axes among them, so the bounding box stays and the surface lies inside the true one.
    """
    points = np.unique(np.round(points, 3), axis=0)
    centre = points.mean(axis=0)
    axes = np.linalg.eigh((points - centre).T @ (points - centre))[1].T
    flat = np.ptp((points - centre) @ axes.T, axis=0) < 2 * THIN_CM
    for direction in axes[flat]:
        points = np.concatenate([points + direction * THIN_CM, points - direction * THIN_CM])
    try:
        corners = points[ConvexHull(points).vertices]
    except QhullError:
        corners = points[ConvexHull(points, qhull_options="QJ Pp").vertices]
    if len(corners) > MAX_VERTICES:
        corners = corners[np.unique(np.argmax(corners @ _directions().T, axis=0))]
    ordered = np.unique(np.round(corners, 3), axis=0)
    return HullBody(vertices=[(float(x), float(y), float(z)) for x, y, z in ordered])


def _directions() -> Points:
    count = MAX_VERTICES - 6
    height = 1 - 2 * (np.arange(count) + 0.5) / count
    turn = np.arange(count) * np.pi * (3 - 5**0.5)
    radius = np.sqrt(1 - height**2)
    even = np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)
    return np.concatenate([np.eye(3), -np.eye(3), even])


def pieces(vertices: Points, faces: NDArray[np.int64]) -> list[Points]:
    """Points of each connected piece of a surface; corners at one place are one corner. Hollow pieces fall apart.

    A piece is hollow when its hull holds more than ``HOLLOW_CM3`` and the piece fills less than half of it, as a room
    or a shelf does, whose hull would fill what it is there to hold. It is replaced by its flat sides: each a
    convex flat, or triangle by triangle where a side has a notch or a door.
    The ``MAX_PIECES`` largest alone are told apart when there are more; the rest is one piece.
    """
    _, same = np.unique(np.round(vertices, 2), axis=0, return_inverse=True)
    welded = same.reshape(-1)[faces]
    found = []
    for part in connected(welded, np.zeros(len(faces), np.int64)):
        points = vertices[np.unique(faces[part])]
        found += _sides(vertices, faces[part], welded[part]) if _hollow(vertices[faces[part]], points) else [points]
    found.sort(key=lambda points: -float(np.linalg.norm(np.ptp(points, axis=0))))
    return found if len(found) <= MAX_PIECES else [*found[: MAX_PIECES - 1], np.concatenate(found[MAX_PIECES - 1 :])]


def connected(welded: NDArray[np.int64], group: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """Indices of the faces of each set that hangs together by corners of the same group."""
    keys = welded.astype(np.int64) * (int(group.max()) + 1) + group[:, None]
    _, corner = np.unique(keys, return_inverse=True)
    corner = corner.reshape(keys.shape)
    edges = np.concatenate([corner[:, [0, 1]], corner[:, [1, 2]]])
    count = int(corner.max()) + 1
    joins = coo_array((np.ones(len(edges), np.int8), (edges[:, 0], edges[:, 1])), shape=(count, count))
    label = connected_components(joins, directed=False)[1][corner[:, 0]]
    return [np.flatnonzero(label == number) for number in np.unique(label)]


def _hollow(triangles: Points, points: Points) -> bool:
    try:
        volume = float(ConvexHull(points).volume)
    except QhullError:
        return False
    centred = triangles - points.mean(axis=0)
    solid = float(np.einsum("ij,ij->i", centred[:, 0], np.cross(centred[:, 1], centred[:, 2])).sum()) / 6
    return volume > HOLLOW_CM3 and solid < volume / 2


def _sides(vertices: Points, faces: NDArray[np.int64], welded: NDArray[np.int64]) -> list[Points]:
    triangles = vertices[faces]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = np.linalg.norm(normals, axis=1) / 2
    keep = areas > 1e-3
    triangles, normals, areas, welded = (values[keep] for values in (triangles, normals, areas, welded))
    normals = normals / (2 * areas[:, None])
    planes = np.column_stack([np.round(normals, 2), np.round(np.einsum("ij,ij->i", normals, triangles[:, 0]), 0)])
    found: list[Points] = []
    for side in connected(welded, np.unique(planes + 0.0, axis=0, return_inverse=True)[1].reshape(-1)):
        corners = np.unique(triangles[side].reshape(-1, 3), axis=0)
        axes = np.linalg.svd(normals[side[:1]])[2][1:]
        outline = float(ConvexHull(corners @ axes.T, qhull_options="QJ Pp").volume)
        found += [corners] if areas[side].sum() > 0.95 * outline else list(triangles[side])
    return found


def bodies(parts: list[tuple[str, Points, NDArray[np.int64]]], per: HullPer) -> list[HullBody]:
    """Collision bodies of parts (node, vertices in cm, triangles)."""
    if per == "asset":
        return [hull(np.concatenate([points for _, points, _ in parts]))]
    if per == "node":
        nodes = sorted({node for node, _, _ in parts})
        return [hull(np.concatenate([points for name, points, _ in parts if name == node])) for node in nodes]
    offsets = np.cumsum([0] + [len(points) for _, points, _ in parts[:-1]])
    faces = np.concatenate([triangles + offset for (_, _, triangles), offset in zip(parts, offsets, strict=True)])
    return [hull(points) for points in pieces(np.concatenate([points for _, points, _ in parts]), faces)]
