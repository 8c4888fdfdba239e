"""Collision that a glTF file states in numbers: colliders of KHR_physics_rigid_bodies and OMI_physics_body.

Their shapes (KHR_implicit_shapes, OMI_physics_shape) are boxes, spheres, capsules, cylinders and hulls of meshes. One
under a scale that it does not survive becomes a hull.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.records.pack import CapsuleBody, CollisionBody, SphereBody
from catalog.ingest.authored import framed_box, rotator
from catalog.ingest.automatic import automatic
from catalog.ingest.gltf_file import GltfFile
from catalog.ingest.gltf_tree import GltfTree
from catalog.ingest.hulls import hull, joined
from catalog.ingest.source import GLTF, TO_UNREAL
from catalog.ingest.surfaces import Points

BODY_EXTENSIONS = ("KHR_physics_rigid_bodies", "OMI_physics_body")
SHAPE_EXTENSIONS = ("KHR_implicit_shapes", "OMI_physics_shape")
_RING = 16
_Matrix = NDArray[np.float64]


def stated_bodies(path: Path, root: Path, *, scale: float = 1.0) -> tuple[list[CollisionBody], list[str]]:
    """The bodies (cm, Unreal's axes) that a glTF file states, and notes on those that cannot be used.

    ``scale``: factor from the file's units to metres. Other formats state none.
    """
    if path.suffix.lower() not in GLTF or not any(name.encode() in path.read_bytes() for name in BODY_EXTENSIONS):
        return [], []
    file = GltfFile(path, root)
    tree = GltfTree(file)
    axes = np.eye(4)
    axes[:3, :3] = np.asarray(TO_UNREAL["y"], dtype=float) * (100 * scale)
    bodies: list[CollisionBody] = []
    notes: list[str] = []
    for index, names in tree.paths.items():
        for collider in _colliders(file.item("nodes", index)):
            try:
                bodies.extend(_bodies(file, tree, collider, axes @ tree.worlds[index]))
            except (KeyError, TypeError, ValueError, IndexError, BadInput) as error:
                reason = error.what if isinstance(error, BadInput) else f"{type(error).__name__}: {error}"
                notes.append(f"the collider of node {names[-1]!r} cannot be used ({reason})")
    return bodies, notes


def _colliders(node: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for name in BODY_EXTENSIONS:
        collider = node.get("extensions", {}).get(name, {}).get("collider")
        if isinstance(collider, dict):
            yield {**collider, **collider.get("geometry", {})}


def _shapes(file: GltfFile) -> list[dict[str, Any]]:
    return [
        shape for name in SHAPE_EXTENSIONS for shape in file.tree.get("extensions", {}).get(name, {}).get("shapes", [])
    ]


def _bodies(file: GltfFile, tree: GltfTree, collider: dict[str, Any], matrix: _Matrix) -> Sequence[CollisionBody]:
    if "shape" not in collider:
        return _mesh(tree, collider.get("mesh"), matrix, convex=collider.get("convexHull", True) is not False)
    shape = _shapes(file)[collider["shape"]]
    if shape["type"] in ("convex", "trimesh"):
        mesh = shape.get(shape["type"], {}).get("mesh", shape.get("mesh"))
        return _mesh(tree, mesh, matrix, convex=shape["type"] == "convex")
    return [_body(shape, matrix)]


def _body(shape: dict[str, Any], matrix: _Matrix) -> CollisionBody:
    kind = shape["type"]
    numbers = shape.get(kind, {})
    if kind == "box":
        half = np.asarray(numbers.get("size", (1, 1, 1)), float) / 2
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
        points, frame = _moved(matrix, signs * half), _frame(matrix)
        return (framed_box(points, frame) if frame is not None else None) or hull(points)
    if kind == "sphere":
        return _round(matrix, float(numbers.get("radius", 0.5)), 0.0) or hull(
            _moved(matrix, _rings(0.0, float(numbers.get("radius", 0.5)), float(numbers.get("radius", 0.5))))
        )
    if kind in ("capsule", "cylinder"):
        height = float(numbers.get("height", 0.5 if kind == "capsule" else 2.0))
        bottom, top = (
            float(numbers.get(name, numbers.get("radius", 0.25 if kind == "capsule" else 0.5)))
            for name in ("radiusBottom", "radiusTop")
        )
        made = _round(matrix, bottom, height) if kind == "capsule" and bottom == top else None
        return made or hull(
            _moved(matrix, _rings(height, bottom, top) if kind == "capsule" else _ends(height, bottom, top))
        )
    raise ValueError(f"unknown shape {kind!r}")


def _mesh(tree: GltfTree, mesh: Any, matrix: _Matrix, *, convex: bool) -> Sequence[CollisionBody]:
    parts = tree.meshes.primitives(mesh)
    if convex:
        return [hull(np.concatenate([_moved(matrix, part.points) for part in parts]))]
    step = -1 if np.linalg.det(matrix[:3, :3]) < 0 else 1
    made = automatic(*joined([("", _moved(matrix, part.points), part.faces[:, ::step]) for part in parts]))
    return [hull(points) for points in made.bodies]


def _moved(matrix: _Matrix, points: Points) -> Points:
    moved: Points = points @ matrix[:3, :3].T + matrix[:3, 3]
    return moved


def _frame(matrix: _Matrix) -> Points | None:
    """The rotation of a matrix whose axes stay square, as a right-handed frame; None for others."""
    sizes = np.linalg.norm(matrix[:3, :3], axis=0)
    frame = matrix[:3, :3] / sizes
    if np.abs(frame.T @ frame - np.eye(3)).max() > 1e-6:
        return None
    if np.linalg.det(frame) < 0:  # the file's Z is Unreal's Y: swap them, which a box does not notice
        frame = frame[:, [0, 2, 1]]
    return np.asarray(frame)


def _round(matrix: _Matrix, radius: float, height: float) -> CollisionBody | None:
    """A sphere, or a capsule along the file's Y, under an even scale; None under an uneven one."""
    frame, sizes = _frame(matrix), np.linalg.norm(matrix[:3, :3], axis=0)
    if frame is None or np.ptp(sizes) > 1e-6 * sizes.max():
        return None
    size = float(sizes[0])
    x, y, z = (round(float(value), 4) + 0.0 for value in matrix[:3, 3])
    if height <= 0:
        return SphereBody(center=(x, y, z), radius=round(radius * size, 4))
    return CapsuleBody(
        center=(x, y, z), rotation_deg=rotator(frame), radius=round(radius * size, 4), length=round(height * size, 4)
    )


def _rings(height: float, bottom: float, top: float) -> Points:
    """Points on a capsule with two radii along Y."""
    rows = [
        [
            radius * np.cos(rise) * np.cos(turn),
            end * height / 2 + end * radius * np.sin(rise),
            radius * np.cos(rise) * np.sin(turn),
        ]
        for end, radius in ((-1, bottom), (1, top))
        for rise in np.linspace(0, np.pi / 2, 5)
        for turn in np.arange(_RING) * 2 * np.pi / _RING
    ]
    return np.array(rows)


def _ends(height: float, bottom: float, top: float) -> Points:
    """Points on the two ends of a cylinder along Y."""
    return np.array(
        [
            [radius * np.cos(turn), end * height / 2, radius * np.sin(turn)]
            for end, radius in ((-1, bottom), (1, top))
            for turn in np.arange(_RING) * 2 * np.pi / _RING
        ]
    )
