"""Geometric measures behind spatial decisions. All lengths in cm; plan means x and y.

Each relation says of every subject whether it stands in it to the references (to any of them, itself aside). The
relations and their thresholds are written in ``docs/rule-judge.md``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from c4s.semantics.between import between_any
from c4s.semantics.boxes import Boxes, Flags, holds_to_any
from c4s.semantics.hull import in_ring, in_ring_of_others
from c4s.semantics.inventory import Array, Thing

Test: TypeAlias = Callable[[Sequence[Thing], Sequence[Thing]], Flags]

CONTACT_CM = 10.0
NEAR_CM = 300.0
ROW_SHARE = 0.15
AROUND_GAP_DEG = 150.0
_TIES = 6
"""Neighbours that are measured to find the nearest: on a grid several are equally near but for rounding."""


def plan_centres(things: Sequence[Thing]) -> Array:
    """Plan centres (n, 2) of things."""
    return np.array([thing.centre[:2] for thing in things]).reshape(-1, 2)


def _is_on(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    over = np.all((subject.centre[:, :2] >= least.low[:, :2]) & (subject.centre[:, :2] <= most.high[:, :2]), axis=1)
    return np.asarray(
        over
        & (-0.5 * most.height - CONTACT_CM <= subject.low[:, 2] - least.high[:, 2])
        & (subject.low[:, 2] - most.high[:, 2] <= CONTACT_CM)
        & (subject.high[:, 2] > least.high[:, 2])
    )


def _overlaps_in_plan(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    return np.asarray(
        np.all((least.low[:, :2] <= subject.high[:, :2]) & (subject.low[:, :2] <= most.high[:, :2]), axis=1)
    )


def _is_above(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    return _overlaps_in_plan(subject, least, most) & (subject.low[:, 2] >= least.high[:, 2] - CONTACT_CM)


def _is_below(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    return (
        _overlaps_in_plan(subject, least, most)
        & (subject.low[:, 2] < most.low[:, 2] + CONTACT_CM)
        & (subject.centre[:, 2] < most.high[:, 2])
    )


def _is_in_box(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    return np.asarray(np.all((subject.centre >= least.low) & (subject.centre <= most.high), axis=1))


def _gaps(subject: Boxes, least: Boxes, most: Boxes) -> Array:
    """Distances along each axis (cm), 0 where the boxes overlap."""
    return np.maximum(np.maximum(least.low - subject.high, subject.low - most.high), 0.0)


def _is_near(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    gaps = _gaps(subject, least, most)
    limit = np.maximum(NEAR_CM, 0.5 * np.maximum(subject.plan_size, most.plan_size))
    return np.asarray(np.hypot(gaps[:, 0], gaps[:, 1]) <= limit)


def _is_against(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    return np.asarray(np.linalg.norm(_gaps(subject, least, most), axis=1) <= 3 * CONTACT_CM)


def on(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Its bottom is at a reference's top (10 cm, or inside the upper half) and its centre is over it."""
    return holds_to_any(subjects, references, _is_on)


def above(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Its bottom is at least at a reference's top (10 cm slack) and their plans overlap."""
    return holds_to_any(subjects, references, _is_above)


def below(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Its centre is under a reference's top, it reaches the reference's plan, and it starts lower."""
    return holds_to_any(subjects, references, _is_below)


def inside(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Its centre lies in a reference's box, or in plan within the ring that at least three references form."""
    places = plan_centres(references)
    ringed = in_ring(plan_centres(subjects), places) if len(places) >= 3 else np.zeros(len(subjects), dtype=bool)
    among = _numbers(subjects, references)
    if (among >= 0).any():
        others = in_ring_of_others(places) if len(places) > 3 else np.zeros(len(places), dtype=bool)
        ringed[among >= 0] = others[among[among >= 0]]
    return ringed | holds_to_any(subjects, references, _is_in_box)


def near(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Within 3 m of a reference, or within half the larger one's size."""
    return holds_to_any(subjects, references, _is_near)


def against(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Its box is within 30 cm of a reference's box."""
    return holds_to_any(subjects, references, _is_against)


def apart(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Further than near from every reference."""
    return ~near(subjects, references)


def along(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Beside (within near of) a reference that is at least twice as long as wide, or a row of three and more."""
    sides = np.array([np.sort((other.high - other.low)[:2]) for other in references]).reshape(-1, 2)
    long = [other for other, (short, longer) in zip(references, sides, strict=True) if longer >= 2 * short]
    found = near(subjects, long)
    places = plan_centres(references)
    rowed = np.full(len(subjects), len(places) >= 3 and is_row(places)[0])
    among = _numbers(subjects, references)
    if (among >= 0).any():
        rowed[among >= 0] = _row_of_others(places)[among[among >= 0]]
    return found | rowed & near(subjects, references)


def between(subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags:
    """Its plan centre is near the middle part of a line between two references (a quarter of its length aside)."""
    return between_any(plan_centres(subjects), plan_centres(references))


def _numbers(subjects: Sequence[Thing], references: Sequence[Thing]) -> NDArray[np.int64]:
    """Each subject's own place among the references, -1 where it is none."""
    place = {id(thing): number for number, thing in enumerate(references)}
    return np.array([place.get(id(thing), -1) for thing in subjects], dtype=np.int64)


def _row_of_others(points: Array) -> Flags:
    """Whether the other points (at least three) lie on a line, for each of the points; by moments less one point."""
    n = len(points)
    if n < 4:
        return np.zeros(n, dtype=bool)
    offsets = points - points.mean(axis=0)
    full = offsets.T @ offsets
    rest = full - n / (n - 1) * offsets[:, :, None] * offsets[:, None, :]
    half_sum, half_gap = (rest[:, 0, 0] + rest[:, 1, 1]) / 2, (rest[:, 0, 0] - rest[:, 1, 1]) / 2
    bend = np.hypot(half_gap, rest[:, 0, 1])
    across, along_ = np.maximum(half_sum - bend, 0.0), half_sum + bend
    held = np.where(along_ > 0, across <= ROW_SHARE**2 * along_, False)
    for lone in np.flatnonzero(2 * half_sum < 1e-6 * np.trace(full)):
        held[lone] = is_row(np.delete(points, lone, axis=0))[0]
    return held


def encircles(subjects: Sequence[Thing], references: Sequence[Thing]) -> tuple[bool, float]:
    """Whether the subjects stand all around the references: no angle of 150 degrees without one; the largest gap."""
    largest = angular_gap(plan_centres(subjects), plan_centres(references).mean(axis=0))
    return largest <= AROUND_GAP_DEG, largest


def angular_gap(points: Array, centre: Array) -> float:
    """The largest angle (degrees) seen from the centre that holds no point; 360 for fewer than two points."""
    offsets = points - centre
    offsets = offsets[np.hypot(offsets[:, 0], offsets[:, 1]) > 1e-6]
    if len(offsets) < 2:
        return 360.0
    angles = np.sort(np.degrees(np.arctan2(offsets[:, 1], offsets[:, 0])))
    return float(np.diff(np.append(angles, angles[0] + 360)).max())


def is_row(points: Array) -> tuple[bool, float]:
    """Whether points lie on a line: the spread across it is at most 15 % of the spread along it; that share."""
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    share = float(spread[1] / spread[0]) if spread[0] > 0 else 1.0
    return share <= ROW_SHARE, share


def is_ring(points: Array) -> tuple[bool, float]:
    """Whether four or more points stand around an empty middle: radii vary by at most 30 %, no gap over 120 degrees."""
    centre = points.mean(axis=0)
    radii = np.hypot(*(points - centre).T)
    if len(points) < 4 or radii.mean() == 0:
        return False, math.inf
    variation = float(radii.std() / radii.mean())
    return variation <= 0.3 and angular_gap(points, centre) <= 120, variation


def nearest(points: Array) -> Array:
    """Distance of every point to its nearest other point."""
    places, inverse, count = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    ways = np.zeros(len(places))
    if len(places) > 1:
        close = KDTree(places).query(places, k=min(_TIES, len(places)))[1]
        every = np.hypot(*(places[:, None] - places[close]).transpose(2, 0, 1))
        every[close == np.arange(len(places))[:, None]] = np.inf
        ways = every.min(axis=1)
    ways[count > 1] = 0.0
    return np.asarray(ways[inverse.ravel()])


def is_cluster(things: Sequence[Thing]) -> tuple[bool, float]:
    """Whether things stand together: the median way to the nearest is at most twice their plan size, or 3 m."""
    way = float(np.median(nearest(plan_centres(things))))
    size = float(np.median([(thing.high - thing.low)[:2].max() for thing in things]))
    return way <= max(2 * size, NEAR_CM), way


def is_scattered(points: Array) -> tuple[bool, float]:
    """Whether points are spread out without order: no row or ring, and a nearest-neighbour ratio in [0.6, 1.6].

    The ratio is Clark and Evans', with Donnelly's border correction over the points' rectangle (its sides lengthened by
    (n + 1) / (n - 1), as the range of n points is too short): about 1 at random, under 0.6 clustered, 2 on a grid.
    """
    n = len(points)
    sides = np.ptp(points, axis=0) * (n + 1) / (n - 1)
    if (sides == 0).any():
        return False, 0.0
    expected = 0.5 * math.sqrt(float(sides.prod()) / n) + (0.0514 + 0.041 / math.sqrt(n)) * 2 * float(sides.sum()) / n
    ratio = float(nearest(points).mean()) / expected
    return 0.6 <= ratio <= 1.6 and not is_row(points)[0] and not is_ring(points)[0], ratio


RELATIONS: dict[str, Test] = {
    "on": on,
    "above": above,
    "below": below,
    "inside": inside,
    "near": near,
    "against": against,
    "apart": apart,
    "along": along,
    "between": between,
}

SYNONYMS: dict[str, str] = {
    "on": "on",
    "on_top_of": "on",
    "atop": "on",
    "resting_on": "on",
    "standing_on": "on",
    "placed_on": "on",
    "sits_on": "on",
    "above": "above",
    "over": "above",
    "hanging_over": "above",
    "below": "below",
    "under": "below",
    "beneath": "below",
    "underneath": "below",
    "in": "inside",
    "inside": "inside",
    "within": "inside",
    "near": "near",
    "next_to": "near",
    "beside": "near",
    "by": "near",
    "close_to": "near",
    "adjacent_to": "near",
    "alongside": "near",
    "at": "near",
    "against": "against",
    "leaning_against": "against",
    "apart_from": "apart",
    "away_from": "apart",
    "far_from": "apart",
    "along": "along",
    "lining": "along",
    "lines": "along",
    "between": "between",
    "around": "around",
    "surrounds": "around",
    "surround": "around",
    "surrounding": "around",
    "encloses": "around",
    "encircles": "around",
    "rings": "around",
    "clustered_around": "around",
    "surrounded_by": "around_inverse",
    "enclosed_by": "around_inverse",
    "supports": "on_inverse",
    "contains": "inside_inverse",
    "flanked_by": "between_references",
}
"""Relation words of a bundle to the tests here. A word that is not listed is not decidable."""
