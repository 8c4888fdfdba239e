"""Tricks by what stands beside what: rows with a hole, things out of a row, strangers, things that sink or hover."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from c4s.agents.baselines.blind.guess import Guess
from c4s.agents.baselines.blind.scene import SeenActor, SeenLevel, Vector

IN_ROW_CM, STAND_CM = 3.0, 5.0
LARGE_CM = 1000.0


def rows(scene: SeenLevel) -> Iterator[Guess]:
    """Equal things at equal distances: fill the one hole, or put there the one of its like that stands out of line."""
    holes = []
    for things in scene.of_mesh.values():
        if 3 <= len(things) <= 60:
            holes += [(row, place, things) for row, place in _holes(things)]
    for row, place, things in holes:
        model = row[0]
        outside = [t for t in things if t not in row and t.rotation == model.rotation and t.scale == model.scale]
        for thing in outside:
            yield Guess(thing.name, "place", "out of a row", 0.4 / (len(holes) * len(outside)), location=place)
        yield Guess(model.name, "copy", "a hole in a row", 0.5 / len(holes), location=place)


def _holes(things: Sequence[SeenActor]) -> Iterator[tuple[list[SeenActor], Vector]]:
    """Rows along one axis of at least three things at equal steps but one of two, with the place between."""
    for axis in (0, 1):
        lines: dict[tuple[float, float], list[SeenActor]] = {}
        for thing in things:
            across, up = thing.location[1 - axis], thing.location[2]
            key = (round(across / IN_ROW_CM), round(up / IN_ROW_CM))
            lines.setdefault(key, []).append(thing)
        for line in lines.values():
            line = sorted(line, key=lambda t: t.location[axis])
            steps = [b.location[axis] - a.location[axis] for a, b in pairwise(line)]
            if len(line) < 3:
                continue
            step = min(steps)
            odd = [i for i, s in enumerate(steps) if abs(s - step) > IN_ROW_CM]
            if step > IN_ROW_CM and len(odd) == 1 and abs(steps[odd[0]] - 2 * step) <= 2 * IN_ROW_CM:
                a, b = line[odd[0]].location, line[odd[0] + 1].location
                yield line, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2)


def strangers(scene: SeenLevel) -> Iterator[Guess]:
    """A thing that is alone of its mesh among neighbours of another kind."""
    odd = [
        thing
        for row, thing in enumerate(scene.things)
        if len(scene.of_mesh[thing.mesh]) == 1
        and thing.side_cm < LARGE_CM
        and all(other.category != thing.category for other in scene.nearest(row, 8))
    ]
    for thing in odd:
        yield Guess(thing.name, "delete", "alone of its kind", 0.6 / (1 + len(odd)))


def hovering(scene: SeenLevel) -> Iterator[Guess]:
    """A thing with nothing under it and nothing beside it: what it stood on may have been moved from below it."""
    odd = [row for row, thing in enumerate(scene.things) if thing.side_cm < LARGE_CM and not _touched(scene, row)]
    for row in odd:
        thing, low, high = scene.things[row], scene.low[row], scene.high[row]
        under = np.all((scene.low[:, :2] < high[:2]) & (scene.high[:, :2] > low[:2]), axis=1)
        under &= scene.high[:, 2] < low[2]
        drop = float(low[2] - scene.high[under, 2].max(initial=0.0))
        x, y, z = thing.location
        yield Guess(thing.name, "delete", "it hovers", 0.3 / len(odd))
        yield Guess(thing.name, "place", "it hovers", 0.3 / len(odd), location=(x, y, z - drop))


def sinking(scene: SeenLevel) -> Iterator[Guess]:
    """Two things of different meshes whose boxes share much: one of them was put there, grew, or was moved."""
    found: list[SeenActor] = []
    for row, thing in enumerate(scene.things):
        if thing.side_cm < LARGE_CM / 2:
            deep = [scene.things[i] for i in np.flatnonzero(scene.shared(row) > 0.3)]
            found += [thing for other in deep if other.mesh != thing.mesh and other.side_cm < LARGE_CM / 2]
    for thing in found:
        rare = 1 / len(scene.of_mesh[thing.mesh])
        yield Guess(thing.name, "delete", "it sinks into another", 0.5 * max(rare, 0.3) / len(found))


def _touched(scene: SeenLevel, row: int) -> bool:
    near = (scene.low < scene.high[row] + STAND_CM) & (scene.high > scene.low[row] - STAND_CM)
    return int(np.all(near, axis=1).sum()) > 1
