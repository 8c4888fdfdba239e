"""Ground, water, and paths over them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from cases.open190.layout.putting import Putting
from cases.open190.layout.things import Pair

SEABED_CM = 0.6
"""Water carries nothing, so boats lie on solid ground that far below its surface: sand, or the plate of a text."""


class Paving(Putting):
    """Covers the ground."""

    def ground(
        self,
        box: tuple[float, float, float, float],
        of: str = "Grass",
        *,
        family: str = "ground",
        tile: float = 1000.0,
        z: float = 0.0,
    ) -> None:
        """Cover a rectangle with tiles of about ``tile`` cm; their upper faces lie at ``z``, water's above a plate."""
        x0, y0, x1, y1 = box
        asset = self.one(family, side=tile) if family == "water" else self.one(family, of=of, side=tile)
        if family == "water" and self.tops_only:
            z += SEABED_CM
        elif family == "water":
            self.ground(box, "Sand", tile=tile, z=z - SEABED_CM)
        columns, lines = max(1, round((x1 - x0) / tile)), max(1, round((y1 - y0) / tile))
        sx, sy = (x1 - x0) / columns / tile, (y1 - y0) / lines / tile
        for i in range(columns):
            for j in range(lines):
                self.put(
                    asset,
                    x0 + (i + 0.5) * (x1 - x0) / columns,
                    y0 + (j + 0.5) * (y1 - y0) / lines,
                    z,
                    scale=(round(sx, 5), round(sy, 5), 1.0),
                )

    def plate(self, metres: float, of: str) -> None:
        """The ground of a text scene: a square of that many metres around the origin."""
        half = 50 * metres
        self.ground((-half, -half, half, half), of, tile=metres * 10)

    def trail(self, points: Sequence[Pair], wide: float = 250.0, of: str = "Gravel", z: float = 1.0) -> None:
        """A path through points, of square pieces end to end."""
        asset, number = self.one("ground", of=of, side=wide), 0
        for a, b in pairwise(points):
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            yaw, count = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])), max(1, math.ceil(length / wide))
            for i in range(count):
                t = (i + 0.5) / count
                number += 1
                self.put(asset, a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), z + 0.15 * (number % 3), yaw)
