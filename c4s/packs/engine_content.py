"""Engine content that scripts name beside the basic shapes: made here after what each is for, with plain surfaces.

Shapes are the basic ones in other sizes; the sky sphere is a Blueprint without a body, as pictures draw their own sky.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from c4s.packs import basic_shapes
from c4s.packs.meshes import Mesh
from c4s.records.pack import Asset, BoxBody, CapsuleBody, CollisionBody, HullBody, Material, MaterialSlot, SphereBody

_MATERIALS = "/Engine/EngineMaterials"
MATERIALS = (
    Material(path=f"{_MATERIALS}/WorldGridMaterial.WorldGridMaterial", base_color=(0.18, 0.18, 0.18), roughness=0.8),
    Material(path=f"{_MATERIALS}/DefaultMaterial.DefaultMaterial", base_color=(0.18, 0.18, 0.18), roughness=0.8),
)
SIZES_CM: dict[str, tuple[str, float]] = {
    "/Engine/EditorMeshes/EditorCube": ("Cube", 256.0),
    "/Engine/EditorMeshes/EditorSphere": ("Sphere", 256.0),
    "/Engine/EditorMeshes/EditorCylinder": ("Cylinder", 256.0),
    "/Engine/EditorMeshes/EditorPlane": ("Plane", 256.0),
    "/Engine/EngineMeshes/Cube": ("Cube", 256.0),
    "/Engine/EngineMeshes/Sphere": ("Sphere", 320.0),
    "/Engine/EngineMeshes/Cylinder": ("Cylinder", 256.0),
    "/Engine/EngineMeshes/Cone": ("Cone", 256.0),
}
"""The basic shape that each mesh is, and how far across (cm)."""
SKY_SPHERE = "/Engine/EngineSky/BP_Sky_Sphere.BP_Sky_Sphere"


def _path(package: str) -> str:
    return f"{package}.{package.rsplit('/', 1)[-1]}"


def _scaled(body: CollisionBody, factor: float) -> CollisionBody:
    def times(row: tuple[float, float, float]) -> tuple[float, float, float]:
        return (row[0] * factor, row[1] * factor, row[2] * factor)

    if isinstance(body, BoxBody):
        return body.model_copy(update={"center": times(body.center), "half_extent": times(body.half_extent)})
    if isinstance(body, SphereBody):
        return body.model_copy(update={"center": times(body.center), "radius": body.radius * factor})
    if isinstance(body, CapsuleBody):
        raise TypeError("no basic shape has a capsule")
    assert isinstance(body, HullBody)
    return body.model_copy(update={"vertices": [times(vertex) for vertex in body.vertices]})


@cache
def meshes() -> dict[str, Mesh]:
    """Mesh of each shape by its path."""
    basic = basic_shapes.meshes()
    found = {}
    for package, (shape, across) in SIZES_CM.items():
        mesh = basic[f"{basic_shapes.FOLDER}/{shape}.{shape}"]
        vertices = (mesh.vertices * np.float32(across / 100)).astype(np.float32)
        found[_path(package)] = Mesh(vertices, mesh.faces, mesh.normals, mesh.uvs, mesh.face_slots)
    return found


@cache
def assets() -> dict[str, Asset]:
    """Asset of each shape, and the sky sphere, by its path."""
    basic = basic_shapes.assets()
    found = {}
    for package, (shape, across) in SIZES_CM.items():
        source, factor, name = basic[f"{basic_shapes.FOLDER}/{shape}.{shape}"], across / 100, package.rsplit("/", 1)[-1]
        half, height = across / 2, source.bounds_max_cm[2] * factor
        found[_path(package)] = source.model_copy(
            update={
                "id": f"engine_{package.split('/')[-2].lower()}_{name.lower()}",
                "name": name,
                "path": _path(package),
                "category": "enginecontent",
                "description": f"Stand-in for the engine's {name}, a {shape.lower()} {across:g} cm across.",
                "tags": ["engine", "shape"],
                "bounds_min_cm": (-half, -half, -height),
                "bounds_max_cm": (half, half, height),
                "slots": [MaterialSlot(name="WorldGridMaterial", material=MATERIALS[0].path)],
                "collision": [_scaled(body, factor) for body in source.collision],
            }
        )
    found[SKY_SPHERE] = Asset(
        id="engine_bp_sky_sphere",
        name="BP_Sky_Sphere",
        kind="blueprint",
        path=SKY_SPHERE,
        category="enginecontent",
        description="Stand-in for the engine's sky sphere: an actor without a body.",
        tags=["engine", "sky"],
        bounds_min_cm=(0, 0, 0),
        bounds_max_cm=(0, 0, 0),
    )
    return found
