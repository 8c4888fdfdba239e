"""Scenes as people leave them: things stand a little askew, are of uneven size, and some are mirrored.

In a scene of round numbers whatever a recipe has moved, scaled or mirrored is the only thing of its kind. So some of
the things that stand free are turned and shifted a little, some are made uneven, and some that carry nothing are
mirrored within their box. What would then stand no more, or touch what it did not touch, is left as it is.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from c4s.geometry.transform import normalize_axis
from c4s.records.level import Level, LevelActor, Transform, Vector
from cases.boxes import Array, Boxes, world_box
from cases.corruption import STATIC_MESH_ACTOR, Operation, SetTransform, id_of

CLEAR_CM = 4.0
"""Air that is kept beside what is shifted, turned or scaled."""
TOUCH_CM = 5.0
"""A thing whose lower side lies within this of another's upper side stands on it."""
LARGEST_CM = 600.0
"""Longest side of what is shifted, turned or scaled; buildings are mirrored only."""
ASKEW, UNEVEN, MIRRORED = 0.6, 0.4, 0.3
"""Shares of the things that can be."""
TRIES = 4
"""Each half as far as the one before, and smaller where the first was larger."""
SMALLER = tuple(hundredths / 100 for hundredths in range(80, 94))
ANY_SIZE = SMALLER + tuple(hundredths / 100 for hundredths in range(107, 126))
"""Factors of an axis; none is near 1, since a size within the tolerance of Repair F1 is the usual size."""


@dataclass
class _Placed:
    """World boxes of a level's actors, a row an actor; NaN where it shows no mesh."""

    low: Array
    high: Array

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

    def held(self, row: int, low: Array, high: Array) -> bool:
        """Whether a box stands with all of its lower side on upper sides of others."""
        xs, ys = (np.linspace(low[axis] + 0.5, high[axis] - 0.5, 5) for axis in (0, 1))
        points = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 1, 2)
        under = np.abs(self.high[:, 2] - low[2]) <= TOUCH_CM
        under[row] = False
        within = (points > self.low[under, :2]) & (points < self.high[under, :2])
        inside: Array = np.all(within, axis=2)
        return bool(np.all(np.any(inside, axis=1)))


def lived_in(level: Level, boxes: Boxes, chance: random.Random, scaled: Collection[str] = ()) -> Level:
    """The level with things askew, uneven and mirrored; the same chance, the same level.

    Args:
        level: the original; each actor has a stable id.
        boxes: local boxes of the meshes; an actor with a mesh that is not among them stays as it is.
        chance: where it is drawn from.
        scaled: stable ids of things that a recipe scales or mirrors: they are mirrored and uneven, or the size that
            most things have would be theirs too.
    """
    parents = {actor.parent for actor in level.actors}
    actors = list(level.actors)
    rows = [world_box(actor, actor.transform, boxes) for actor in actors]
    placed = _Placed(np.array([low for low, _ in rows]), np.array([high for _, high in rows]))
    for row, actor in enumerate(actors):
        simple = actor.class_path == STATIC_MESH_ACTOR and len(actor.components) == 1
        if not simple or actor.parent or actor.name in parents or np.isnan(placed.low[row]).any():
            continue
        now = actor.transform
        if placed.carried(row):
            continue
        if chance.random() < MIRRORED or id_of(actor) in scaled:
            now = _mirrored(actor, now, boxes)
        side = float((placed.high[row] - placed.low[row]).max())
        loose = not placed.beside(row, placed.low[row], placed.high[row], CLEAR_CM).any()
        if side <= LARGEST_CM and placed.held(row, placed.low[row], placed.high[row]):
            wanted = chance.random() < UNEVEN or id_of(actor) in scaled
            if loose:
                now = _disturbed(actor, now, boxes, placed, row, chance, uneven=wanted)
            elif wanted:
                now = _smaller(actor, now, boxes, chance)
        if now != actor.transform:
            actors[row] = actor.model_copy(update={"transform": now})
            placed.low[row], placed.high[row] = world_box(actor, now, boxes)
    return level.model_copy(update={"actors": actors})


def _at(actor: LevelActor, place: Transform, boxes: Boxes, middle: Array, bottom: float) -> Transform:
    """A place whose box has its middle and lower side where they were."""
    low, high = world_box(actor, place, boxes)
    off = np.array((*(middle - (low + high) / 2)[:2], bottom - low[2]))
    x, y, z = (float(round(value, 3)) for value in np.add(place.location_cm, off))
    return place.model_copy(update={"location_cm": (x, y, z)})


def _mirrored(actor: LevelActor, now: Transform, boxes: Boxes) -> Transform:
    """Left and right changed: furniture and houses look along their Y, and go on looking where they did."""
    x, y, z = now.scale
    turned = now.model_copy(update={"scale": (-x, y, z)})
    low, high = world_box(actor, now, boxes)
    return _at(actor, turned, boxes, (low + high) / 2, float(low[2]))


def _disturbed(
    actor: LevelActor, now: Transform, boxes: Boxes, placed: _Placed, row: int, chance: random.Random, *, uneven: bool
) -> Transform:
    """A little askew and uneven, as far as there is room and what it stands on reaches."""
    askew = chance.random() < ASKEW
    turn = chance.choice((-1, 1)) * chance.uniform(5.5, 24.0)
    shift = [chance.choice((-1, 1)) * chance.uniform(6.0, 28.0) for _ in range(2)]
    factors, smaller = ([chance.choice(range_of) for _ in range(3)] for range_of in (ANY_SIZE, SMALLER))
    low, high = world_box(actor, now, boxes)
    middle, bottom = (low + high) / 2, float(low[2])
    for step in range(TRIES):
        far = 0.5**step
        pitch, yaw, roll = now.rotation_deg
        place = now
        if uneven:
            x, y, z = (round(s * f, 2) for s, f in zip(now.scale, smaller if step else factors, strict=True))
            place = place.model_copy(update={"scale": (x, y, z)})
        if askew:
            turned = round(normalize_axis(yaw + far * turn), 1)
            place = place.model_copy(update={"rotation_deg": (pitch, turned, roll)})
        moved = middle + np.array((*(np.round(shift, 1) * (far if askew else 0.0)), 0.0))
        place = _at(actor, place, boxes, moved, bottom)
        box = world_box(actor, place, boxes)
        if not placed.beside(row, *box, CLEAR_CM / 2).any() and placed.held(row, *box):
            return place
    return now


def _smaller(actor: LevelActor, now: Transform, boxes: Boxes, chance: random.Random) -> Transform:
    """A little smaller, unevenly, where it stands: that never needs room."""
    x, y, z = (round(s * chance.choice(SMALLER), 2) for s in now.scale)
    low, high = world_box(actor, now, boxes)
    smaller = now.model_copy(update={"scale": (x, y, z)})
    return _at(actor, smaller, boxes, (low + high) / 2, float(low[2]))


def rebased(operations: Sequence[Operation], before: Level, after: Level) -> list[Operation]:
    """A recipe that was written for a level, for the same level after its things were disturbed.

    New places and angles keep their distance from the original's, new scales their factor.
    """
    was = {id_of(actor): actor.transform for actor in before.actors}
    now = {id_of(actor): actor.transform for actor in after.actors}
    return [
        _rebased(operation, was[operation.target], now[operation.target])
        if isinstance(operation, SetTransform) and operation.target in was
        else operation
        for operation in operations
    ]


def _rebased(operation: SetTransform, was: Transform, now: Transform) -> SetTransform:
    changes: dict[str, Vector] = {}
    if operation.location_cm is not None:
        x, y, z = (
            round(n + o - w, 3) for n, o, w in zip(now.location_cm, operation.location_cm, was.location_cm, strict=True)
        )
        changes["location_cm"] = (x, y, z)
    if operation.rotation_deg is not None:
        x, y, z = (
            round(normalize_axis(n + o - w), 3)
            for n, o, w in zip(now.rotation_deg, operation.rotation_deg, was.rotation_deg, strict=True)
        )
        changes["rotation_deg"] = (x, y, z)
    if operation.scale is not None:
        x, y, z = (round(n * o / w, 2) for n, o, w in zip(now.scale, operation.scale, was.scale, strict=True))
        changes["scale"] = (x, y, z)
    return operation.model_copy(update=changes)
