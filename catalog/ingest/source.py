"""Reads one mesh file (glTF, GLB, OBJ, DAE) into parts in Unreal's axes and cm, with surfaces and notes of faults."""

from __future__ import annotations

import io
import logging
import re
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image

from c4s.errors import BadInput
from catalog.ingest.resolver import FolderResolver

SUFFIXES = (".glb", ".gltf", ".obj", ".dae")
Up = Literal["y", "z", "x"]
TO_UNREAL: dict[str, list[list[float]]] = {
    "y": [[1, 0, 0], [0, 0, 1], [0, 1, 0]],
    "z": [[1, 0, 0], [0, -1, 0], [0, 0, 1]],
    "x": [[0, -1, 0], [0, 0, 1], [1, 0, 0]],
}
"""From right-handed axes with this one up to Unreal's left-handed ones with Z up: all three mirror."""
MAX_TEXTURE = 1024
"""Textures are reduced to this many pixels a side: a pack is read by every engine process."""
logging.getLogger("trimesh").setLevel(logging.CRITICAL)
logging.getLogger("collada").setLevel(logging.CRITICAL)


@dataclass(frozen=True)
class Surface:
    """What a face looks like: linear base colour, and the PNG of its base-colour texture."""

    name: str
    color: tuple[float, float, float] = (0.5, 0.5, 0.5)
    roughness: float = 0.8
    metallic: float = 0.0
    emissive: tuple[float, float, float] = (0.0, 0.0, 0.0)
    opacity: float = 1.0
    texture: bytes | None = None


@dataclass(frozen=True)
class SourcePart:
    """The triangles of one node and one surface; cm, Unreal's axes, normals and texture coordinates as in ``Mesh``."""

    node: str
    surface: Surface
    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    normals: NDArray[np.float64]
    uvs: NDArray[np.float64]


@dataclass
class Source:
    """A read mesh file."""

    parts: list[SourcePart]
    notes: list[str] = field(default_factory=list)


def linear(channel: float) -> float:
    """A display (sRGB) channel in [0, 1] as linear light."""
    return channel / 12.92 if channel <= 0.04045 else float(((channel + 0.055) / 1.055) ** 2.4)


def texture_png(image: Image.Image) -> bytes:
    """PNG bytes of a picture, reduced to ``MAX_TEXTURE``."""
    image = image.convert("RGB")
    return _encoded(image.size, image.tobytes())


@lru_cache(maxsize=8)
def _encoded(size: tuple[int, int], data: bytes) -> bytes:
    image = Image.frombytes("RGB", size, data)
    if max(image.size) > MAX_TEXTURE:
        factor = MAX_TEXTURE / max(image.size)
        image = image.resize((max(1, round(image.width * factor)), max(1, round(image.height * factor))),
                             Image.Resampling.BOX)
    out = io.BytesIO()
    image.save(out, format="PNG")
    return out.getvalue()


class SurfaceReader:
    """Turns trimesh's materials into surfaces; a picture is converted once.

    ``display_colors``: plain colours are display (sRGB) values, as in OBJ and DAE, and not linear, as in glTF.
    """

    def __init__(self, *, display_colors: bool = False) -> None:
        self.display_colors = display_colors
        self._pictures: dict[int, tuple[Image.Image, bytes | None]] = {}

    def read(self, visual: Any, notes: list[str]) -> Surface:
        """The surface of a geometry's visual."""
        material = getattr(visual, "material", None)
        if material is None:
            mean = np.asarray(visual.main_color, dtype=float)[:3] / 255 if visual.defined else np.full(3, 0.5)
            if visual.defined and visual.kind == "vertex" and np.ptp(visual.vertex_colors, axis=0).any():
                notes.append("colours of vertices became one mean colour")
                mean = np.asarray(visual.vertex_colors, dtype=float)[:, :3].mean(axis=0) / 255
            return Surface("plain", _color([linear(float(c)) for c in mean]))
        name = str(getattr(material, "name", None) or "material")
        if isinstance(material, trimesh.visual.material.PBRMaterial):
            return self._pbr(name, material, notes)
        texture = self._texture(material.image, notes)
        diffuse = np.asarray(material.diffuse, dtype=float).ravel()[:3] / 255
        color = (1.0, 1.0, 1.0) if texture else _color([linear(float(c)) for c in diffuse])
        return Surface(name, color, texture=texture)

    def _pbr(self, name: str, material: Any, notes: list[str]) -> Surface:
        factor = material.baseColorFactor
        base = np.ones(4) if factor is None else np.asarray(factor, dtype=float)
        base = base / 255 if factor is not None and np.asarray(factor).dtype.kind in "ui" else base
        emissive = np.zeros(3) if material.emissiveFactor is None else np.asarray(material.emissiveFactor, dtype=float)
        see_through = material.alphaMode == "BLEND" and len(base) > 3
        texture = self._texture(material.baseColorTexture, notes)
        shown = [linear(max(0.0, float(c))) for c in base[:3]] if self.display_colors else base[:3]
        return Surface(name, _color(shown), round(_number(material.roughnessFactor, 1.0), 4),
                       round(_number(material.metallicFactor, 0.0), 4), _color(emissive[:3]),
                       round(float(base[3]), 4) if see_through else 1.0,
                       texture)

    def _texture(self, image: Any, notes: list[str]) -> bytes | None:
        if image is None:
            return None
        if id(image) not in self._pictures:
            try:
                data = texture_png(image)
            except (OSError, ValueError, SyntaxError) as error:
                notes.append(f"a texture cannot be decoded and is left out: {error}")
                data = None
            self._pictures[id(image)] = (image, data)
        return self._pictures[id(image)][1]


def _color(values: Any) -> tuple[float, float, float]:
    r, g, b = (round(min(1.0, max(0.0, float(value))), 4) for value in values)
    return r, g, b


def _number(value: Any, default: float) -> float:
    return default if value is None else float(value)


class OpenFile:
    """A parsed mesh file with its unit and axes; arguments and errors as in ``read_source``."""

    def __init__(self, path: Path, root: Path, *, scale: float = 1.0, up: Up | None = None) -> None:
        if not path.is_file():
            raise BadInput("no such mesh file", where=str(path))
        resolver, kind = FolderResolver(path, root), path.suffix.lower()
        if kind == ".dae":
            head = path.read_bytes()[:20_000].decode("utf-8", errors="replace")
            unit = re.search(r'<unit[^>]*\bmeter="([^"]+)"', head)
            axis = re.search(r"<up_axis>\s*([XYZ])_UP", head)
            scale *= _unit(unit.group(1), path) if unit else 1.0
            up = up or (axis.group(1).lower() if axis else "y")  # type: ignore[assignment]
        try:
            with path.open("rb") as file:
                self.scene = trimesh.load_scene(file, file_type=kind[1:], resolver=resolver, process=False)
        except Exception as error:  # trimesh's readers raise whatever their format's parser raises
            lost = f"; missing {', '.join(resolver.missing)}" if resolver.missing else ""
            raise BadInput(f"cannot read this mesh: {type(error).__name__}: {error}{lost}", where=str(path)) from None
        self.notes = [f"file {name!r} is missing: the plain colour is used" for name in resolver.missing]
        self.surfaces = SurfaceReader(display_colors=kind in (".obj", ".dae"))
        self.path, self.scale, self.axes = path, scale, np.asarray(TO_UNREAL[up or "y"])

    def part(self, node: str, geometry: Any, matrix: NDArray[np.float64], surface: Surface) -> SourcePart:
        """The triangles of a geometry under a matrix of the file's axes and units."""
        return _part(node, geometry, matrix, self.axes, self.scale, surface, self.path)


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
    opened = OpenFile(path, root, scale=scale, up=up)
    scene, notes = opened.scene, opened.notes
    parts, read = [], opened.surfaces.read
    order = {name: number for number, name in enumerate(scene.geometry)}
    placed = [(node, *scene.graph[node]) for node in scene.graph.nodes_geometry]
    for node, matrix, name in sorted(placed, key=lambda one: (order[one[2]], np.asarray(one[1]).tolist())):
        geometry = scene.geometry[name]
        if not isinstance(geometry, trimesh.Trimesh) or not len(geometry.faces):
            notes.append(f"node {node!r} has no triangles")
            continue
        surface = read(geometry.visual, notes)
        split = geometry.metadata.get("from_gltf_primitive") and node in scene.graph.transforms.parents
        owner = scene.graph.transforms.parents[node] if split else node
        parts.append(opened.part(str(owner), geometry, np.asarray(matrix, float), surface))
    if not parts:
        raise BadInput("the file has no triangles", where=str(path))
    extent = np.ptp(np.concatenate([part.vertices for part in parts]), axis=0)
    if np.count_nonzero(extent > 1e-4) < 2:
        raise BadInput("the mesh has no extent (is it compressed in a way that cannot be read?)", where=str(path))
    return Source(parts, list(dict.fromkeys(notes)))


def _unit(text: str, path: Path) -> float:
    try:
        unit = float(text)
    except ValueError:
        unit = 0.0
    if not 0 < unit < 1e6:
        raise BadInput(f"the unit of the file, {text!r} metres, is no positive number", where=str(path))
    return unit


def _part(node: str, geometry: Any, matrix: NDArray[np.float64], axes: NDArray[np.float64], scale: float,
          surface: Surface, path: Path) -> SourcePart:
    full = axes @ matrix[:3, :3]
    points = (np.asarray(geometry.vertices, float) @ full.T + axes @ matrix[:3, 3]) * (100 * scale)
    if not np.isfinite(points).all():
        raise BadInput("the mesh has coordinates that are not finite numbers", where=str(path))
    if not 0 <= geometry.faces.min() <= geometry.faces.max() < len(points):
        raise BadInput("a triangle names a vertex that does not exist", where=str(path))
    if abs(np.linalg.det(full)) < 1e-12:
        raise BadInput(f"node {node!r} is scaled to nothing", where=str(path))
    normals = np.nan_to_num(np.asarray(geometry.vertex_normals, float)) @ np.linalg.inv(full)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, length, out=np.tile([0.0, 0.0, 1.0], (len(normals), 1)), where=length > 0)
    raw = getattr(geometry.visual, "uv", None)
    fits = raw is not None and np.shape(raw) == (len(points), 2) and np.isfinite(raw).all()
    uvs = np.asarray(raw, float) * [1, -1] + [0, 1] if fits else np.zeros((len(points), 2))
    mirrored = np.linalg.det(full) < 0
    faces = np.asarray(geometry.faces, np.int64)
    return SourcePart(node, surface, points, faces[:, ::-1] if mirrored else faces, normals, uvs)
