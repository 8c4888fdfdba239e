"""A scene that people made, imported from an installed package, in the place of one that is laid out by rules."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from functools import cached_property
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from c4s.geometry.transform import affine
from c4s.records.level import Level, LevelActor
from c4s.records.pack import Asset
from cases.corruption import with_identities
from cases.natural import TOUCH_CM
from cases.open190.layout import Relation, StagedPlace
from cases.open190.space import Solid, Space
from catalog.ingest.excess import corners_of
from catalog.kits import styles

HOLLOW_CM: Final = 900.0
"""What is larger, and has several bodies, is hollow: its bodies count one by one."""
LAMPS_CM: Final = 380.0
LAMP, SUN, SKY, SUN_DEG = 2200.0, 1.6, 0.9, (-52.0, 24.0)
"""Strength (the engine's unitless measure) of a lamp, the sun and the sky, and where the sun shines to."""
WALL_CM: Final = 25.0
"""Eyes keep so far from a wall."""
BESIDE_CM: Final = 250.0
"""Like things with no more air between them were put together."""
Points = NDArray[np.float64]


@dataclass
class BroughtPlace:
    """An imported scene as the repairs take a place: its level, and where its bodies lie.

    Args:
        scene_id: of the scene.
        pack_id: of its meshes.
        imported: its level.
        assets: of its pack.
        room_cm: the plan (x0, y0, x1, y1) and the height of lamps of a room: eyes are in it, and its lamps are hung
            as in a room that is laid out. A simulator's lights say how its author worked, and nothing of the room.
        soft: patterns of the names of actors that are never changed.
    """

    scene_id: str
    pack_id: str
    imported: Level
    assets: Sequence[Asset]
    room_cm: tuple[float, float, float, float, float] | None = None
    soft: Sequence[str] = ()

    def level(self) -> Level:
        """The level; the same every time."""
        return self._lit

    @cached_property
    def _lit(self) -> Level:
        if self.room_cm is None:
            return self.imported
        x0, y0, x1, y1, high = self.room_cm
        lights = StagedPlace(self.scene_id, styles.DOMESTIC, "lamps")
        for x in _middles(x0, x1):
            for y in _middles(y0, y1):
                lights.light(x, y, high, intensity=LAMP)
        lights.sun(*SUN_DEG, intensity=SUN, sky=SKY)
        kept = [actor for actor in self.imported.actors if not _shines(actor)]
        return with_identities(self.imported.model_copy(update={"actors": [*kept, *lights.actors]}), self.scene_id)

    @cached_property
    def left_alone(self) -> frozenset[str]:
        """Names of the actors that are never changed."""
        names = [actor.name for actor in self.imported.actors]
        return frozenset(name for name in names if any(fnmatch(name, pattern) for pattern in self.soft))

    def may_look_from(self, x: float, y: float) -> bool:
        """Whether an eye may be at a place of the plan."""
        if self.room_cm is None:
            return True
        x0, y0, x1, y1, _ = self.room_cm
        return x0 + WALL_CM < x < x1 - WALL_CM and y0 + WALL_CM < y < y1 - WALL_CM

    @cached_property
    def _bodies(self) -> Mapping[str, list[Points]]:
        """Corners (cm) of the bodies of each actor, in the world."""
        own = {asset.path: [corners_of(body) for body in asset.collision] for asset in self.assets}
        found = {}
        for actor in self.imported.actors:
            mesh = actor.components[0].static_mesh if actor.components else None
            if mesh in own:
                place = actor.transform
                matrix = affine(place.location_cm, place.rotation_deg, place.scale)
                found[actor.name] = [points @ matrix[:3, :3].T + matrix[:3, 3] for points in own[mesh]]
        return found

    @cached_property
    def parted(self) -> Mapping[str, list[tuple[Points, Points]]]:
        """Boxes of the bodies of each hollow thing: the shell of a room, the ground of a place."""
        found = {}
        for name, bodies in self._bodies.items():
            if len(bodies) > 1 and float(np.ptp(np.concatenate(bodies), axis=0).max()) > HOLLOW_CM:
                found[name] = [(points.min(axis=0), points.max(axis=0)) for points in bodies]
        return found

    @cached_property
    def relations(self) -> list[Relation]:
        """What stands on what, and what stands beside its like: told by boxes, for the source does not say."""
        boxes = {
            name: (every.min(axis=0), every.max(axis=0))
            for name, bodies in self._bodies.items()
            if bodies and name not in self.parted
            for every in [np.concatenate(bodies)]
        }
        mesh = {actor.name: actor.components[0].static_mesh for actor in self.imported.actors if actor.components}
        found = []
        for name, (low, high) in boxes.items():
            for other, (under, over) in boxes.items():
                middle = (low + high)[:2] / 2
                if other != name and abs(low[2] - over[2]) <= TOUCH_CM and (under[:2] < middle).all():
                    found += [Relation("on", name, other)] if (middle < over[:2]).all() else []
        first: dict[str, str] = {}
        for name, (low, high) in boxes.items():
            for other in list(first):
                under, over = boxes[other]
                apart = np.linalg.norm(np.maximum(0.0, np.maximum(low - over, under - high)))
                if mesh[other] == mesh[name] and apart <= BESIDE_CM and abs(low[2] - under[2]) <= TOUCH_CM:
                    first[name] = first[other]
                    break
            first.setdefault(name, name)
        sets = Counter(first.values())
        return found + [Relation("in_row", name, one) for name, one in first.items() if sets[one] > 1]

    @cached_property
    def space(self) -> Space:
        """The room that its bodies take."""
        space = Space()
        for bodies in self._bodies.values():
            space.take(solid for points in bodies if (solid := _solid(points)) is not None)
        return space


def _middles(low: float, high: float) -> list[float]:
    """Middles of equal parts of a side, each about ``LAMPS_CM`` long."""
    count = max(1, round((high - low) / LAMPS_CM))
    return [round(low + (high - low) * (number + 0.5) / count, 1) for number in range(count)]


def _shines(actor: LevelActor) -> bool:
    return "Light" in actor.class_path.rpartition(".")[2]


def _solid(points: Points) -> Solid | None:
    low, high = float(points[:, 2].min()), float(points[:, 2].max())
    try:
        plan = points[ConvexHull(points[:, :2]).vertices, :2]
    except QhullError:
        return None
    return Solid(tuple((float(x), float(y)) for x, y in plan), low, high)


AnyPlace = StagedPlace | BroughtPlace
