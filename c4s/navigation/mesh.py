"""What a measurement asks of a navigation mesh, whichever engine made it, and the answers of a walkable space."""

from __future__ import annotations

from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from c4s.collision.mesh_body import Array
from c4s.navigation import paths
from c4s.navigation.space import WalkableSpace
from c4s.protocol.navigation import PHASE_CM

NONE = -1
_KEPT = 4
_INSIDE_CM = 0.01
"""A point of a cell is no nearer to its edge: it belongs to one cell alone."""


class NavigationMesh(Protocol):
    """A settled navigation mesh. Points are (n, 3) in cm, on the mesh."""

    def bounds_cm(self) -> tuple[Array, Array] | None:
        """The box of the mesh; None where there is nothing to walk on."""
        ...

    def lattice(self, pitch_cm: float, stratum_cm: float) -> Array:
        """The points of the mesh on a lattice over its bounds, by column and then upwards."""
        ...

    def components(self, points: Array) -> NDArray[np.int64]:
        """Of each point a number that it shares with those to which a complete path leads; -1 off the mesh."""
        ...

    def distances(self, start: Array, points: Array) -> Array:
        """Length (cm) of the way to each point; infinite without a complete path."""
        ...

    def route(self, start: Array, goal: Array) -> Array | None:
        """Corners (k, 3) of a path from one point to another; None without a complete one."""
        ...


class SpaceMesh:
    """A walkable space as a navigation mesh."""

    def __init__(self, space: WalkableSpace) -> None:
        self.space = space
        self._spread: dict[int, tuple[NDArray[np.int32], NDArray[np.int32]]] = {}

    @cached_property
    def _column(self) -> NDArray[np.int32]:
        return self.space.columns_of_spans().astype(np.int32)

    def bounds_cm(self) -> tuple[Array, Array] | None:
        """See ``NavigationMesh``."""
        return self.space.bounds_cm()

    def lattice(self, pitch_cm: float, stratum_cm: float) -> Array:
        """See ``NavigationMesh``; a lattice lies at multiples of the pitch in the world, and ``PHASE_CM``."""
        space, bounds = self.space, self.space.bounds_cm()
        if bounds is None:
            return np.zeros((0, 3))
        x, y = (
            np.arange(np.ceil((low - PHASE_CM) / pitch_cm), np.floor((high - PHASE_CM) / pitch_cm) + 1) * pitch_cm
            + PHASE_CM
            for low, high in zip(bounds[0][:2], bounds[1][:2], strict=True)
        )
        plan = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
        column = space.column_of(plan)
        plan, column = plan[column >= 0], column[column >= 0]
        counts = space.first[column + 1] - space.first[column]
        before = np.repeat(np.cumsum(counts) - counts, counts)
        spans = np.repeat(space.first[column], counts) + np.arange(len(before)) - before
        kept = space.region[spans] >= 0
        heights = space.origin_cm[2] + space.floor[spans] * space.settings.cell_height_cm
        points = np.column_stack([np.repeat(plan, counts, axis=0), heights])[kept]
        strata = np.floor(points[:, 2] / stratum_cm)
        same = (np.diff(points[:, :2], axis=0) == 0).all(axis=1) & (np.diff(strata) == 0)
        return np.asarray(points[np.concatenate([[True], ~same])]) if len(points) else points

    def locate(self, points: Array, reach_cm: float = 100.0) -> NDArray[np.int64]:
        """The span on which each point lies, the nearest upwards or downwards; -1 where there is none in reach."""
        space, found = self.space, np.full(len(points), NONE, dtype=np.int64)
        for index, (column, z) in enumerate(zip(space.column_of(points), points[:, 2], strict=True)):
            if column < 0:
                continue
            spans = np.arange(space.first[column], space.first[column + 1])
            spans = spans[space.region[spans] >= 0]
            if len(spans):
                away = np.abs(space.origin_cm[2] + space.floor[spans] * space.settings.cell_height_cm - z)
                if away.min() <= reach_cm:
                    found[index] = spans[away.argmin()]
        return found

    def nearest(self, point: Array, extent: Array) -> Array | None:
        """The point of the mesh nearest to a place within a box around it (half extents, cm); None for none."""
        space, cell = self.space, self.space.settings.cell_cm
        first = np.maximum(np.floor((point[:2] - extent[:2] - space.origin_cm[:2]) / cell), 0).astype(np.int64)
        last = np.minimum(
            np.floor((point[:2] + extent[:2] - space.origin_cm[:2]) / cell), (space.columns - 1, space.rows - 1)
        ).astype(np.int64)
        if (last < first).any():
            return None
        x, y = np.meshgrid(np.arange(first[0], last[0] + 1), np.arange(first[1], last[1] + 1))
        column = (y * space.columns + x).ravel()
        counts = space.first[column + 1] - space.first[column]
        spans = (
            np.repeat(space.first[column], counts)
            + np.arange(counts.sum())
            - np.repeat(np.cumsum(counts) - counts, counts)
        )
        z = space.origin_cm[2] + space.floor[spans] * space.settings.cell_height_cm
        low = space.origin_cm[:2] + np.column_stack([x.ravel(), y.ravel()]).repeat(counts, axis=0) * cell
        places = np.column_stack([np.clip(point[:2], low + _INSIDE_CM, low + cell - _INSIDE_CM), z])
        away = np.abs(places - point)
        near = np.flatnonzero((space.region[spans] >= 0) & (away <= extent + 1e-9).all(axis=1))
        if not len(near):
            return None
        return np.asarray(places[near[np.linalg.norm(away[near], axis=1).argmin()]])

    def components(self, points: Array) -> NDArray[np.int64]:
        """See ``NavigationMesh``."""
        spans = self.locate(points)
        return np.where(spans >= 0, self.space.region[np.maximum(spans, 0)], NONE) if len(points) else spans

    def distances(self, start: Array, points: Array) -> Array:
        """See ``NavigationMesh``; over cells in eight directions: up to a twelfth more than the straight way."""
        origin, spans = self.locate(start[None])[0], self.locate(points)
        if origin < 0:
            return np.full(len(points), np.inf)
        cost = self._from(int(origin))[0][np.maximum(spans, 0)]
        known = (spans >= 0) & (cost < 1 << 30)
        return np.where(known, cost * (self.space.settings.cell_cm / paths.STRAIGHT), np.inf)

    def route(self, start: Array, goal: Array) -> Array | None:
        """See ``NavigationMesh``; straightened, with the body's clearance."""
        origin, end = self.locate(np.array([start, goal]))
        if origin < 0 or end < 0 or self.space.region[origin] != self.space.region[end]:
            return None
        cost, before = self._from(int(end))
        if cost[origin] >= 1 << 30:
            return None
        way = [int(origin)]
        while way[-1] != end:
            way.append(int(before[way[-1]]))
        spans = np.array(way, dtype=np.int32)
        space = self.space
        corners = paths.straighten(space.links, space.region, self._column, space.columns, spans)
        points = space.points(corners)
        return np.concatenate([points, points]) if len(points) == 1 else points

    def _from(self, span: int) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Costs and ways to a span; the last few are kept, since many ways lead to one goal."""
        found = self._spread.pop(span, None)
        if found is None:
            found = paths.spread(self.space.links, self.space.region, span)
        self._spread[span] = found
        while len(self._spread) > _KEPT:
            del self._spread[next(iter(self._spread))]
        return found
