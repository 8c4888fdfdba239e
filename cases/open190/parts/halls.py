"""Halls indoors: aisles of shelves, rows of desks."""

from __future__ import annotations

from collections.abc import Sequence

from cases.open190.layout import Assets, Box, StagedPlace


def aisles(
    p: StagedPlace,
    box: Box,
    lines: int,
    shelf: str,
    goods: Sequence[Sequence[str]],
    *,
    gap: float = 4.0,
    share: float = 0.92,
) -> int:
    """Double rows of stocked shelves along X; each row has one kind of goods."""
    x0, y0, x1, y1 = box
    thing, count = p.thing(shelf), 0
    per = int((x1 - x0) // (thing.width + 1))
    for j in range(lines):
        y = y0 + (j + 0.5) * (y1 - y0) / lines
        for side in (-1, 1):
            for i in range(per):
                item = p.put(
                    shelf,
                    x0 + (i + 0.5) * (thing.width + 1),
                    y + side * (thing.depth / 2 + 1),
                    yaw=0 if side > 0 else 180,
                )
                p.relate("in_row", item)
                count += p.stock(item, goods[(2 * j + (side > 0)) % len(goods)], gap, share)
    return count


def desks(
    p: StagedPlace,
    box: Box,
    columns: int,
    lines: int,
    desk: Assets,
    chair: Assets,
    things: Assets,
    *,
    each: int = 3,
    yaw: float = 0.0,
    must: Assets = (),
) -> None:
    """A grid of desks with a chair before and things on each."""
    for item in p.grid(box, desk, columns, lines, yaw=yaw):
        x, y = item.at(p.uni(-6, 6), item.thing.high[1] + 28)
        c = p.thing(p.choose(chair))
        p.relate("beside", p.put_world(c.name, x, y, item.yaw + 180 + p.uni(-12, 12)), item)
        if must:
            p.middle(item, must, yaw=0)
        p.on(item, things, each)
