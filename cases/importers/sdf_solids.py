"""Primitive geometry of SDF as parts: box, plane, cylinder, sphere, capsule, ellipsoid, cone, polyline."""

from __future__ import annotations

from xml.etree.ElementTree import Element

import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from shapely import Polygon, constrained_delaunay_triangles
from shapely.geometry.polygon import orient

from c4s.errors import BadInput
from cases.importers.sdf_frames import Matrix, numbers
from catalog.ingest.surface import SourcePart, Surface

CYLINDER_SIDES = 24


def solid(element: Element) -> SourcePart:
    """A primitive as a part of cm in Unreal's axes about its own middle."""
    if element.tag == "plane":
        width, depth = numbers(element.findtext("size"), 2, 1.0)
        normal = np.asarray(numbers(element.findtext("normal") or "0 0 1", 3))
        corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * [width / 2, depth / 2, 1]
        turn = Rotation.align_vectors(normal[None], np.array([[0.0, 0.0, 1.0]]))[0].as_matrix()
        return _part(
            corners @ turn.T, np.array([[0, 1, 2], [0, 2, 3]]), np.array([[0, 1], [1, 1], [1, 0], [0, 0]], float)
        )
    if element.tag == "box":
        return _box(np.asarray(numbers(element.findtext("size"), 3, 1.0)))
    if element.tag == "cylinder":
        mesh = trimesh.creation.cylinder(
            radius=numbers(element.findtext("radius"), 1, 1.0)[0],
            sections=CYLINDER_SIDES,
            height=numbers(element.findtext("length"), 1, 1.0)[0],
        )
    elif element.tag == "sphere":
        mesh = trimesh.creation.uv_sphere(radius=numbers(element.findtext("radius"), 1, 1.0)[0], count=[12, 24])
    elif element.tag == "capsule":
        mesh = trimesh.creation.capsule(
            radius=numbers(element.findtext("radius"), 1, 1.0)[0],
            height=numbers(element.findtext("length"), 1, 1.0)[0],
            count=[12, 12],
        )
        mesh.apply_translation(-mesh.bounds.mean(axis=0))
    elif element.tag == "ellipsoid":
        mesh = trimesh.creation.uv_sphere(radius=1.0, count=[12, 24])
        mesh.vertices = mesh.vertices * numbers(element.findtext("radii"), 3, 1.0)
    elif element.tag == "cone":
        mesh = trimesh.creation.cone(
            radius=numbers(element.findtext("radius"), 1, 1.0)[0],
            sections=CYLINDER_SIDES,
            height=numbers(element.findtext("length"), 1, 1.0)[0],
        )
        mesh.apply_translation(-mesh.bounds.mean(axis=0))
    elif element.tag == "polyline":
        mesh = _prism(element)
    else:
        raise BadInput(f"geometry <{element.tag}> is not supported")
    sharp = np.asarray(mesh.faces).ravel()
    return _part(np.asarray(mesh.vertices)[sharp], np.arange(len(sharp)).reshape(-1, 3), None)


def _box(size: Matrix) -> SourcePart:
    corners, faces, uvs = [], [], []
    for axis in range(3):
        for side in (-1, 1):
            across, along = [i for i in range(3) if i != axis]
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = np.zeros(3)
                corner[axis], corner[across], corner[along] = side, a, b
                corners.append(corner * size / 2)
                uvs.append(((a + 1) / 2, (1 - b) / 2))
            start, turn = len(corners) - 4, side * (-1 if axis == 1 else 1)
            faces += [[start, start + 1, start + 2][::turn], [start, start + 2, start + 3][::turn]]
    return _part(np.array(corners), np.array(faces), np.array(uvs))


def _part(points: Matrix, faces: NDArray[np.int64], uvs: Matrix | None) -> SourcePart:
    """Triangles that are wound outward in SDF's axes, in Unreal's, which mirror, and wound outward there."""
    points, faces = points * [100, -100, 100], faces[:, ::-1]
    sides = points[faces]
    flat = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    normals = np.zeros_like(points)
    normals[faces] = flat[:, None]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return SourcePart(
        "solid",
        Surface("plain"),
        points,
        faces.astype(np.int64),
        normals,
        np.zeros((len(points), 2)) if uvs is None else uvs,
    )


def _prism(element: Element) -> trimesh.Trimesh:
    """The outline of a polyline raised by its height, from z = 0."""
    outline = Polygon([numbers(point.text, 2) for point in element.findall("point")] or None)
    height = numbers(element.findtext("height"), 1, 1.0)[0]
    if not outline.is_valid or outline.area <= 0 or height <= 0:
        raise BadInput("a polyline needs an outline that does not cross itself, and a height")
    triangles = constrained_delaunay_triangles(outline).geoms
    flat = np.array([orient(triangle).exterior.coords[:3] for triangle in triangles])
    ring = np.array(orient(outline).exterior.coords)

    def lifted(*corners: tuple[Matrix, float]) -> Matrix:
        return np.stack([np.column_stack([points, np.full(len(points), z)]) for points, z in corners], axis=1)

    start, end = ring[:-1], ring[1:]
    points = np.concatenate(
        [
            lifted(*((flat[:, corner], 0.0) for corner in (2, 1, 0))),
            lifted(*((flat[:, corner], height) for corner in (0, 1, 2))),
            lifted((start, 0.0), (end, 0.0), (end, height)),
            lifted((start, 0.0), (end, height), (start, height)),
        ]
    )
    points = points.reshape(-1, 3)
    return trimesh.Trimesh(points, np.arange(len(points)).reshape(-1, 3), process=False)
