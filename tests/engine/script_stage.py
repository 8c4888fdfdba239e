"""Where the scripts of ``scripts/`` are at home: a pack of props, and a level that scripts of repair open."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

import trimesh

from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import Asset, BlueprintPart, BoxBody, Material, MaterialSlot, Pack

SIZES_CM = {
    "House": (600, 500, 400),
    "Tree": (200, 200, 500),
    "Rock": (150, 120, 80),
    "Fence": (200, 10, 100),
    "Bench": (160, 60, 80),
    "Post": (20, 20, 300),
}


def make_pack(folder: Path) -> Path:
    """A pack of boxes in the size of things, two materials, and a gate of two posts and a fence."""
    assets = []
    (folder / "meshes").mkdir(parents=True)
    (folder / "textures").mkdir()
    for name, (x, y, z) in SIZES_CM.items():
        box = trimesh.creation.box(extents=(x / 100, z / 100, y / 100))
        box.apply_translation((0, z / 200, 0))
        box.export(folder / f"meshes/{name}.glb")
        assets.append(
            Asset(
                id=name.lower(),
                name=name,
                path=f"/Game/Props/SM_{name}.SM_{name}",
                category="props",
                mesh=f"meshes/{name}.glb",
                mesh_sha256="0" * 64,
                bounds_min_cm=(-x / 2, -y / 2, 0),
                bounds_max_cm=(x / 2, y / 2, z),
                slots=[MaterialSlot(name="Main", material="/Game/Props/M_Wood.M_Wood")],
                collision=[BoxBody(center=(0, 0, z / 2), half_extent=(x / 2, y / 2, z / 2))],
            )
        )
    parts = [
        BlueprintPart(name="Left", asset="/Game/Props/SM_Post.SM_Post"),
        BlueprintPart(name="Right", asset="/Game/Props/SM_Post.SM_Post", relative=Transform(location_cm=(220, 0, 0))),
    ]
    assets.append(
        Asset(
            id="gate",
            name="Gate",
            kind="blueprint",
            path="/Game/Props/BP_Gate.BP_Gate",
            category="props",
            bounds_min_cm=(-10, -10, 0),
            bounds_max_cm=(230, 10, 300),
            parts=parts,
        )
    )
    Pack(
        pack_id="props",
        content_folder="Props",
        title="Props",
        license="CC0-1.0",
        assets=assets,
        materials=[
            Material(path="/Game/Props/M_Wood.M_Wood", base_color=(0.4, 0.25, 0.1)),
            Material(path="/Game/Props/M_Stone.M_Stone", base_color=(0.5, 0.5, 0.5)),
        ],
    ).write(folder / "pack.json")
    return folder


def placed(name: str, mesh: str, location=(0, 0, 0), rotation=(0, 0, 0), scale=(1, 1, 1)) -> LevelActor:
    where = Transform(location_cm=location, rotation_deg=rotation, scale=scale)
    return LevelActor(
        name=f"{name}_0",
        label=name,
        class_path="/Script/Engine.StaticMeshActor",
        transform=where,
        guid=sha256(name.encode()).hexdigest()[:32].upper(),
        components=[
            LevelComponent(
                name="StaticMeshComponent0", class_path="/Script/Engine.StaticMeshComponent", static_mesh=mesh
            )
        ],
    )


def start_level(folder: Path) -> Path:
    """The level that scripts of repair open: read-only, with things that lie, float, sink and repeat."""
    prop = "/Game/Props/SM_{0}.SM_{0}".format
    sun = LevelActor(
        name="DirectionalLight_0",
        label="Sun",
        class_path="/Script/Engine.DirectionalLight",
        guid="A" * 32,
        transform=Transform(rotation_deg=(-50, 30, 0)),
        components=[LevelComponent(name="LightComponent0", class_path="/Script/Engine.DirectionalLightComponent")],
    )
    Level(
        package="/Game/Maps/Start",
        actors=[
            placed("Ground", "/Engine/BasicShapes/Plane.Plane", scale=(100, 100, 1)),
            placed("House_A", prop("House"), (0, 0, 120), (20, 35, 90)),
            placed("Tree_A", prop("Tree"), (900, 0, 60)),
            placed("Tree_B", prop("Tree"), (900, 600, -80), scale=(1, 1, 3)),
            placed("Tree_B_copy", prop("Tree"), (900, 600, -80), scale=(1, 1, 3)),
            placed("Rock_A", prop("Rock"), (-700, 200, 250)),
            placed("Bench_A", prop("Bench"), (-300, -900, 0)),
            sun,
        ],
    ).write(folder / "start.level.json")
    return folder / "start.level.json"
