"""Seats around a table."""

from __future__ import annotations

import math

from c4s.geometry.transform import normalize_axis
from cases.open190.layout.putting import Putting
from cases.open190.layout.things import Assets, Item


class Seating(Putting):
    """Stands seats around a table."""

    def around(self, item: Item | None, assets: Assets, count: int, gap: float = 8.0) -> list[Item]:
        """Seats around a table, fronts to it: on the long sides of a long one, in a ring around another."""
        if item is None:
            return []
        thing, found = item.thing, []
        half_x, half_y = thing.width * item.scale[0] / 2, thing.depth * item.scale[1] / 2
        asset = self.choose(assets)
        deep = self.thing(asset).depth / 2
        if half_x > 1.3 * half_y:
            each = math.ceil(count / 2)
            spots = [
                (
                    (i - (each - 1) / 2) * 2 * half_x / each,
                    side * (half_y + deep + gap - 14),
                    180.0 if side > 0 else 0.0,
                )
                for side in (1, -1)
                for i in range(each)
            ][:count]
        else:
            reach = max(half_x, half_y) + deep + gap - 10
            spots = [
                (reach * math.cos(a), reach * math.sin(a), math.degrees(a) + 90)
                for a in (2 * math.pi * (i + 0.25) / count for i in range(count))
            ]
        for x, y, yaw in spots:
            wx, wy = item.at(x / item.scale[0], y / item.scale[1])
            made = self._put(
                asset,
                round(wx, 3),
                round(wy, 3),
                round(normalize_axis(item.yaw + yaw + self.uni(-7, 7)), 3),
                item.z if item.z > 5 else 0.0,
                1.0,
                0.4,
                0.0,
            )
            self.relate("around", made, item)
            if made:
                found.append(made)
        return found
