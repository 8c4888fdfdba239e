"""A mesh, and the picture on it, in few bytes: what a page loads once, however many scenes show it.

A mesh is raw deflate of: the length of the header (4 bytes, little-endian), the header (JSON, padded with blanks to a
multiple of 4), then its arrays, each padded likewise::

    positions  uint16 x 3 a vertex, from ``low`` to ``high`` (local cm, Unreal's axes)
    normals    int8 x 3
    uvs        uint16 x 2, from ``uv_low`` to ``uv_high``
    colors     uint8 x 3, linear, only where ``colors`` is set
    indices    uint16, or uint32 where ``wide`` is set, sorted by slot; ``groups`` has [slot, first, count]

Triangles face where their normals point (the first side is counter-clockwise in a right-handed reading of the axes).
"""

from __future__ import annotations

import io
import json
import struct
import zlib
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from c4s.packs.meshes import Mesh
from c4s.packs.pictures import open_picture

MOST_TRIANGLES: Final = 20_000
"""A mesh of more is drawn coarser: vertices in one cell of a grid become one."""
MOST_PIXELS: Final = 256
"""Sides of a texture are at most this long."""
_COARSER: Final = 1.25
_STEPS: Final = 65535
_WIDE: Final = 65536
_RAW_DEFLATE: Final = -15
_QUALITY: Final = 80

Array = NDArray[Any]


def mesh_bytes(mesh: Mesh) -> tuple[bytes, int]:
    """A mesh as pages load it, and its number of triangles."""
    faces, used = _facing(mesh), np.arange(len(mesh.vertices))
    slots = mesh.face_slots
    if len(faces) > MOST_TRIANGLES:
        faces, slots, used = _coarse(mesh, faces)
    order = np.argsort(slots, kind="stable")
    faces, slots = faces[order], slots[order]
    kinds, first, count = np.unique(slots, return_index=True, return_counts=True)
    low, positions = _stepped(mesh.vertices[used])
    uv_low, uvs = _stepped(mesh.uvs[used])
    wide = len(used) >= _WIDE
    header = {
        "vertices": len(used),
        "indices": int(faces.size),
        "low": low[0],
        "high": low[1],
        "uv_low": uv_low[0],
        "uv_high": uv_low[1],
        "colors": mesh.colors is not None,
        "wide": wide,
        "groups": [[int(k), int(f) * 3, int(c) * 3] for k, f, c in zip(kinds, first, count, strict=True)],
    }
    arrays: list[Array] = [positions, np.round(mesh.normals[used] * 127).astype(np.int8), uvs]
    if mesh.colors is not None:
        arrays.append(np.round(mesh.colors[used] * 255).astype(np.uint8))
    arrays.append(faces.astype(np.uint32 if wide else np.uint16))
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data = struct.pack("<I", len(text)) + text + b"".join(_padded(array.tobytes()) for array in arrays)
    squeezer = zlib.compressobj(9, zlib.DEFLATED, _RAW_DEFLATE)
    return squeezer.compress(data) + squeezer.flush(), len(faces)


def texture_bytes(file: Path, *, holes: bool) -> bytes:
    """A texture as a small JPEG, or as PNG where its alpha cuts holes."""
    picture = open_picture(file, where=str(file)).convert("RGBA" if holes else "RGB")
    picture.thumbnail((MOST_PIXELS, MOST_PIXELS))
    buffer = io.BytesIO()
    if holes:
        picture.save(buffer, "PNG", optimize=True)
    else:
        picture.save(buffer, "JPEG", quality=_QUALITY)
    return buffer.getvalue()


def _padded(data: bytes) -> bytes:
    return data + b"\0" * (-len(data) % 4)


def _stepped(values: Array) -> tuple[tuple[list[float], list[float]], Array]:
    """Values as whole steps between the lowest and the highest of each column, and those two."""
    low, high = values.min(axis=0).astype(np.float64), values.max(axis=0).astype(np.float64)
    span = np.where(high > low, high - low, 1.0)
    ends = [round(float(value), 5) for value in low], [round(float(value), 5) for value in high]
    return ends, np.round((values - low) / span * _STEPS).astype(np.uint16)


def _facing(mesh: Mesh) -> Array:
    """The triangles, each turned so that it faces where its normals point."""
    faces = np.array(mesh.faces)
    corners = mesh.vertices[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inwards = np.einsum("ij,ij->i", across, mesh.normals[faces].sum(axis=1)) < 0
    faces[inwards] = faces[inwards][:, ::-1]
    return faces


def _coarse(mesh: Mesh, faces: Array) -> tuple[Array, Array, Array]:
    """Fewer triangles, their slots, and the vertices that are kept: one of each cell of the finest grid that does."""
    low = mesh.vertices.min(axis=0)
    cell = float(np.max(mesh.vertices.max(axis=0) - low)) / np.sqrt(2 * MOST_TRIANGLES)
    while True:
        cells = np.floor((mesh.vertices - low) / cell).astype(np.int64)
        _, used, place = np.unique(cells, axis=0, return_index=True, return_inverse=True)
        joined = place.reshape(-1)[faces]
        a, b, c = joined.T
        kept = (a != b) & (b != c) & (a != c)
        if np.count_nonzero(kept) <= MOST_TRIANGLES:
            return joined[kept], mesh.face_slots[kept], used
        cell *= _COARSER
