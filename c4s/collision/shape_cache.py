"""Hulls and shapes of the process, kept by what they are made of: the body's own numbers and the scale.

Names play no part, so two snapshots that hold different bodies under one mesh path cannot mix. The least recently used
go first; the limit counts hull corners, which is where the memory goes (about 300 bytes each).
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

import numpy as np

from c4s.collision.hulls import Hull, convex_hull
from c4s.collision.mesh_body import MeshBody, Triple
from c4s.collision.shapes import Shape, scaled_shape

MOST_CORNERS = 500_000
SMALL = 8
"""What a shape without corners, or a body that has no shape, counts."""

T = TypeVar("T")


class _Recent(Generic[T]):
    """Values by key, the least recently used dropped once their weights exceed ``most``."""

    def __init__(self, most: int) -> None:
        self._most, self._held = most, 0
        self._kept: OrderedDict[Hashable, tuple[T, int]] = OrderedDict()

    def get(self, key: Hashable, weight: int, make: Callable[[], T]) -> T:
        found = self._kept.get(key)
        if found is not None:
            self._kept.move_to_end(key)
            return found[0]
        value = make()
        self._kept[key] = value, weight
        self._held += weight
        while self._held > self._most and len(self._kept) > 1:
            self._held -= self._kept.popitem(last=False)[1][1]
        return value

    def __len__(self) -> int:
        return len(self._kept)


class ShapeCache:
    """Least-recently-used shapes and hulls; safe to share between threads."""

    def __init__(self, most_corners: int = MOST_CORNERS) -> None:
        self._most = most_corners
        self._lock = threading.Lock()
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        with self._lock:
            self._shapes: _Recent[Shape | None] = _Recent(self._most)
            self._hulls: _Recent[Hull | None] = _Recent(self._most)

    def __len__(self) -> int:
        """Shapes that are kept."""
        return len(self._shapes)

    def shape(self, body: MeshBody, scale: Triple) -> Shape | None:
        """The body under a scale; None when nothing with an area is left."""
        weight = max(SMALL, len(body.vertices) // 24)
        with self._lock:
            return self._shapes.get(
                (body, scale),
                weight,
                lambda: scaled_shape(
                    body,
                    np.array(scale),
                    self._hulls.get(body, weight, lambda: convex_hull(body.points)) if body.kind == "hull" else None,
                ),
            )


SHAPES = ShapeCache()
"""The cache of this process."""
