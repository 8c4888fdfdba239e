"""Geometry of SDF visuals and collisions: meshes, primitives and ground. SDF is metres, right-handed, Z up."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace as dataclass_replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from c4s.geometry.transform import rotator_from_quat
from c4s.records.pack import CapsuleBody, CollisionBody, SphereBody
from cases.importers.sdf_frames import Matrix, numbers, pose
from cases.importers.sdf_ground import heights, road, terrain, terrain_slabs
from cases.importers.sdf_library import SdfFiles
from cases.importers.sdf_materials import SdfMaterials
from cases.importers.sdf_solids import solid
from cases.importers.sdf_submesh import part_names
from catalog.ingest.collision import made_bodies
from catalog.ingest.hulls import hull
from catalog.ingest.source import GLTF, Up, read_source
from catalog.ingest.surface import Source, SourcePart, Surface, color_of, linear

EARTH = (0.19, 0.14, 0.09)
FLIP = np.diag([1.0, -1.0, 1.0, 1.0])


def to_unreal(matrix: Matrix) -> Matrix:
    """A matrix of SDF's axes and metres in Unreal's axes and cm."""
    turned = FLIP @ matrix @ FLIP
    turned[:3, 3] *= 100
    return np.asarray(turned)


class SdfShapes:
    """Reads geometry elements; mesh files and material scripts are looked for in the scene's folders alone.

    ``replace``: the file to read in place of one that is named (``model://a/b.obj`` as ``a/c.obj#part,part``).
    """

    def __init__(self, files: SdfFiles, replace: Mapping[str, str]) -> None:
        self.files, self.replace = files, replace
        self.materials = SdfMaterials(files)
        self.meshes: dict[Path, Source] = {}

    def visual(self, element: Element, frame: Matrix) -> tuple[list[SourcePart], list[str]]:
        """Parts of a visual placed in ``frame`` (SDF axes), and notes."""
        matrix = to_unreal(frame @ pose(element))
        geometry = element.find("geometry")
        if geometry is None or not len(geometry):
            raise BadInput("a visual without geometry")
        kind, notes = geometry[0].tag, list[str]()
        surface, repeat = self.materials.read(element, notes)
        if kind == "empty":
            return [], notes
        if kind == "mesh":
            parts, factors, said = self._mesh(geometry[0])
            matrix = matrix @ np.diag([*factors, 1.0])
            notes += said
        elif kind == "heightmap":
            parts = [self._terrain(geometry[0], surface, notes)]
            surface = None
        else:
            parts = [solid(geometry[0])]
            surface = surface or Surface("plain", (0.6, 0.6, 0.6))
        return [_moved(part, matrix, surface, repeat) for part in parts], notes

    def collision(self, element: Element, frame: Matrix) -> list[CollisionBody]:
        """Bodies of a collision element placed in ``frame``: of a mesh the solid parts and panels that it tells."""
        geometry = element.find("geometry")
        if geometry is None or not len(geometry):
            return []
        matrix = to_unreal(frame @ pose(element))
        kind = geometry[0].tag
        if kind == "empty":
            return []
        if kind == "sphere":
            radius = numbers(geometry[0].findtext("radius"), 1, 1.0)[0] * 100
            return [SphereBody(center=_vector(matrix[:3, 3]), radius=radius)]
        if kind == "capsule":
            radius, length = (numbers(geometry[0].findtext(name), 1, 1.0)[0] * 100 for name in ("radius", "length"))
            turn = rotator_from_quat(Rotation.from_matrix(matrix[:3, :3]).as_quat().tolist())
            return [CapsuleBody(center=_vector(matrix[:3, 3]), rotation_deg=turn, radius=radius, length=length)]
        if kind == "heightmap":
            return list(terrain_slabs(*heights(geometry[0], self._heightmap(geometry[0])), matrix))
        if kind != "mesh":
            return [hull(_moved(solid(geometry[0]), matrix, None, 1.0).vertices)]
        found, factors, _ = self._mesh(geometry[0])
        parts = [_moved(part, matrix @ np.diag([*factors, 1.0]), None, 1.0) for part in found]
        return made_bodies(parts, "auto")[0]

    def road(self, element: Element, notes: list[str]) -> tuple[Matrix, SourcePart, list[CollisionBody]]:
        """Where a road of the world lies (metres, SDF's axes), and its surface and bodies about that place."""
        surface = self.materials.read(element, notes)[0] if element.find("material") is not None else None
        middle, part, slabs = road(element, surface or Surface("road", color_of([linear(0.25)] * 3), roughness=1.0))
        return middle, part, list(slabs)

    def _heightmap(self, element: Element) -> Path:
        uri = (element.findtext("uri") or element.findtext("filename") or "").strip()
        path = self.files.locate(uri)
        if path is None:
            raise BadInput(f"heightmap {uri!r} is missing")
        return path

    def _terrain(self, element: Element, surface: Surface | None, notes: list[str]) -> SourcePart:
        """A heightmap under the texture that most of it shows: blended ones are told apart by height."""
        levels, size, offset = heights(element, self._heightmap(element))
        textures, blends = element.findall("texture"), element.findall("blend")
        usual = float(np.median(levels))
        above = sum(numbers(blend.findtext("min_height"), 1)[0] <= usual for blend in blends)
        texture = textures[min(above, len(textures) - 1)] if textures else None
        repeat_m = 0.0
        if texture is not None:
            surface = self.materials.texture((texture.findtext("diffuse") or "").strip(), notes) or surface
            repeat_m = max(0.0, numbers(texture.findtext("size"), 1, 10.0)[0])
            if len(textures) > 1:
                notes.append(f"of {len(textures)} textures that a heightmap blends it shows one")
        return terrain(levels, size, offset, surface or Surface("earth", EARTH, roughness=1.0), repeat_m)

    def _mesh(self, element: Element) -> tuple[list[SourcePart], list[float], list[str]]:
        """Parts of a mesh element (of its submesh, if it names one), its scale factors, and notes."""
        uri = (element.findtext("uri") or element.findtext("filename") or "").strip()
        name, _, chosen = self.replace.get(uri, uri).partition("#") if uri in self.replace else (uri, "", "")
        path = self.files.locate(name)
        if path is None:
            raise BadInput(f"mesh {name!r} is missing")
        if path not in self.meshes:
            up: Up | None = None if path.suffix.lower() in GLTF else "z"
            self.meshes[path] = read_source(path, self.files.folder_of(path), up=up)
        source = self.meshes[path]
        said = [f"mesh {uri!r} is replaced by {self.replace[uri]!r}"] if uri in self.replace else []
        notes = [*source.notes, *said]
        wanted = [part.strip() for part in chosen.split(",") if part.strip()]
        sub = element.find("submesh")
        if sub is not None:
            wanted = [(sub.findtext("name") or "").strip()]
        parts = _chosen(path, source.parts, wanted) if wanted else source.parts
        if not parts:
            there = ", ".join(sorted({part.node for part in source.parts})[:12])
            raise BadInput(f"mesh {name!r} has no part {wanted[0]!r} (it has {there})")
        if sub is not None and (sub.findtext("center") or "").strip().lower() in ("true", "1"):
            points = np.concatenate([part.vertices for part in parts])
            middle = (points.min(axis=0) + points.max(axis=0)) / 2
            parts = [dataclass_replace(part, vertices=part.vertices - middle) for part in parts]
        factors = numbers(element.findtext("scale"), 3, 1.0)
        if min(map(abs, factors)) < 1e-9:
            raise BadInput(f"mesh {name!r} is scaled to nothing")
        return parts, factors, notes


def _chosen(path: Path, parts: list[SourcePart], wanted: list[str]) -> list[SourcePart]:
    """The parts that are called by one of these names: their nodes or geometries, else their materials."""
    low = {name.lower() for name in wanted}
    named = [part for part, names in zip(parts, part_names(path, parts), strict=True) if names & low]
    return named or [part for part in parts if part.surface.name.lower() in low]


def _vector(values: Matrix) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 3) for value in values)
    return x, y, z


def _moved(part: SourcePart, matrix: Matrix, surface: Surface | None, repeat: float) -> SourcePart:
    normals = part.normals @ np.linalg.inv(matrix[:3, :3])
    length = np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return SourcePart(
        part.node,
        surface or part.surface,
        part.vertices @ matrix[:3, :3].T + matrix[:3, 3],
        part.faces[:, ::-1] if np.linalg.det(matrix[:3, :3]) < 0 else part.faces,
        normals / length,
        part.uvs * repeat,
        part.colors if surface is None else None,
    )
