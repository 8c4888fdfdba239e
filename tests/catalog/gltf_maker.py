"""Makes small glTF files for tests: arrays become accessors of one inline buffer."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

KINDS = {"float32": 5126, "uint8": 5121, "int8": 5120, "uint16": 5123, "int16": 5122, "uint32": 5125}
SHAPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Gltf:
    """A file under construction; ``tree`` is its JSON, to be changed at will."""

    def __init__(self) -> None:
        self.data = b""
        self.tree: dict[str, Any] = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, "name": "thing"}],
            "meshes": [],
            "accessors": [],
            "bufferViews": [],
            "buffers": [],
        }

    def view(self, data: bytes, **more: Any) -> int:
        """Number of a buffer view of these bytes."""
        self.data += b"\0" * (-len(self.data) % 4)
        self.tree["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), **more})
        self.data += data
        return len(self.tree["bufferViews"]) - 1

    def accessor(self, values: Any, kind: str = "float32", **more: Any) -> int:
        """Number of an accessor of these values, one row an element."""
        rows = np.asarray(values, kind)
        rows = rows.reshape(len(rows), -1)
        self.tree["accessors"].append(
            {
                "bufferView": self.view(rows.tobytes()),
                "componentType": KINDS[kind],
                "count": len(rows),
                "type": SHAPES[rows.shape[1]],
                **more,
            }
        )
        return len(self.tree["accessors"]) - 1

    def mesh(self, *primitives: dict[str, Any], **more: Any) -> int:
        """Number of a mesh of these primitives."""
        self.tree["meshes"].append({"name": f"mesh{len(self.tree['meshes'])}", "primitives": list(primitives), **more})
        return len(self.tree["meshes"]) - 1

    def box(self, size: tuple[float, float, float] = (1, 2, 3), **more: Any) -> dict[str, Any]:
        """A primitive: a box about the origin."""
        import trimesh

        made = trimesh.creation.box(extents=size)
        return {
            "attributes": {"POSITION": self.accessor(made.vertices)},
            "indices": self.accessor(np.asarray(made.faces).reshape(-1, 1), "uint16"),
            **more,
        }

    def write(self, path: Path) -> Path:
        """Write the file: GLB by its ending, else with the buffer inline."""
        tree = {key: value for key, value in self.tree.items() if value != []}
        if path.suffix == ".glb":
            tree["buffers"] = [{"byteLength": len(self.data)}]
            text = json.dumps(tree).encode()
            text += b" " * (-len(text) % 4)
            data = self.data + b"\0" * (-len(self.data) % 4)
            path.write_bytes(
                struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
                + struct.pack("<I4s", len(text), b"JSON")
                + text
                + struct.pack("<I4s", len(data), b"BIN\0")
                + data
            )
        else:
            if self.data:
                tree["buffers"] = [
                    {
                        "byteLength": len(self.data),
                        "uri": "data:application/octet-stream;base64," + base64.b64encode(self.data).decode(),
                    }
                ]
            path.write_text(json.dumps(tree))
        return path
