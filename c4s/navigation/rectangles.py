"""A walkable space as few flat rectangles, for drawings."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from c4s.collision.mesh_body import Array
from c4s.navigation.space import WalkableSpace

Whole = NDArray[np.int64]


def rectangles_of(space: WalkableSpace, regions: Whole) -> Array:
    """Rectangles (n, 5) of the spans of some regions: low x, low y, high x, high y, height, in cm.

    Cells of one height are merged along x, and equal runs along y; together they cover each span exactly once.
    """
    spans = np.flatnonzero(np.isin(space.region, regions))
    if not len(spans):
        return np.empty((0, 5))
    column = space.columns_of_spans()[spans]
    cells = np.column_stack([space.floor[spans], column // space.columns, column % space.columns]).astype(np.int64)
    height, row, x = cells[np.lexsort(cells.T[::-1])].T
    first, last = _runs((np.diff(height) == 0) & (np.diff(row) == 0) & (np.diff(x) == 1))
    height, row, low, high = height[first], row[first], x[first], x[last] + 1
    order = np.lexsort((row, high, low, height))
    height, row, low, high = height[order], row[order], low[order], high[order]
    same = (np.diff(height) == 0) & (np.diff(low) == 0) & (np.diff(high) == 0) & (np.diff(row) == 1)
    first, last = _runs(same)
    cell, origin = space.settings.cell_cm, space.origin_cm
    plan = np.column_stack([low[first], row[first], high[first], row[last] + 1]) * cell + np.tile(origin[:2], 2)
    return np.column_stack([plan, origin[2] + height[first] * space.settings.cell_height_cm])


def _runs(joined: NDArray[np.bool_]) -> tuple[Whole, Whole]:
    """The first and last index of each run; ``joined[i]`` says whether ``i + 1`` goes on with what ``i`` is of."""
    breaks = np.flatnonzero(~joined)
    return np.concatenate([[0], breaks + 1]), np.concatenate([breaks, [len(joined)]])
