"""Triangle meshes in Unreal's local axes, and how mesh files become them.

Files are glTF/GLB, OBJ or DAE: metres, Y up, right-handed. The conversion is (x, y, z) m -> (x, z, y) * 100 cm with the
winding of every triangle reversed, because the swap of two axes changes the handedness.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.names import file_in
from c4s.packs.gltf_bounds import hold_file
from c4s.packs.plain_glb import PlainPart, read_plain
from c4s.records.pack import Asset

F32 = NDArray[np.float32]
I32 = NDArray[np.int32]


def reader_words(error: Exception) -> str:
    """What a library's reader says of a file, without names of classes; one that stumbled says nothing of use."""
    if isinstance(error, AttributeError | TypeError | LookupError | AssertionError):
        return "its content is not what such a file holds"
    return re.sub(r"\b\w+(?:Error|Exception):? ?", "", str(error)) or "its reader says nothing more"


@dataclass(frozen=True)
class Mesh:
    """A triangle mesh. Triangles are two-sided; their winding carries no meaning."""

    vertices: F32
    """(n, 3) cm, Unreal axes, origin at the pivot."""
    faces: I32
    """(m, 3) vertex indices."""
    normals: F32
    """(n, 3) unit vectors."""
    uvs: F32
    """(n, 2) texture coordinates: u to the right, v down, (0, 0) at the top left corner; they repeat."""
    face_slots: I32
    """(m,) material slot of each triangle."""
    colors: F32 | None = None
    """(n, 3) linear colours that multiply the materials' base colours; ``None`` for white."""

    @property
    def bounds_cm(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Lower and upper corner of the local bounding box."""
        low, high = self.vertices.min(axis=0), self.vertices.max(axis=0)
        return (float(low[0]), float(low[1]), float(low[2])), (float(high[0]), float(high[1]), float(high[2]))


@dataclass(frozen=True)
class MeshPart:
    """The triangles of one node and one material of a mesh file, already in Unreal's axes and cm."""

    slot: str
    """Name of the material in the file; ``slot`` where it has none."""
    vertices: F32
    faces: I32
    normals: F32
    uvs: F32
    colors: F32 | None = None


def _material_name(geometry: Any) -> str:
    name = getattr(getattr(geometry.visual, "material", None), "name", None)
    return str(name) if name else "slot"


def _colors(geometry: Any) -> F32 | None:
    """Vertex colours of a geometry, linear as glTF stores them; ``None`` when it has none."""
    visual = geometry.visual
    found = getattr(visual, "vertex_attributes", {}).get("color")
    if found is None and visual.kind == "vertex":
        found = visual.vertex_colors
    if found is None or len(found) != len(geometry.vertices):
        return None
    full = np.asarray(found)
    factor = np.iinfo(full.dtype).max if full.dtype.kind in "ui" else 1.0
    return np.clip(full[:, :3].astype(np.float64) / factor, 0.0, 1.0).astype(np.float32)


def _part(geometry: Any, matrix: NDArray[np.float64], scale: float, where: str) -> MeshPart:
    points = np.asarray(geometry.vertices, dtype=np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
    normals = np.asarray(geometry.vertex_normals, dtype=np.float64) @ np.linalg.inv(matrix[:3, :3])
    raw = getattr(geometry.visual, "uv", None)
    uvs = np.zeros((len(points), 2)) if raw is None or len(raw) != len(points) else np.asarray(raw) * [1, -1] + [0, 1]
    return _converted(
        _material_name(geometry), points, normals, uvs, np.asarray(geometry.faces), _colors(geometry), scale, where
    )


def _plain_part(part: PlainPart, scale: float, where: str) -> MeshPart:
    flipped = None if part.uvs is None else np.stack([part.uvs[:, 0], np.float32(1) - part.uvs[:, 1]], axis=1)
    uvs = np.zeros((len(part.points), 2)) if flipped is None else flipped * [1, -1] + [0, 1]
    return _converted(
        part.material or "slot",
        part.points.astype(np.float64),
        part.normals.astype(np.float64),
        uvs,
        part.faces,
        None,
        scale,
        where,
    )


def _converted(
    slot: str,
    points: NDArray[np.float64],
    normals: NDArray[np.float64],
    uvs: NDArray[np.float64],
    faces: NDArray[Any],
    colors: F32 | None,
    scale: float,
    where: str,
) -> MeshPart:
    """A part in Unreal's axes and cm, from metres with Y up."""
    if not np.isfinite(points).all():
        raise BadInput("the mesh has coordinates that are not finite numbers", where=where)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, length, out=np.tile([0.0, 1.0, 0.0], (len(normals), 1)), where=length > 0)
    swap = [0, 2, 1]
    return MeshPart(
        slot,
        (points[:, swap] * (100.0 * scale)).astype(np.float32),
        faces[:, ::-1].astype(np.int32),
        normals[:, swap].astype(np.float32),
        uvs.astype(np.float32),
        colors,
    )


def read_parts(path: Path, *, scale: float = 1.0) -> list[MeshPart]:
    """All triangles of a mesh file, a part for each node and material.

    Args:
        path: GLB, glTF, OBJ or DAE.
        scale: factor from the file's units to metres.

    Raises:
        BadInput: the file is missing, cannot be read, holds no triangles, or coordinates that are not finite.
    """
    if not path.is_file():
        raise BadInput("no such mesh file", where=str(path))
    plain = read_plain(path)
    if plain is not None:
        return [_plain_part(part, scale, str(path)) for part in plain]
    import trimesh

    BOUNDS["mesh_bytes"].hold(path.stat().st_size, where=str(path))
    if path.suffix.lower() in (".glb", ".gltf"):
        hold_file(path)
    try:
        scene = trimesh.load_scene(path, process=False)
    except Exception as error:  # trimesh's readers raise whatever their format's parser raises
        raise BadInput(f"cannot read this mesh: {reader_words(error)}", where=str(path)) from None
    parts: list[MeshPart] = []
    vertices = 0
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        geometry = scene.geometry[name]
        vertices += len(getattr(geometry, "vertices", ()))
        BOUNDS["mesh_vertices"].hold(vertices, where=str(path))
        if isinstance(geometry, trimesh.Trimesh) and len(geometry.faces):
            parts.append(_part(geometry, np.asarray(matrix, dtype=np.float64), scale, str(path)))
    if not parts:
        raise BadInput("the mesh has no triangles", where=str(path))
    return parts


def join_parts(parts: list[MeshPart], slots: list[str], where: str) -> Mesh:
    """One mesh of all parts. ``slots`` are the slot names in order; a part of another name is ``BadInput``."""
    index = {name: i for i, name in enumerate(slots)}
    unknown = sorted({part.slot for part in parts} - set(index))
    if unknown:
        raise BadInput(f"the mesh has a material {unknown[0]!r} that is no slot of the asset", where=where)
    offsets = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
    colors = None
    if any(part.colors is not None for part in parts):
        colors = np.concatenate(
            [np.ones((len(p.vertices), 3), np.float32) if p.colors is None else p.colors for p in parts]
        )
    return Mesh(
        vertices=np.concatenate([p.vertices for p in parts]),
        faces=np.concatenate([p.faces + np.int32(o) for p, o in zip(parts, offsets, strict=True)]),
        normals=np.concatenate([p.normals for p in parts]),
        uvs=np.concatenate([p.uvs for p in parts]),
        face_slots=np.concatenate([np.full(len(p.faces), index[p.slot], np.int32) for p in parts]),
        colors=colors,
    )


def load_mesh(pack_dir: Path, asset: Asset) -> Mesh:
    """The mesh of a static mesh asset; ``BadInput`` when the asset has none or its file is unusable."""
    if asset.mesh is None:
        raise BadInput("this asset has no mesh of its own", where=asset.path)
    path = file_in(pack_dir, asset.mesh)
    return join_parts(read_parts(path, scale=asset.mesh_scale), [slot.name for slot in asset.slots], str(path))
