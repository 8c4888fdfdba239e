"""Onto which cell of the navigation mesh a target's footprint falls (paper, EU09, EU10, EU16)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from c4s.collision.mesh_body import Array
from c4s.navigation.targets import WalkTarget
from c4s.protocol.navigation import ABOVE_CM, BELOW_CM, REACH_CM, SAMPLES

_SLACK = 1e-6
"""Wider than the rounding of a distance."""
Level = Literal["storey", "raised", "buried", "none"]


@dataclass(frozen=True)
class Projection:
    """A target's cell: on its own storey, on others alone (it is scenery, above or below them), or none in reach."""

    level: Level
    cell: int = -1
    """Index of the lattice point."""
    sample: int = -1


def project(targets: Sequence[WalkTarget], cells: Array) -> list[Projection]:
    """The projection of each target onto lattice points (n, 3) in cm.

    Samples are tried in their order; the first with a cell of the target's own storey within reach decides, by its
    nearest one in plan, of equals the nearer one in height.
    """
    if not len(cells):
        return [Projection("none") for _ in targets]
    near = Near(cells[:, :2])
    return [_project(target, cells, near) for target in targets]


class Near:
    """Points (n, 2) in order of their first coordinate, to find those near a place."""

    def __init__(self, points: Array) -> None:
        self._order = np.argsort(points[:, 0], kind="stable")
        self._sorted = points[self._order]

    def within(self, place: Array, reach: float) -> NDArray[np.intp]:
        """Indices of the points within reach of a place, in ascending order."""
        first, last = np.searchsorted(self._sorted[:, 0], [place[0] - reach - _SLACK, place[0] + reach + _SLACK])
        away = self._sorted[first:last] - place
        found = away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1] <= reach * reach
        return np.sort(self._order[first:last][found])


def _project(target: WalkTarget, cells: Array, near: Near) -> Projection:
    middle, half = (target.low + target.high) / 2, (target.high - target.low) / 2
    points = middle[:2] + np.array(SAMPLES) * half[:2]
    met: Level = "none"
    for number, point in enumerate(points):
        rows = near.within(point, REACH_CM)
        if not len(rows):
            continue
        above = target.base_cm - cells[rows, 2]
        if met == "none":
            met = "raised" if above[np.abs(above).argmin()] > 0 else "buried"
        own = rows[(above <= ABOVE_CM) & (above >= -BELOW_CM)]
        if len(own):
            away = np.round(np.linalg.norm(cells[own, :2] - points[number], axis=1), 3)
            order = np.lexsort((own, np.abs(target.base_cm - cells[own, 2]), away))
            return Projection("storey", int(own[order[0]]), number)
    return Projection(met)
