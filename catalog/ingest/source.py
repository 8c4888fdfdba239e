"""Reads a mesh file (glTF, GLB, OBJ, DAE, STL) into parts in Unreal's axes and cm, with surfaces and notes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from catalog.ingest.gltf_file import GltfFile
from catalog.ingest.gltf_tree import GltfTree, Placed
from catalog.ingest.obj_file import ObjFile
from catalog.ingest.surface import Source, SourcePart, Surface
from catalog.ingest.trimesh_file import TrimeshFile

SUFFIXES = (".glb", ".gltf", ".obj", ".dae")
GLTF = (".glb", ".gltf")
Up = Literal["y", "z", "x"]
TO_UNREAL: dict[str, list[list[float]]] = {
    "y": [[1, 0, 0], [0, 0, 1], [0, 1, 0]],
    "z": [[1, 0, 0], [0, -1, 0], [0, 0, 1]],
    "x": [[0, -1, 0], [0, 0, 1], [1, 0, 0]],
}
"""From right-handed axes with this one up to Unreal's left-handed ones with Z up: all three mirror."""
MALFORMED = (ArithmeticError, AttributeError, LookupError, MemoryError, RecursionError, TypeError, ValueError)
"""What reading a file raises that has something else in a place than its format says."""
Floats = NDArray[np.float64]


def read_source(path: Path, root: Path, *, scale: float = 1.0, up: Up | None = None) -> Source:
    """All triangles of a mesh file with every node's transform applied.

    Args:
        path: the mesh file.
        root: folder in which textures and buffers are looked for.
        scale: factor from the file's units to metres; a DAE file's own unit is applied as well.
        up: axis that points up; the format's (glTF: Y, DAE: as the file says) or Y when left out.

    Raises:
        BadInput: the file cannot be read, holds no triangles of any size, or numbers that are not finite.
    """
    notes: list[str] = []
    kind = path.suffix.lower()
    read = _of_gltf if kind in GLTF else _of_obj if kind == ".obj" else _of_others
    made = read(path, root, scale, up, notes)
    parts, count = [], 0
    try:
        for part in made:
            parts.append(part)
            count += len(part.vertices)
            BOUNDS["mesh_vertices"].hold(count, where=str(path))
            BOUNDS["mesh_nodes"].hold(len(parts), where=str(path))
    except MALFORMED as error:
        parts.clear()
        raise BadInput(f"the file is malformed: {type(error).__name__}: {error!s:.200}", where=str(path)) from None
    if not parts:
        reason = f" ({notes[0]})" if notes else ""
        raise BadInput(f"the file has no triangles{reason}", where=str(path))
    low = np.min([part.vertices.min(axis=0) for part in parts], axis=0)
    high = np.max([part.vertices.max(axis=0) for part in parts], axis=0)
    if np.count_nonzero(high - low > 1e-4) < 2:
        raise BadInput(f"the mesh has no extent: {' x '.join(f'{side:g}' for side in high - low)} cm", where=str(path))
    return Source(parts, list(dict.fromkeys(notes)))


def gltf_parts(tree: GltfTree, placed: Placed, axes: Floats, scale: float, path: Path) -> Iterator[SourcePart]:
    """The parts of a placed mesh of a glTF file, named for its node."""
    for one, matrix in tree.triangles(placed):
        yield part_of(
            placed.path[-1],
            one.surface,
            one.points,
            one.faces,
            one.normals,
            one.uvs,
            one.colors,
            matrix,
            axes,
            scale,
            path,
        )


def _of_gltf(path: Path, root: Path, scale: float, up: Up | None, notes: list[str]) -> Iterator[SourcePart]:
    file = GltfFile(path, root)
    tree, axes = GltfTree(file), np.asarray(TO_UNREAL[up or "y"], dtype=float)
    try:
        for placed in tree.placed():
            yield from gltf_parts(tree, placed, axes, scale, path)
    finally:
        notes += file.notes


def _of_obj(path: Path, root: Path, scale: float, up: Up | None, notes: list[str]) -> Iterator[SourcePart]:
    file, axes = ObjFile(path, root), np.asarray(TO_UNREAL[up or "y"], dtype=float)
    try:
        for one in file.parts():
            yield part_of(
                one.piece,
                one.surface,
                one.points,
                one.faces,
                one.normals,
                one.uvs,
                one.colors,
                np.eye(4),
                axes,
                scale,
                path,
            )
    finally:
        notes += file.notes


def _of_others(path: Path, root: Path, scale: float, up: Up | None, notes: list[str]) -> Iterator[SourcePart]:
    file = TrimeshFile(path, root)
    axes = np.asarray(TO_UNREAL[up or file.up], dtype=float)
    try:
        for node, name, matrix in file.geometries():
            arrays = file.arrays(name)
            if arrays is None:
                file.notes.append(f"node {node!r} has no triangles")
                continue
            yield part_of(node, *arrays, matrix, axes, scale * file.unit_m, path)
    finally:
        notes += file.notes


def part_of(
    node: str,
    surface: Surface,
    points: Floats,
    faces: NDArray[np.int64],
    normals: Floats,
    uvs: Floats,
    colors: Floats | None,
    matrix: Floats,
    axes: Floats,
    scale: float,
    path: Path,
) -> SourcePart:
    """A part from arrays of a file: its points (file's axes and units) under ``matrix``, turned by ``axes``.

    Triangles of a matrix that mirrors are turned round. ``BadInput`` for numbers that are not finite and for a matrix
    that leaves nothing.
    """
    full = axes @ matrix[:3, :3]
    with np.errstate(over="ignore", invalid="ignore"):
        moved = (points @ full.T + axes @ matrix[:3, 3]) * (100 * scale)
    if not np.isfinite(moved).all():
        raise BadInput("the mesh has coordinates that are not finite numbers", where=str(path))
    size = np.linalg.norm(full, axis=0)
    if not np.isfinite(full).all() or size.min() == 0 or abs(np.linalg.det(full / size)) < 1e-9:
        raise BadInput(f"node {node!r} is scaled to nothing", where=str(path))
    turned = normals @ np.linalg.inv(full)
    length = np.linalg.norm(turned, axis=1, keepdims=True)
    turned = np.divide(turned, length, out=np.tile([0.0, 0.0, 1.0], (len(turned), 1)), where=length > 0)
    mirrored = np.linalg.det(full / size) < 0
    return SourcePart(node, surface, moved, faces[:, ::-1] if mirrored else faces, turned, uvs, colors)
