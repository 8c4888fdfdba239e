"""The walkable space of a scene: where a body of some size can stand, and from where it gets where.

The voxel stages of Recast over collision bodies, solid inside: rasterise, filter, connect, erode, regions. Contours and
polygons are left out: every question is answered on the cells themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.collision.mesh_body import Array
from c4s.collision.shapes import Body, box_body
from c4s.navigation import paths, raster, voxels
from c4s.navigation.settings import NavigationSettings
from c4s.navigation.solids import is_walkable, solids_of

MOST_COLUMNS = 24_000_000
MOST_SPANS = 60_000_000
MOST_STEPS = 1 << 24
"""Larger fields are not made: columns, spans of all bodies, and cell heights from the lowest to the highest."""

Ints = NDArray[np.int32]


class SpaceTooLarge(ValueError):
    """The bounds or the bodies are more than a field may hold."""


@dataclass(frozen=True)
class WalkableSpace:
    """Spans that can be walked on, by column; ``x = origin + cell * column``, ``z = origin + cell height * floor``."""

    settings: NavigationSettings
    origin_cm: Array
    columns: int
    rows: int
    first: Ints
    """(columns * rows + 1) where the spans of a column begin; they rise."""
    floor: Ints
    """In cell heights."""
    links: Ints
    """(spans, 4) where one gets towards -x, +y, +x and -y; -1 where one does not."""
    region: Ints
    """Region of each span; -1 where the body does not fit. Smaller regions than the settings ask for are none."""
    sizes: NDArray[np.int64]
    """Cells of each region."""

    @property
    def area_m2(self) -> float:
        """Of all regions, seen from above."""
        return float(self.sizes.sum()) * (self.settings.cell_cm / 100) ** 2

    def column_of(self, points: Array) -> NDArray[np.int64]:
        """Number of the column of each point (n, 2 or 3) in cm; -1 outside."""
        at = np.floor((points[:, :2] - self.origin_cm[:2]) / self.settings.cell_cm)
        inside = (at[:, 0] >= 0) & (at[:, 1] >= 0) & (at[:, 0] < self.columns) & (at[:, 1] < self.rows)
        x, y = np.where(inside[:, None], at, 0).astype(np.int64).T
        return np.where(inside, y * self.columns + x, -1)

    def columns_of_spans(self) -> NDArray[np.int64]:
        """The column of each span."""
        return np.repeat(np.arange(len(self.first) - 1), np.diff(self.first))

    def points(self, spans: NDArray[Any]) -> Array:
        """Where spans lie (n, 3) in cm: the centre of the cell, on the floor."""
        spans = np.asarray(spans, dtype=np.int64)
        column = np.searchsorted(self.first, spans, side="right") - 1
        cells = np.column_stack([column % self.columns + 0.5, column // self.columns + 0.5])
        plan = self.origin_cm[:2] + cells * self.settings.cell_cm
        return np.column_stack([plan, self.origin_cm[2] + self.floor[spans] * self.settings.cell_height_cm])

    def bounds_cm(self) -> tuple[Array, Array] | None:
        """The box of all regions; None where there is none."""
        spans = np.flatnonzero(self.region >= 0)
        if not len(spans):
            return None
        column = np.searchsorted(self.first, spans, side="right") - 1
        x, y, z = column % self.columns, column // self.columns, self.floor[spans]
        cell, step = self.settings.cell_cm, self.settings.cell_height_cm
        low = self.origin_cm + np.array([x.min() * cell, y.min() * cell, z.min() * step])
        high = self.origin_cm + np.array([(x.max() + 1) * cell, (y.max() + 1) * cell, z.max() * step])
        return low, high


def build_space(
    bodies: Sequence[Body], bounds: tuple[Array, Array] | None, settings: NavigationSettings
) -> WalkableSpace:
    """The walkable space of bodies within a box (cm); empty without a box.

    The grid lies at multiples of the cell in the world, so that what is added far away moves no cell. The order of the
    bodies changes nothing.

    Raises:
        SpaceTooLarge: more than ``MOST_COLUMNS``, ``MOST_STEPS`` or ``MOST_SPANS``.
    """
    cell, step = settings.cell_cm, settings.cell_height_cm
    low, high = (np.zeros(3), np.zeros(3)) if bounds is None else bounds
    unit = np.array([cell, cell, step])
    origin = (np.floor(low / unit) - [1, 1, 2]) * unit
    beyond = np.array([1, 1, settings.height_steps + 1])
    columns, rows, tall = (int(part) for part in np.ceil((high - origin) / unit) + beyond)
    if columns * rows > MOST_COLUMNS or tall > MOST_STEPS:
        width, depth, height = (high - low) / 100
        raise SpaceTooLarge(f"the navigation bounds are {width:.0f} by {depth:.0f} by {height:.0f} m")
    solids = solids_of(bodies)
    walkable = is_walkable(solids.triangles, settings.slope_deg)
    windows = _windows(solids.low, solids.high, origin, cell, columns, rows)
    where, bottom, top, stands, whole = raster.rasterise(
        (solids.triangles - origin) / unit,
        solids.first,
        walkable,
        windows,
        columns,
        tall,
        settings.climb_steps,
        MOST_SPANS,
    )
    if not whole:
        raise SpaceTooLarge(f"the collision bodies fill more than {MOST_SPANS:,} spans")
    first, bottom, top, stands = raster.merge(where, bottom, top, stands, columns * rows, settings.climb_steps)
    del where
    voxels.low_obstacles(first, top, stands, settings.climb_steps)
    height, climb = settings.height_steps, settings.climb_steps
    stands = voxels.ledges(first, bottom, top, stands, columns, rows, height, climb)
    first, floor, above = voxels.compact(first, bottom, top, stands)
    links = voxels.connect(first, floor, above, columns, rows, height, climb)
    kept = voxels.erode(links, settings.radius_cells)
    region, sizes = voxels.regions(links, kept, settings.least_cells)
    return WalkableSpace(settings, origin, columns, rows, first, floor, links, region, sizes)


def warm() -> None:
    """Compile what builds a walkable space and finds ways in it."""
    plate = box_body(np.array([-500.0, -500.0, -20.0]), np.array([500.0, 500.0, 0.0]))
    space = build_space([plate], (plate.low, plate.high), NavigationSettings())
    span = int(np.flatnonzero(space.region >= 0)[0])
    paths.spread(space.links, space.region, span)
    column = space.columns_of_spans().astype(np.int32)
    paths.straighten(space.links, space.region, column, space.columns, np.array([span], np.int32))


def _windows(low: Array, high: Array, origin: Array, cell: float, columns: int, rows: int) -> NDArray[np.int64]:
    """(bodies, 4) first column and row that a body may touch, and how many; none of one outside the field."""
    most = np.array([columns, rows])
    start = np.clip(np.floor((low[:, :2] - origin[:2]) / cell) - 1, 0, most)
    end = np.clip(np.floor((high[:, :2] - origin[:2]) / cell) + 2, 0, most)
    return np.column_stack([start, np.maximum(end - start, 0)]).astype(np.int64)
