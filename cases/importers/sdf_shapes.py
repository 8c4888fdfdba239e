"""Geometry of SDF visuals and collisions: meshes, primitives, Ogre materials. SDF is metres, right-handed, Z up."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from c4s.packs.manifest import CollisionBody, SphereBody
from catalog.ingest.hulls import bodies, hull
from catalog.ingest.resolver import FolderResolver
from catalog.ingest.source import Source, SourcePart, Surface, linear, read_source, texture_png

Matrix = NDArray[np.float64]
FLIP = np.diag([1.0, -1.0, 1.0, 1.0])
CYLINDER_SIDES = 24


def numbers(text: str | None, count: int, default: float = 0.0) -> list[float]:
    """``count`` numbers of an element's text; ``BadInput`` when one is not finite or there are too few."""
    words = (text or "").split()
    if not words:
        return [default] * count
    try:
        values = [float(word) for word in words[:count]]
    except ValueError:
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise BadInput(f"{' '.join(words[:6])!r} is not {count} numbers")
    return values


def pose(element: Element) -> Matrix:
    """The pose of an element: x y z, and roll pitch yaw about fixed axes (radians)."""
    x, y, z, roll, pitch, yaw = numbers(element.findtext("pose"), 6)
    return rigid([x, y, z], [roll, pitch, yaw])


def rigid(place: list[float], angles: list[float]) -> Matrix:
    """A 4x4 matrix of a place and turns about the fixed axes x, y, z in that order (radians)."""
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_euler("xyz", angles).as_matrix()
    matrix[:3, 3] = place
    return matrix


def to_unreal(matrix: Matrix) -> Matrix:
    """A matrix of SDF's axes and metres in Unreal's axes and cm."""
    turned = FLIP @ matrix @ FLIP
    turned[:3, 3] *= 100
    return np.asarray(turned)


class SdfShapes:
    """Reads geometry elements; mesh files and material scripts are looked for under ``root`` alone."""

    def __init__(self, world: Path, root: Path) -> None:
        self.root = root
        self.files = FolderResolver(world, root)
        self.meshes: dict[Path, Source] = {}
        self._scripts: dict[str, tuple[Surface, float]] = {}
        for path in sorted(root.rglob("*.material")):
            self._read_script(path)

    def visual(self, element: Element, frame: Matrix) -> tuple[list[SourcePart], list[str]]:
        """Parts of a visual placed in ``frame`` (SDF axes), and notes."""
        matrix = to_unreal(frame @ pose(element))
        geometry = element.find("geometry")
        surface, repeat = self._surface(element.find("material"))
        if geometry is None or not len(geometry):
            raise BadInput("a visual without geometry")
        kind, notes = geometry[0].tag, list[str]()
        if kind == "mesh":
            source, factors = self._mesh(geometry[0])
            matrix, notes = matrix @ np.diag([*factors, 1.0]), source.notes
            parts = source.parts
        else:
            parts = [_solid(geometry[0])]
            surface = surface or Surface("plain", (0.6, 0.6, 0.6))
        return [_moved(part, matrix, surface, repeat) for part in parts], notes

    def collision(self, element: Element, frame: Matrix) -> list[CollisionBody]:
        """Bodies of a collision element placed in ``frame``: hulls, a hull a connected piece of a mesh."""
        geometry = element.find("geometry")
        if geometry is None or not len(geometry):
            return []
        matrix = to_unreal(frame @ pose(element))
        if geometry[0].tag == "sphere":
            radius = numbers(geometry[0].findtext("radius"), 1, 1.0)[0] * 100
            return [SphereBody(center=_vector(matrix[:3, 3]), radius=radius)]
        if geometry[0].tag != "mesh":
            return [hull(_moved(_solid(geometry[0]), matrix, None, 1.0).vertices)]
        source, factors = self._mesh(geometry[0])
        parts = [_moved(part, matrix @ np.diag([*factors, 1.0]), None, 1.0) for part in source.parts]
        return list(bodies([(part.node, part.vertices, part.faces) for part in parts], "piece"))

    def _mesh(self, element: Element) -> tuple[Source, list[float]]:
        uri = (element.findtext("uri") or "").strip()
        path = self.files.locate(uri)
        if path is None:
            raise BadInput(f"mesh {uri!r} is missing")
        if path not in self.meshes:
            self.meshes[path] = read_source(path, self.root, up="z")
        return self.meshes[path], numbers(element.findtext("scale"), 3, 1.0)

    def _surface(self, material: Element | None) -> tuple[Surface | None, float]:
        if material is None:
            return None, 1.0
        name = (material.findtext("script/name") or "").strip()
        if name in self._scripts:
            return self._scripts[name]
        color = material.findtext("diffuse") or material.findtext("ambient")
        if not color:
            return None, 1.0
        r, g, b = (round(linear(min(1.0, max(0.0, value))), 4) for value in numbers(color, 3))
        return Surface(name or "plain", (r, g, b)), 1.0

    def _read_script(self, path: Path) -> None:
        text = path.read_text(encoding="utf-8", errors="replace")
        for match in re.finditer(r"^\s*material\s+(\S+)(.*?)(?=^\s*material\s|\Z)", text, re.MULTILINE | re.DOTALL):
            name, body = match.groups()
            picture = re.search(r"\btexture\s+(\S+)", body)
            scale = re.search(r"\bscale\s+([0-9.eE+-]+)", body)
            diffuse = re.search(r"\bdiffuse\s+([0-9.]+)\s+([0-9.]+)\s+([0-9.]+)", body)
            color = [round(linear(min(1.0, float(value))), 4) for value in diffuse.groups()] if diffuse else [1.0] * 3
            file, data = self.files.locate(picture.group(1)) if picture else None, None
            if file is not None:
                try:
                    data = texture_png(Image.open(file))
                except (UnidentifiedImageError, OSError) as error:
                    raise BadInput(f"this texture cannot be read: {error}", where=str(file)) from None
            self._scripts[name] = (Surface(name.rsplit("/", 1)[-1], (color[0], color[1], color[2]), texture=data),
                                   1 / float(scale.group(1)) if scale and float(scale.group(1)) else 1.0)


def _vector(values: Matrix) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 3) for value in values)
    return x, y, z


def _moved(part: SourcePart, matrix: Matrix, surface: Surface | None, repeat: float) -> SourcePart:
    normals = part.normals @ np.linalg.inv(matrix[:3, :3])
    length = np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return SourcePart(part.node, surface or part.surface, part.vertices @ matrix[:3, :3].T + matrix[:3, 3], part.faces,
                      normals / length, part.uvs * repeat)


def _solid(element: Element) -> SourcePart:
    """A primitive as a part of cm in Unreal's axes about its own middle."""
    if element.tag == "plane":
        width, depth = numbers(element.findtext("size"), 2, 1.0)
        normal = np.asarray(numbers(element.findtext("normal") or "0 0 1", 3))
        corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * [width / 2, depth / 2, 1]
        turn = Rotation.align_vectors(normal[None], np.array([[0.0, 0.0, 1.0]]))[0].as_matrix()
        return _part(corners @ turn.T, np.array([[0, 1, 2], [0, 2, 3]]),
                     np.array([[0, 1], [1, 1], [1, 0], [0, 0]], float))
    if element.tag == "box":
        return _box(np.asarray(numbers(element.findtext("size"), 3, 1.0)))
    if element.tag == "cylinder":
        mesh = trimesh.creation.cylinder(radius=numbers(element.findtext("radius"), 1, 1.0)[0], sections=CYLINDER_SIDES,
                                         height=numbers(element.findtext("length"), 1, 1.0)[0])
    elif element.tag == "sphere":
        mesh = trimesh.creation.uv_sphere(radius=numbers(element.findtext("radius"), 1, 1.0)[0], count=[12, 24])
    else:
        raise BadInput(f"geometry <{element.tag}> is not supported")
    sharp = np.asarray(mesh.faces).ravel()
    return _part(np.asarray(mesh.vertices)[sharp], np.arange(len(sharp)).reshape(-1, 3), None)


def _box(size: Matrix) -> SourcePart:
    corners, faces, uvs = [], [], []
    for axis in range(3):
        for side in (-1, 1):
            across, along = [i for i in range(3) if i != axis]
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = np.zeros(3)
                corner[axis], corner[across], corner[along] = side, a, b
                corners.append(corner * size / 2)
                uvs.append(((a + 1) / 2, (1 - b) / 2))
            start = len(corners) - 4
            faces += [[start, start + 1, start + 2], [start, start + 2, start + 3]]
    return _part(np.array(corners), np.array(faces), np.array(uvs))


def _part(points: Matrix, faces: NDArray[np.int64], uvs: Matrix | None) -> SourcePart:
    points = points * [100, -100, 100]
    sides = points[faces]
    flat = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    outward = np.sign(np.einsum("ij,ij->i", flat, sides.mean(axis=1)))
    flat *= np.where(outward == 0, 1, outward)[:, None]
    normals = np.zeros_like(points)
    normals[faces] = flat[:, None]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return SourcePart("solid", Surface("plain"), points, faces.astype(np.int64), normals,
                      np.zeros((len(points), 2)) if uvs is None else uvs)
