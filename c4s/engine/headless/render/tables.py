"""A scene's meshes, materials and instances as flat arrays that the kernels read.

Opaque and translucent faces of an instance are two *pieces* (a mesh with some of its slots), because shadow rays must
see the first and not the second.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from c4s.engine.headless.render import layout
from c4s.engine.headless.render.textures import Textures, build_textures
from c4s.engine.headless.render.types import Instance, SurfaceMaterial
from c4s.errors import BadInput
from c4s.packs.meshes import Mesh

BASE, EMISSIVE, ROUGHNESS, METALLIC, OPACITY, SURFACE_COLUMNS = 0, 3, 6, 7, 8, 9
_UNASSIGNED = SurfaceMaterial(base_color=(0.35, 0.35, 0.35))


class SceneTables(NamedTuple):
    """What the kernels need to know of a hit, by instance and face number."""

    actor: NDArray[np.int32]
    first_face: NDArray[np.int64]
    """By instance: first row of its piece in ``faces``."""
    first_material: NDArray[np.int64]
    """By instance: first row of its slots in ``materials``."""
    normal_matrix: NDArray[np.float32]
    """(instances, 3, 3) that turns local normals into world ones, up to length and sign."""
    texel_rate: NDArray[np.float32]
    """By instance: texture repeats per cm of its surface, on average."""
    faces: NDArray[np.int32]
    """(faces, 3) rows of ``normals`` and ``uvs``."""
    face_slot: NDArray[np.int32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32]
    materials: NDArray[np.int32]
    """Row of ``surfaces`` of each instance's slot."""
    surfaces: NDArray[np.float32]
    """(materials, SURFACE_COLUMNS)."""
    surface_texture: NDArray[np.int32]
    """-1 for none."""


class Geometry(NamedTuple):
    """What Embree needs."""

    vertices: list[NDArray[np.float32]]
    faces: list[NDArray[np.int32]]
    piece_of: NDArray[np.int32]
    matrices: NDArray[np.float32]
    masks: NDArray[np.int32]


class _Materials:
    """Distinct materials and textures, in order of appearance."""

    def __init__(self) -> None:
        self._rows: dict[int, int] = {}
        self._texture_rows: dict[int, int] = {}
        self.items: list[SurfaceMaterial] = []
        self.textures: list[NDArray[np.uint8]] = []
        self.texture_of: list[int] = []

    def row(self, material: SurfaceMaterial) -> int:
        """Row of a material, added at its first appearance."""
        found = self._rows.get(id(material))
        if found is None:
            found = self._rows[id(material)] = len(self.items)
            self.items.append(material)
            self.texture_of.append(self._texture(material.texture))
        return found

    def _texture(self, texture: NDArray[np.uint8] | None) -> int:
        if texture is None:
            return -1
        if id(texture) not in self._texture_rows:
            self._texture_rows[id(texture)] = len(self.textures)
            self.textures.append(texture)
        return self._texture_rows[id(texture)]

    def surfaces(self) -> NDArray[np.float32]:
        """The numbers of all materials, with values that no surface can have brought into range."""
        rows = np.zeros((len(self.items), SURFACE_COLUMNS), dtype=np.float32)
        for row, item in zip(rows, self.items, strict=True):
            row[BASE:BASE + 3], row[EMISSIVE:EMISSIVE + 3] = item.base_color, item.emissive
            row[ROUGHNESS], row[METALLIC], row[OPACITY] = item.roughness, item.metallic, item.opacity
        if not np.isfinite(rows).all():
            raise BadInput("a material has a value that is not finite", where="renderer")
        rows = np.maximum(rows, np.float32(0))
        rows[:, ROUGHNESS:] = np.minimum(rows[:, ROUGHNESS:], np.float32(1))
        return rows


def _checked(meshes: Sequence[Mesh]) -> None:
    for number, mesh in enumerate(meshes):
        count, faces = len(mesh.vertices), mesh.faces
        if not count or not len(faces):
            raise BadInput(f"mesh {number} has no triangles", where="renderer")
        if faces.min() < 0 or faces.max() >= count:
            raise BadInput(f"mesh {number} has a face beyond its {count} vertices", where="renderer")
        if len(mesh.normals) != count or len(mesh.uvs) != count or len(mesh.face_slots) != len(faces):
            raise BadInput(f"mesh {number} has normals, uvs or slots of another length", where="renderer")
        if not all(np.isfinite(part).all() for part in (mesh.vertices, mesh.normals, mesh.uvs)):
            raise BadInput(f"mesh {number} has a vertex, normal or uv that is not finite", where="renderer")


def _texture_density(mesh: Mesh) -> float:
    """Texture repeats per local cm: square root of texture area over surface area."""
    corner = mesh.vertices[mesh.faces].astype(np.float64)
    area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1).sum()
    uv = mesh.uvs[mesh.faces].astype(np.float64)
    a, b = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    return float(np.sqrt(np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / max(area, 1e-9)))


def _cofactors(linear: NDArray[np.float64]) -> NDArray[np.float64]:
    """Matrices that turn normals: the inverse transpose times the determinant, defined for flat scales too."""
    x, y, z = linear[:, :, 0], linear[:, :, 1], linear[:, :, 2]
    return np.stack([np.cross(y, z), np.cross(z, x), np.cross(x, y)], axis=2)


def _matrices(instances: Sequence[Instance]) -> NDArray[np.float64]:
    if not instances:
        return np.zeros((0, 4, 4))
    stack = np.array([instance.matrix for instance in instances], dtype=np.float64)
    if stack.shape[1:] != (4, 4) or not np.isfinite(stack).all():
        raise BadInput("an instance's matrix is not 4x4 and finite", where="renderer")
    return stack


def build_tables(meshes: Sequence[Mesh], instances: Sequence[Instance]
                 ) -> tuple[SceneTables, Geometry, Textures, NDArray[np.float64]]:
    """Tables of a scene, Embree's input, the textures, and the world point (cm) that Embree's origin stands for.

    Instances with a determinant of zero are left out, as nothing of them can be hit reliably.

    Raises:
        BadInput: a mesh without triangles, an index out of range, or a number that is not finite.
    """
    _checked(meshes)
    world = _matrices(instances)
    origin = np.round(np.median(world[:, :3, 3], axis=0)) if len(world) else np.zeros(3)
    slots = [int(mesh.face_slots.max()) + 1 for mesh in meshes]
    materials = _Materials()
    unassigned = materials.row(_UNASSIGNED)
    pieces: dict[tuple[int, tuple[int, ...]], int] = {}
    rows: list[tuple[int, int, int, int]] = []
    material_rows: list[int] = []
    volumes = np.abs(np.linalg.det(world[:, :3, :3]))
    for number, instance in enumerate(instances):
        if not 0 <= instance.mesh < len(meshes) or instance.actor < 0:
            raise BadInput(f"instance {number} names mesh {instance.mesh}, actor {instance.actor}", where="renderer")
        if volumes[number] < 1e-12:
            continue
        first, count = len(material_rows), slots[instance.mesh]
        given = instance.materials[:count]
        material_rows += [materials.row(material) for material in given]
        material_rows += [unassigned] * (count - len(given))
        clear = tuple(slot for slot, material in enumerate(given) if material.opacity < 1)
        solid = tuple(slot for slot in range(count) if slot not in clear)
        for part, mask in ((solid, layout.OPAQUE_MASK), (clear, layout.TRANSLUCENT_MASK)):
            if part:
                rows.append((pieces.setdefault((instance.mesh, part), len(pieces)), first, number, mask))
    return _assemble(meshes, instances, world, origin, pieces, rows, materials, material_rows)


def _assemble(meshes: Sequence[Mesh], instances: Sequence[Instance], world: NDArray[np.float64],
              origin: NDArray[np.float64], pieces: dict[tuple[int, tuple[int, ...]], int],
              rows: list[tuple[int, int, int, int]], materials: _Materials, material_rows: list[int]
              ) -> tuple[SceneTables, Geometry, Textures, NDArray[np.float64]]:
    first_vertex = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    piece_faces: list[NDArray[np.int32]] = []
    shading_faces = [np.zeros((0, 3), dtype=np.int64)]
    face_slots = [np.zeros(0, dtype=np.int32)]
    starts = np.zeros(len(pieces) + 1, dtype=np.int64)
    for (mesh_number, part), piece in pieces.items():
        mesh = meshes[mesh_number]
        chosen = np.isin(mesh.face_slots, part)
        piece_faces.append(mesh.faces[chosen].astype(np.int32))
        shading_faces.append(piece_faces[-1].astype(np.int64) + first_vertex[mesh_number])
        face_slots.append(mesh.face_slots[chosen].astype(np.int32))
        starts[piece + 1] = starts[piece] + len(piece_faces[-1])
    table = np.array(rows, dtype=np.int64).reshape(-1, 4)
    piece_of, first_material, source, mask = table.T
    linear = world[source][:, :3, :3]
    local = world[source][:, :3, :].copy()
    local[:, :, 3] -= origin
    density = np.array([_texture_density(mesh) for mesh in meshes] or [0.0])
    mesh_of = np.array([instance.mesh for instance in instances], dtype=np.int64)[source] if len(table) else source
    normal_matrix = _cofactors(linear)
    scale = np.sqrt(np.linalg.norm(normal_matrix, axis=(1, 2)) / np.sqrt(3))
    normal_matrix /= np.maximum(np.abs(normal_matrix).max(axis=(1, 2), keepdims=True), 1e-30)

    def stacked(parts: list[NDArray[np.float32]], width: int) -> NDArray[np.float32]:
        joined = np.concatenate(parts) if parts else np.zeros((1, width))
        return np.ascontiguousarray(joined, dtype=np.float32)

    scene = SceneTables(
        actor=np.array([instances[number].actor for number in source], dtype=np.int32),
        first_face=np.ascontiguousarray(starts[piece_of]),
        first_material=np.ascontiguousarray(first_material),
        normal_matrix=np.ascontiguousarray(normal_matrix, dtype=np.float32),
        texel_rate=np.ascontiguousarray(density[mesh_of] / np.maximum(scale, 1e-9), dtype=np.float32),
        faces=np.ascontiguousarray(np.concatenate(shading_faces), dtype=np.int32),
        face_slot=np.concatenate(face_slots),
        normals=stacked([mesh.normals for mesh in meshes], 3),
        uvs=stacked([mesh.uvs for mesh in meshes], 2),
        materials=np.array(material_rows, dtype=np.int32),
        surfaces=materials.surfaces(),
        surface_texture=np.array(materials.texture_of, dtype=np.int32))
    order = [key[0] for key in pieces]
    geometry = Geometry([np.asarray(meshes[number].vertices, dtype=np.float32) for number in order], piece_faces,
                        piece_of.astype(np.int32), np.ascontiguousarray(local, dtype=np.float32),
                        mask.astype(np.int32))
    return scene, geometry, build_textures(materials.textures), origin
