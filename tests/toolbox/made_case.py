"""A small pack and two cases, built with real parts: boxes as GLB files, a Blueprint, a start level."""

from __future__ import annotations

import io
from pathlib import Path

import trimesh
from PIL import Image

from c4s.files import digest_file, write_bytes, write_json
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import Asset, BlueprintPart, BoxBody, Material, MaterialSlot, Pack
from c4s.records.suite import AgentCase, Budget, PackRef

START = "/Game/Test/Maps/Room"
BOXES = {  # id: (category, size in metres x y z, description)
    "oak_table": ("Tables", (1.6, 0.8, 0.75), "A wooden dining table"),
    "crate": ("Storage", (0.5, 0.5, 0.5), "A wooden box for cargo"),
    "sofa": ("Seating", (2.0, 0.9, 0.8), "A grey couch for three"),
    "floor_tile": ("Ground", (4.0, 4.0, 0.1), "A flat concrete floor tile"),
}


def path_of(name: str) -> str:
    return f"/Game/Test/{name}.{name}"


def make_pack(root: Path) -> Path:
    """Write the pack ``test-pack`` under ``root``."""
    folder = root / "test-pack"
    assets = []
    for name, (category, size, text) in BOXES.items():
        half = tuple(50 * side for side in size)
        mesh = trimesh.creation.box(extents=(size[0], size[2], size[1]))
        mesh.apply_translation((0, size[2] / 2, 0))
        mesh.visual = trimesh.visual.TextureVisuals(material=trimesh.visual.material.PBRMaterial(name="Default"))
        write_bytes(folder / "meshes" / f"{name}.glb", mesh.export(file_type="glb"))
        assets.append(
            Asset(
                id=name,
                name=name.replace("_", " ").title(),
                path=path_of(f"SM_{name}"),
                category=category,
                description=text,
                tags=["wood"],
                bounds_min_cm=(-half[0], -half[1], 0),
                bounds_max_cm=(half[0], half[1], 2 * half[2]),
                mesh=f"meshes/{name}.glb",
                mesh_sha256=digest_file(folder / "meshes" / f"{name}.glb"),
                slots=[MaterialSlot(name="Default", material=path_of("M_plain"))],
                collision=[BoxBody(center=(0, 0, half[2]), half_extent=half)],
                preview="previews/crate.png" if name == "crate" else None,
            )
        )
    assets.append(
        Asset(
            id="stacked_table",
            name="Stacked Table",
            kind="blueprint",
            path=path_of("BP_stacked_table"),
            category="Tables",
            description="A table with a crate on it",
            bounds_min_cm=(-80, -40, 0),
            bounds_max_cm=(80, 40, 125),
            parts=[
                BlueprintPart(name="Table", asset=path_of("SM_oak_table")),
                BlueprintPart(name="Crate", asset=path_of("SM_crate"), relative=Transform(location_cm=(0, 0, 75))),
            ],
        )
    )
    picture = io.BytesIO()
    Image.new("RGB", (32, 32), (150, 110, 60)).save(picture, "PNG")
    write_bytes(folder / "previews" / "crate.png", picture.getvalue())
    Pack(
        pack_id="test-pack",
        content_folder="Test",
        title="Test",
        license="CC0-1.0",
        assets=assets,
        materials=[Material(path=path_of("M_plain"))],
        category_descriptions={"Tables": "To eat and work at"},
    ).write(folder / "pack.json")
    return folder


def mesh_actor(number: int, label: str, name: str, location: tuple[float, float, float]) -> LevelActor:
    """A static mesh actor of the start level."""
    return LevelActor(
        name=f"StaticMeshActor_{number}",
        label=label,
        class_path="/Script/Engine.StaticMeshActor",
        guid=f"{number:032X}",
        transform=Transform(location_cm=location),
        components=[
            LevelComponent(
                name="StaticMeshComponent0",
                class_path="/Script/Engine.StaticMeshComponent",
                static_mesh=path_of(f"SM_{name}"),
            )
        ],
    )


def make_case(
    root: Path, pack: Path, *, setting: str = "image-to-scene/indoor", calls: int = 60, minutes: float = 5.0
) -> tuple[AgentCase, Path]:
    """Write a case under ``root``: its record and its agent folder. Text-to-scene starts empty."""
    actors = (
        []
        if setting == "text-to-scene"
        else [
            mesh_actor(1, "Floor", "floor_tile", (0, 0, -10)),
            mesh_actor(2, "Table", "oak_table", (0, 0, 0)),
            mesh_actor(3, "Box", "crate", (0, 0, 75)),
            mesh_actor(4, "Sofa", "sofa", (50, 120, 40)),
            mesh_actor(5, "Twin", "crate", (-150, -150, 0)),
            mesh_actor(6, "Twin", "crate", (150, -150, 0)),
        ]
    )
    folder = root / "agent" / "room"
    Level(package=START, actors=actors).write(folder / "start.level.json")
    manifest = Pack.read(pack / "pack.json")
    case = AgentCase.parse(
        {
            "alias": "room",
            "setting": setting,
            "prompt": "A room with a table.",
            "start_map": START,
            "budget": Budget(tool_calls=calls, wall_minutes=minutes).plain(),
            "packs": [PackRef(pack_id="test-pack", digest=manifest.sha256()).plain()],
            "catalog": [f"{asset.path}_C" if asset.kind == "blueprint" else asset.path for asset in manifest.assets],
            "plate_m": 20.0 if setting == "text-to-scene" else None,
        }
    )
    case.write(folder / "case.json")
    write_json(folder / "facts.json", {})
    return case, folder
