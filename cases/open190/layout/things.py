"""What layout rules put somewhere: things, how they stand to others, and the measures of places."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from c4s.records.level import Vector
from catalog.kits.maker import KitAsset

TOP_CM = 4.5
"""The support rule of text-to-scene knows only the top of a whole thing, and nothing that is further above."""
Assets = str | Sequence[str]
Pair = tuple[float, float]
Box = tuple[float, float, float, float]
"""A rectangle: x0, y0, x1, y1."""


@dataclass(frozen=True)
class Item:
    """A thing that was placed."""

    label: str
    thing: KitAsset
    x: float
    y: float
    z: float
    yaw: float
    scale: Vector

    def at(self, x: float, y: float) -> Pair:
        """World place of a point in the thing's axes."""
        c, s = math.cos(math.radians(self.yaw)), math.sin(math.radians(self.yaw))
        return self.x + x * self.scale[0] * c - y * self.scale[1] * s, self.y + x * self.scale[0] * s + y * self.scale[
            1
        ] * c


@dataclass(frozen=True)
class Relation:
    """How a placed thing stands to another, or to its like: ``on``, ``around``, ``in_row``, ``along``, ``in_grid``."""

    kind: str
    subject: str
    reference: str = ""
