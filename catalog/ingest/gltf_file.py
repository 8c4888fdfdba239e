"""The container of glTF 2.0: JSON, buffers and accessors of a .gltf or .glb file, each checked before it is used."""

from __future__ import annotations

import base64
import binascii
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import read_plain
from c4s.packs.gltf_bounds import hold_tree, read_tree
from catalog.ingest.resolver import FolderResolver

COMPONENT = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
READ = (
    "KHR_draco_mesh_compression",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_texture_basisu",
    "EXT_texture_webp",
    "EXT_texture_avif",
    "EXT_mesh_gpu_instancing",
    "KHR_lights_punctual",
    "KHR_node_visibility",
    "KHR_animation_pointer",
    "KHR_xmp_json_ld",
    "MSFT_lod",
    "KHR_physics_rigid_bodies",
    "KHR_implicit_shapes",
    "OMI_physics_body",
    "OMI_physics_shape",
)
"""Extensions that a file may require; those of materials (``KHR_materials_*``) may be required too."""
MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")


class GltfFile:
    """A parsed file; arrays are decoded on request.

    Args:
        path: the file.
        root: the only folder whose files may be read.

    Raises:
        BadInput: the file is no glTF 2.0, is cut off, or requires an extension that is not read (it is named).
    """

    def __init__(self, path: Path, root: Path) -> None:
        if not path.is_file():
            raise BadInput("no such mesh file", where=str(path))
        self.path, self.resolver = path, FolderResolver(path, root)
        self.notes: list[str] = []
        self._buffers: dict[int, memoryview] = {}
        self._accessors: dict[int, NDArray[Any]] = {}
        data = read_plain(path, bound=BOUNDS["mesh_bytes"])
        self.binary: bytes | None = None
        text = self._chunks(data) if data[:4] == b"glTF" or path.suffix.lower() == ".glb" else data
        tree = read_tree(text, str(path))
        if not isinstance(tree.get("asset"), dict):
            raise self.bad("this is no glTF file: it has no asset record")
        hold_tree(tree, str(path))
        self.tree: dict[str, Any] = tree
        version = str(tree["asset"].get("version", ""))
        if not version.startswith("2."):
            raise self.bad(f"glTF version {version or 'unknown'} is not read; export it as glTF 2.0")
        self._check_extensions()

    def bad(self, what: str) -> BadInput:
        """An error about this file."""
        return BadInput(what, where=str(self.path))

    def _chunks(self, data: bytes) -> bytes:
        if len(data) < 20 or data[:4] != b"glTF":
            raise self.bad("cannot read this mesh: it is no GLB file, or it is cut off in its header")
        version, length = struct.unpack_from("<II", data, 4)
        if version != 2:
            raise self.bad(f"GLB version {version} is not read; export it as glTF 2.0")
        if length > len(data):
            raise self.bad(f"the file is cut off: {len(data)} of {length} bytes are here")
        text, place = b"", 12
        while place + 8 <= length:
            size, kind = struct.unpack_from("<II", data, place)
            if place + 8 + size > length:
                raise self.bad("the file is cut off: a chunk reaches past its end")
            chunk = data[place + 8 : place + 8 + size]
            if kind == 0x4E4F534A and not text:
                text = chunk
            elif kind == 0x004E4942 and self.binary is None:
                self.binary = chunk
            place += 8 + size
        return text

    def _check_extensions(self) -> None:
        for name in self.tree.get("extensionsRequired", []):
            if name in MESHOPT:
                raise self.bad(
                    f"its meshes are compressed with {name}, which is not read; write the file again "
                    "without it (gltfpack without -c, or gltf-transform copy)"
                )
            if name not in READ and not str(name).startswith("KHR_materials_"):
                raise self.bad(f"it requires the extension {name}, which is not read")

    def items(self, kind: str) -> list[dict[str, Any]]:
        """The records of a kind (``nodes``, ``meshes``), an empty list where there are none."""
        found = self.tree.get(kind, [])
        if not isinstance(found, list) or not all(isinstance(item, dict) for item in found):
            raise self.bad(f"its {kind} are no list of records")
        return found

    def item(self, kind: str, index: Any) -> dict[str, Any]:
        """One record; ``BadInput`` when the index is none of the list."""
        found = self.items(kind)
        if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(found):
            raise self.bad(f"it names {kind} {index!r}, of which there are {len(found)}")
        return found[index]

    def buffer(self, index: Any) -> memoryview:
        """Bytes of a buffer."""
        record = self.item("buffers", index)
        if index not in self._buffers:
            uri, length = record.get("uri"), int(record.get("byteLength", 0))
            if uri is None and any(name in record.get("extensions", {}) for name in MESHOPT):
                raise self.bad(f"its meshes are compressed with {MESHOPT[0]} and hold no plain copy")
            data = self.binary if uri is None and index == 0 else self.bytes_of(uri)
            if data is None:
                raise self.bad(f"buffer {index} has no data")
            if len(data) < length:
                raise self.bad(f"buffer {index} is cut off: {len(data)} of {length} bytes are here")
            self._buffers[index] = memoryview(data)
        return self._buffers[index]

    def bytes_of(self, uri: Any) -> bytes:
        """Bytes behind an address: inline data, or a file of the folder; ``BadInput`` when there are none."""
        if not isinstance(uri, str):
            raise self.bad("a buffer or picture has neither data nor a file")
        if uri.startswith("data:"):
            head, _, body = uri.partition(",")
            try:
                return base64.b64decode(body, validate=True) if head.endswith(";base64") else body.encode()
            except (binascii.Error, ValueError):
                raise self.bad("inline data is no valid base64") from None
        try:
            return self.resolver.get(uri)
        except FileNotFoundError:
            raise self.bad(f"file {uri!r} is missing") from None

    def view(self, index: Any) -> memoryview:
        """Bytes of a buffer view."""
        record = self.item("bufferViews", index)
        start, length = int(record.get("byteOffset", 0)), int(record.get("byteLength", 0))
        data = self.buffer(record.get("buffer"))
        if start < 0 or length < 0 or start + length > len(data):
            raise self.bad(f"buffer view {index} reaches past the end of its buffer")
        return data[start : start + length]

    def array(self, index: Any) -> NDArray[Any]:
        """An accessor as (count, width): integers as they are, normalised ones and floats as float64."""
        record = self.item("accessors", index)
        if index not in self._accessors:
            kind, width = COMPONENT.get(record.get("componentType", 0)), WIDTH.get(str(record.get("type")))
            count = record.get("count")
            if (
                kind is None
                or width is None
                or not isinstance(count, int)
                or not 0 <= count <= BOUNDS["mesh_numbers"].most
            ):
                raise self.bad(f"accessor {index} has an unknown type or count")
            values = self._plain(record, kind, width, count, index)
            if "sparse" in record:
                values = self._sparse(record["sparse"], values, kind, width, index)
            self._accessors[index] = (
                scaled(values)
                if record.get("normalized")
                else (values.astype(np.float64) if values.dtype.kind == "f" else values)
            )
        return self._accessors[index]

    def _plain(self, record: dict[str, Any], kind: Any, width: int, count: int, index: Any) -> NDArray[Any]:
        if "bufferView" not in record:
            return np.zeros((count, width), kind)
        data, size = self.view(record["bufferView"]), np.dtype(kind).itemsize * width
        start = int(record.get("byteOffset", 0))
        stride = int(self.item("bufferViews", record["bufferView"]).get("byteStride") or size)
        if count == 0:
            return np.zeros((0, width), kind)
        if start < 0 or stride < 1 or start + stride * (count - 1) + size > len(data):
            raise self.bad(f"accessor {index} reaches past the end of its data")
        return np.ndarray(
            (count, width), np.dtype(kind).newbyteorder("<"), data, start, (stride, np.dtype(kind).itemsize)
        ).astype(kind)

    def _sparse(self, record: dict[str, Any], values: NDArray[Any], kind: Any, width: int, index: Any) -> NDArray[Any]:
        count, places, news = int(record.get("count", 0)), record.get("indices", {}), record.get("values", {})
        where_kind = COMPONENT.get(places.get("componentType"))
        if where_kind not in (np.uint8, np.uint16, np.uint32) or not 0 <= count <= len(values):
            raise self.bad(f"accessor {index} has wrong sparse values")
        where = self._plain(places, where_kind, 1, count, index)[:, 0]
        if len(where) and where.max() >= len(values):
            raise self.bad(f"accessor {index} has a sparse value past its end")
        values = values.copy()
        values[where] = self._plain(news, kind, width, count, index)
        return values


def scaled(values: NDArray[Any]) -> NDArray[np.float64]:
    """Integers as shares of the largest value of their type (glTF 2.0, 3.6.2.2); floats as they are."""
    if values.dtype.kind == "f":
        return values.astype(np.float64)
    return np.maximum(values.astype(np.float64) / np.iinfo(values.dtype).max, -1.0)
