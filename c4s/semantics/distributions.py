"""How many things are laid out in plan: rows, rings, grids, clusters. Lengths in cm, angles in degrees.

Each test says yes, no or, between its two limits, nothing: what is nearly a row has to be seen.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final, TypeAlias

import numpy as np

from c4s.semantics.inventory import Array, Thing

Layout: TypeAlias = Callable[[Sequence[Thing]], tuple[bool | None, str, float]]
"""Of at least three things: whether they are laid out so (None: unclear), what was measured, and its value."""

NEAR_CM = 300.0
ROW_SHARE, NO_ROW_SHARE = 0.15, 0.6
PARALLEL, NOT_PARALLEL = 0.7, 0.25
"""Concentration of the directions to the nearest neighbours, 0 (any) to 1 (one)."""
EVEN, UNEVEN = 0.35, 1.2
"""Coefficient of variation of the ways to the nearest neighbours."""
RING_VARIATION, RING_GAP_DEG = 0.3, 120.0
NO_SCATTER = 0.15
"""Up to this variation of its radii a ring is drawn, and not the rim of something that things are scattered around."""
_TIES = 6
"""Neighbours that are measured to find the nearest: on a grid several are equally near but for rounding."""


def plan_centres(things: Sequence[Thing]) -> Array:
    """Plan centres (n, 2) of things."""
    return np.array([thing.centre[:2] for thing in things]).reshape(-1, 2)


def angular_gap(points: Array, centre: Array) -> float:
    """The largest angle (degrees) seen from the centre that holds no point; 360 for fewer than two points."""
    offsets = points - centre
    offsets = offsets[np.hypot(offsets[:, 0], offsets[:, 1]) > 1e-6]
    if len(offsets) < 2:
        return 360.0
    angles = np.sort(np.degrees(np.arctan2(offsets[:, 1], offsets[:, 0])))
    return float(np.diff(np.append(angles, angles[0] + 360)).max())


def row_share(points: Array) -> float:
    """The spread of points across their line, as a share of that along it; 1 for points at one place."""
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return float(spread[1] / spread[0]) if spread[0] > 0 else 1.0


def nearest(points: Array) -> Array:
    """Distance of every point to its nearest other point."""
    places, inverse, count = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    ways = np.zeros(len(places))
    if len(places) > 1:
        from scipy.spatial import KDTree

        close = KDTree(places).query(places, k=min(_TIES, len(places)))[1]
        every = np.hypot(*(places[:, None] - places[close]).transpose(2, 0, 1))
        every[close == np.arange(len(places))[:, None]] = np.inf
        ways = every.min(axis=1)
    ways[count > 1] = 0.0
    return np.asarray(ways[inverse.ravel()])


def _concentration(points: Array, folds: int) -> float:
    """How much the directions to the nearest neighbours agree, up to a turn of 360 / ``folds`` degrees."""
    places = np.unique(points, axis=0)
    if len(places) < 3:
        return 0.0
    from scipy.spatial import KDTree

    close = KDTree(places).query(places, k=2)[1][:, 1]
    offsets = places[close] - places
    return float(np.abs(np.exp(1j * folds * np.arctan2(offsets[:, 1], offsets[:, 0])).mean()))


def _variation(values: Array) -> float:
    return float(values.std() / values.mean()) if values.mean() > 0 else math.inf


def _through_all(things: Sequence[Thing]) -> bool:
    """Whether one line, three times as long as the things reach aside of it, goes through the plans of nine in ten."""
    points = plan_centres(things)
    offsets = points - points.mean(axis=0)
    axes = np.linalg.svd(offsets, full_matrices=False)[2]
    along, aside = offsets @ axes[0], np.abs(offsets @ axes[1])
    half = np.array([(thing.high - thing.low)[:2] for thing in things]) / 2 @ np.abs(axes[1])
    return bool(np.mean(aside <= half) >= 0.9 and np.ptp(along) >= 3 * 2 * float(np.quantile(aside, 0.9)))


def row(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """On one line: the spread across is at most 15 % of that along, or a line goes through nearly all."""
    share = row_share(plan_centres(things))
    if share <= ROW_SHARE or _through_all(things):
        return True, "spread_share", share
    return (False if share > NO_ROW_SHARE else None), "spread_share", share


def rows(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """On one line or several parallel ones: nearest neighbours lie in one direction."""
    points = plan_centres(things)
    same = _concentration(points, 2)
    if same >= PARALLEL or row_share(points) <= ROW_SHARE:
        return True, "direction_concentration", same
    return (False if same < NOT_PARALLEL else None), "direction_concentration", same


def grid(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """In a grid: neighbours at like distances, in directions at right angles, not all on one line."""
    points = plan_centres(things)
    same, variation = _concentration(points, 4), _variation(nearest(points))
    if len(points) >= 4 and same >= PARALLEL and variation <= EVEN and row_share(points) > ROW_SHARE:
        return True, "direction_concentration", same
    return (False if same < NOT_PARALLEL or variation > UNEVEN else None), "direction_concentration", same


def regular(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """At like distances from each other."""
    variation = _variation(nearest(plan_centres(things)))
    return (True if variation <= EVEN else False if variation > UNEVEN else None), "distance_variation", variation


def ring(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """Four or more around an empty middle: radii vary by at most 30 %, no gap over 120 degrees."""
    points = plan_centres(things)
    centre = points.mean(axis=0)
    radii = np.hypot(*(points - centre).T)
    variation, gap = _variation(radii), angular_gap(points, centre)
    if len(points) >= 4 and variation <= RING_VARIATION and gap <= RING_GAP_DEG:
        return True, "radius_variation", variation
    return (False if gap > 180 else None), "radius_variation", min(variation, 1e6)


def cluster(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """Close together: the median way to the nearest is at most twice their plan size, or 3 m; no from thrice that."""
    way = float(np.median(nearest(plan_centres(things))))
    size = float(np.median([(thing.high - thing.low)[:2].max() for thing in things]))
    limit = max(2 * size, NEAR_CM)
    return (True if way <= limit else False if way > 3 * limit else None), "nearest_cm", way


def scattered(things: Sequence[Thing]) -> tuple[bool | None, str, float]:
    """Spread out without order: no row, no drawn ring, no grid, and a nearest-neighbour ratio in [0.6, 1.6].

    The ratio is Clark and Evans', with Donnelly's border correction over the points' rectangle (its sides lengthened by
    (n + 1) / (n - 1), as the range of n points is too short): about 1 at random, under 0.6 clustered, 2 on a grid.
    """
    points = plan_centres(things)
    n = len(points)
    sides = np.ptp(points, axis=0) * (n + 1) / (n - 1)
    if (sides == 0).any():
        return False, "clark_evans", 0.0
    expected = 0.5 * math.sqrt(float(sides.prod()) / n) + (0.0514 + 0.041 / math.sqrt(n)) * 2 * float(sides.sum()) / n
    ratio = float(nearest(points).mean()) / expected
    ringed, _, variation = ring(things)
    if row(things)[0] or (ringed and variation <= NO_SCATTER) or grid(things)[0]:
        return False, "clark_evans", ratio
    return (True if 0.6 <= ratio <= 1.6 else False if ratio < 0.2 else None), "clark_evans", ratio


LAYOUTS: Final[tuple[tuple[frozenset[str], Layout], ...]] = (
    (frozenset({"grid", "lattice"}), grid),
    (frozenset({"rows"}), rows),
    (frozenset({"row", "line", "lined", "queue"}), row),
    (frozenset({"ring", "circle", "circular"}), ring),
    (frozenset({"cluster", "clustered", "grouped", "huddled", "bunched"}), cluster),
    (frozenset({"scattered", "scatter", "spread", "dotted", "strewn"}), scattered),
    (frozenset({"regular", "regularly", "evenly", "equidistant"}), regular),
)
"""Words to tests, the first that is said decides."""
