"""Where an eye may be among boxes, and what stands between it and what it looks at."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.semantics.boxes import Flags
from c4s.semantics.inventory import Array

Rows: TypeAlias = NDArray[np.int64]
CLEARANCE_CM = 25.0
"""An eye keeps at least this far from every box."""
HOLLOW_CM = 220.0
"""A box whose sides are all at least this long may be a room: an eye may be inside it with what it looks at."""
_CELLS = 1 << 20
"""Pairs of a ray and a box that are looked at together: they bound the memory."""


def corners_of(low: Array, high: Array) -> Array:
    """The eight corners (8, 3) of a box."""
    return np.array(list(itertools.product(*zip(low, high, strict=True))))


@dataclass(frozen=True)
class Solids:
    """World boxes (n, 3), cm."""

    low: Array
    high: Array

    def __len__(self) -> int:
        return len(self.low)

    def take(self, rows: Rows | Flags) -> Solids:
        """Some of the boxes."""
        return Solids(self.low[rows], self.high[rows])

    @property
    def centre(self) -> Array:
        """Centres (n, 3)."""
        return (self.low + self.high) / 2

    @property
    def size(self) -> Array:
        """Sides (n, 3)."""
        return self.high - self.low

    def corners(self) -> Array:
        """The corners of all boxes (8 n, 3)."""
        sides = np.stack([self.low, self.high], axis=1)
        return np.concatenate([sides[:, pick, range(3)] for pick in itertools.product((0, 1), repeat=3)])

    def union(self) -> tuple[Array, Array]:
        """Corners of the box around all."""
        return self.low.min(axis=0), self.high.max(axis=0)

    def hollow(self, low: Array, high: Array) -> Flags:
        """Which boxes hold the box from ``low`` to ``high`` and may be a room around it."""
        holds = np.all((self.low <= low) & (self.high >= high), axis=1)
        return np.asarray(holds & (self.size.min(axis=1) >= HOLLOW_CM))


def is_held(points: Array, boxes: Solids, clearance_cm: float = CLEARANCE_CM) -> Flags:
    """Whether each point (k, 3) lies in a box or nearer than the clearance to one, along every axis."""
    held = np.zeros(len(points), dtype=bool)
    for rows in _chunks(len(points), len(boxes)):
        inside = np.all(
            (points[rows, None] > boxes.low - clearance_cm) & (points[rows, None] < boxes.high + clearance_cm), axis=2
        )
        held[rows] = inside.any(axis=1)
    return held


def hits(starts: Array, ends: Array, boxes: Solids) -> Array:
    """Where on its way (0 to 1) each line from a start to an end (k, 3) first meets a box that it does not begin in.

    1 where it meets none.
    """
    first = np.ones(len(starts))
    if not len(boxes):
        return first
    for rows in _chunks(len(starts), len(boxes)):
        start, way = starts[rows, None], (ends - starts)[rows, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            one, other = (boxes.low - start) / way, (boxes.high - start) / way
        flat = way == 0
        within = (start > boxes.low) & (start < boxes.high)
        entry = np.where(flat, np.where(within, -np.inf, np.inf), np.minimum(one, other)).max(axis=2)
        leave = np.where(flat, np.where(within, np.inf, -np.inf), np.maximum(one, other)).min(axis=2)
        met = (entry < leave) & (entry > 0) & (entry < 1)
        first[rows] = np.where(met, entry, 1.0).min(axis=1)
    return first


def crossed(starts: Array, ends: Array, boxes: Solids) -> Array:
    """How many boxes each line from a start to an end (k, 3) goes through, without those that it begins in."""
    count = np.zeros(len(starts))
    if not len(boxes):
        return count
    for rows in _chunks(len(starts), len(boxes)):
        start, way = starts[rows, None], (ends - starts)[rows, None]
        way = np.where(np.abs(way) < 1e-9, 1e-9, way)
        one, other = (boxes.low - start) / way, (boxes.high - start) / way
        entry, leave = np.minimum(one, other).max(axis=2), np.maximum(one, other).min(axis=2)
        count[rows] = ((entry < leave) & (entry > 0) & (entry < 1)).sum(axis=1)
    return count


def _chunks(points: int, boxes: int) -> list[slice]:
    step = max(1, _CELLS // max(1, boxes))
    return [slice(first, first + step) for first in range(0, points, step)]
