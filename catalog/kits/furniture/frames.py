"""Categories of furniture, and the legs that several pieces stand on."""

from __future__ import annotations

from catalog.kits.maker import KitMaker

SEATS, TABLES, BEDS, STORAGE, KITCHEN, BATH = "seating", "tables", "beds", "storage", "kitchen", "bathroom"


def legs(
    m: KitMaker, of: str, width: float, depth: float, height: float, thick: float = 5.0, *, round_: bool = False
) -> None:
    """Four legs at the corners of a rectangle."""
    for x in (-1, 1):
        for y in (-1, 1):
            at = (x * (width - thick) / 2, y * (depth - thick) / 2, 0.0)
            if round_:
                m.b.cylinder(of, thick / 2, height, at, top=thick / 2.6, segments=8)
            else:
                m.b.box(of, (thick, thick, height), at)
