"""Walls around a floor, and beams on them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cases.open190.layout.ground import Paving


class Walling(Paving):
    """Builds rooms."""

    def room(
        self,
        box: tuple[float, float, float, float],
        floor: str = "",
        *,
        high: float = 300.0,
        wall: str = "",
        module: float = 400.0,
        base: str = "",
        sides: str = "SENW",
        **kinds: Sequence[str],
    ) -> None:
        """Walls around a rectangle and a floor in it. ``S=("Plain", "Door")`` names the kinds of the modules of a side,
        over and over (S is y0, N is y1, W is x0, E is x1)."""
        x0, y0, x1, y1 = box
        wall = wall or self.random.choice(self.style.wall)
        if floor:
            self.ground(box, floor, family="floor", tile=400.0)
        for side, a, b in (
            ("S", (x0, y0 - 7), (x1, y0 - 7)),
            ("N", (x1, y1 + 7), (x0, y1 + 7)),
            ("E", (x1 + 7, y0), (x1 + 7, y1)),
            ("W", (x0 - 7, y1), (x0 - 7, y0)),
        ):
            if side not in sides:
                continue
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            count = max(1, round(length / module))
            order = kinds.get(side) or ("Plain",)
            yaw = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
            for i in range(count):
                asset = self.one(
                    "room-wall",
                    kind=order[i % len(order)],
                    length=round(length / count, 1),
                    high=high,
                    wall=wall,
                    base=base,
                )
                t = (i + 0.5) / count
                self.put(asset, a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0.0, yaw, slack=3.0)
        corner = self.one("room-wall", kind="Plain", length=14.0, high=high, wall=wall, noun="CornerPost")
        for x, y, needs in (
            (x0 - 7, y0 - 7, "SW"),
            (x1 + 7, y0 - 7, "SE"),
            (x0 - 7, y1 + 7, "NW"),
            (x1 + 7, y1 + 7, "NE"),
        ):
            if all(side in sides for side in needs):
                self.put(corner, x, y, slack=3.0)

    def beams(
        self, box: tuple[float, float, float, float], high: float, count: int, of: str = "", *, truss: bool = False
    ) -> None:
        """Beams or trusses across a rectangle along X, on its walls."""
        x0, y0, x1, y1 = box
        asset = self.one("beam", length=x1 - x0 + 26, truss=truss, of=of or self.style.wood[0])
        for i in range(count):
            self.put(asset, (x0 + x1) / 2, y0 + (y1 - y0) * (i + 1) / (count + 1), high + 0.1)
