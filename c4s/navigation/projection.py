"""Onto which cell of the navigation mesh a target's footprint falls (paper, EU09, EU10, EU16)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.spatial import cKDTree

from c4s.collision.mesh_body import Array
from c4s.navigation.targets import WalkTarget
from c4s.protocol.navigation import ABOVE_CM, BELOW_CM, REACH_CM, SAMPLES

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
    tree = cKDTree(cells[:, :2])
    return [_project(target, cells, tree) for target in targets]


def _project(target: WalkTarget, cells: Array, tree: cKDTree) -> Projection:
    middle, half = (target.low + target.high) / 2, (target.high - target.low) / 2
    points = middle[:2] + np.array(SAMPLES) * half[:2]
    met: Level = "none"
    for number, near in enumerate(tree.query_ball_point(points, REACH_CM, return_sorted=True)):
        if not near:
            continue
        rows = np.array(near)
        above = target.base_cm - cells[rows, 2]
        if met == "none":
            met = "raised" if above[np.abs(above).argmin()] > 0 else "buried"
        own = rows[(above <= ABOVE_CM) & (above >= -BELOW_CM)]
        if len(own):
            away = np.round(np.linalg.norm(cells[own, :2] - points[number], axis=1), 3)
            order = np.lexsort((own, np.abs(target.base_cm - cells[own, 2]), away))
            return Projection("storey", int(own[order[0]]), number)
    return Projection(met)
