"""The engine's basic shapes, 100 cm across with the pivot at the centre: Cube, Sphere, Cylinder, Cone and Plane."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import numpy as np

from c4s.packs.meshes import Mesh
from c4s.records.pack import Asset, BoxBody, CollisionBody, HullBody, Material, MaterialSlot, SphereBody

FOLDER = "/Engine/BasicShapes"
MATERIAL = Material(path=f"{FOLDER}/BasicShapeMaterial.BasicShapeMaterial", base_color=(0.5, 0.5, 0.5), roughness=0.9)
_SEGMENTS = 32
_Ring = list[tuple[float, float]]


def _revolved(profile: _Ring, smooth: bool) -> Mesh:
    """A surface of revolution about Z through ``(radius, z)`` points, bottom to top."""
    vertices: list[tuple[float, float, float]] = []
    normals: list[tuple[float, float, float]] = []
    uvs: list[tuple[float, float]] = []
    faces: list[tuple[int, int, int]] = []
    for (r0, z0), (r1, z1) in pairwise(profile):
        base = len(vertices)
        across, up = z1 - z0, r0 - r1
        for step in range(_SEGMENTS + 1):
            angle = 2 * math.pi * step / _SEGMENTS
            c, s = math.cos(angle), math.sin(angle)
            for radius, z in ((r0, z0), (r1, z1)):
                vertices.append((radius * c, radius * s, z))
                normals.append((radius * c, radius * s, z) if smooth else (across * c, across * s, up))
                uvs.append((step / _SEGMENTS, 0.5 - z / 100))
        for step in range(_SEGMENTS):
            a = base + 2 * step
            faces += [(a, a + 2, a + 1), (a + 1, a + 2, a + 3)]
    points, directions = np.array(vertices, np.float32), np.array(normals, np.float32)
    triangles = np.array(faces, np.int32)
    corners = points[triangles].astype(np.float64)
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    triangles = triangles[area > 1e-9]
    return Mesh(
        points,
        triangles,
        directions / np.maximum(np.linalg.norm(directions, axis=1, keepdims=True), 1e-9),
        np.array(uvs, np.float32),
        np.zeros(len(triangles), np.int32),
    )


def _quads(sides: list[tuple[int, int]], half: float) -> Mesh:
    """Squares of half size 50 cm at ``half`` along each (axis, sign)."""
    vertices, normals = [], []
    for axis, sign in sides:
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for du, dv in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            point, normal = np.zeros(3), np.zeros(3)
            point[axis], point[u], point[v], normal[axis] = sign * half, du * 50.0, dv * 50.0, sign
            vertices.append(point)
            normals.append(normal)
    faces = [(4 * i + a, 4 * i + b, 4 * i + c) for i in range(len(sides)) for a, b, c in ((0, 1, 2), (0, 2, 3))]
    uvs = np.tile(np.array([(0, 1), (1, 1), (1, 0), (0, 0)], np.float32), (len(sides), 1))
    return Mesh(
        np.array(vertices, np.float32),
        np.array(faces, np.int32),
        np.array(normals, np.float32),
        uvs,
        np.zeros(len(faces), np.int32),
    )


def _disc_points(z: float) -> list[tuple[float, float, float]]:
    return [(50 * math.cos(2 * math.pi * i / 16), 50 * math.sin(2 * math.pi * i / 16), z) for i in range(16)]


@cache
def meshes() -> dict[str, Mesh]:
    """Mesh of each shape by its path."""
    arc = [(50 * math.cos(a), 50 * math.sin(a)) for a in np.linspace(-math.pi / 2, math.pi / 2, 17)]
    shapes = {
        "Cube": _quads([(a, s) for a in range(3) for s in (-1, 1)], 50.0),
        "Sphere": _revolved(arc, True),
        "Cylinder": _revolved([(0, -50), (50, -50), (50, 50), (0, 50)], False),
        "Cone": _revolved([(0, -50), (50, -50), (0, 50)], False),
        "Plane": _quads([(2, 1)], 0.0),
    }
    return {f"{FOLDER}/{name}.{name}": mesh for name, mesh in shapes.items()}


@cache
def assets() -> dict[str, Asset]:
    """Asset of each shape by its path."""
    bodies: dict[str, CollisionBody] = {
        "Cube": BoxBody(center=(0, 0, 0), half_extent=(50, 50, 50)),
        "Sphere": SphereBody(center=(0, 0, 0), radius=50),
        "Cylinder": HullBody(vertices=_disc_points(-50) + _disc_points(50)),
        "Cone": HullBody(vertices=[*_disc_points(-50), (0.0, 0.0, 50.0)]),
        "Plane": BoxBody(center=(0, 0, -0.5), half_extent=(50, 50, 0.5)),
    }
    found = {}
    for name, body in bodies.items():
        path = f"{FOLDER}/{name}.{name}"
        half = 0.0 if name == "Plane" else 50.0
        found[path] = Asset(
            id=f"basic_{name.lower()}",
            name=name,
            path=path,
            category="basicshapes",
            description=f"Engine basic shape, {name.lower()}, 1 m across, pivot at the centre.",
            tags=["basic", "shape"],
            bounds_min_cm=(-50, -50, -half),
            bounds_max_cm=(50, 50, half),
            slots=[MaterialSlot(name="BasicShapeMaterial", material=MATERIAL.path)],
            collision=[body],
        )
    return found
