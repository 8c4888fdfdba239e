"""Aeroplanes."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.vehicles.categories import VEHICLES


@family("plane")
def plane(m: KitMaker) -> None:
    """A small aeroplane."""
    paint = m.mat("paint")
    m.say(
        "LightAircraft",
        VEHICLES,
        f"{word(paint).capitalize()} light aircraft with one propeller, wings 10 m wide, nose to +X.",
        camel(paint),
        tags="aircraft plane vehicle",
    )
    m.b.lathe("WhitePaint", [(0, 0), (50, 40), (62, 160), (56, 380), (20, 700), (0, 720)], (340, 0, 120), (90, 0, 0))
    m.b.box(paint, (130, 1000, 14), (90, 0, 170))
    m.b.box(paint, (80, 330, 10), (-320, 0, 130))
    m.b.box(paint, (90, 8, 130), (-330, 0, 130), (0, 0, 0))
    m.b.box("WindowGlass", (110, 90, 50), (140, 0, 150), body=None)
    m.b.box("BlackPaint", (6, 190, 16), (345, 0, 112), body=None)
    for x, y in ((220, 0), (60, 90), (60, -90)):
        m.b.cylinder("Rubber", 20, 12, (x, y - 6, 20), (0, 0, 90), segments=14)
        m.b.tube("Iron", [(x, y, 20), (x, y * 0.5, 90)], 3)
