"""Another reader of mesh files to compare with: the Assimp library that the collision library brings along."""

from __future__ import annotations

import ctypes
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

TRIANGULATE = 0x8
LIBRARY = next(iter(Path(np.__file__).parents[1].glob("cmeel.prefix/lib/libassimp.so*")), None)


@dataclass(frozen=True)
class AssimpMesh:
    """Triangles of one material: (n, 3, 3) corners, and texture coordinates (n, 3, 2) with v up where it has them."""

    material: str
    corners: NDArray[np.float64]
    uvs: NDArray[np.float64] | None
    colors: NDArray[np.float64] | None


def read(path: Path, scratch: Path) -> list[AssimpMesh]:
    """The meshes of a file as Assimp reads them, placed by no node."""
    assert LIBRARY is not None
    library = ctypes.CDLL(str(LIBRARY))
    library.aiImportFile.restype = ctypes.c_void_p
    library.aiImportFile.argtypes = [ctypes.c_char_p, ctypes.c_uint]
    library.aiExportScene.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_uint]
    library.aiReleaseImport.argtypes = [ctypes.c_void_p]
    scene = library.aiImportFile(str(path).encode(), TRIANGULATE)
    assert scene, path
    out = scratch / "assimp.json"
    assert library.aiExportScene(scene, b"assjson", str(out).encode(), 0) == 0
    library.aiReleaseImport(scene)
    tree = json.loads(out.read_text(errors="replace"), strict=False)
    names = [
        next((one["value"] for one in material["properties"] if one["key"] == "?mat.name"), "")
        for material in tree.get("materials", [])
    ]
    return [_mesh(record, names) for record in tree.get("meshes", [])]


def _mesh(record: dict[str, Any], names: list[str]) -> AssimpMesh:
    faces = np.asarray([face for face in record["faces"] if len(face) == 3], np.int64).reshape(-1, 3)

    def table(values: Any, width: int) -> NDArray[np.float64]:
        corners: NDArray[np.float64] = np.asarray(values, float).reshape(-1, width)[faces]
        return corners

    uvs = record.get("texturecoords")
    colors = record.get("colors")
    return AssimpMesh(
        names[record["materialindex"]],
        table(record["vertices"], 3),
        table(uvs[0], record["numuvcomponents"][0])[..., :2] if uvs else None,
        table(colors[0], 4) if colors else None,
    )
