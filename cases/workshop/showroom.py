"""A scene for a pack that has none: its assets in rows on a floor, so that there is something to change."""

from __future__ import annotations

from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import Asset, Pack
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of

MOST_ASSETS = 60
MOST_SIDE_M, LEAST_SIDE_M = 12.0, 0.15
"""Larger and smaller assets are left out."""
ROW_CM, GAP_CM, STAND_CM = 1600.0, 90.0, 0.2
"""Length of a row, air between things, and their height above the floor."""
FLOOR = "/Engine/BasicShapes/Cube.Cube"


def showroom(pack: Pack) -> Level:
    """A level with an actor an asset, the largest in the back. ``BadInput`` where no asset is of a handy size."""
    shown = sorted(
        (
            asset
            for asset in pack.assets
            if asset.kind == "static_mesh" and LEAST_SIDE_M <= max(asset.size_m) <= MOST_SIDE_M
        ),
        key=lambda asset: (-asset.size_m[2], asset.id),
    )[:MOST_ASSETS]
    if not shown:
        raise BadInput(
            f"no mesh of this pack is {LEAST_SIDE_M} to {MOST_SIDE_M} m large",
            where=pack.pack_id,
            todo="is the pack's scale right? see `c4s catalog show`",
        )
    actors: list[LevelActor] = []
    x = y = deepest = 0.0
    for asset in shown:
        width, depth = (100 * asset.size_m[axis] for axis in (0, 1))
        if x > 0 and x + width > ROW_CM:
            x, y, deepest = 0.0, y + deepest + GAP_CM, 0.0
        actors.append(_standing(pack.pack_id, asset, x, y))
        x, deepest = x + width + GAP_CM, max(deepest, depth)
    length = y + deepest
    return Level(
        package=f"/Game/{pack.content_folder}/Maps/Showroom",
        actors=[_floor(pack.pack_id, ROW_CM, length), *actors, *_daylight(pack.pack_id)],
    )


def _standing(key: str, asset: Asset, x: float, y: float) -> LevelActor:
    """The asset with the low corner of its box at ``x, y`` on the floor."""
    low = asset.bounds_min_cm
    place = (round(x - low[0], 3), round(y - low[1], 3), round(STAND_CM - low[2], 3))
    return _mesh(
        key, f"{asset.path.rpartition('.')[2].removeprefix('SM_')}_1", asset.path, Transform(location_cm=place)
    )


def _floor(key: str, width: float, length: float) -> LevelActor:
    """A slab of 10 cm with its upper side at 0, with an edge around what stands on it."""
    edge, thick = 300.0, 10.0
    return _mesh(
        key,
        "Floor_1",
        FLOOR,
        Transform(
            location_cm=(width / 2, round(length / 2, 3), -thick / 2),
            scale=((width + 2 * edge) / 100, round((length + 2 * edge) / 100, 3), thick / 100),
        ),
    )


def _mesh(key: str, name: str, mesh: str, place: Transform) -> LevelActor:
    component = LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=mesh)
    return LevelActor(
        name=name,
        label=name,
        class_path=STATIC_MESH_ACTOR,
        guid=guid_of(f"{key}|{name}"),
        transform=place,
        components=[component],
    )


def _daylight(key: str) -> list[LevelActor]:
    lights = (
        ("DirectionalLight", "LightComponent0", (-50.0, -120.0, 0.0), {"intensity": 4.0}),
        ("SkyLight", "SkyLightComponent0", (0.0, 0.0, 0.0), {"intensity": 1.0}),
    )
    return [
        LevelActor(
            name=f"{kind}_0",
            label=f"{kind}_0",
            class_path=f"/Script/Engine.{kind}",
            guid=guid_of(f"{key}|{kind}"),
            transform=Transform(location_cm=(0.0, 0.0, 2000.0), rotation_deg=turned),
            components=[LevelComponent(name=component, class_path=f"/Script/Engine.{kind}Component", properties=own)],
        )
        for kind, component, turned, own in lights
    ]
