"""Cameras that could show some boxes: around them, far enough that all is in the picture, and clear of everything."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.geometry.transform import WORLD_CM, look_at
from c4s.semantics.boxes import Flags
from c4s.semantics.inventory import Array
from c4s.semantics.sight.clearance import CLEARANCE_CM, Solids, corners_of, crossed, hits, is_held

ASPECT = 16 / 9
FOV_DEG = 60.0
WIDEST_DEG = 95.0
"""Horizontal fields of view: the usual one, and the widest that a narrow room may need."""
MARGIN = 1.08
"""What is framed takes at most one part in this of the picture."""
LEAST_CM = 60.0
"""No eye is nearer to the middle of what it looks at."""
ABOVE_GROUND_CM = 30.0
_SHORTENED = 0.92
"""Of the free way to the first wall."""
_JUMPS = 80
"""Enough to leave the largest world, half as far again each time."""


@dataclass(frozen=True)
class Eye:
    """A camera without a size or a name."""

    place: tuple[float, float, float]
    target: tuple[float, float, float]
    fov_deg: float = FOV_DEG

    @property
    def direction(self) -> Array:
        """From the eye to what it looks at, length 1."""
        way = np.subtract(self.target, self.place)
        return np.asarray(way / max(float(np.linalg.norm(way)), 1e-9))

    def camera(self, name: str, width: int, height: int) -> dict[str, Any]:
        """The camera as an engine takes it."""
        return {
            "name": name,
            "location_cm": list(self.place),
            "rotation_deg": [float(angle) for angle in look_at(self.place, self.target)],
            "fov_deg": self.fov_deg,
            "width": width,
            "height": height,
        }


def angle_deg(one: Eye, other: Eye) -> float:
    """The angle between the directions in which two eyes look."""
    return math.degrees(math.acos(float(np.clip(one.direction @ other.direction, -1.0, 1.0))))


def directions(azimuths: int, elevations: Sequence[float], turn_deg: float = 22.5) -> Array:
    """Directions (n, 3) from a target to its eyes, by elevation and then azimuth."""
    found = []
    for elevation in elevations:
        up = math.radians(elevation)
        for number in range(azimuths):
            around = math.radians(turn_deg + 360.0 * number / azimuths)
            found.append((math.cos(around) * math.cos(up), math.sin(around) * math.cos(up), math.sin(up)))
    return np.array(found)


def _axes(ways: Array) -> tuple[Array, Array]:
    """Right and up (k, 3) of eyes that look against the directions."""
    right = np.stack([ways[:, 1], -ways[:, 0], np.zeros(len(ways))], axis=1)
    right /= np.linalg.norm(right, axis=1, keepdims=True)
    return right, np.cross(right, -ways)


@dataclass(frozen=True)
class Framing:
    """Pictures of some points along several directions (k): where their middle is, and how far away the eye."""

    middles: Array
    """(k, 3) what each eye looks at."""
    distances: Array
    """(k) at which all points are just in the picture."""

    @classmethod
    def of(cls, ways: Array, points: Array, fov_deg: float = FOV_DEG) -> Framing:
        """The nearest eyes along the directions that have all points (m, 3) in the picture, margin included.

        A point at ``(x, y)`` across and ``n`` nearer than the middle is in it where ``|x - ex| <= (d - n) tan``. That
        holds for all points when ``d tan`` is half the way from the least ``x - n tan`` to the largest ``x + n tan``,
        and the eye stands in the middle of these.
        """
        across = math.tan(math.radians(fov_deg) / 2) / MARGIN
        centre = (points.min(axis=0) + points.max(axis=0)) / 2
        right, up = _axes(ways)
        nearer = ways @ (points - centre).T
        shifts, need = [], np.full(len(ways), LEAST_CM)
        for side, slope in ((right, across), (up, across / ASPECT)):
            aside = side @ (points - centre).T
            most, least = (aside + nearer * slope).max(axis=1), (aside - nearer * slope).min(axis=1)
            shifts.append(((most + least) / 2)[:, None] * side)
            need = np.maximum(need, (most - least) / 2 / slope)
        return cls(centre + shifts[0] + shifts[1], np.maximum(need, nearer.max(axis=1) + LEAST_CM))


def _needed_fov(ways: Array, points: Array, middles: Array, distances: Array) -> Array:
    """Fields of view (k) that hold all points from the distances."""
    right, up = _axes(ways)
    offset = points[None] - middles[:, None]
    aside, above, nearer = (np.einsum("kmi,ki->km", offset, axis) for axis in (right, up, ways))
    depth = np.maximum(distances[:, None] - nearer, 1.0)
    return np.asarray(np.degrees(2 * np.arctan((np.maximum(np.abs(aside), np.abs(above) * ASPECT) / depth).max(1))))


def around(
    points: Array, ways: Array, obstacles: Solids, own: Flags, ground_cm: float = -math.inf, most: int | None = None
) -> list[Eye]:
    """Eyes that have all points in the picture, none inside an obstacle, the most promising first.

    Where a box stands in the way, a second eye stands before it with a wider field of view. Eyes from which fewer
    boxes stand before the middle and the corners of what is framed come first; else the order is that of ``ways``.

    Args:
        points: (m, 3) what is framed (cm).
        ways: directions (n, 3) from it to the eyes.
        obstacles: what no eye may be in or behind.
        own: which obstacles are what is looked at; they are not in the way.
        ground_cm: no eye goes below it.
        most: how many eyes at most.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    rooms = obstacles.hollow(low, high) & ~own
    solid, walls = obstacles.take(~rooms), obstacles.take(~rooms & ~own)
    framing = Framing.of(ways, points)
    middles, full = framing.middles, framing.distances
    ends = middles + ways * full[:, None]
    first = hits(middles, ends, walls)
    wall = np.where(first < 1.0, first * full * _SHORTENED - CLEARANCE_CM, np.inf)
    free = np.minimum(wall, _inner(middles, ways, obstacles.take(rooms)))
    short = (free < full) & (free >= LEAST_CM)
    near = np.where(short, free, full)
    fov = np.clip(MARGIN * _needed_fov(ways, corners_of(low, high), middles, near), FOV_DEG, WIDEST_DEG)
    places = np.clip(np.concatenate([middles + ways * near[:, None], ends[short]]), -WORLD_CM, WORLD_CM)
    fovs = np.concatenate([np.where(short, fov, FOV_DEG), np.full(int(short.sum()), FOV_DEG)])
    targets = np.concatenate([middles, middles[short]])
    fine = ~is_held(places, solid) & (places[:, 2] >= ground_cm + ABOVE_GROUND_CM)
    places, targets, fovs = places[fine], targets[fine], fovs[fine]
    if not len(places):
        return []
    aims = np.concatenate([[(low + high) / 2], (low + high) / 2 + 0.6 * (corners_of(low, high) - (low + high) / 2)])
    starts, stops = np.repeat(places, len(aims), axis=0), np.tile(aims, (len(places), 1))
    in_the_way = crossed(starts, stops, walls).reshape(len(places), -1)
    order = np.argsort(np.minimum(in_the_way, 3).sum(axis=1), kind="stable")[:most]
    return [_eye(places[row], targets[row], fovs[row]) for row in order]


def _eye(place: Array, target: Array, fov_deg: float = FOV_DEG) -> Eye:
    (x, y, z), (u, v, w) = place.tolist(), target.tolist()
    return Eye((x, y, z), (u, v, w), float(fov_deg))


def _inner(middles: Array, ways: Array, rooms: Solids) -> Array:
    """How far an eye may go from its middle along each way and stay in the smallest room around it."""
    if not len(rooms):
        return np.full(len(ways), np.inf)
    smallest = int(np.argmin(rooms.size.prod(axis=1)))
    with np.errstate(divide="ignore", invalid="ignore"):
        limits = np.where(ways > 0, rooms.high[smallest] - middles, rooms.low[smallest] - middles) / ways
    limits = np.where(ways == 0, np.inf, limits)
    return np.asarray(limits.min(axis=1) * _SHORTENED - CLEARANCE_CM)


def outside(points: Array, ways: Array, obstacles: Solids) -> list[Eye]:
    """Eyes that look at the points from beyond all obstacles that hold them, where none nearer is free."""
    framing = Framing.of(ways, points)
    distances = framing.distances
    for _ in range(_JUMPS):
        places = np.clip(framing.middles + ways * distances[:, None], -WORLD_CM, WORLD_CM)
        held = is_held(places, obstacles)
        if not held.any():
            break
        distances = np.where(held, 1.5 * distances + CLEARANCE_CM, distances)
    free = ~held if not held.all() else held
    return [_eye(place, target) for place, target in zip(places[free], framing.middles[free], strict=True)]
