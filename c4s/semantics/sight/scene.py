"""The scene as cameras are planned in it: the boxes of its things, the ground, and what of it is the scene at all.

What an agent places to draw the cameras away is left out of the content: things far from the rest, one box around
everything, things deep below the ground, copies at one place (they count once).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from c4s.semantics.boxes import Flags
from c4s.semantics.inventory import Array, Box, Thing
from c4s.semantics.sight.clearance import Solids, corners_of

FAR = 6.0
"""Content lies within this many times the median way to the middle of all (of at least 10 m)."""
_NEAREST_CM = 1000.0
_WIDEST = 4.0
"""A thing this many times as large as what lies within that way is no content but around it."""
_CELL_CM = 100.0
"""Things whose centres share a cell of this size count once where the middle is sought."""
_FLAT = 0.08
"""A floor tile is at most this share of its shorter plan side high, and no plan side is below 1 m."""
_TILE_CM = 100.0
_BURIED_CM = 300.0
"""What ends this far below the ground is not to be seen."""
_LEAST_CM = 1.0
_LEAST_FRAME_CM = 50.0
"""Half the side of the smallest cube that is framed as a scene."""


@dataclass(frozen=True)
class SightScene:
    """Things with their boxes; rows of all arrays are things."""

    actors: Sequence[str]
    boxes: Solids
    content: Flags
    """Things that the scene consists of."""
    tiles: Flags
    """Flat ones that lie as a floor, path or water."""
    ground_cm: float
    """Height of the lowest floor or landscape; 0, the world's plane, where there is none. No eye goes below."""

    @classmethod
    def of(cls, things: Sequence[Thing], landscapes: Sequence[Box] = ()) -> SightScene:
        """The scene of an inventory, with the boxes (low, high) of its landscapes."""
        low = np.array([thing.low for thing in things]).reshape(-1, 3)
        high = np.array([thing.high for thing in things]).reshape(-1, 3)
        boxes = Solids(low, high)
        size = boxes.size
        tiles = (size[:, :2].min(axis=1) >= _TILE_CM) & (size[:, 2] <= _FLAT * size[:, :2].min(axis=1))
        here, near = _near(boxes, size)
        ground = _ground(boxes.take(here & tiles), landscapes)
        content = near & (high[:, 2] > ground - _BURIED_CM)
        return cls([thing.actor for thing in things], boxes, content, tiles, ground)

    @property
    def objects(self) -> Flags:
        """Content that stands: without tiles, unless there is nothing else."""
        standing = self.content & ~self.tiles
        return standing if standing.any() else self.content

    def framed(self) -> Array:
        """Points (n, 3) around all content; around a 20 m plate where there is none, so that its emptiness is seen."""
        if not self.content.any():
            return corners_of(np.array([-1000.0, -1000.0, 0.0]), np.array([1000.0, 1000.0, 300.0]))
        own = self.boxes.take(self.objects)
        middle = (own.low.min(axis=0) + own.high.max(axis=0)) / 2
        return np.concatenate([own.corners(), corners_of(middle - _LEAST_FRAME_CM, middle + _LEAST_FRAME_CM)])


def _near(boxes: Solids, size: Array) -> tuple[Flags, Flags]:
    """Things that reach near the middle and are large enough to be seen; and of those, the ones of a like size."""
    kept = size.max(axis=1) >= _LEAST_CM
    if not kept.any():
        return np.asarray(kept), np.asarray(kept)
    centre = boxes.centre
    places = np.unique(np.round(centre[kept] / _CELL_CM), axis=0) * _CELL_CM
    middle = np.median(places, axis=0)
    reach = FAR * max(float(np.median(np.linalg.norm(places - middle, axis=1))), _NEAREST_CM)
    inner = np.maximum(np.maximum(boxes.low - middle, middle - boxes.high), 0.0)
    kept &= np.linalg.norm(inner, axis=1) <= reach
    alike = kept & (size.max(axis=1) <= _WIDEST * reach)
    for _ in range(2):
        around = alike & (np.linalg.norm(centre - middle, axis=1) <= reach)
        if not around.any():
            break
        span = np.ptp(centre[around], axis=0).max()
        alike &= size.max(axis=1) <= max(_WIDEST * float(np.median(size[around].max(axis=1))), 1.5 * span, 2000.0)
    return np.asarray(kept), np.asarray(alike)


def _ground(tiles: Solids, landscapes: Sequence[Box]) -> float:
    """The height below which at most a twentieth of the floors' area lies, or a landscape that is lower."""
    lowest = [float(low[2]) for low, _ in landscapes]
    if len(tiles):
        order = np.argsort(tiles.high[:, 2], kind="stable")
        area = np.cumsum(tiles.size[order, 0] * tiles.size[order, 1])
        lowest.append(float(tiles.high[order[int(np.searchsorted(area, 0.05 * area[-1]))], 2]))
    return min(lowest, default=0.0)
