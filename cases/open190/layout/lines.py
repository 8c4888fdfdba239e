"""Things along a line: side by side, as along a wall, or at equal distances."""

from __future__ import annotations

import math

from cases.open190.layout.putting import Putting
from cases.open190.layout.things import Assets, Item, Pair


class Lining(Putting):
    """Stands things along lines."""

    def along(
        self,
        a: Pair,
        b: Pair,
        assets: Assets,
        gap: float | Pair = 4.0,
        *,
        z: float = 0.0,
        fill: bool = False,
        count: int = 10_000,
    ) -> list[Item]:
        """Things side by side from a to b, backs on the line: each once in order, or again and again with ``fill``."""
        names = [assets] if isinstance(assets, str) else list(assets)
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        yaw, x = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])), 0.0
        found: list[Item] = []
        number = 0
        while number < count and (fill or number < len(names)):
            thing = self.thing(self.choose(names) if fill else names[number])
            number += 1
            step = gap if isinstance(gap, int | float) else self.uni(*gap)
            if x + thing.width > length:
                break
            with self.at(a[0], a[1], yaw):
                item = self.put(thing.name, x - thing.low[0], -thing.low[1] + 1, z)
            x += thing.width + step
            self.relate("along", item, found[-1] if found else None)
            if item:
                found.append(item)
        return found

    def row(
        self,
        a: Pair,
        b: Pair,
        assets: Assets,
        count: int,
        *,
        yaw: float = 0.0,
        z: float = 0.0,
        jitter: float = 0.0,
        scale: Pair = (1.0, 1.0),
    ) -> list[Item]:
        """Things at equal distances from a to b; ``yaw`` is added to the row's direction."""
        turn = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
        found = []
        for i in range(count):
            t = i / (count - 1) if count > 1 else 0.5
            x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
            item = self.put(
                assets,
                x + self.uni(-jitter, jitter),
                y + self.uni(-jitter, jitter),
                z,
                turn + yaw + self.uni(-jitter, jitter) * 0.2,
                scale=self.uni(*scale),
            )
            self.relate("in_row", item)
            if item:
                found.append(item)
        return found
