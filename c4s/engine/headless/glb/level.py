"""The open level as one GLB: metres, Y up, right-handed; every mesh once, nodes as ``nodes.py`` says, named by labels.

A mesh has a primitive a material slot. Triangles, whose winding means nothing here, are turned to face where their
normals point. Mirrored scales stay at the nodes, where viewers expect them. Lights and cameras come along
(``lights.py``). Texture coordinates are written as they are: what transforms a pack's textures had is in them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import trimesh
from PIL import Image
from trimesh.visual.material import PBRMaterial

from c4s.engine.headless.glb.lights import LightsAndCameras
from c4s.engine.headless.glb.nodes import Leaf, NodeTree
from c4s.engine.headless.unreal.components import StaticMeshComponent
from c4s.engine.headless.world.world import Drawable, World
from c4s.errors import BadInput
from c4s.files import write_bytes
from c4s.packs.meshes import Mesh
from c4s.packs.pictures import open_picture
from c4s.records.pack import Material

_METRE_CM = 100.0
_SWAP = [0, 2, 1]
_MIN_VOLUME = 1e-9
_VERTICES, _INDICES = 34962, 34963


def write_glb(world: World, path: Path) -> dict[str, Any]:
    """Write the open level of ``world`` to ``path``; returns what it holds by count, and lights that it cannot hold.

    Raises:
        BadInput: the level shows no mesh, or a mesh file is broken.
    """
    scene = _Scene(world)
    shown = [d for d in world.drawables() if abs(np.linalg.det(d.matrix[:3, :3])) >= _MIN_VOLUME]
    for drawable in shown:
        scene.add(drawable)
    if not shown:
        raise BadInput("the level shows no mesh", where=world.package, todo="give the packs that it uses")
    write_bytes(path, scene.bytes())
    return {
        "actors": len({d.actor_index for d in shown}),
        "nodes": len(scene.nodes),
        "meshes": len(scene.meshes),
        "triangles": scene.triangles,
        "lights": len(scene.extras.lights),
        "light_factor": scene.extras.factor,
        "cameras": len(scene.extras.cameras),
        "left_out": scene.extras.left_out,
    }


@dataclass(frozen=True)
class GlbPictures:
    """Texture files of a material, and what the alpha of the base colour does."""

    base: Path | None = None
    normal: Path | None = None
    roughness_metal: Path | None = None
    emissive: Path | None = None
    alpha: Literal["opaque", "mask", "blend"] = "opaque"
    alpha_cutoff: float = 0.5


class _Scene:
    """Collects nodes and meshes; one geometry for each mesh, slot and material."""

    def __init__(self, world: World) -> None:
        self._world, self._store = world, world.store
        self._scene = trimesh.Scene()
        self._tree = NodeTree()
        self.nodes: list[dict[str, Any]] = []
        self.meshes: dict[tuple[str, ...], int] = {}
        """Numbers of the written meshes by their geometries."""
        self.geometries: dict[tuple[str, int, str], str] = {}
        self._materials: dict[tuple[Material, GlbPictures], tuple[str, PBRMaterial]] = {}
        self._opened: dict[tuple[Path, bool], Image.Image] = {}
        self._exact: dict[str, tuple[str, Material, GlbPictures]] = {}
        self.triangles = 0
        self.extras = LightsAndCameras(world, self._tree)

    def add(self, part: Drawable) -> None:
        """A mesh that an actor shows."""
        mesh = self.meshes.setdefault(tuple(self._geometries(part)), len(self.meshes))
        self._tree.add(part.actor, Leaf(part.component.get_name(), part.pose, {"mesh": mesh}))

    def _geometries(self, part: Drawable) -> Iterator[str]:
        mesh = self._store.mesh(part.mesh)
        for slot in np.unique(mesh.face_slots):
            surface = part.materials[slot] if slot < len(part.materials) else Material(path="/Engine/Default.Default")
            material_key, material = self._material(surface, self._pictures(part.component, int(slot)))
            key = (part.mesh, int(slot), material_key)
            if key not in self.geometries:
                self.geometries[key] = f"mesh_{len(self.geometries)}"
                self._scene.add_geometry(_geometry(mesh, int(slot), material), geom_name=self.geometries[key])
            self.triangles += int(np.count_nonzero(mesh.face_slots == slot))
            yield self.geometries[key]

    def _pictures(self, component: StaticMeshComponent, slot: int) -> GlbPictures:
        """Texture files of the pack material that a slot shows, or of the one that it was made of."""
        material = component.get_material(slot) if slot < component.get_num_materials() else None
        packed = self._store.material(material._origin_path()) if material is not None else None
        if packed is None:
            return GlbPictures()
        base, normal, roughness_metal, emissive = (
            self._store.pack_file(packed, name)
            for name in (packed.texture, packed.normal_texture, packed.roughness_metal_texture, packed.emissive_texture)
        )
        return GlbPictures(base, normal, roughness_metal, emissive, packed.alpha, packed.alpha_cutoff)

    def _material(self, surface: Material, pictures: GlbPictures) -> tuple[str, PBRMaterial]:
        known = (surface, pictures)
        if known not in self._materials:
            key = f"material_{len(self._materials)}"
            self._exact[key] = (surface.path.rsplit(".", 1)[-1] or "Default", surface, pictures)
            self._materials[known] = (
                key,
                PBRMaterial(  # type: ignore[no-untyped-call]
                    name=key,
                    baseColorTexture=self._picture(pictures.base, pictures.alpha != "opaque"),
                    normalTexture=self._picture(pictures.normal),
                    emissiveTexture=self._picture(pictures.emissive),
                    metallicRoughnessTexture=self._picture(pictures.roughness_metal),
                    doubleSided=True,
                ),
            )
        return self._materials[known]

    def _picture(self, file: Path | None, alpha: bool = False) -> Image.Image | None:
        """A picture, opened once, so that it is stored once."""
        if file is None:
            return None
        if (file, alpha) not in self._opened:
            self._opened[file, alpha] = open_picture(file, where=str(file)).convert("RGBA" if alpha else "RGB")
        return self._opened[file, alpha]

    def bytes(self) -> bytes:
        """The finished file."""
        made: bytes = self._scene.export(file_type="glb", tree_postprocessor=self._finish)  # type: ignore[no-untyped-call]
        return made

    def _finish(self, tree: dict[str, Any]) -> None:
        """Our own nodes and meshes, and the exact factors of the materials (trimesh keeps colours in bytes)."""
        made = {mesh["name"]: mesh["primitives"] for mesh in tree["meshes"]}
        paths = {name: key[0] for key, name in self.geometries.items()}
        tree["meshes"] = [
            {
                "name": paths[names[0]].rsplit(".", 1)[-1],
                "primitives": [primitive for name in names for primitive in made[name]],
            }
            for names in self.meshes
        ]
        self.nodes, tops = self._tree.write(self._world.actor_list())
        tree["nodes"], tree["scene"], tree["scenes"] = self.nodes, 0, [{"nodes": tops}]
        _tell_targets(tree)
        self.extras.add_to(tree)
        strong = False
        for material in tree["materials"]:
            name, surface, pictures = self._exact[material["name"]]
            material["name"] = name
            material.setdefault("pbrMetallicRoughness", {}).update(
                baseColorFactor=[*surface.base_color, surface.opacity],
                roughnessFactor=surface.roughness,
                metallicFactor=surface.metallic,
            )
            material["alphaMode"] = "BLEND" if surface.opacity < 1 else pictures.alpha.upper()
            if material["alphaMode"] == "MASK":
                material["alphaCutoff"] = pictures.alpha_cutoff
            strength = max(1.0, *surface.emissive)
            material["emissiveFactor"] = [value / strength for value in surface.emissive]
            if strength > 1:
                material["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": strength}}
                strong = True
        if strong:
            tree["extensionsUsed"] = [*tree.get("extensionsUsed", []), "KHR_materials_emissive_strength"]


def _tell_targets(tree: dict[str, Any]) -> None:
    """Say of each buffer view whether it holds vertices or indices, as validators ask for."""
    for mesh in tree["meshes"]:
        for primitive in mesh["primitives"]:
            for accessor, target in [(index, _VERTICES) for index in primitive["attributes"].values()] + [
                (primitive["indices"], _INDICES)
            ]:
                tree["bufferViews"][tree["accessors"][accessor]["bufferView"]]["target"] = target


def _geometry(mesh: Mesh, slot: int, material: PBRMaterial) -> trimesh.Trimesh:
    """The triangles of one slot in glTF's axes and metres, with the vertices that they use, facing where normals do."""
    used, faces = np.unique(mesh.faces[mesh.face_slots == slot], return_inverse=True)
    faces = faces.reshape(-1, 3)
    points, normals = mesh.vertices[used][:, _SWAP] / _METRE_CM, mesh.normals[used][:, _SWAP]
    corners = points[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inwards = np.einsum("ij,ij->i", across, normals[faces].sum(axis=1)) < 0
    faces[inwards] = faces[inwards][:, ::-1]
    textured = any(
        picture is not None
        for picture in (
            material.baseColorTexture,
            material.normalTexture,
            material.metallicRoughnessTexture,
            material.emissiveTexture,
        )
    )
    visual = trimesh.visual.TextureVisuals(  # type: ignore[no-untyped-call]
        uv=mesh.uvs[used] * [1, -1] + [0, 1] if textured else None, material=material
    )
    if mesh.colors is not None:
        shown = np.column_stack((mesh.colors[used], np.ones(len(used))))
        visual.vertex_attributes["color"] = np.round(255 * shown).astype(np.uint8)
    return trimesh.Trimesh(points, faces, vertex_normals=normals, visual=visual, process=False)
