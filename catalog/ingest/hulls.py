"""Convex collision bodies from triangles."""

from __future__ import annotations

from typing import Literal

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from c4s.records.pack import HullBody
from catalog.ingest.merging import HARD_LIMIT, merged
from catalog.ingest.surfaces import Faces, Points, pieces

HullPer = Literal["asset", "node", "piece"]
"""One hull for all of an asset, one a node of its file, or one a connected piece of its surface."""
MAX_VERTICES = 128
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


def bodies(parts: list[tuple[str, Points, Faces]], per: HullPer) -> list[HullBody]:
    """Collision bodies of parts (node, vertices in cm, triangles). Beyond ``HARD_LIMIT`` neighbours are merged."""
    if per == "asset":
        return [hull(np.concatenate([points for _, points, _ in parts]))]
    if per == "node":
        nodes = sorted({node for node, _, _ in parts})
        sets = [np.concatenate([points for name, points, _ in parts if name == node]) for node in nodes]
    else:
        vertices, faces = joined(parts)
        sets = [piece.points for piece in pieces(vertices, faces)] or [vertices]
    return [hull(points) for points in (merged(sets, most=HARD_LIMIT) if len(sets) > HARD_LIMIT else sets)]


def joined(parts: list[tuple[str, Points, Faces]]) -> tuple[Points, Faces]:
    """Vertices and triangles of parts (node, vertices, triangles) as one mesh."""
    offsets = np.cumsum([0] + [len(points) for _, points, _ in parts[:-1]])
    faces = [triangles + offset for (_, _, triangles), offset in zip(parts, offsets, strict=True)]
    return np.concatenate([points for _, points, _ in parts]), np.concatenate(faces)
