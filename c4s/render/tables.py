"""A scene's meshes, materials and instances as flat arrays that the kernels read.

Opaque and translucent faces of an instance are two *pieces* (a mesh with some of its slots), because shadow rays must
see the first and not the second; faces whose texture cuts holes are pieces of their own, as Embree asks for each hit.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.packs.meshes import Mesh
from c4s.render import layout
from c4s.render.textures import TexturePicture, Textures, build_textures
from c4s.render.types import Instance, SurfaceMaterial

BASE, EMISSIVE, ROUGHNESS, METALLIC, OPACITY, BLENDS, SURFACE_COLUMNS = 0, 3, 6, 7, 8, 9, 10
"""Columns of ``SceneTables.surfaces``; ``BLENDS`` is 1 where the texture's alpha scales the opacity."""
COLOR_MAP, NORMAL_MAP, ROUGHNESS_METAL_MAP, EMISSIVE_MAP, MAPS = 0, 1, 2, 3, 4
"""Columns of ``SceneTables.surface_maps``."""
_Piece: TypeAlias = tuple[int, tuple[int, ...], int]
"""Mesh, slots, and row of the material that cuts holes (-1: none)."""
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
    linear: NDArray[np.float32]
    """(instances, 3, 3) that turns local directions into world ones."""
    texel_rate: NDArray[np.float32]
    """By instance: texture repeats per cm of its surface, on average."""
    faces: NDArray[np.int32]
    """(faces, 3) rows of ``points``, ``normals``, ``uvs`` and ``colors``."""
    face_slot: NDArray[np.int32]
    points: NDArray[np.float32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32]
    colors: NDArray[np.float32]
    """Of no rows when no mesh has vertex colours."""
    materials: NDArray[np.int32]
    """Row of ``surfaces`` of each instance's slot."""
    surfaces: NDArray[np.float32]
    """(materials, SURFACE_COLUMNS)."""
    surface_maps: NDArray[np.int32]
    """(materials, MAPS) textures, -1 for none."""


class Geometry(NamedTuple):
    """What Embree needs."""

    vertices: list[NDArray[np.float32]]
    faces: list[NDArray[np.int32]]
    piece_of: NDArray[np.int32]
    matrices: NDArray[np.float32]
    masks: NDArray[np.int32]
    holes: list[Holes | None]
    """By piece: what cuts holes into it."""


class Holes(NamedTuple):
    """A texture whose alpha cuts holes into all faces of a piece."""

    uvs: NDArray[np.float32]
    """(vertices, 2) of the piece's mesh."""
    alpha: NDArray[np.uint8]
    """(H, W)."""
    cutoff: int
    """Alpha byte below which there is a hole."""


class _Materials:
    """Distinct materials and textures, in order of appearance."""

    def __init__(self) -> None:
        self._rows: dict[int, int] = {}
        self._texture_rows: dict[tuple[int, bool], int] = {}
        self.items: list[SurfaceMaterial] = []
        self.textures: list[TexturePicture] = []
        self.maps: list[list[int]] = []

    def row(self, material: SurfaceMaterial) -> int:
        """Row of a material, added at its first appearance."""
        found = self._rows.get(id(material))
        if found is None:
            found = self._rows[id(material)] = len(self.items)
            self.items.append(material)
            self.maps.append(
                [
                    self._texture(material.texture, True),
                    self._texture(material.normal_texture, False),
                    self._texture(material.roughness_metal_texture, False),
                    self._texture(material.emissive_texture, True),
                ]
            )
        return found

    def _texture(self, texture: NDArray[np.uint8] | None, colors: bool) -> int:
        if texture is None:
            return -1
        key = (id(texture), colors)
        if key not in self._texture_rows:
            self._texture_rows[key] = len(self.textures)
            self.textures.append(TexturePicture(texture, colors))
        return self._texture_rows[key]

    def surfaces(self) -> NDArray[np.float32]:
        """The numbers of all materials, with values that no surface can have brought into range."""
        rows = np.zeros((len(self.items), SURFACE_COLUMNS), dtype=np.float32)
        for row, item in zip(rows, self.items, strict=True):
            row[BASE : BASE + 3], row[EMISSIVE : EMISSIVE + 3] = item.base_color, item.emissive
            row[ROUGHNESS], row[METALLIC], row[OPACITY] = item.roughness, item.metallic, item.opacity
            row[BLENDS] = blends(item)
        if not np.isfinite(rows).all():
            raise BadInput("a material has a value that is not finite", where="renderer")
        rows = np.maximum(rows, np.float32(0))
        rows[:, ROUGHNESS:] = np.minimum(rows[:, ROUGHNESS:], np.float32(1))
        return rows


def _has_alpha(material: SurfaceMaterial) -> bool:
    return material.texture is not None and material.texture.ndim == 3 and material.texture.shape[2] == 4


def blends(material: SurfaceMaterial) -> bool:
    """Whether the alpha of its texture scales the opacity."""
    return material.alpha == "blend" and _has_alpha(material)


def cuts(material: SurfaceMaterial) -> bool:
    """Whether the alpha of its texture cuts holes."""
    return material.alpha == "mask" and _has_alpha(material)


def _checked(meshes: Sequence[Mesh]) -> None:
    for number, mesh in enumerate(meshes):
        count, faces = len(mesh.vertices), mesh.faces
        if not count or not len(faces):
            raise BadInput(f"mesh {number} has no triangles", where="renderer")
        if faces.min() < 0 or faces.max() >= count:
            raise BadInput(f"mesh {number} has a face beyond its {count} vertices", where="renderer")
        if len(mesh.normals) != count or len(mesh.uvs) != count or len(mesh.face_slots) != len(faces):
            raise BadInput(f"mesh {number} has normals, uvs or slots of another length", where="renderer")
        if mesh.colors is not None and len(mesh.colors) != count:
            raise BadInput(f"mesh {number} has vertex colours of another length", where="renderer")
        if not all(np.isfinite(part).all() for part in (mesh.vertices, mesh.normals, mesh.uvs)):
            raise BadInput(f"mesh {number} has a vertex, normal or uv that is not finite", where="renderer")


def _texture_density(mesh: Mesh) -> float:
    """Texture repeats per local cm: square root of texture area over surface area."""
    corner = mesh.vertices[mesh.faces].astype(np.float64)
    area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1).sum()
    uv = mesh.uvs[mesh.faces].astype(np.float64)
    a, b = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    return float(np.sqrt(np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / max(area, 1e-9)))


def _holes(mesh: Mesh, material: SurfaceMaterial) -> Holes:
    assert material.texture is not None
    cutoff = min(max(material.alpha_cutoff, 0.0), 1.0)
    return Holes(
        np.ascontiguousarray(mesh.uvs, dtype=np.float32),
        np.ascontiguousarray(material.texture[..., 3]),
        int(np.ceil(cutoff * 255)),
    )


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


def build_tables(
    meshes: Sequence[Mesh], instances: Sequence[Instance]
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
    pieces: dict[_Piece, int] = {}
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
        for part, mask, cutter in _parts(given, count):
            key = (instance.mesh, part, -1 if cutter is None else materials.row(cutter))
            rows.append((pieces.setdefault(key, len(pieces)), first, number, mask))
    return _assemble(meshes, instances, world, origin, pieces, rows, materials, material_rows)


def _parts(given: tuple[SurfaceMaterial, ...], count: int) -> list[tuple[tuple[int, ...], int, SurfaceMaterial | None]]:
    """Slots of an instance that lie in one piece, its ray mask, and the material that cuts holes into it."""
    clear = tuple(slot for slot, material in enumerate(given) if material.opacity < 1 or blends(material))
    holed = tuple(slot for slot, material in enumerate(given) if cuts(material) and slot not in clear)
    solid = tuple(slot for slot in range(count) if slot not in clear and slot not in holed)
    found: list[tuple[tuple[int, ...], int, SurfaceMaterial | None]] = []
    if solid:
        found.append((solid, layout.OPAQUE_MASK, None))
    found += [((slot,), layout.OPAQUE_MASK, given[slot]) for slot in holed]
    if clear:
        found.append((clear, layout.TRANSLUCENT_MASK, None))
    return found


def _assemble(
    meshes: Sequence[Mesh],
    instances: Sequence[Instance],
    world: NDArray[np.float64],
    origin: NDArray[np.float64],
    pieces: dict[_Piece, int],
    rows: list[tuple[int, int, int, int]],
    materials: _Materials,
    material_rows: list[int],
) -> tuple[SceneTables, Geometry, Textures, NDArray[np.float64]]:
    first_vertex = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    piece_faces: list[NDArray[np.int32]] = []
    shading_faces = [np.zeros((0, 3), dtype=np.int64)]
    face_slots = [np.zeros(0, dtype=np.int32)]
    starts = np.zeros(len(pieces) + 1, dtype=np.int64)
    holes: list[Holes | None] = []
    for (mesh_number, part, cutter), piece in pieces.items():
        mesh = meshes[mesh_number]
        holes.append(None if cutter < 0 else _holes(mesh, materials.items[cutter]))
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

    colored = any(mesh.colors is not None for mesh in meshes)

    def stacked(parts: list[NDArray[np.float32]], width: int) -> NDArray[np.float32]:
        joined = np.concatenate(parts) if parts else np.zeros((1, width))
        return np.ascontiguousarray(joined, dtype=np.float32)

    scene = SceneTables(
        actor=np.array([instances[number].actor for number in source], dtype=np.int32),
        first_face=np.ascontiguousarray(starts[piece_of]),
        first_material=np.ascontiguousarray(first_material),
        normal_matrix=np.ascontiguousarray(normal_matrix, dtype=np.float32),
        linear=np.ascontiguousarray(linear, dtype=np.float32),
        texel_rate=np.ascontiguousarray(density[mesh_of] / np.maximum(scale, 1e-9), dtype=np.float32),
        faces=np.ascontiguousarray(np.concatenate(shading_faces), dtype=np.int32),
        face_slot=np.concatenate(face_slots),
        points=stacked([mesh.vertices for mesh in meshes], 3),
        normals=stacked([mesh.normals for mesh in meshes], 3),
        uvs=stacked([mesh.uvs for mesh in meshes], 2),
        colors=stacked([np.ones_like(mesh.vertices) if mesh.colors is None else mesh.colors for mesh in meshes], 3)
        if colored
        else np.zeros((0, 3), dtype=np.float32),
        materials=np.array(material_rows, dtype=np.int32),
        surfaces=materials.surfaces(),
        surface_maps=np.array(materials.maps, dtype=np.int32),
    )
    order = [key[0] for key in pieces]
    geometry = Geometry(
        [np.asarray(meshes[number].vertices, dtype=np.float32) for number in order],
        piece_faces,
        piece_of.astype(np.int32),
        np.ascontiguousarray(local, dtype=np.float32),
        mask.astype(np.int32),
        holes,
    )
    return scene, geometry, build_textures(materials.textures), origin
