"""Drawings of a walkable space that are small enough for a record: a map from above, and its floors."""

from __future__ import annotations

import numpy as np

from c4s.collision.mesh_body import Array
from c4s.navigation.rectangles import rectangles_of
from c4s.navigation.space import WalkableSpace
from c4s.records.navigation import ELSEWHERE, MAIN, NEAR, NavigationFloors, NavigationMap

MOST_PIXELS = 320
"""Along the longer side."""


def map_of(space: WalkableSpace, main: Array) -> NavigationMap | None:
    """Where one can walk, with the component of ``main`` (points on it) apart; None without anywhere to walk.

    Where several floors lie over each other, the largest component wins, then any other, then what is too near a solid.
    """
    if space.bounds_cm() is None:
        return None
    size = int(np.ceil(max(space.columns, space.rows) / MOST_PIXELS))
    columns, rows = -(-space.columns // size), -(-space.rows // size)
    column = space.columns_of_spans()
    pixel = column // space.columns // size * columns + column % space.columns // size
    region = _region_at(space, main)
    pixels = np.zeros(columns * rows, np.uint8)
    pixels[pixel[space.region < 0]] = NEAR
    pixels[pixel[(space.region >= 0) & (space.region != region)]] = ELSEWHERE
    pixels[pixel[space.region == region]] = MAIN
    low = (float(space.origin_cm[0]), float(space.origin_cm[1]))
    return NavigationMap.of(low, size * space.settings.cell_cm, columns, rows, pixels.tobytes())


def floors_of(space: WalkableSpace, main: Array) -> NavigationFloors | None:
    """Where one can walk as rectangles, with the component of ``main`` (points on it) apart."""
    if space.bounds_cm() is None:
        return None
    region = _region_at(space, main)
    largest = rectangles_of(space, np.array([region]))
    others = rectangles_of(space, np.delete(np.arange(len(space.sizes)), region))
    of_largest = np.arange(len(largest) + len(others)) < len(largest)
    rows = np.column_stack([np.round(10 * np.concatenate([largest, others])), of_largest])
    return NavigationFloors.of(rows.astype("<i4").tobytes())


def _region_at(space: WalkableSpace, main: Array) -> int:
    column = space.column_of(main[:1])[0]
    spans = np.arange(space.first[column], space.first[column + 1])
    heights = space.origin_cm[2] + space.floor[spans] * space.settings.cell_height_cm
    return int(space.region[spans[np.abs(heights - main[0, 2]).argmin()]])
