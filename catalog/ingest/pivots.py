"""Where the pivot of a mesh lies, and meshes moved so that it is the middle of their bottom."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from c4s.records.level import Vector
from c4s.records.pack import CollisionBody, HullBody
from catalog.ingest.surface import SourcePart

FAR = 0.25
"""A pivot is outside when it is farther from the bounding box than this share of the box's diagonal."""


def outside(parts: Sequence[SourcePart]) -> float:
    """How far (cm) the pivot lies from the bounding box; 0 where it is in it or near it."""
    low, high = _box(parts)
    away = float(np.linalg.norm(np.maximum(np.maximum(low, -high), 0.0)))
    return away if away > FAR * float(np.linalg.norm(high - low)) else 0.0


def bottom(parts: Sequence[SourcePart]) -> NDArray[np.float64]:
    """The middle of the bottom of the bounding box (cm)."""
    low, high = _box(parts)
    return np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])


def _box(parts: Sequence[SourcePart]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    low = np.min([part.vertices.min(axis=0) for part in parts], axis=0)
    return low, np.max([part.vertices.max(axis=0) for part in parts], axis=0)


def moved(parts: Sequence[SourcePart], by: NDArray[np.float64]) -> list[SourcePart]:
    """The parts moved (cm)."""
    return [replace(part, vertices=part.vertices + by) for part in parts]


def moved_bodies(bodies: Sequence[CollisionBody], by: NDArray[np.float64]) -> list[CollisionBody]:
    """Collision bodies moved (cm)."""

    def shift(point: Vector) -> Vector:
        x, y, z = (round(float(value), 4) + 0.0 for value in np.asarray(point) + by)
        return x, y, z

    return [
        body.model_copy(update={"vertices": [shift(point) for point in body.vertices]})
        if isinstance(body, HullBody)
        else body.model_copy(update={"center": shift(body.center)})
        for body in bodies
    ]
