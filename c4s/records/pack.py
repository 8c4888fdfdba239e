"""The pack manifest: a folder of meshes with what the engine, the catalog and the verifiers need to know of them.

A pack is a folder with ``pack.json`` (this model) and the files that it names. Local coordinates of an asset are
Unreal's: centimetres, left-handed, Z up, origin at the pivot. Meshes on disk are glTF/GLB (metres, Y up, right-handed),
OBJ or DAE; ``c4s.packs.meshes`` converts them.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from c4s.names import InnerPath, Name, PackagePath
from c4s.records.base import Record
from c4s.records.level import Number, Transform, Vector


class BoxBody(Record):
    """A box: centre (cm), rotation ([pitch, yaw, roll] degrees), half extents (cm)."""

    kind: Literal["box"] = "box"
    center: Vector
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    half_extent: Vector


class SphereBody(Record):
    """A sphere: centre and radius in cm."""

    kind: Literal["sphere"] = "sphere"
    center: Vector
    radius: float


class CapsuleBody(Record):
    """A capsule along its local Z: centre, rotation, radius, and the length of the cylinder part (cm)."""

    kind: Literal["capsule"] = "capsule"
    center: Vector
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    radius: float
    length: float


class HullBody(Record):
    """A convex hull given by its vertices (cm)."""

    kind: Literal["hull"] = "hull"
    vertices: list[Vector]


MANIFEST, STAMP = "pack.json", "build.json"
"""The two files of a pack that its manifest does not list: itself, and what its builder notes about the build."""
CollisionBody = Annotated[BoxBody | SphereBody | CapsuleBody | HullBody, Field(discriminator="kind")]


AIUse = Literal["allowed", "forbidden", "unknown"]
"""Whether content may be used with systems that learn (paper, benchmark suite: packs marked as allowed for AI use)."""


class Material(Record):
    """A material asset. Colours are linear RGB in [0, 1]."""

    path: PackagePath
    """``/Game/<Pack>/Materials/M_X.M_X``."""
    class_path: str = "/Script/Engine.Material"
    base_color: tuple[Number, Number, Number] = (0.5, 0.5, 0.5)
    roughness: Number = 0.8
    metallic: Number = 0.0
    emissive: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)
    opacity: Number = 1.0
    texture: InnerPath | None = None
    """Base-colour texture, a file relative to the pack folder; it multiplies ``base_color``."""
    alpha: Literal["opaque", "mask", "blend"] = "opaque"
    """What the texture's alpha does: nothing; cuts holes where it is below ``alpha_cutoff``; or scales the opacity."""
    alpha_cutoff: float = 0.5
    normal_texture: InnerPath | None = None
    """Tangent-space normals as in glTF (green points to the picture's top), a file of the pack."""
    roughness_metal_texture: InnerPath | None = None
    """As in glTF: green multiplies ``roughness``, blue ``metallic``; a file of the pack."""
    emissive_texture: InnerPath | None = None
    """It multiplies ``emissive``; a file of the pack."""


class MaterialSlot(Record):
    """Slot of a mesh: its name and the path of its default material. Faces name their slot by index."""

    name: str
    material: str


class BlueprintPart(Record):
    """One component of a Blueprint asset, relative to the Blueprint's pivot."""

    name: str
    asset: str
    """Path of the static mesh."""
    relative: Transform = Transform()


class Asset(Record):
    """One asset of a pack: a static mesh, or a Blueprint composed of meshes of the same pack."""

    id: Name
    """Catalog id, unique in the pack: lower-case, ``_`` between words."""
    name: str
    """Readable name."""
    kind: Literal["static_mesh", "blueprint"] = "static_mesh"
    path: PackagePath
    """``/Game/<Pack>/.../SM_X.SM_X``; a Blueprint's class is this path with ``_C`` behind it."""
    category: str
    description: str = ""
    tags: list[str] = Field(default_factory=list)
    bounds_min_cm: Vector
    bounds_max_cm: Vector
    """Local AABB of the mesh (a Blueprint: of all parts)."""
    mesh: InnerPath | None = None
    """Mesh file relative to the pack folder (static meshes only)."""
    mesh_sha256: str | None = None
    mesh_scale: float = 1.0
    """Factor from the file's units (glTF: metres) to metres."""
    slots: list[MaterialSlot] = Field(default_factory=list)
    collision: list[CollisionBody] = Field(default_factory=list)
    collision_source: Literal["authored", "hull", "decomposition", "none"] = "authored"
    parts: list[BlueprintPart] = Field(default_factory=list)
    preview: InnerPath | None = None
    """Preview picture relative to the pack folder."""

    @property
    def spawn_path(self) -> str:
        """Path to spawn by, as cases offer it: a mesh's object path, a Blueprint's generated class."""
        return f"{self.path}_C" if self.kind == "blueprint" else self.path

    @property
    def size_m(self) -> Vector:
        """Width (X), depth (Y) and height (Z) in metres."""
        low, high = self.bounds_min_cm, self.bounds_max_cm
        return ((high[0] - low[0]) / 100, (high[1] - low[1]) / 100, (high[2] - low[2]) / 100)


class Pack(Record):
    """A pack: its assets and materials."""

    schema_version: Literal["c4s.pack.v1"] = "c4s.pack.v1"
    pack_id: Name
    """Folder-safe id; the content folder is ``/Game/<content_folder>``."""
    content_folder: Name
    title: str
    license: str
    """SPDX id, several joined by ``AND``; ``unknown`` where none is told."""
    ai_use: AIUse = Field(default="unknown", exclude_if=lambda value: value == "unknown")
    """Whether its licence, or words of its authors, let the content be used by AI."""
    description: str = ""
    assets: list[Asset]
    materials: list[Material] = Field(default_factory=list)
    files: dict[InnerPath, str] = Field(default_factory=dict)
    """SHA-256 (64 hex) of every file of the pack by its relative name: meshes, textures, previews, licence text."""
    category_descriptions: dict[str, str] = Field(default_factory=dict)

    def named_files(self) -> set[str]:
        """The files that assets and materials name."""
        names = [name for asset in self.assets for name in (asset.mesh, asset.preview)]
        for material in self.materials:
            names += [
                material.texture,
                material.normal_texture,
                material.roughness_metal_texture,
                material.emissive_texture,
            ]
        return {name for name in names if name is not None}
