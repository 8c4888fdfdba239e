"""Scenes as people leave them: things stand a little askew, are of uneven size, and some are mirrored.

In a scene of round numbers whatever a recipe has moved, scaled or mirrored is the only thing of its kind. So some of
the things that stand free are turned and shifted a little, some are made uneven, and some that carry nothing are
mirrored within their box. What would then stand no more, or touch what it did not touch, is left as it is.
"""

from __future__ import annotations

import math
import random
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from c4s.geometry.transform import normalize_axis
from c4s.records.level import Level, LevelActor, Transform, Vector
from cases.boxes import Array, Boxes, world_box
from cases.corruption import STATIC_MESH_ACTOR, id_of
from cases.recipe import Operation, SetTransform, SpawnActor

CLEAR_CM = 4.0
"""Air that is kept beside what is shifted, turned or scaled."""
TOUCH_CM = 5.0
"""A thing whose lower side lies within this of another's upper side stands on it."""
LARGEST_CM = 600.0
"""Longest side of what is shifted, turned or scaled; buildings are mirrored only."""
ASKEW, UNEVEN, MIRRORED = 0.6, 0.6, 0.3
"""Shares of the things that can be."""
TRIES = 4
"""Each half as far as the one before, and smaller where the first was larger."""
SIZES = (0.55, 1.8)
"""By this what is uneven is larger or smaller, evenly on a scale of logarithms."""
SIDEWAYS = 0.12
"""Each axis differs from the size by up to this share, and one of them by more than the tolerance of Repair F1."""
NEAR_DEG, FAR_DEG, TURNED_FAR = (5.5, 24.0), (24.0, 156.0), 0.25
"""Most things are turned a little, a part of them by any angle."""
DIGITS = 3
"""Decimals of every place, angle and scale of a scene, and of all that a recipe writes."""


Parted = Mapping[str, Sequence[tuple[Array, Array]]]
"""World boxes of the parts of things that are too large and hollow for one, by the name of the actor."""
NOT_PARTED: Parted = {}


@dataclass
class StandingBoxes:
    """World boxes of a level's actors, a row an actor; NaN where it shows no mesh."""

    low: Array
    high: Array

    @classmethod
    def of(cls, actors: Sequence[LevelActor], boxes: Boxes, parted: Parted = NOT_PARTED) -> StandingBoxes:
        """The boxes of some actors in their order; behind them those of the parts of what is ``parted``, whose own
        rows are NaN: a room's walls are one thing, and what stands in the room does not meet them."""
        rows = [
            (np.full(3, np.nan),) * 2 if actor.name in parted else world_box(actor, actor.transform, boxes)
            for actor in actors
        ]
        rows += [box for name in sorted(parted) for box in parted[name]]
        return cls(np.array([low for low, _ in rows]), np.array([high for _, high in rows]))

    def beside(self, row: int, low: Array, high: Array, air_cm: float) -> Array:
        """Which other actors a box in the place of a row's meets, grown by some air to the sides."""
        grow = np.array((air_cm, air_cm, -TOUCH_CM / 5))
        met = np.asarray((self.low < high + grow).all(axis=1) & (self.high > low - grow).all(axis=1))
        met[row] = False
        return met

    def carried(self, row: int) -> bool:
        """Whether something stands on an actor or against its top."""
        low, high = self.low[row], self.high[row]
        over = (self.low[:, :2] < high[:2]).all(axis=1) & (self.high[:, :2] > low[:2]).all(axis=1)
        over &= (self.low[:, 2] > low[2] + 1) & (self.low[:, 2] < high[2] + TOUCH_CM)
        over[row] = False
        return bool(over.any())

    def held(self, row: int | None, low: Array, high: Array) -> bool:
        """Whether a box in the place of a row's, or of none, stands with all of its lower side on upper sides."""
        xs, ys = (np.linspace(low[axis] + 0.5, high[axis] - 0.5, 5) for axis in (0, 1))
        points = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 1, 2)
        under = np.abs(self.high[:, 2] - low[2]) <= TOUCH_CM
        if row is not None:
            under[row] = False
        within = (points > self.low[under, :2]) & (points < self.high[under, :2])
        inside: Array = np.all(within, axis=2)
        return bool(np.all(np.any(inside, axis=1)))


@dataclass(frozen=True)
class Plans:
    """What recipes have in mind for a scene's things, by stable id."""

    factors: Mapping[str, float]
    """By how much a thing is scaled: its size before leaves room for that within ``SIZES``."""
    mirrored: Collection[str]
    """What is mirrored: in the original it is mirrored already, so that what most things are is never the answer."""


NO_PLANS = Plans({}, ())


def lived_in(
    level: Level,
    boxes: Boxes,
    chance: random.Random,
    plans: Plans = NO_PLANS,
    only: Collection[str] | None = None,
    parted: Parted = NOT_PARTED,
) -> Level:
    """The level with things askew, uneven and mirrored; the same chance, the same level.

    Args:
        level: the original; each actor has a stable id.
        boxes: local boxes of the meshes; an actor with a mesh that is not among them stays as it is.
        chance: where it is drawn from.
        plans: what recipes have in mind.
        only: stable ids of the things that may be disturbed; all when left out.
        parted: boxes of the parts of what is hollow.
    """
    parents = {actor.parent for actor in level.actors}
    actors = [_rounded(actor) for actor in level.actors]
    placed = StandingBoxes.of(actors, boxes, parted)
    for row, actor in enumerate(actors):
        simple = actor.class_path == STATIC_MESH_ACTOR and len(actor.components) == 1
        own = id_of(actor) or ""
        if not simple or actor.parent or actor.name in parents or np.isnan(placed.low[row]).any():
            continue
        if only is not None and own not in only:
            continue
        now = actor.transform
        if placed.carried(row):
            continue
        if chance.random() < MIRRORED or own in plans.mirrored:
            now = _mirrored(actor, now, boxes)
        side = float((placed.high[row] - placed.low[row]).max())
        loose = not placed.beside(row, placed.low[row], placed.high[row], CLEAR_CM).any()
        if side <= LARGEST_CM and placed.held(row, placed.low[row], placed.high[row]):
            wanted = chance.random() < UNEVEN or own in plans.factors
            factor = plans.factors.get(own, 1.0) if wanted else None
            if loose:
                now = _disturbed(actor, now, boxes, placed, row, chance, factor)
            elif factor is not None:
                now = _at_once(actor, now, boxes, uneven(now.scale, factor, chance, largest=0.93))
        if now != actor.transform:
            actors[row] = actor.model_copy(update={"transform": now})
            placed.low[row], placed.high[row] = world_box(actor, now, boxes)
    return level.model_copy(update={"actors": actors})


def _at(actor: LevelActor, place: Transform, boxes: Boxes, middle: Array, bottom: float) -> Transform:
    """A place whose box has its middle and lower side where they were."""
    low, high = world_box(actor, place, boxes)
    off = np.array((*(middle - (low + high) / 2)[:2], bottom - low[2]))
    x, y, z = (float(round(value, DIGITS)) for value in np.add(place.location_cm, off))
    return place.model_copy(update={"location_cm": (x, y, z)})


def _mirrored(actor: LevelActor, now: Transform, boxes: Boxes) -> Transform:
    """Left and right changed: furniture and houses look along their Y, and go on looking where they did."""
    x, y, z = now.scale
    turned = now.model_copy(update={"scale": (-x, y, z)})
    low, high = world_box(actor, now, boxes)
    return _at(actor, turned, boxes, (low + high) / 2, float(low[2]))


def uneven(scale: Vector, factor: float, chance: random.Random, largest: float = SIZES[1]) -> Vector:
    """Another size, each axis a little different; as far as the factor allows, it is of ``SIZES`` with it too."""
    low = min(0.93, max(SIZES[0], SIZES[0] / factor))
    high = max(low, min(largest, SIZES[1], SIZES[1] / factor))
    size = math.exp(chance.uniform(math.log(low), math.log(high)))
    axes = [size * (1 + chance.uniform(-SIDEWAYS, SIDEWAYS)) for _ in range(3)]
    axes[chance.randrange(3)] = size * (1 + chance.choice((-1, 1)) * SIDEWAYS)
    x, y, z = (round(s * axis, DIGITS) for s, axis in zip(scale, axes, strict=True))
    return x, y, z


def _at_once(actor: LevelActor, now: Transform, boxes: Boxes, scale: Vector) -> Transform:
    """Of another size where it stands."""
    low, high = world_box(actor, now, boxes)
    return _at(actor, now.model_copy(update={"scale": scale}), boxes, (low + high) / 2, float(low[2]))


def _disturbed(
    actor: LevelActor,
    now: Transform,
    boxes: Boxes,
    placed: StandingBoxes,
    row: int,
    chance: random.Random,
    factor: float | None,
) -> Transform:
    """Askew, and uneven where a factor is given, as far as there is room and what it stands on reaches."""
    askew = chance.random() < ASKEW
    turn = chance.choice((-1, 1)) * chance.uniform(*(FAR_DEG if chance.random() < TURNED_FAR else NEAR_DEG))
    shift = np.array([chance.choice((-1, 1)) * chance.uniform(6.0, 28.0) for _ in range(2)] + [0.0])
    turned, shifted = chance.choice(((1, 1), (1, 0), (0, 1)))
    low, high = world_box(actor, now, boxes)
    middle, bottom = (low + high) / 2, float(low[2])
    for step in range(TRIES):
        far = 0.5**step if askew else 0.0
        pitch, yaw, roll = now.rotation_deg
        rotation = (pitch, round(normalize_axis(yaw + turned * far * turn), DIGITS), roll)
        scale = now.scale if factor is None else uneven(now.scale, factor, chance, SIZES[1] if step == 0 else 0.93)
        place = now.model_copy(update={"rotation_deg": rotation, "scale": scale})
        place = _at(actor, place, boxes, middle + shifted * far * shift, bottom)
        box = world_box(actor, place, boxes)
        if not placed.beside(row, *box, CLEAR_CM / 2).any() and placed.held(row, *box):
            return place
    return now


def rounded(level: Level) -> Level:
    """The level with as many decimals as all that is written of a scene: what is left as it was is the same in all."""
    return level.model_copy(update={"actors": [_rounded(actor) for actor in level.actors]})


def _rounded(actor: LevelActor) -> LevelActor:
    """The actor with as many decimals as all that is written of a scene."""
    place = actor.transform
    values = {
        name: tuple(round(value, DIGITS) for value in getattr(place, name))
        for name in ("location_cm", "rotation_deg", "scale")
    }
    return actor.model_copy(update={"transform": place.model_copy(update=values)})


def rebased(operations: Sequence[Operation], before: Level, after: Level, chance: random.Random) -> list[Operation]:
    """A recipe that was written for a level, for the same level after its things were disturbed.

    New places and angles keep their distance from the original's, new scales their factor, all of them within half a
    centimetre, half a degree and a hundredth: a recipe's round numbers would tell what it touched.
    """
    was = {id_of(actor): actor.transform for actor in before.actors}
    now = {id_of(actor): actor.transform for actor in after.actors}
    told: list[Operation] = []
    for operation in operations:
        if isinstance(operation, SetTransform) and operation.target in was:
            operation = _rebased(operation, was[operation.target], now[operation.target], chance)
        elif isinstance(operation, SpawnActor):
            x, y, z = operation.location_cm
            x, y = (round(value + chance.uniform(-0.5, 0.5), DIGITS) for value in (x, y))
            operation = operation.model_copy(update={"location_cm": (x, y, z)})
        told.append(operation)
    return told


def _rebased(operation: SetTransform, was: Transform, now: Transform, chance: random.Random) -> SetTransform:
    def off(*values: float, by: float) -> Vector:
        x, y, z = (value + chance.uniform(-by, by) if value else 0.0 for value in values)
        return x, y, z

    changes: dict[str, Vector] = {}
    if operation.location_cm is not None:
        dx, dy, dz = np.subtract(operation.location_cm, was.location_cm)
        step = (*off(dx, dy, 0.0, by=0.5)[:2], float(dz))
        x, y, z = (round(n + d, DIGITS) for n, d in zip(now.location_cm, step, strict=True))
        changes["location_cm"] = (x, y, z)
    if operation.rotation_deg is not None:
        turns = off(*np.subtract(operation.rotation_deg, was.rotation_deg), by=0.5)
        x, y, z = (round(normalize_axis(n + d), DIGITS) for n, d in zip(now.rotation_deg, turns, strict=True))
        changes["rotation_deg"] = (x, y, z)
    if operation.scale is not None:
        factor = 1 + chance.uniform(-0.01, 0.01)
        mirrored = min(np.divide(operation.scale, was.scale)) < 0
        sizes = zip(now.scale, operation.scale, was.scale, strict=True)
        x, y, z = (round(n * o / w * (1.0 if mirrored else factor), DIGITS) for n, o, w in sizes)
        changes["scale"] = (x, y, z)
    return operation.model_copy(update=changes)


def plans_of(operations: Sequence[Operation], level: Level) -> Plans:
    """What recipes that were written for a level have in mind."""
    was = {id_of(actor): actor.transform.scale for actor in level.actors}
    factors: dict[str, float] = {}
    mirrored = set()
    for operation in operations:
        if isinstance(operation, SetTransform) and operation.scale is not None and operation.target in was:
            ratios = [new / old for new, old in zip(operation.scale, was[operation.target], strict=True)]
            factors[operation.target] = abs(math.prod(ratios)) ** (1 / 3)
            if min(ratios) < 0:
                mirrored.add(operation.target)
    return Plans(factors, mirrored)


def settled_spawns(operations: Sequence[Operation], level: Level) -> list[Operation]:
    """The operations with what they put there as it stands in a level."""
    places = {id_of(actor): actor.transform for actor in level.actors}
    return [
        operation.model_copy(
            update={
                "location_cm": (place := places[operation.stable_id]).location_cm,
                "rotation_deg": place.rotation_deg,
                "scale": place.scale,
            }
        )
        if isinstance(operation, SpawnActor)
        else operation
        for operation in operations
    ]
