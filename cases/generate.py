"""Repair cases made from a source scene by chance: which actors, which changes, which views, all from one seed.

Only actors that stand and fit in the original are changed, so that a perfect repair can score fully: a thing that hangs
in the air or sinks into another in the scene as its makers left it would cost points that nobody can win. What is too
large to be left askew in the original (``cases.natural``) keeps right angles, its size, and its grid.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from c4s.errors import BadInput
from c4s.records.level import Level, Vector
from c4s.records.pack import Pack
from cases.corruption import STATIC_MESH_ACTOR, Author, Corruption
from cases.model import GROUP_OF_KIND, CaseView, RepairCase, SourceScene, SuiteDefinition, difficulty_of
from cases.natural import LARGEST_CM
from cases.recipe import Kind
from cases.standing import losing, snapshot_of, unscored
from cases.views import orbit

KINDS: tuple[Kind, ...] = ("removal", "move", "rotate", "rescale", "insertion", "duplication", "replacement", "mirror")
TRIES = 6
"""So many cases are made for each that is wanted: some lose points of their own, some can be guessed."""
LIKE, SMALL_CM = (0.4, 1.6), 120.0
"""What takes a thing's place or is put beside it is about as large: this many times, or small."""
MIN_SIDE_CM, MAX_SHARE = 15.0, 0.34
"""Changed things are at least this large, and at most this share of the scene in plan: no crumbs, no floors."""
MIN_DISTANCE_CM, REACH = 220.0, 2.6
"""A view stands this many times the radius of what changed away, at least this far."""


@dataclass(frozen=True)
class MeshShape:
    """A mesh that may be put into a scene: its lowest point about its pivot, and its longest side (cm)."""

    bottom_cm: float
    side_cm: float


@dataclass(frozen=True)
class SoundThing:
    """An actor that may be changed: name, middle and half extent of its box (cm), its mesh."""

    name: str
    origin: Vector
    extent: Vector
    mesh: str


def generated(
    scene_id: str,
    level: Level,
    things: Sequence[SoundThing],
    packs_root: Path,
    packs: Sequence[str],
    *,
    count: int,
    changes: int,
    seed: int,
    environment: Literal["indoor", "outdoor"] = "indoor",
) -> SuiteDefinition:
    """A suite of ``count`` repair cases of 1 to ``changes`` changes each (the first has one, the next two, and so on).

    ``TRIES`` as many are made, of which the suite keeps the first good ones.

    Args:
        scene_id: name of the scene; the suite has the same id with ``-cases`` behind it.
        level: the original.
        things: the actors that may be changed (``sound_things``).
        packs_root: where the packs lie.
        packs: ids of the packs that hold the scene's assets.
        count: number of cases.
        changes: most changes of a case.
        seed: same scene, same seed, same cases.
        environment: decides the setting and the budget.

    Raises:
        BadInput: too few actors stand and fit for what is asked.
    """
    if len(things) < changes + 1:
        raise BadInput(
            f"{len(things)} actors of this scene stand and fit; {changes + 1} are needed",
            where=scene_id,
            todo="give fewer --changes",
        )
    meshes = {
        asset.path: MeshShape(asset.bounds_min_cm[2], 100 * max(asset.size_m))
        for pack in packs
        for asset in Pack.read(packs_root / pack / "pack.json").assets
        if asset.kind == "static_mesh" and min(asset.size_m) > MIN_SIDE_CM / 100
    }
    author, chance = Author(level, scene_id), random.Random(f"{scene_id}|{seed}")
    scene = SourceScene(scene_id, environment, scene_id.replace("-", " ").capitalize(), level, tuple(packs))
    made = (
        _case(number, scene, author, things, meshes, 1 + (number % changes), chance) for number in range(TRIES * count)
    )
    cases = [case for case in made if case is not None]
    if not cases:
        raise BadInput("no actor can take a change", where=scene_id, todo="give another --seed")
    return SuiteDefinition(
        f"{scene_id}-cases",
        f"Repairs of {scene_id}",
        f"Changes made by chance, seed {seed}.",
        tuple(packs),
        (scene,),
        tuple(cases),
        most=count,
    )


def sound_things(level: Level, packs: Sequence[Path]) -> list[SoundThing]:
    """Static mesh actors of a handy size that are solid, are supported and sink into nothing, by name.

    Raises ``MachineryFault`` when the engine cannot export the scene.
    """
    snapshot = snapshot_of(level, packs)
    bad = losing(snapshot) | unscored(snapshot)
    known = {actor.name: actor for actor in level.actors if actor.class_path == STATIC_MESH_ACTOR}
    boxes = {
        actor["name"]: (actor["bounds"]["origin_cm"], actor["bounds"]["extent_cm"], actor.get("label"))
        for actor in snapshot["actors"]
        if actor["name"] in known
    }
    corners = np.array([[np.subtract(origin, extent), np.add(origin, extent)] for origin, extent, _ in boxes.values()])
    whole = corners[:, 1].max(axis=0) - corners[:, 0].min(axis=0) if len(corners) else np.zeros(3)
    found = []
    for name, (origin, extent, label) in sorted(boxes.items()):
        mesh = next((component.static_mesh for component in known[name].components if component.static_mesh), None)
        small = 2 * max(extent) >= MIN_SIDE_CM and all(2 * extent[i] <= MAX_SHARE * whole[i] for i in (0, 1))
        if mesh and small and name not in bad and label not in bad:
            found.append(SoundThing(name, tuple(origin), tuple(extent), mesh))
    return found


def _case(
    number: int,
    scene: SourceScene,
    author: Author,
    things: Sequence[SoundThing],
    meshes: Mapping[str, MeshShape],
    changes: int,
    chance: random.Random,
) -> RepairCase | None:
    made: list[Corruption] = []
    places: list[SoundThing] = []
    removed: set[str] = set()
    added: set[str] = set()
    left = chance.sample(things, len(things))
    kinds = [KINDS[(number + step) % len(KINDS)] for step in range(changes)]
    for kind in kinds:
        for thing in list(left):
            change = _change(kind, thing, author, meshes, chance, removed, added)
            if change is not None:
                left.remove(thing)
                made.append(change)
                places.append(thing)
                break
    if not made:
        return None
    names = "-".join(dict.fromkeys(change.kind for change in made))
    return RepairCase(
        f"{scene.scene_id}-{number + 1:02d}-{names}",
        scene.scene_id,
        f"{len(made)} change{'s' if len(made) > 1 else ''}",
        made,
        GROUP_OF_KIND[made[0].kind],
        difficulty_of(len(made)),
        views_of(places, 1 if scene.environment == "outdoor" else 2),
        "image-to-scene/indoor" if scene.environment == "indoor" else "image-to-scene/outdoor",
    )


def _change(
    kind: Kind,
    thing: SoundThing,
    author: Author,
    meshes: Mapping[str, MeshShape],
    chance: random.Random,
    removed: set[str],
    added: set[str],
) -> Corruption | None:
    """One change of a thing, or ``None`` where it would not be one or would spoil another."""
    name, (x, y, z), (wide, deep, high) = thing.name, thing.origin, thing.extent
    far = chance.uniform(2.0, 3.2)
    aside = (max(40.0, far * wide) * chance.choice((-1, 1)), max(40.0, far * deep) * chance.choice((-1, 0, 1)))
    large = 2 * max(thing.extent) > LARGEST_CM
    if large:
        aside = (2 * wide * chance.choice((-2, -1, 1, 2)), 2 * deep * chance.choice((-2, -1, 0, 1, 2)))
    bottom = z - high
    near = (max(LIKE[0] * 2 * max(thing.extent), MIN_SIDE_CM), max(LIKE[1] * 2 * max(thing.extent), SMALL_CM))
    others = [
        mesh
        for mesh, shape in meshes.items()
        if mesh != thing.mesh and mesh not in removed and near[0] <= shape.side_cm <= near[1]
    ]
    match kind:
        case "removal":
            if thing.mesh in added:
                return None
            removed.add(thing.mesh)
            return author.removal(name)
        case "move":
            return author.move(name, by_cm=(round(aside[0], 1), round(aside[1], 1), 0.0))
        case "rotate":
            turn = (
                chance.choice((-90.0, 90.0, 180.0)) if large else chance.choice((-1, 1)) * chance.uniform(30.0, 140.0)
            )
            return author.rotate(name, round(turn, 2))
        case "rescale":
            if large:
                return None
            return author.rescale(
                name, round(chance.choice((chance.uniform(0.58, 0.75), chance.uniform(1.3, 1.65))), 3)
            )
        case "mirror":
            return author.mirror(name, "x")
        case "replacement":
            return author.replacement(name, chance.choice(others)) if others else None
        case "insertion":
            if not others:
                return None
            added.add(mesh := chance.choice(others))
            return author.insertion(
                mesh, (round(x + aside[0], 1), round(y + aside[1], 1), round(bottom - meshes[mesh].bottom_cm, 3))
            )
        case "duplication":
            if thing.mesh in removed:
                return None
            added.add(thing.mesh)
            px, py, pz = author.actor(name).transform.location_cm
            return author.duplication(name, (round(px + aside[0], 1), round(py + aside[1], 1), pz))


def views_of(places: Sequence[SoundThing], count: int) -> list[CaseView]:
    """One view, or two from opposite sides, above all that changed."""
    low = np.min([np.subtract(thing.origin, thing.extent) for thing in places], axis=0)
    high = np.max([np.add(thing.origin, thing.extent) for thing in places], axis=0)
    x, y, z = (float(round(value, 1)) for value in (low + high) / 2)
    distance = round(max(MIN_DISTANCE_CM, REACH * float(np.linalg.norm(high - low)) / 2 + 100), 1)
    return [
        orbit("view-01", (x, y, z), distance_cm=distance, yaw_deg=-60, pitch_deg=42),
        orbit("view-02", (x, y, z), distance_cm=distance, yaw_deg=125, pitch_deg=52),
    ][:count]
