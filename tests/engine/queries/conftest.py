"""A pack whose bodies differ from their triangles, an engine with it, and an empty level."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest
import trimesh
from query_scene import BODIES, FOLDER, Scene, path_of

from c4s.engine.headless.process.boot import boot
from c4s.files import write_bytes
from c4s.records.pack import Asset, Material, MaterialSlot, Pack


@pytest.fixture(scope="module")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Meshes that are boxes of 200 x 100 x 100 cm, with other collision bodies."""
    folder = tmp_path_factory.mktemp("packs") / "q"
    mesh = trimesh.creation.box(extents=(2.0, 1.0, 1.0))
    mesh.apply_translation((0, 0.5, 0))
    mesh.visual = trimesh.visual.TextureVisuals(material=trimesh.visual.material.PBRMaterial(name="Default"))
    write_bytes(folder / "meshes/box.glb", mesh.export(file_type="glb"))
    assets = [
        Asset(
            id=name,
            name=name,
            path=path_of(name),
            category="things",
            bounds_min_cm=(-100, -50, 0),
            bounds_max_cm=(100, 50, 100),
            mesh="meshes/box.glb",
            mesh_sha256="0" * 64,
            slots=[MaterialSlot(name="Default", material=f"{FOLDER}/M_A.M_A")],
            collision=bodies,
        )
        for name, bodies in BODIES.items()
    ]
    Pack(
        pack_id="q",
        content_folder="Q",
        title="Q",
        license="CC0-1.0",
        assets=assets,
        materials=[Material(path=f"{FOLDER}/M_A.M_A")],
    ).write(folder / "pack.json")
    return folder


@pytest.fixture(scope="module")
def engine(pack: Path, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    return boot([pack], tmp_path_factory.mktemp("content"))


@pytest.fixture
def unreal(engine: ModuleType) -> ModuleType:
    """The module on an empty level."""
    engine.EditorLoadingAndSavingUtils.new_blank_map(False)
    return engine


@pytest.fixture
def scene(unreal: ModuleType) -> Scene:
    return Scene(unreal)
