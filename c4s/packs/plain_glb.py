"""The GLB files that packs are made of, read without trimesh: importing that takes longer than reading a pack's meshes.

A plain file has roots without children that stand where their meshes do, one primitive of indexed triangles a mesh, and
positions, normals and texture coordinates in closely packed floats. Everything else is left to trimesh, and so is
saying what is wrong with a file.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s import files
from c4s.bounds import BOUNDS

_MAGIC, _JSON, _BIN = b"glTF", b"JSON", b"BIN\0"
_TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}
_ATTRIBUTES = {"POSITION", "NORMAL", "TEXCOORD_0"}
_NOT_PLAIN = ("children", "matrix", "translation", "rotation", "scale", "skin", "weights", "extensions")
_TRIANGLES = 4


@dataclass(frozen=True)
class PlainPart:
    """One node's triangles as the file has them: metres, Y up, and texture coordinates with v down."""

    material: str | None
    points: NDArray[np.float32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32] | None
    faces: NDArray[np.int64]


class _Other(Exception):
    """The file is not plain."""


def read_plain(path: Path) -> list[PlainPart] | None:
    """The parts of a plain GLB file, the last root first, as trimesh has them; ``None`` for any other file."""
    try:
        data = files.read_plain(path, bound=BOUNDS["mesh_bytes"])
        if data[:4] != _MAGIC or struct.unpack_from("<I", data, 4) != (2,):
            return None
        size, kind = struct.unpack_from("<I4s", data, 12)
        tree = json.loads(data[20 : 20 + size])
        length, binary = struct.unpack_from("<I4s", data, 20 + size)
        if kind != _JSON or binary != _BIN or "extensionsRequired" in tree or "uri" in tree["buffers"][0]:
            return None
        return _parts(tree, data[28 + size : 28 + size + length])
    except (_Other, ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError, struct.error):
        return None


def _parts(tree: dict[str, Any], data: bytes) -> list[PlainPart]:
    nodes = [tree["nodes"][number] for number in tree["scenes"][tree.get("scene", 0)]["nodes"]]
    meshes = [node["mesh"] for node in nodes]
    if not nodes or len(set(meshes)) < len(meshes) or any(name in node for node in nodes for name in _NOT_PLAIN):
        raise _Other
    return [_part(tree, tree["meshes"][number], data) for number in reversed(meshes)]


def _part(tree: dict[str, Any], mesh: dict[str, Any], data: bytes) -> PlainPart:
    (primitive,) = mesh["primitives"]
    attributes = primitive["attributes"]
    if (
        primitive.get("mode", _TRIANGLES) != _TRIANGLES
        or set(attributes) - _ATTRIBUTES
        or "targets" in primitive
        or "extensions" in primitive
    ):
        raise _Other
    points, normals = (_floats(tree, attributes[name], data, 3) for name in ("POSITION", "NORMAL"))
    uvs = _floats(tree, attributes["TEXCOORD_0"], data, 2) if "TEXCOORD_0" in attributes else None
    faces = _accessor(tree, primitive["indices"], data, "SCALAR").astype(np.int64).reshape(-1, 3)
    counts = {len(points), len(normals), len(points if uvs is None else uvs)}
    if not len(faces) or faces.max() >= len(points) or len(counts) != 1:
        raise _Other
    material = tree["materials"][primitive["material"]].get("name") if "material" in primitive else None
    if uvs is not None and material is None:
        raise _Other
    return PlainPart(material, points, normals, uvs, faces)


def _floats(tree: dict[str, Any], number: int, data: bytes, width: int) -> NDArray[np.float32]:
    found = _accessor(tree, number, data, f"VEC{width}")
    if found.dtype != np.float32:
        raise _Other
    return found.reshape(-1, width)


def _accessor(tree: dict[str, Any], number: int, data: bytes, kind: str) -> NDArray[Any]:
    accessor = tree["accessors"][number]
    view = tree["bufferViews"][accessor["bufferView"]]
    if (
        accessor["type"] != kind
        or "sparse" in accessor
        or accessor.get("normalized")
        or view.get("byteStride")
        or view.get("buffer", 0) != 0
    ):
        raise _Other
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return np.frombuffer(data, _TYPES[accessor["componentType"]], accessor["count"] * _WIDTHS[kind], start)
