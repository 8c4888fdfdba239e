"""DAE and STL files, parsed by trimesh: surfaces, units, axes and notes of faults."""

from __future__ import annotations

import io
import logging
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import read_plain
from c4s.packs.meshes import reader_words
from catalog.ingest.resolver import FolderResolver
from catalog.ingest.surface import Surface, color_of, linear, linear_of, texture_png

Floats = NDArray[np.float64]
logging.getLogger("trimesh").setLevel(logging.CRITICAL)
logging.getLogger("collada").setLevel(logging.CRITICAL)


class SurfaceReader:
    """Turns trimesh's materials into surfaces; a picture is converted once. Plain colours are display (sRGB) values."""

    def __init__(self) -> None:
        self._pictures: dict[int, tuple[Image.Image, bytes | None]] = {}

    def read(self, visual: Any, notes: list[str]) -> Surface:
        """The surface of a geometry's visual; colours of vertices are not part of it."""
        material = getattr(visual, "material", None)
        if material is None:
            mean = np.asarray(visual.main_color, dtype=float)[:3] / 255 if visual.defined else np.full(3, 0.5)
            return Surface("plain", color_of([linear(float(c)) for c in mean]))
        name = str(getattr(material, "name", None) or "material")
        if isinstance(material, trimesh.visual.material.PBRMaterial):
            return self._pbr(name, material, notes)
        texture = self._texture(material.image, notes)
        diffuse = np.asarray(material.diffuse, dtype=float).ravel()[:3] / 255
        color = (1.0, 1.0, 1.0) if texture else color_of([linear(float(c)) for c in diffuse])
        return Surface(name, color, texture=texture)

    def _pbr(self, name: str, material: Any, notes: list[str]) -> Surface:
        factor = material.baseColorFactor
        base = np.ones(4) if factor is None else np.asarray(factor, dtype=float)
        base = base / 255 if factor is not None and np.asarray(factor).dtype.kind in "ui" else base
        emissive = np.zeros(3) if material.emissiveFactor is None else np.asarray(material.emissiveFactor, dtype=float)
        see_through = material.alphaMode == "BLEND" and len(base) > 3
        texture = self._texture(material.baseColorTexture, notes)
        return Surface(
            name,
            color_of([linear(max(0.0, float(c))) for c in base[:3]]),
            round(_number(material.roughnessFactor, 1.0), 4),
            round(_number(material.metallicFactor, 0.0), 4),
            color_of(emissive[:3]),
            round(float(base[3]), 4) if see_through else 1.0,
            texture,
        )

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


class TrimeshFile:
    """A parsed file: its scene of trimesh, metres per unit, and the axis that points up.

    Args:
        path: the file; ``.dae`` or ``.stl``.
        root: the only folder whose files may be read.
    """

    def __init__(self, path: Path, root: Path) -> None:
        if not path.is_file():
            raise BadInput("no such mesh file", where=str(path))
        kind = path.suffix.lower()
        resolver = FolderResolver(path, root)
        self.path, self.unit_m, self.up = path, 1.0, "y"
        if kind == ".dae":
            head = read_plain(path, bound=BOUNDS["mesh_bytes"])[:20_000].decode("utf-8", errors="replace")
            unit = re.search(r'<unit[^>]*\bmeter="([^"]+)"', head)
            axis = re.search(r"<up_axis>\s*([XYZ])_UP", head)
            self.unit_m = _unit(unit.group(1), path) if unit else 1.0
            self.up = axis.group(1).lower() if axis else "y"
        data = io.BytesIO(read_plain(path, bound=BOUNDS["mesh_bytes"]))
        try:
            self.scene = trimesh.load_scene(data, file_type=kind[1:], resolver=resolver, process=False)
        except BadInput:
            raise
        except Exception as error:  # trimesh's readers raise whatever their format's parser raises
            lost = f"; missing {', '.join(resolver.missing)}" if resolver.missing else ""
            raise BadInput(f"cannot read this mesh: {reader_words(error)}{lost}", where=str(path)) from None
        self.notes = [f"file {name!r} is missing: the plain colour is used" for name in resolver.missing]
        self.surfaces = SurfaceReader()

    def geometries(self) -> Iterator[tuple[str, str, NDArray[np.float64]]]:
        """Node, geometry and matrix of everything placed, in an order that does not hang on the reader's."""
        graph, order = self.scene.graph, {name: number for number, name in enumerate(self.scene.geometry)}
        placed = [(str(node), *graph[node]) for node in graph.nodes_geometry]
        for node, matrix, name in sorted(placed, key=lambda one: (order[one[2]], np.asarray(one[1]).tolist())):
            yield node, str(name), np.asarray(matrix, float)

    def arrays(self, name: str) -> tuple[Surface, Floats, NDArray[np.int64], Floats, Floats, Floats | None] | None:
        """Surface, points, triangles, normals, texture coordinates (v down) and colours of a geometry.

        ``None`` for one without triangles; ``BadInput`` when a triangle names a vertex that does not exist.
        """
        geometry = self.scene.geometry[name]
        if not isinstance(geometry, trimesh.Trimesh) or not len(geometry.faces):
            return None
        visual: Any = geometry.visual
        surface = self.surfaces.read(visual, self.notes)
        points, faces = np.asarray(geometry.vertices, float), np.asarray(geometry.faces, np.int64)
        if not 0 <= faces.min() <= faces.max() < len(points):
            raise BadInput("a triangle names a vertex that does not exist", where=str(self.path))
        normals = np.nan_to_num(np.asarray(geometry.vertex_normals, float))
        if getattr(visual, "kind", None) == "vertex" and np.ptp(visual.vertex_colors, axis=0).any():
            colors = linear_of(np.asarray(visual.vertex_colors, float)[:, :3] / 255)
            return Surface("vertex_colors", (1.0, 1.0, 1.0)), points, faces, normals, np.zeros((len(points), 2)), colors
        raw = getattr(visual, "uv", None)
        fits = raw is not None and np.shape(raw) == (len(points), 2) and np.isfinite(raw).all()
        return (
            surface,
            points,
            faces,
            normals,
            (np.asarray(raw, float) * [1, -1] + [0, 1] if fits else np.zeros((len(points), 2))),
            None,
        )


def _number(value: Any, default: float) -> float:
    return default if value is None else float(value)


def _unit(text: str, path: Path) -> float:
    try:
        unit = float(text)
    except ValueError:
        unit = 0.0
    if not 0 < unit < 1e6:
        raise BadInput(f"the unit of the file, {text!r} metres, is no positive number", where=str(path))
    return unit
