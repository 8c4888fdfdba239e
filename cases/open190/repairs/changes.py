"""What may be changed in a scene, and single changes of it: each leaves things standing, and none meets another."""

from __future__ import annotations

import math
import random
from collections import defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from c4s.geometry.transform import normalize_axis
from c4s.packs.store import PackStore
from c4s.records.level import Level, LevelActor, Transform, Vector
from cases.admissible import unfit
from cases.boxes import Array, Boxes, world_box
from cases.corruption import STATIC_MESH_ACTOR, Author, Corruption, compound, id_of
from cases.generate import SoundThing
from cases.natural import DIGITS, LARGEST_CM, NOT_PARTED, Parted, StandingBoxes, uneven
from cases.open190.layout import Relation
from cases.recipe import Kind
from cases.standing import losing, unscored

SMALLEST_CM, LARGEST_SIDE_CM = 9.0, 900.0
"""Longest side of what is changed."""
SPOTS = 14
"""Places that are tried for what is moved or added."""
LIKE = (0.55, 1.7)
"""By this a thing that takes another's place is larger or smaller, on each axis."""
LOPSIDED = 0.03
"""Mean way (of the size) from a shape's points to the mirrored or turned shape: what has less is symmetrical."""
SAMPLED = 1500
PATTERN_CM, LEVEL_WEIGHT = 500.0, 40.0
"""Like things so near to each other make a pattern; a difference of height counts so many times."""
Inside = Callable[[Vector], bool]
"""Whether a place can be seen."""


@dataclass
class Changeable:
    """A scene whose things can be changed, one change after the other.

    ``snapshot`` is of ``level``; ``relations`` tell how things were put.
    """

    level: Level
    scene_id: str
    snapshot: Mapping[str, Any]
    boxes: Boxes
    store: PackStore
    relations: Sequence[Relation]
    parted: Parted = field(default_factory=lambda: NOT_PARTED)
    left_alone: Collection[str] = ()
    """Names of what is never changed."""
    placed: StandingBoxes = field(init=False)
    things: dict[str, SoundThing] = field(init=False)
    """What may be changed, by name: it stands, fits, carries nothing and is no part of a building."""
    mates: dict[str, list[str]] = field(init=False)
    """The others that were put with a thing: around a table, in a row, in a grid."""
    alike: set[str] = field(init=False)
    """What stands near enough to two others of its look at one height to make a pattern with them."""
    related: set[str] = field(init=False)
    """What stands in a relation to another thing."""

    def __post_init__(self) -> None:
        self.rows = {actor.name: row for row, actor in enumerate(self.level.actors)}
        self.actors = {actor.name: actor for actor in self.level.actors}
        self.placed = StandingBoxes.of(self.level.actors, self.boxes, self.parted)
        self.things = self._things()
        groups: dict[tuple[str, str], list[str]] = defaultdict(list)
        mesh = {name: thing.mesh for name, thing in self.things.items()}
        for relation in self.relations:
            if relation.kind in ("around", "in_row", "in_grid") and relation.subject in mesh:
                groups[relation.reference, mesh[relation.subject]].append(relation.subject)
        self.mates = {
            name: sorted(set(group) - {name}, key=lambda other: (self._far(name, other), other))
            for group in groups.values()
            for name in group
            if len(set(group)) > 1
        }
        self.related = {relation.subject for relation in self.relations}
        self.alike = self._among_their_like()
        self.ids = {actor.name: id_of(actor) or "" for actor in self.level.actors}
        self._symmetry: dict[tuple[str, str], float] = {}

    def author(self) -> Author:
        """A new author of changes of this scene."""
        return Author(self.level, self.scene_id)

    @cached_property
    def meshes(self) -> list[str]:
        """What can be put beside, or in the place of, a thing."""
        return sorted({thing.mesh for thing in self.things.values()})

    def _far(self, one: str, other: str) -> float:
        return math.dist(self.things[one].origin, self.things[other].origin)

    def _things(self) -> dict[str, SoundThing]:
        snapshot = dict(self.snapshot)
        bad = losing(snapshot, self.store) | unscored(snapshot) | {*self.left_alone}
        simple = [
            actor
            for actor in self.level.actors
            if actor.class_path == STATIC_MESH_ACTOR and len(actor.components) == 1 and actor.name not in bad
        ]
        no_target = unfit(simple, snapshot)
        found = {}
        for actor in simple:
            low, high = (side[self.rows[actor.name]] for side in (self.placed.low, self.placed.high))
            mesh = actor.components[0].static_mesh
            side = float((high - low).max())
            if not mesh or actor.name in no_target or not SMALLEST_CM <= side <= LARGEST_SIDE_CM:
                continue
            if not self.placed.carried(self.rows[actor.name]):
                middle, half = (low + high) / 2, (high - low) / 2
                found[actor.name] = SoundThing(actor.name, _vector(middle), _vector(half), mesh)
        return found

    def _among_their_like(self) -> set[str]:
        looks: dict[str, list[SoundThing]] = defaultdict(list)
        for thing in self.things.values():
            looks[thing.mesh].append(thing)
        found = set()
        for like in looks.values():
            places = np.array([[*thing.origin[:2], LEVEL_WEIGHT * thing.origin[2]] for thing in like])
            near = cKDTree(places).query_ball_point(places, PATTERN_CM)
            found |= {thing.name for thing, others in zip(like, near, strict=True) if len(others) > 2}
        return found

    # what a change needs

    def fits(self, name: str, now: Transform, mesh: str | None = None) -> bool:
        """Whether a thing that is changed so stands, and meets nothing that it did not meet before."""
        row = self.rows[name]
        before = self.placed.beside(row, self.placed.low[row], self.placed.high[row], 0.0)
        low, high = self._box(self.actors[name], now, mesh)
        met = np.logical_and(self.placed.beside(row, low, high, 0.0), np.logical_not(before))
        return not bool(met.any()) and self.placed.held(row, low, high)

    def free(self, low: Array, high: Array) -> bool:
        """Whether a box stands on something and meets nothing."""
        if ((self.placed.low < high - 0.5) & (self.placed.high > low + 0.5)).all(axis=1).any():
            return False
        return self.placed.held(None, low, high)

    def _box(self, actor: LevelActor, now: Transform, mesh: str | None = None) -> tuple[Array, Array]:
        if mesh is not None:
            part = actor.components[0].model_copy(update={"static_mesh": mesh})
            actor = actor.model_copy(update={"components": [part]})
        return world_box(actor, now, self.boxes)

    def lopsided(self, mesh: str, axis: str, angle_deg: float = 0.0) -> float:
        """How far a mesh is from its mirror image across ``x``, or from itself turned by an angle (``turn``)."""
        key = (mesh, axis if axis == "x" else f"{round(angle_deg / 5) * 5}")
        if key not in self._symmetry:
            facts = self.snapshot["c4s"]["meshes"].get(mesh) or {}
            loaded = self.store.recorded_mesh(mesh, facts)
            self._symmetry[key] = 0.0 if loaded is None else _lopsided(loaded.vertices, axis, angle_deg)
        return self._symmetry[key]

    # the changes

    def change(self, kind: Kind, name: str, author: Author, chance: random.Random, inside: Inside) -> Corruption | None:
        """A change of a thing, or beside it; None where it would not be one, or where there is no room."""
        match kind:
            case "removal":
                return author.removal(name)
            case "move":
                return self._move(name, author, chance, inside)
            case "rotate":
                return self._rotate(name, author, chance)
            case "rescale":
                return self._rescale(name, author, chance)
            case "mirror":
                return self._mirror(name, author)
            case "replacement":
                return self._replacement(name, author, chance)
            case "insertion":
                return self._added(name, chance.choice(self.meshes), author, chance, inside)
            case "duplication":
                return self._added(name, None, author, chance, inside)

    def _spots(self, name: str, chance: random.Random) -> list[tuple[float, float]]:
        """Steps (cm) away from a thing, the nearer ones first."""
        wide, deep, _ = self.things[name].extent
        size = 2 * max(wide, deep)
        steps = []
        for number in range(SPOTS):
            reach = max(18.0, size * chance.uniform(0.9, 1.5 + 0.2 * number))
            turn = chance.uniform(0, 2 * math.pi)
            steps.append((reach * math.cos(turn), reach * math.sin(turn)))
        return steps

    def _move(self, name: str, author: Author, chance: random.Random, inside: Inside) -> Corruption | None:
        now = self.actors[name].transform
        x, y, z = self.things[name].origin
        for dx, dy in self._spots(name, chance):
            step = (round(dx, DIGITS), round(dy, DIGITS), 0.0)
            place = now.model_copy(update={"location_cm": _vector(np.add(now.location_cm, step))})
            if inside((x + dx, y + dy, z)) and self.fits(name, place):
                return author.move(name, to_cm=place.location_cm)
        return None

    def _rotate(self, name: str, author: Author, chance: random.Random) -> Corruption | None:
        now, thing = self.actors[name].transform, self.things[name]
        for _ in range(5):
            turn = chance.choice((-1, 1)) * chance.uniform(28.0, 160.0)
            if 2 * max(thing.extent) > LARGEST_CM:
                turn = chance.choice((-90.0, 90.0, 180.0))
            pitch, yaw, roll = now.rotation_deg
            place = now.model_copy(update={"rotation_deg": (pitch, round(normalize_axis(yaw + turn), DIGITS), roll)})
            if self.lopsided(thing.mesh, "turn", turn) >= LOPSIDED and self.fits(name, place):
                return author.rotate(name, round(turn, DIGITS))
        return None

    def _rescale(self, name: str, author: Author, chance: random.Random) -> Corruption | None:
        now = self.actors[name].transform
        if now.scale == (1.0, 1.0, 1.0) or abs(self.boxes[self.things[name].mesh][0][2]) > 0.5:
            return None
        for _ in range(4):
            factor = round(chance.choice((chance.uniform(0.55, 0.74), chance.uniform(1.34, 1.75))), DIGITS)
            x, y, z = (round(side * factor, DIGITS) for side in now.scale)
            if self.fits(name, now.model_copy(update={"scale": (x, y, z)})):
                return author.rescale(name, factor)
        return None

    def _mirror(self, name: str, author: Author) -> Corruption | None:
        now, mesh = self.actors[name].transform, self.things[name].mesh
        x, y, z = now.scale
        if x > 0 or self.lopsided(mesh, "x") < LOPSIDED:
            return None
        return author.mirror(name, "x") if self.fits(name, now.model_copy(update={"scale": (-x, y, z)})) else None

    def _replacement(self, name: str, author: Author, chance: random.Random) -> Corruption | None:
        mesh = self.things[name].mesh
        others = [other for other in self.meshes if other != mesh and self._alike(mesh, other)]
        chance.shuffle(others)
        for other in others[:6]:
            if self.fits(name, self.actors[name].transform, other):
                return author.replacement(name, other)
        return None

    def _alike(self, mesh: str, other: str) -> bool:
        (low, high), (under, over) = self.boxes[mesh], self.boxes[other]
        sizes = np.subtract(over, under) / np.maximum(1.0, np.subtract(high, low))
        return abs(low[2] - under[2]) < 0.5 and LIKE[0] <= sizes.min() and sizes.max() <= LIKE[1]

    def _added(
        self, name: str, mesh: str | None, author: Author, chance: random.Random, inside: Inside
    ) -> Corruption | None:
        """A thing beside another: one of the same look where no mesh is given."""
        model, thing = self.actors[name], self.things[name]
        shown = mesh or thing.mesh
        if mesh is not None and (mesh == thing.mesh or not self._may_join(thing, mesh)):
            return None
        scale = uneven((1.0, 1.0, 1.0), 1.0, chance, 1.3) if chance.random() < 0.7 else (1.0, 1.0, 1.0)
        yaw = round(model.transform.rotation_deg[1] + chance.choice((0.0, chance.uniform(-150, 150))), DIGITS)
        bottom = float(self.placed.low[self.rows[name]][2]) - self.boxes[shown][0][2] * scale[2]
        x, y, z = thing.origin
        for dx, dy in self._spots(name, chance):
            spot = (round(x + dx, DIGITS), round(y + dy, DIGITS), round(bottom, DIGITS))
            place = Transform(location_cm=spot, rotation_deg=(0.0, normalize_axis(yaw), 0.0), scale=scale)
            if inside((x + dx, y + dy, z)) and self.free(*self._box(model, place, shown)):
                return _spawned(author, name if mesh is None else None, shown, place)
        return None

    def _may_join(self, thing: SoundThing, mesh: str) -> bool:
        """Whether a mesh is about as large as what it is put beside."""
        low, high = self.boxes[mesh]
        side = float(np.subtract(high, low).max())
        return 0.4 <= side / (2 * max(thing.extent)) <= 1.8


def _spawned(author: Author, like: str | None, mesh: str, place: Transform) -> Corruption:
    """An insertion, or a duplication of an actor, at a place with its own turn and size."""
    made = (
        author.insertion(mesh, place.location_cm)
        if like is None
        else author.duplication(like, place.location_cm, yaw_deg=place.rotation_deg[1])
    )
    operation = made.operations[0].model_copy(update={"rotation_deg": place.rotation_deg, "scale": place.scale})
    return Corruption(made.kind, (operation,))


def joined(kind: Kind, changes: Sequence[Corruption]) -> Corruption:
    """Some changes as one entry of the chain."""
    return changes[0] if len(changes) == 1 else compound(kind, *changes)


def _vector(values: Collection[float] | Array) -> Vector:
    x, y, z = (round(float(value), DIGITS) for value in values)
    return x, y, z


def _lopsided(vertices: Any, axis: str, angle_deg: float) -> float:
    """Mean way of a shape's points to the shape mirrored across x, or turned, as a share of its size."""
    points = np.asarray(vertices, dtype=np.float64)
    size = float(np.ptp(points, axis=0).max()) or 1.0
    some = points[:: max(1, len(points) // SAMPLED)]
    if axis == "x":
        other = some * [-1, 1, 1]
    else:
        c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
        other = some @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return float(cKDTree(points).query(other)[0].mean()) / size
