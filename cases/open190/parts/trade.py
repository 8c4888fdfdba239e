"""Markets, and yards of containers."""

from __future__ import annotations

from cases.open190.layout import Assets, Box, StagedPlace


def market(p: StagedPlace, box: Box, columns: int, lines: int, goods: Assets) -> None:
    """Stalls in rows back to back with goods between them."""
    x0, y0, x1, y1 = box
    stalls = p.kinds_of(
        "stall", "ware", "Fruit", "Vegetable", "Bread", "Cheese", "Fish", "Cloth", "Pottery", "Spice", "Flower", "Book"
    )
    for j in range(lines):
        for i in range(columns):
            x, y = x0 + (i + 0.5) * (x1 - x0) / columns, y0 + (j + 0.5) * (y1 - y0) / lines
            p.relate("in_grid", p.put(stalls, x, y, yaw=0 if j % 2 else 180))
            for s in (-1, 1):
                p.put(goods, x + s * 165, y + p.uni(-60, 60), yaw=p.uni(-20, 20))


def container_yard(
    p: StagedPlace, x: float, y: float, columns: int, lines: int, levels: int = 3, *, long_: bool = False
) -> None:
    """Blocks of stacked containers."""
    boxes = p.kit("container", 6, long=long_)
    step_x = 1240 if long_ else 640
    for i in range(columns):
        for j in range(lines):
            base = p.put(boxes, x + i * step_x, y + j * 270)
            below = base
            for level in range(p.random.randint(0, levels - 1)):
                if below is None:
                    break
                item = p.put(boxes, x + i * step_x, y + j * 270, (level + 1) * 259.4)
                p.relate("on", item, below)
                below = item
