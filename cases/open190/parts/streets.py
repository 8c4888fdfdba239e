"""Streets: houses along a line, a street between them, a car park."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cases.open190.layout import Box, Item, Pair, StagedPlace


def frontage(
    p: StagedPlace, a: Pair, b: Pair, houses: Sequence[str], gap: Pair = (0.0, 0.0), setback: Pair = (0.0, 0.0)
) -> list[Item]:
    """Houses along a line from a to b whose fronts lie on it and look to its left; each once, then over again."""
    length, yaw = math.hypot(b[0] - a[0], b[1] - a[1]), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
    x, number = 0.0, 0
    found: list[Item] = []
    while True:
        thing = p.thing(houses[number % len(houses)])
        number += 1
        if x + thing.width > length:
            return found
        with p.at(a[0], a[1], yaw):
            item = p.put(thing.name, x - thing.low[0], -thing.high[1] - p.uni(*setback), slack=2.0)
        p.relate("along", item, found[-1] if found else None)
        if item:
            found.append(item)
        x += thing.width + 2 + p.uni(*gap)


def street(
    p: StagedPlace,
    x0: float,
    x1: float,
    y: float,
    *,
    north: Sequence[str] = (),
    south: Sequence[str] = (),
    wide: float = 700.0,
    pavement: str = "Paving",
    trees: Sequence[str] = (),
    cars: Sequence[str] = (),
    lamps: Sequence[str] = (),
    clutter: Sequence[str] = (),
    gap: Pair = (0.0, 0.0),
    setback: Pair = (10.0, 20.0),
    road: str = "Asphalt",
    share: float = 0.6,
) -> None:
    """A road along X with pavements, parked cars, lamps and trees, and houses on both sides."""
    length = x1 - x0
    pieces = max(1, round(length / 800))
    asset = p.one("road", length=round(length / pieces, 1), wide=wide, of=road)
    for i in range(pieces):
        p.put(asset, x0 + (i + 0.5) * length / pieces, y, 0.4)
    walk = 300.0
    for side in (-1, 1):
        p.ground(
            (x0, y + side * wide / 2 - (walk if side < 0 else 0), x1, y + side * wide / 2 + (walk if side > 0 else 0)),
            pavement,
            tile=walk,
            z=0.6,
        )
        edge = y + side * (wide / 2 + 55)
        if lamps:
            p.row((x0 + 200, edge), (x1 - 200, edge), lamps, max(2, int(length / 1400)), yaw=0 if side < 0 else 180)
        if trees:
            p.row(
                (x0 + 700, edge + side * 20),
                (x1 - 700, edge + side * 20),
                trees,
                max(1, int(length / 1100)),
                jitter=20,
                scale=(0.6, 0.8),
            )
        if cars:
            for i in range(int(length / 620)):
                if p.random.random() < share:
                    p.put(
                        cars,
                        x0 + 320 + i * 620 + p.uni(-20, 20),
                        y + side * (wide / 2 - 115),
                        0.4,
                        0 if side > 0 else 180,
                    )
        if clutter:
            for _ in range(int(length / 260)):
                p.put(
                    clutter, p.uni(x0 + 60, x1 - 60), y + side * (wide / 2 + p.uni(110, 180)), 0, 0 if side < 0 else 180
                )
    line = wide / 2 + walk
    if north:
        frontage(p, (x1, y + line), (x0, y + line), north, gap, setback)
    if south:
        frontage(p, (x0, y - line), (x1, y - line), south, gap, setback)


def car_park(p: StagedPlace, box: Box, cars: Sequence[str], *, share: float = 0.7) -> None:
    """Rows of parking bays, most of them taken."""
    x0, y0, x1, y1 = box
    lines = max(1, int((y1 - y0) // 1250))
    length = x1 - x0
    bay = p.one("road", length=round(length, 1), wide=550.0, mark="bays")
    p.ground(box, "Asphalt", tile=800)
    for j in range(lines):
        y = y0 + 300 + j * (y1 - y0) / lines
        p.put(bay, (x0 + x1) / 2, y, 0.8)
        count = int(length // 270)
        for i in range(count):
            if p.random.random() < share:
                p.relate(
                    "in_row",
                    p.put(
                        cars, x0 + (i + 0.5) * length / count, y + p.uni(-12, 12), 0.8, 90 * p.random.choice((1, -1))
                    ),
                )
