"""PMD, the mesh format of 0 A.D.: triangles, and the points that props are fixed to. Metres, Y up, left-handed."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from cases.importers.imported import Matrix

MAGIC, VERSIONS, NO_BONE = b"PSMD", (3, 4), 0xFF
BLENDS = 20
"""Bytes of what binds a vertex to bones: four numbers of bones, four weights."""


@dataclass(frozen=True)
class PmdMesh:
    """A mesh: its vertices are as it was bound to its bones, ``points`` are the poses of props by name."""

    vertices: Matrix
    normals: Matrix
    uvs: Matrix
    faces: NDArray[np.int64]
    points: dict[str, Matrix]


def read_pmd(data: bytes, where: str) -> PmdMesh:
    """A mesh of the bytes of its file; ``BadInput`` where they are none."""
    try:
        return _read(data)
    except (struct.error, ValueError, IndexError, UnicodeDecodeError) as error:
        raise BadInput(f"this PMD cannot be read: {error}", where=where) from None


def _read(data: bytes) -> PmdMesh:
    magic, version, _, count = struct.unpack_from("<4s3I", data)
    if magic != MAGIC or version not in VERSIONS:
        raise ValueError("another format or version")
    at, sets = 16, 1
    if version > 3:
        (sets,), at = struct.unpack_from("<I", data, at), at + 4
    row = np.dtype([("place", "<f4", 3), ("normal", "<f4", 3), ("uv", "<f4", (sets, 2)), ("blends", "V", BLENDS)])
    rows = np.frombuffer(data, row, count, at)
    at += count * row.itemsize
    (triangles,) = struct.unpack_from("<I", data, at)
    faces = np.frombuffer(data, "<u2", 3 * triangles, at + 4).reshape(-1, 3).astype(np.int64)
    at += 4 + 6 * triangles
    if faces.size and int(faces.max()) >= count:
        raise ValueError("a triangle of vertices that are not there")
    (bones,) = struct.unpack_from("<I", data, at)
    poses = [_pose(struct.unpack_from("<7f", data, at + 4 + 28 * number)) for number in range(bones)]
    at += 4 + 28 * bones
    (named,), at = struct.unpack_from("<I", data, at), at + 4
    points = {}
    for _ in range(named):
        (length,) = struct.unpack_from("<I", data, at)
        name = data[at + 4 : at + 4 + length].decode("utf-8")
        *place, bone = struct.unpack_from("<7fB", data, at + 4 + length)
        at += 4 + length + 29
        points[name] = _pose(place) if bone == NO_BONE else poses[bone] @ _pose(place)
    return PmdMesh(
        rows["place"].astype(float), rows["normal"].astype(float), rows["uv"][:, 0].astype(float), faces, points
    )


def _pose(values: tuple[float, ...] | list[float]) -> Matrix:
    """A matrix of a place and a quaternion (x, y, z, w)."""
    matrix = np.eye(4)
    matrix[:3, 3] = values[:3]
    matrix[:3, :3] = Rotation.from_quat(values[3:]).as_matrix()
    return matrix
