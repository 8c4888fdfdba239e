"""Surfaces of simple solids as arrays: cm, Unreal axes, texture coordinates in metres (v down).

Every function returns a ``Patch`` whose origin is the middle of the bottom, so that furniture is stacked by heights.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray

Array = NDArray[np.float64]
Point2 = tuple[float, float]
Point3 = tuple[float, float, float]


@dataclass(frozen=True)
class Patch:
    """Triangles with normals and texture coordinates."""

    vertices: Array
    faces: NDArray[np.int64]
    normals: Array
    uvs: Array


def join(patches: Sequence[Patch]) -> Patch:
    """All patches as one."""
    offsets = np.cumsum([0] + [len(p.vertices) for p in patches[:-1]])
    return Patch(
        np.concatenate([p.vertices for p in patches]),
        np.concatenate([p.faces + o for p, o in zip(patches, offsets, strict=True)]),
        np.concatenate([p.normals for p in patches]),
        np.concatenate([p.uvs for p in patches]),
    )


def _box_uvs(points: Array, normals: Array) -> Array:
    """Texture coordinates in metres by projection along the main axis of each normal."""
    axis = np.abs(normals).argmax(axis=1)
    u = np.where(axis == 0, points[:, 1], points[:, 0])
    v = np.where(axis == 2, points[:, 1], -points[:, 2])
    return np.column_stack([u, v]) / 100


def flat(triangles: Array) -> Patch:
    """Flat-shaded triangles (n, 3, 3), ordered so that the cross product of their edges is the outward normal."""
    cross = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(cross, axis=1)
    keep = length > 1e-7
    triangles, normals = triangles[keep], cross[keep] / length[keep, None]
    points, repeated = triangles.reshape(-1, 3), np.repeat(normals, 3, axis=0)
    return Patch(points, np.arange(len(points)).reshape(-1, 3), repeated, _box_uvs(points, repeated))


def hull(points: Sequence[Point3] | Array) -> Patch:
    """The convex hull of points, flat-shaded."""
    from scipy.spatial import ConvexHull

    cloud = np.asarray(points, dtype=float)
    solid = ConvexHull(cloud)
    triangles = cloud[solid.simplices]
    cross = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    inward = np.einsum("ij,ij->i", cross, triangles.mean(axis=1) - cloud.mean(axis=0)) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return flat(triangles)


@functools.lru_cache(maxsize=4096)
def box(size: Point3, bevel: float = 0.0) -> Patch:
    """A box; ``bevel`` cuts its edges by that many cm. Equal boxes share their arrays."""
    half = np.array(size, dtype=float) / 2
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    cut = min(bevel, *(0.49 * s for s in size))
    corners = [signs * half] if cut <= 0 else [signs * (half - cut + cut * np.eye(3)[axis]) for axis in range(3)]
    return hull(np.concatenate(corners) + np.array([0, 0, half[2]]))


def revolve(profile: Sequence[Point2], segments: int = 20, *, smooth: bool = False, squash: float = 1.0) -> Patch:
    """A surface of revolution about Z through ``(radius, z)`` points from bottom to top.

    Args:
        profile: radii and heights in cm; a radius of 0 closes an end.
        segments: steps around.
        smooth: shade along the profile too (spheres, vases), not only around.
        squash: factor on Y (an ellipse seen from above).
    """
    points = np.asarray(profile, dtype=float)
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    outward = np.column_stack([steps[:, 1], -steps[:, 0]]) / np.maximum(lengths, 1e-9)[:, None]
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    if smooth:
        joint = np.vstack([outward[:1], outward[:-1] + outward[1:], outward[-1:]])
        joint /= np.maximum(np.linalg.norm(joint, axis=1), 1e-9)[:, None]
    angles = np.linspace(0, 2 * math.pi, segments + 1)
    cosine, sine = np.cos(angles), np.sin(angles)
    rings = []
    for i in range(len(steps)):
        radius = np.array([points[i, 0], points[i + 1, 0]])
        normal = joint[i : i + 2] if smooth else np.repeat(outward[i : i + 1], 2, axis=0)
        vertices = np.stack(
            [
                np.outer(cosine, radius),
                np.outer(sine, radius) * squash,
                np.broadcast_to(points[i : i + 2, 1], (segments + 1, 2)),
            ],
            axis=-1,
        ).reshape(-1, 3)
        normals = np.stack(
            [
                np.outer(cosine, normal[:, 0]),
                np.outer(sine, normal[:, 0]) / squash,
                np.broadcast_to(normal[:, 1], (segments + 1, 2)),
            ],
            axis=-1,
        ).reshape(-1, 3)
        girth = angles * max(radius.max(), 1e-6)
        uvs = (
            np.stack(
                [np.repeat(girth[:, None], 2, axis=1), np.broadcast_to(-along[i : i + 2], (segments + 1, 2))], axis=-1
            ).reshape(-1, 2)
            / 100
        )
        first = 2 * np.arange(segments)
        faces = np.concatenate(
            [np.column_stack([first, first + 2, first + 1]), np.column_stack([first + 1, first + 2, first + 3])]
        )
        corners = vertices[faces]
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
        rings.append(Patch(vertices, faces[area > 1e-7], normals, uvs))
    return join([ring for ring in rings if len(ring.faces)])


def cylinder(
    radius: float, height: float, segments: int = 20, *, top: float | None = None, squash: float = 1.0
) -> Patch:
    """A cylinder, or a cone frustum when ``top`` (its upper radius) is given."""
    return revolve(
        [(0, 0), (radius, 0), (radius if top is None else top, height), (0, height)], segments, squash=squash
    )


def ellipsoid(size: Point3, segments: int = 16) -> Patch:
    """An ellipsoid of the given diameters."""
    arc = np.linspace(-math.pi / 2, math.pi / 2, max(6, segments // 2) + 1)
    half = size[0] / 2
    profile = [(half * max(0.0, math.cos(a)), size[2] / 2 * (1 + math.sin(a))) for a in arc]
    return revolve(profile, segments, smooth=True, squash=size[1] / size[0])


def extrude(outline: Sequence[Point2] | shapely.Polygon, height: float) -> Patch:
    """A prism on a polygon in the XY plane (holes allowed), from z = 0 to ``height``."""
    polygon = shapely.geometry.polygon.orient(
        outline if isinstance(outline, shapely.Polygon) else shapely.Polygon(outline)
    )
    top = np.array(
        [
            np.asarray(shapely.geometry.polygon.orient(piece).exterior.coords)[:3]
            for piece in shapely.constrained_delaunay_triangles(polygon).geoms
        ]
    )
    upper = np.concatenate([top, np.full((len(top), 3, 1), height)], axis=2)
    lower = np.concatenate([top[:, ::-1], np.zeros((len(top), 3, 1))], axis=2)
    sides = []
    for ring in (polygon.exterior, *polygon.interiors):
        points = np.asarray(ring.coords)
        for a, b in pairwise(points):
            p, q, r, s = (*a, 0.0), (*b, 0.0), (*b, height), (*a, height)
            sides += [(p, q, r), (p, r, s)]
    return flat(np.concatenate([upper, lower, np.array(sides)]))


def tube(path: Sequence[Point3], radius: float, segments: int = 10) -> Patch:
    """A round tube along a path of points, closed at both ends."""
    points = np.asarray(path, dtype=float)
    steps = np.diff(points, axis=0)
    steps /= np.linalg.norm(steps, axis=1, keepdims=True)
    tangents = np.vstack([steps[:1], steps[:-1] + steps[1:], steps[-1:]])
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    side = np.eye(3)[np.abs(tangents[0]).argmin()]
    angles = np.linspace(0, 2 * math.pi, segments + 1)
    rings, outs = [], []
    for point, tangent in zip(points, tangents, strict=True):
        side = side - tangent * (side @ tangent)
        side /= np.linalg.norm(side)
        out = np.outer(np.cos(angles), side) + np.outer(np.sin(angles), np.cross(tangent, side))
        outs.append(out)
        rings.append(point + radius * out)
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    count = segments + 1
    uvs = (
        np.stack([np.tile(angles * radius, (len(points), 1)), np.tile(along[:, None], (1, count))], axis=-1).reshape(
            -1, 2
        )
        / 100
    )
    faces = [
        face
        for i in range(len(points) - 1)
        for j in range(segments)
        for a in (i * count + j,)
        for face in ((a, a + 1, a + count), (a + 1, a + count + 1, a + count))
    ]
    body = Patch(np.concatenate(rings), np.array(faces), np.concatenate(outs), uvs)
    caps = []
    for centre, ring, tangent in ((points[0], rings[0], -tangents[0]), (points[-1], rings[-1], tangents[-1])):
        cap = np.array([(centre, ring[j], ring[j + 1]) for j in range(segments)])
        normals = np.tile(tangent, (3 * segments, 1))
        caps.append(
            Patch(
                cap.reshape(-1, 3),
                np.arange(3 * segments).reshape(-1, 3),
                normals,
                _box_uvs(cap.reshape(-1, 3), normals),
            )
        )
    return join([body, *caps])


def prism(outline: Sequence[Point2], depth: float) -> Patch:
    """A prism on an outline in the XZ plane (x, z), from -depth/2 to +depth/2 along Y: wedges, gables, arches."""
    solid = extrude(outline, depth)
    turn = np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
    points = solid.vertices @ turn.T + [0, depth / 2, 0]
    normals = solid.normals @ turn.T
    return Patch(points, solid.faces, normals, _box_uvs(points, normals))


def arch_outline(
    width: float, height: float, opening_width: float, opening_height: float, steps: int = 12
) -> list[Point2]:
    """Outline (x, z) of a wall with a round-topped opening that reaches the floor."""
    half, radius = width / 2, opening_width / 2
    spring = opening_height - radius
    curve = [(radius * math.cos(a), spring + radius * math.sin(a)) for a in np.linspace(0, math.pi, steps + 1)]
    return [(-half, 0), (-half, height), (half, height), (half, 0), (radius, 0), *curve, (-radius, 0)]


def quad(corners: Sequence[Point3], *, fit: bool = True) -> Patch:
    """A four-sided sheet, corners in order from the lower left; ``fit``: the texture covers it once."""
    a, b, c, d = (np.asarray(p, dtype=float) for p in corners)
    sheet = flat(np.array([(a, b, c), (a, c, d)]))
    if not fit:
        return sheet
    return Patch(
        sheet.vertices,
        sheet.faces,
        sheet.normals,
        np.array([(0, 1), (1, 1), (1, 0), (0, 1), (1, 0), (0, 0)], dtype=float),
    )
