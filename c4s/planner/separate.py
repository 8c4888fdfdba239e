"""Removing overlaps in plan: entries on the ground are pushed apart until no two footprints overlap. Deterministic."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from shapely import STRtree, box

from c4s.geometry.transform import Array
from c4s.planner.place import PlacedEntry
from c4s.planner.tiers import is_ground

ROUNDS = 60
GAP_CM = 1.0


def separate(entries: Sequence[PlacedEntry], half_extent_cm: float) -> tuple[list[str], int]:
    """Move entries apart in place. Returns the names of moved entries and how many pairs still overlap.

    Ground tiles, and entries that stand on another, are left alone; what stands on a moved entry moves along.
    A pair is moved along the axis of least overlap, the smaller entry further; fixed entries yield only to each other.
    """
    loose = [entry for entry in entries if entry.on is None and not is_ground(entry)]
    if not loose:
        return [], 0
    start = np.array([[entry.x, entry.y] for entry in loose])
    centre = start.copy()
    half = np.array([[entry.half_x, entry.half_y] for entry in loose]) + GAP_CM / 2
    spans = np.array([[entry.bottom, entry.top] for entry in loose])
    weight = 1 / np.maximum(half.prod(axis=1), 1.0)
    weight[[entry.fixed for entry in loose]] *= 1e-3
    pairs = np.empty((0, 2), dtype=int)
    for _ in range(ROUNDS):
        pairs = _overlapping(centre, half, spans)
        if not len(pairs):
            break
        a, b = pairs[:, 0], pairs[:, 1]
        apart = centre[b] - centre[a]
        depth = half[a] + half[b] - np.abs(apart)
        axis = np.argmin(depth, axis=1)
        rows = np.arange(len(pairs))
        sign = np.where(apart[rows, axis] >= 0, 1.0, -1.0)
        push = depth[rows, axis] * 1.02 + 0.1
        share = weight[a] / (weight[a] + weight[b])
        moves = np.zeros_like(centre)
        np.subtract.at(moves, (a, axis), sign * push * share)
        np.add.at(moves, (b, axis), sign * push * (1 - share))
        counts = np.bincount(pairs.ravel(), minlength=len(loose))
        centre += moves / np.maximum(counts, 1)[:, None] * 1.3
        limit = np.maximum(half_extent_cm - half, 0.0)
        centre = np.clip(centre, -limit, limit)
    moved = []
    shifts: dict[str, tuple[float, float]] = {}
    for entry, old, new in zip(loose, start, centre, strict=True):
        dx, dy = float(new[0] - old[0]), float(new[1] - old[1])
        if abs(dx) + abs(dy) > 0.01:
            entry.x, entry.y = float(new[0]), float(new[1])
            moved.append(entry.name)
            shifts.setdefault(entry.node.id, (dx, dy))
    for entry in entries:
        if entry.on in shifts:
            entry.x, entry.y = entry.x + shifts[entry.on][0], entry.y + shifts[entry.on][1]
            shifts.setdefault(entry.node.id, shifts[entry.on])
    return moved, len(_overlapping(centre, half - GAP_CM / 2 - 0.5, spans))


def _overlapping(centre: Array, half: Array, spans: Array) -> NDArray[np.intp]:
    """Pairs (n, 2) of overlapping boxes, each once, sorted."""
    boxes = box(
        centre[:, 0] - half[:, 0], centre[:, 1] - half[:, 1], centre[:, 0] + half[:, 0], centre[:, 1] + half[:, 1]
    )
    pairs = STRtree(boxes).query(boxes).T
    pairs = pairs[pairs[:, 0] < pairs[:, 1]]
    a, b = pairs[:, 0], pairs[:, 1]
    inside = np.all(np.abs(centre[a] - centre[b]) < half[a] + half[b] - 1e-6, axis=1)
    tall = np.minimum(spans[a, 1], spans[b, 1]) - np.maximum(spans[a, 0], spans[b, 0]) > 1e-6
    pairs = pairs[inside & tall]
    return np.asarray(pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))])
