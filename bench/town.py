"""A level of many actors for the picture benchmark: a town of the meshes of a starter pack on open ground."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import Pack

PACKAGE = "/Game/Bench/Town"
PLANE = "/Engine/BasicShapes/Plane.Plane"
_GAP_CM = 60.0
_CELL_CM = 260.0


def _component(class_name: str, mesh: str | None = None, **properties: object) -> LevelComponent:
    return LevelComponent(
        name=f"{class_name}0", class_path=f"/Script/Engine.{class_name}", static_mesh=mesh, properties=properties
    )


def _actor(number: int, class_name: str, component: LevelComponent, place: Transform) -> LevelActor:
    return LevelActor(
        name=f"{class_name}_{number}",
        label=f"{class_name}{number}",
        guid=f"{number:032X}",
        class_path=f"/Script/Engine.{class_name}",
        transform=place,
        components=[component],
    )


def town(pack: Pack, actors: int, *, seed: int = 7) -> Level:
    """``actors`` meshes of a pack on a square grid, each turned its own way, with ground, a sun and a sky."""
    rng = np.random.default_rng(seed)
    meshes = [asset for asset in pack.assets if asset.kind == "static_mesh"]
    side = int(np.ceil(actors**0.5))
    extent = side * _CELL_CM
    found = [
        _actor(
            0,
            "StaticMeshActor",
            _component("StaticMeshComponent", PLANE),
            Transform(scale=(extent / 80, extent / 80, 1.0)),
        ),
        _actor(
            1,
            "DirectionalLight",
            _component("DirectionalLightComponent", intensity=8.0),
            Transform(rotation_deg=(-46.0, 25.0, 0.0)),
        ),
        _actor(2, "SkyLight", _component("SkyLightComponent", intensity=1.0), Transform()),
    ]
    for number in range(3, actors):
        asset = meshes[int(rng.integers(len(meshes)))]
        low, high = asset.bounds_min_cm, asset.bounds_max_cm
        reach = max(high[0] - low[0], high[1] - low[1])
        scale = min(1.0, (_CELL_CM - _GAP_CM) / reach)
        place = Transform(
            location_cm=(
                (number % side) * _CELL_CM - extent / 2,
                (number // side) * _CELL_CM - extent / 2,
                -low[2] * scale,
            ),
            rotation_deg=(0.0, float(rng.uniform(-180, 180)), 0.0),
            scale=(scale, scale, scale),
        )
        found.append(_actor(number, "StaticMeshActor", _component("StaticMeshComponent", asset.path), place))
    return Level(package=PACKAGE, actors=found)


def write_town(folder: Path, pack: Pack, actors: int) -> Path:
    """Write the town's document into a folder."""
    path = folder / "town.level.json"
    town(pack, actors).write(path)
    return path
