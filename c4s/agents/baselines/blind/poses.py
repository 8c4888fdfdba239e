"""Tricks by where things stand, how they are turned and how large they are."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

import numpy as np

from c4s.agents.baselines.blind.guess import Guess
from c4s.agents.baselines.blind.scene import SeenActor, SeenLevel, Vector

SAME, STEP_DEG = 0.01, 15.0
FEW = 3
FACTORS = (0.5, 0.55, 0.6, 0.7, 0.72, 0.8, 1.25, 1.3, 1.35, 1.4, 1.5, 1.6, 2.0)
"""By which recipes scale."""


def mirrored(scene: SeenLevel) -> Iterator[Guess]:
    """Negative scales."""
    found = [t for t in scene.things if min(t.scale) < 0]
    for thing in found:
        alike = scene.of_mesh[thing.mesh]
        alone = len(alike) > 1 and sum(min(t.scale) < 0 for t in alike) == 1
        x, y, z = map(abs, thing.scale)
        chance = (0.9 if alone else 0.7) / len(found)
        yield Guess(thing.name, "place", "a mirrored thing", chance, scale=(x, y, z))


def odd_sizes(scene: SeenLevel) -> Iterator[Guess]:
    """A scale that its like do not have, or one that is not 1 on a thing that is alone of its mesh."""
    one: Vector = (1.0, 1.0, 1.0)
    odd: list[tuple[SeenActor, Vector]] = []
    for things in scene.of_mesh.values():
        usual, count = Counter(t.scale for t in things).most_common(1)[0]
        if len(things) == 1:
            odd += [(t, one) for t in things if max(abs(abs(s) - 1) for s in t.scale) > SAME]
        elif count >= max(2, len(things) - 1):
            odd += [(t, usual) for t in things if t.scale != usual]
    for thing, wanted in odd:
        far = max(abs(math.log(abs(s / w))) for s, w in zip(thing.scale, wanted, strict=True) if s and w)
        even = len({round(abs(s), 3) for s in thing.scale}) == 1
        chance = min(0.9, far * (1.2 if even else 0.6)) / math.sqrt(len(odd))
        yield Guess(thing.name, "place", "a size unlike its like", chance, scale=wanted)


def backwards(scene: SeenLevel) -> Iterator[Guess]:
    """A negative scale along the axis that things look along: turn it back."""
    found = [t for t in scene.things if t.scale[1] < 0]
    for thing in found:
        x, y, z = thing.scale
        yield Guess(thing.name, "place", "turned inside out", 0.7 / len(found), scale=(x, -y, z))


def extreme_sizes(scene: SeenLevel) -> Iterator[Guess]:
    """The largest and the smallest of all: by a usual factor back towards the size of most."""
    sizes = sorted((math.prod(map(abs, t.scale)) ** (1 / 3), t.order) for t in scene.things if 0.0 not in t.scale)
    things = {thing.order: thing for thing in scene.things}
    for size, order in dict.fromkeys((*sizes[:FEW], *sizes[-FEW:])):
        thing = things[order]
        factor = min(FACTORS, key=lambda f: abs(math.log(size / f)))
        x, y, z = (value / factor for value in thing.scale)
        yield Guess(thing.name, "place", "an extreme size", 0.05 + 0.1 * abs(math.log(size)), scale=(x, y, z))


def odd_turns(scene: SeenLevel) -> Iterator[Guess]:
    """A yaw that is no multiple of 15 degrees, or another one than that of its like."""
    odd: list[tuple[SeenActor, float]] = []
    for things in scene.of_mesh.values():
        usual, count = Counter(round(t.rotation[1], 1) for t in things).most_common(1)[0]
        for thing in things:
            yaw = thing.rotation[1]
            if count >= max(2, len(things) - 1) and abs(yaw - usual) > 1:
                odd.append((thing, usual))
            elif abs(yaw / STEP_DEG - round(yaw / STEP_DEG)) > SAME:
                odd.append((thing, 90.0 * round(yaw / 90.0)))
    for thing, yaw in odd:
        pitch, _, roll = thing.rotation
        yield Guess(thing.name, "place", "a turn unlike its like", 0.7 / len(odd), rotation=(pitch, yaw, roll))


def round_numbers(scene: SeenLevel) -> Iterator[Guess]:
    """Places with fewer or more decimals than those of hardly any other thing."""
    counts = Counter(map(_decimals, scene.things))
    odd = [t for t in scene.things if counts[_decimals(t)] <= max(1, 0.02 * len(scene.things))]
    for thing in odd if len(odd) <= 3 else ():
        yield Guess(thing.name, "delete", "another number of decimals", 0.5 / len(odd))
    odd = [t for t in scene.things if _scale_decimals(t) > 2]
    for thing in odd if len(odd) <= 3 else ():
        yield Guess(thing.name, "place", "another number of decimals", 0.5 / len(odd), scale=(1.0, 1.0, 1.0))


def _decimals(thing: SeenActor) -> int:
    return max(len(f"{value:.6f}".rstrip("0").partition(".")[2]) for value in thing.location[:2])


def _scale_decimals(thing: SeenActor) -> int:
    return max(len(f"{value:.6f}".rstrip("0").partition(".")[2]) for value in thing.scale)


def copies(scene: SeenLevel) -> Iterator[Guess]:
    """Two of one mesh with the very same turn and an uneven or odd scale, or one inside the other."""
    pairs = []
    for things in scene.of_mesh.values():
        seen: dict[Vector, SeenActor] = {}
        for thing in things:
            pose = thing.scale
            special = max(abs(abs(s) - 1) for s in thing.scale) > SAME
            if special and pose in seen:
                pairs.append((thing, seen[pose]))
            seen.setdefault(pose, thing)
    for row, thing in enumerate(scene.things):
        inside = [scene.things[i] for i in np.flatnonzero(scene.shared(row)[:row] > 0.5)]
        pairs += [(thing, other) for other in inside if other.mesh == thing.mesh]
    for pair in pairs:
        for thing in pair:
            yield Guess(thing.name, "delete", "a copy", 0.8 / (2 * len(pairs)))
