"""The walkable space against Recast: agreement in random scenes, and time on a 200 m plate and in a city.

``python -m bench.navigation [--scenes N]`` prints one JSON object. Recast (``bench.recast``) is given the same convex
bodies, solid inside, in the same field. Times are of the processor, and both use one. Recast's is told up to its
regions, which is what we have, and with contours and polygons, which is what answers questions there.
"""

from __future__ import annotations

import argparse
import json
import resource
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from bench.contacts import city
from bench.recast import recast_cells
from bench.row import Row
from c4s.collision import scene_bodies
from c4s.collision.shapes import Body, box_body
from c4s.navigation import NavigationSettings, WalkableSpace, build_space
from c4s.navigation.solids import solids_of

SEED = 19
SETTINGS = NavigationSettings()
LIFT_CM = 1.7
"""Scenes are lifted off the multiples of the cell height, where Recast's single precision decides by chance."""
PLATE_CM = 20_000.0


@dataclass(frozen=True)
class SceneAgreement:
    """One scene in both."""

    cells: int
    cells_off: int
    """Cells that only one of the two has."""
    area_off: float
    """Share by which our area differs."""
    components: int
    same_components: bool
    """Whether cells that both have are together in one exactly when they are in the other."""


def random_bodies(rng: np.random.Generator) -> list[Body]:
    """A plate with walls, crates, slabs, stairs and turned blocks at random."""
    side = float(rng.uniform(600, 1400))
    bodies = [box_body(np.array([-side, -side, -20.0]), np.array([side, side, 0.0]))]
    snapshot, _ = city(int(rng.integers(5, 25)), seed=int(rng.integers(1 << 30)))
    for body in scene_bodies(snapshot).bodies:
        place = np.array([*rng.uniform(-side, side, 2), rng.uniform(0, 150)])
        bodies.append(body.moved(place - body.translation))
    for _ in range(int(rng.integers(3, 12))):
        middle, along = rng.uniform(-side, side, 2), int(rng.integers(2))
        half = np.array([10.0, rng.uniform(100, side)])[:: 1 if along else -1]
        bodies.append(_box(middle, half, 0.0, float(rng.uniform(20, 300))))
    for _ in range(int(rng.integers(0, 4))):
        bottom = float(rng.uniform(60, 320))
        bodies.append(_box(rng.uniform(-side, side, 2), rng.uniform(100, 500, 2), bottom, bottom + 20))
    rise, start = float(rng.uniform(15, 45)), rng.uniform(-side / 2, side / 2, 2)
    bodies += [
        _box(start + np.array([n * 50, 0]), np.array([25.0, 150.0]), 0.0, (n + 1) * rise)
        for n in range(int(rng.integers(0, 8)))
    ]
    return lifted(bodies)


def lifted(bodies: Sequence[Body]) -> list[Body]:
    """The same bodies, a little higher."""
    return [body.moved(np.array([0.0, 0.0, LIFT_CM])) for body in bodies]


def _box(middle: np.ndarray, half: np.ndarray, bottom: float, top: float) -> Body:
    return box_body(np.array([*(middle - half), bottom]), np.array([*(middle + half), top]))


def plate_bodies(obstacles: int = 1500) -> list[Body]:
    """A plate of 200 m with boxes on it."""
    rng = np.random.default_rng(SEED)
    half = PLATE_CM / 2
    bodies = [box_body(np.array([-half, -half, -20.0]), np.array([half, half, 0.0]))]
    for _ in range(obstacles):
        middle, size = rng.uniform(200 - half, half - 200, 2), rng.uniform(30, 250, 3)
        bodies.append(_box(middle, size[:2], 0.0, float(size[2]) * 2))
    return lifted(bodies)


def city_bodies(actors: int) -> list[Body]:
    """The crowded city of ``bench.contacts``, three times as wide, on a plate."""
    snapshot, _ = city(actors)
    bodies = [body.moved(2 * body.translation * [1, 1, 0]) for body in scene_bodies(snapshot).bodies]
    low, high = bounds_of(bodies)
    plate = box_body(np.array([*low[:2] - 500, low[2] - 20]), np.array([*high[:2] + 500, (low[2] + high[2]) / 2]))
    return lifted([plate, *bodies])


def bounds_of(bodies: Sequence[Body]) -> tuple[np.ndarray, np.ndarray]:
    """The box of all bodies."""
    return np.min([body.low for body in bodies], axis=0), np.max([body.high for body in bodies], axis=0)


def compare(bodies: Sequence[Body]) -> SceneAgreement:
    """Both on one scene."""
    space = build_space(bodies, bounds_of(bodies), SETTINGS)
    theirs = recast_cells(bodies, space, SETTINGS)
    spans = np.flatnonzero(space.region >= 0)
    ours = _places(space.columns_of_spans()[spans], space.floor[spans])
    other = _places(theirs.row.astype(np.int64) * space.columns + theirs.column, theirs.floor)
    both, mine, its = np.intersect1d(ours, other, assume_unique=True, return_indices=True)
    pairs = np.unique(np.column_stack([space.region[spans][mine], theirs.component[its]]), axis=0)
    one_to_one = all(len(np.unique(side)) == len(pairs) for side in pairs.T)
    return SceneAgreement(
        cells=len(ours),
        cells_off=len(ours) + len(other) - 2 * len(both),
        area_off=abs(len(ours) - len(other)) / max(len(other), 1),
        components=len(space.sizes),
        same_components=one_to_one and len(space.sizes) == len(np.unique(theirs.component)),
    )


def _places(column: Any, floor: Any) -> Any:
    """A number a cell: its column, and its place among the floors there from the lowest."""
    order = np.lexsort((floor, column))
    sorted_ = column[order]
    begins = np.flatnonzero(np.concatenate([[True], sorted_[1:] != sorted_[:-1]])) if len(order) else order
    place = np.empty(len(order), np.int64)
    place[order] = np.arange(len(order)) - np.repeat(begins, np.diff([*begins, len(order)]))
    return column.astype(np.int64) * 64 + place


def measure(name: str, bodies: Sequence[Body], rounds: int = 3) -> dict[str, Any]:
    """Time and area of one large scene in both, the best of some rounds in turn."""
    bounds = bounds_of(bodies)
    ours: list[float] = []
    theirs: list[tuple[float, float]] = []
    space: WalkableSpace = build_space(bodies, bounds, SETTINGS)
    area = 0.0
    for _ in range(rounds):
        begun = time.process_time()
        space = build_space(bodies, bounds, SETTINGS)
        ours.append(time.process_time() - begun)
        found = recast_cells(bodies, space, SETTINGS)
        theirs.append((found.voxels_s, found.whole_s))
        area = found.polygons_m2
    return {
        "scene": name,
        "bodies": len(bodies),
        "triangles": len(solids_of(bodies).triangles),
        "columns": space.columns * space.rows,
        "ours_s": round(min(ours), 3),
        "recast_regions_s": round(min(one for one, _ in theirs), 3),
        "recast_whole_s": round(min(whole for _, whole in theirs), 3),
        "ours_m2": round(space.area_m2, 1),
        "recast_m2": round(area, 1),
        "components": len(space.sizes),
    }


def report(scenes: int = 200, actors: int = 6700) -> dict[str, Any]:
    """The whole comparison."""
    rng = np.random.default_rng(SEED)
    agreements = [compare(random_bodies(rng)) for _ in range(scenes)]
    worst = max(agreements, key=lambda one: one.area_off)
    return {
        "scenes": scenes,
        "same_components": sum(one.same_components for one in agreements),
        "same_cells": sum(one.cells_off == 0 for one in agreements),
        "worst_area_off": round(worst.area_off, 5),
        "worst": asdict(worst),
        "timed": [measure("plate", plate_bodies()), measure("city", city_bodies(actors))],
        "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024,
    }


def rows() -> list[Row]:
    """Rows for ``python -m bench``."""
    found = report(scenes=50)
    return [
        Row(
            name=f"walkable space, {one['scene']}",
            ours=one["ours_s"],
            goal="at most 2x Recast, area within 3 %",
            met=one["ours_s"] <= 2 * one["recast_whole_s"] and abs(one["ours_m2"] / one["recast_m2"] - 1) <= 0.03,
            rival="Recast",
            theirs=one["recast_whole_s"],
            ratio=one["recast_whole_s"] / one["ours_s"],
        )
        for one in found["timed"]
    ]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--actors", type=int, default=6700)
    given = parser.parse_args()
    print(json.dumps(report(given.scenes, given.actors), indent=1))
