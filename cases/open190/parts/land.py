"""Woods and fields, and rings of things."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cases.open190.layout import Assets, Box, Item, StagedPlace


def forest(
    p: StagedPlace,
    box: Box,
    trees: Assets,
    count: int,
    *,
    under: Assets = (),
    floor: int = 0,
    avoid: Sequence[Box] = (),
) -> None:
    """Trees at random with bushes, stones and flowers under them."""
    p.scatter(box, trees, count, clear=120, scale=(0.7, 1.15), avoid=avoid)
    if under and floor:
        p.scatter(box, under, floor, clear=15, scale=(0.8, 1.2), avoid=avoid)


def field(p: StagedPlace, box: Box, kind: str, *, soil: str = "Furrows", step: float = 130.0) -> int:
    """A field of one crop in rows along X."""
    x0, y0, x1, y1 = box
    p.ground(box, soil)
    row, count = p.one("crop", kind=kind), 0
    y = y0 + step / 2 + 20
    while y < y1 - 40:
        x = x0 + 215
        while x < x1 - 200:
            item = p.put(row, x, y)
            p.relate("in_row", item)
            count += item is not None
            x += 410
        y += step
    return count


def ring(
    p: StagedPlace,
    x: float,
    y: float,
    radius: float,
    assets: Assets,
    count: int,
    *,
    face: float = 90.0,
    start: float = 0.0,
    jitter: float = 0.0,
) -> list[Item]:
    """Things in a circle, fronts to its middle (``face`` 90) or away from it (-90)."""
    found = []
    for i in range(count):
        a = start + 360 * i / count
        item = p.put(
            assets,
            x + radius * math.cos(math.radians(a)) + p.uni(-jitter, jitter),
            y + radius * math.sin(math.radians(a)) + p.uni(-jitter, jitter),
            yaw=a + face,
        )
        p.relate("in_ring", item)
        if item:
            found.append(item)
    return found
