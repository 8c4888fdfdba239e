"""Stages: a piece of an authored scene, a cast on a grid of cells, and the edits that make its twins.

The grid has 6 columns and 8 rows. Row 0 holds the row that becomes a circle, row 2 single things, the middle the focal
thing with free ground around it, the sides what is counted and what stands beside or on something, row 5 the evenly
spaced things, and rows 6 and 7 stay free for what the edit moves there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import Asset, Pack
from cases.boxes import boxes_of, world_box
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of
from cases.judge_check.model import CheckScene, Staged, Swap, Variant

COLUMNS, ROWS = 6, 8
COUNTS = ((3, 4), (3, 6), (2, 4))
"""How many of each counted asset there are, before and after the edit."""
ROWED, SPACED = 6, 5
GAP_CM = 0.1
NIGHT = 0.02
"""Share of their light that the sun and the sky keep at night; every other light is put out."""
_GROUND = ("ground",)
_UNEVEN = (0.0, 0.25, 2.2, 2.45, 4.9)
_BESIDE = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1))

Placed = dict[str, LevelActor]


class _Floor:
    """Puts assets of a pack on the cells of a stage."""

    def __init__(self, stage: CheckScene, pack: Pack) -> None:
        self.stage = stage
        self.assets = {asset.path.rsplit(".SM_", 1)[-1]: asset for asset in pack.assets if asset.kind == "static_mesh"}
        self.boxes = boxes_of(pack.assets)
        self.materials = {material.path.rsplit(".M_", 1)[-1]: material.path for material in pack.materials}
        self.actors: Placed = {}

    def at(self, column: float, row: float) -> tuple[float, float]:
        """The middle of a cell, in cm."""
        x, y = self.stage.origin_cm
        return x + (column + 0.5) * self.stage.cell_cm, y + (row + 0.5) * self.stage.cell_cm

    def size(self, asset: str) -> float:
        """The longer side of an asset's plan, in cm."""
        low, high = self.boxes[self.assets[asset].path]
        return max(high[0] - low[0], high[1] - low[1])

    def put(
        self, key: str, asset: str, x: float, y: float, *, on: str = "", roll: float = 0.0, yaw: float = 0.0
    ) -> None:
        """Put an asset down so that it just touches the floor, or the top of what it stands on."""
        path = self.assets[asset].path
        part = LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=path)
        place = Transform(location_cm=(x, y, 0.0), rotation_deg=(0.0, yaw, roll))
        name = f"Thing_{key}"
        actor = LevelActor(
            name=name,
            label=name,
            class_path=STATIC_MESH_ACTOR,
            guid=guid_of(f"{self.stage.name}|{key}"),
            transform=place,
            components=[part],
        )
        low = float(world_box(actor, place, self.boxes)[0][2])
        under = self.actors[on] if on else None
        base = self.stage.floor_cm if under is None else float(world_box(under, under.transform, self.boxes)[1][2])
        lifted = place.model_copy(update={"location_cm": (round(x, 3), round(y, 3), round(base - low + GAP_CM, 3))})
        self.actors[key] = actor.model_copy(update={"transform": lifted})

    def cover(self, actor: LevelActor, material: str) -> LevelActor:
        """An actor with one material on all slots of all its meshes."""
        by_path = {asset.path: asset for asset in self.assets.values()}
        parts = [
            part.model_copy(
                update={"materials": _all_slots(by_path.get(part.static_mesh or ""), self.materials[material])}
            )
            for part in actor.components
        ]
        return actor.model_copy(update={"components": parts})


def _all_slots(asset: Asset | None, material: str) -> dict[int, str]:
    return {} if asset is None else dict.fromkeys(range(len(asset.slots)), material)


def staged(stage: CheckScene, source: Level, pack: Pack) -> Staged:
    """The levels of a stage. ``source`` is the authored scene, of the one pack."""
    floor = _Floor(stage, pack)
    around = _around(stage, source, pack)
    _base(floor)
    base = dict(floor.actors)
    _edit(floor)
    edited = dict(floor.actors)
    levels: dict[Variant, Level] = {
        "base": _level(stage, "base", [*around, *base.values()]),
        "edited": _level(stage, "edited", [*around, *edited.values()]),
        "restyled": _level(
            stage, "restyled", [_at_night(floor.cover(actor, stage.overlay)) for actor in (*around, *base.values())]
        ),
    }
    return Staged(stage, levels)


def _level(stage: CheckScene, variant: Variant, actors: list[LevelActor]) -> Level:
    return Level(package=f"/Game/JudgeCheck/{stage.name}_{variant}", actors=[actor for actor in actors if actor.name])


def _base(floor: _Floor) -> None:
    cast = floor.stage.cast
    for column in range(ROWED):
        floor.put(f"rowed{column}", cast.rowed, *floor.at(0.25 + 0.9 * column, 0))
    singles = (
        cast.removed,
        cast.replaced,
        cast.recoloured.asset,
        cast.tipped,
        cast.remade.asset,
        cast.remade_too.asset,
    )
    for column, (key, asset) in enumerate(
        zip(("removed", "replaced", "recoloured", "tipped", "remade", "remade_too"), singles, strict=True)
    ):
        floor.put(key, asset, *floor.at(column, 2))
    for number, (place, asset) in enumerate(zip(((0, 3.2), (0, 4.4), (1.2, 4.6)), cast.counted, strict=True)):
        _count(floor, number, asset, place, COUNTS[number][0])
    floor.put("neighbour", cast.neighbour, *floor.at(5, 3.2))
    _beside(floor, "mover", cast.mover, "neighbour")
    floor.put("carrier", cast.carrier, *floor.at(5, 4.6))
    floor.put("carried", cast.carried, *floor.at(5, 4.6), on="carrier")
    for column in range(SPACED):
        floor.put(f"spaced{column}", cast.spaced, *floor.at(0.3 + 1.15 * column, 5.7))
    floor.put("focal", cast.focal, *floor.at(2.5, 3.4))


def _edit(floor: _Floor) -> None:
    cast = floor.stage.cast
    del floor.actors["removed"]
    floor.put("replaced", cast.newcomer, *floor.at(1, 2))
    _overlay(floor, "recoloured", cast.recoloured)
    _overlay(floor, "remade", cast.remade)
    _overlay(floor, "remade_too", cast.remade_too)
    floor.put("tipped", cast.tipped, *floor.at(3, 2), roll=90.0)
    for number, (place, asset) in enumerate(zip(((0, 3.2), (0, 4.4), (1.2, 4.6)), cast.counted, strict=True)):
        _count(floor, number, asset, place, COUNTS[number][1])
    floor.put("mover", cast.mover, *floor.at(0.1, 7))
    carrier = floor.actors["carrier"]
    aside = 0.5 * (floor.size(cast.carrier) + floor.size(cast.carried)) + 0.15 * floor.stage.cell_cm
    x, y, _ = carrier.transform.location_cm
    floor.put("carried", cast.carried, x, y + aside)
    middle, radius = floor.at(2.5, 0.4), max(0.95 * floor.stage.cell_cm, 1.1 * floor.size(cast.rowed))
    for number in range(ROWED):
        angle = 2 * math.pi * number / ROWED
        floor.put(
            f"rowed{number}", cast.rowed, middle[0] + radius * math.cos(angle), middle[1] + radius * math.sin(angle)
        )
    for number, column in enumerate(_UNEVEN):
        step = max(column, number * floor.size(cast.spaced) / floor.stage.cell_cm)
        floor.put(f"spaced{number}", cast.spaced, *floor.at(min(step, COLUMNS - 1.0), 5.7))
    corner = floor.at(3.6, 6.9)
    floor.put("focal", cast.focal, *corner)
    away = 0.55 * (floor.size(cast.focal) + floor.size(cast.filler))
    for number, (x, y) in enumerate(_BESIDE):
        floor.put(f"filler{number}", cast.filler, corner[0] + x * away, corner[1] + y * away)


def _count(floor: _Floor, number: int, asset: str, place: tuple[float, float], count: int) -> None:
    x, y = floor.at(*place)
    step = 1.25 * floor.size(asset)
    for one in range(count):
        column, row = one % 3, one // 3
        floor.put(f"counted{number}_{one}", asset, x + (column - 0.6) * step, y + row * step)


def _beside(floor: _Floor, key: str, asset: str, other: str) -> None:
    x, y, _ = floor.actors[other].transform.location_cm
    gap = 0.5 * (floor.size(asset) + floor.size(floor.stage.cast.neighbour)) + 0.05 * floor.stage.cell_cm
    floor.put(key, asset, x - gap, y)


def _overlay(floor: _Floor, key: str, swap: Swap) -> None:
    floor.actors[key] = floor.cover(floor.actors[key], swap.material)


def _around(stage: CheckScene, source: Level, pack: Pack) -> list[LevelActor]:
    """What is kept of the authored scene: lights, the ground below the stage, and what stands beside it."""
    boxes, told = boxes_of(pack.assets), {asset.path: asset for asset in pack.assets}
    wide, deep = COLUMNS * stage.cell_cm, ROWS * stage.cell_cm
    (x, y), margin = stage.origin_cm, stage.margin_cm
    own = {path for path, asset in told.items() if path.rsplit(".SM_", 1)[-1] in stage.cast.assets()}
    kept = []
    for actor in source.actors:
        meshes = [part.static_mesh for part in actor.components if part.static_mesh]
        if not meshes:
            kept.append(actor)
            continue
        low, high = world_box(actor, actor.transform, boxes)
        outside = low[0] > x + wide or high[0] < x or low[1] > y + deep or high[1] < y
        near = (
            high[0] > x - margin and low[0] < x + wide + margin and high[1] > y - margin and low[1] < y + deep + margin
        )
        if near and not own & set(meshes) and (outside or _is_ground(told, meshes)) and _is_plain(actor):
            kept.append(actor)
    return kept


def _is_ground(told: Mapping[str, Asset], meshes: list[str]) -> bool:
    return all(told[mesh].category in _GROUND or told[mesh].name.startswith("Floor") for mesh in meshes if mesh in told)


def _is_plain(actor: LevelActor) -> bool:
    """Whether it is one mesh, of which all is known; sets of several meshes are left out."""
    return actor.class_path == STATIC_MESH_ACTOR


def _at_night(actor: LevelActor) -> LevelActor:
    parts = []
    for part in actor.components:
        kept = NIGHT if part.class_path.endswith(("DirectionalLightComponent", "SkyLightComponent")) else 0.0
        if part.class_path.endswith("LightComponent"):
            power = float(part.properties.get("intensity", 1.0))
            part = part.model_copy(update={"properties": {**part.properties, "intensity": kept * power}})
        parts.append(part)
    return actor.model_copy(update={"components": parts})
