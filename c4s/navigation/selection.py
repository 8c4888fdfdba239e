"""Which routes are walked (paper, EU19, EU20, EU24)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from c4s.collision.mesh_body import Array
from c4s.navigation.mesh import NavigationMesh
from c4s.protocol.navigation import ANCHOR_CM, QUANTILES, SMALL_CM, SMALL_LENGTH, SMALL_ROUTES, arrival_radius_cm

MOST_PAIRED = 120
"""Objects of a small scene between which routes are sought; of more, this many at even steps."""


@dataclass(frozen=True)
class Route:
    """A planned way."""

    start: str
    goal: str
    points: Array
    length_cm: float


@dataclass(frozen=True)
class Selection:
    """Where walks start, and what is walked."""

    ground_cm: float | None = None
    anchor: Array | None = None
    small: bool = False
    routes: list[Route] = field(default_factory=list)


Named = Sequence[tuple[str, Array]]


def half_extent_cm(bounds: tuple[Array, Array]) -> float:
    """h: half of the shorter plan side of the mesh (E09)."""
    return float((bounds[1] - bounds[0])[:2].min()) / 2


def select(mesh: NavigationMesh, bounds: tuple[Array, Array], cells: Array, main: Array, reached: Named) -> Selection:
    """The anchor, and the routes to walk: from the anchor to targets at three quantiles of the way there, or in a small
    scene from object to object.

    Args:
        cells: lattice points of the mesh (n, 3).
        main: those of its largest component.
        reached: approachable targets by name, with the cell of each.
    """
    half = half_extent_cm(bounds)
    radius = arrival_radius_cm(half)
    ground = round(float(np.median(cells[:, 2])), 2)
    anchor = _anchor(main, ground)
    if half < SMALL_CM:
        return Selection(ground, anchor, True, _between(mesh, reached, SMALL_LENGTH * radius))
    return Selection(ground, anchor, False, [] if anchor is None else _outward(mesh, anchor, reached, radius))


def _anchor(main: Array, ground: float) -> Array | None:
    """The member of the largest component nearest its centroid in plan that is near the ground; None for none."""
    level = main[np.abs(main[:, 2] - ground) <= ANCHOR_CM]
    if not len(level):
        return None
    away = np.round(np.linalg.norm(level[:, :2] - main[:, :2].mean(axis=0), axis=1), 3)
    return np.asarray(level[np.lexsort((level[:, 2], level[:, 1], level[:, 0], away))[0]])


def _outward(mesh: NavigationMesh, anchor: Array, reached: Named, radius: float) -> list[Route]:
    """Three targets beyond the radius, at quantiles of the length of the way; fewer where there are fewer."""
    beyond = [(name, cell) for name, cell in reached if np.linalg.norm(cell - anchor) > radius]
    if not beyond:
        return []
    lengths = mesh.distances(anchor, np.array([cell for _, cell in beyond]))
    order = sorted(
        (float(length), *one[:1], index) for index, (length, one) in enumerate(zip(lengths, beyond, strict=True))
    )
    picked = dict.fromkeys(order[round(share * (len(order) - 1))][2] for share in QUANTILES)
    return [route for index in picked if (route := _planned(mesh, "", anchor, *beyond[index]))]


def _between(mesh: NavigationMesh, reached: Named, least: float) -> list[Route]:
    """Six routes between objects that are long enough, at even steps of their lengths; fewer where there are fewer."""
    ends = sorted(reached, key=lambda one: one[0])
    if len(ends) > MOST_PAIRED:
        ends = [ends[index] for index in np.linspace(0, len(ends) - 1, MOST_PAIRED).round().astype(int)]
    points = np.array([cell for _, cell in ends]).reshape(-1, 3)
    pairs: list[tuple[float, int, int]] = []
    for first in range(len(ends) - 1):
        lengths = mesh.distances(points[first], points[first + 1 :])
        pairs += [
            (float(length), first, first + 1 + other)
            for other, length in enumerate(lengths)
            if least <= length < np.inf
        ]
    pairs.sort()
    planned: dict[tuple[int, int], Route | None] = {}
    while pairs:
        steps = np.unique(np.linspace(0, len(pairs) - 1, min(SMALL_ROUTES, len(pairs))).round().astype(int))
        picked = [pairs[index][1:] for index in steps]
        for a, b in picked:
            if (a, b) not in planned:
                planned[a, b] = _planned(mesh, ends[a][0], ends[a][1], *ends[b])
        routes = [route for pair in picked if (route := planned[pair]) and route.length_cm >= least]
        if len(routes) == len(picked):
            return routes
        short = {pair for pair in picked if (route := planned[pair]) is None or route.length_cm < least}
        pairs = [one for one in pairs if one[1:] not in short]
    return []


def _planned(mesh: NavigationMesh, start: str, place: Array, goal: str, end: Array) -> Route | None:
    points = mesh.route(place, end)
    if points is None:
        return None
    return Route(start, goal, points, float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()))
