"""Cranes."""

from __future__ import annotations

from catalog.kits.goods.categories import MACHINES
from catalog.kits.maker import KitMaker, camel, family, word


@family("crane")
def crane(m: KitMaker) -> None:
    """A tall crane: a harbour crane, a tower crane or a treadwheel crane."""
    kind = m.opt("kind", m.pick("HarbourCrane", "TowerCrane", "GantryCrane") if not m.style.old else "TreadwheelCrane")
    paint = m.opt("paint", m.pick("YellowPaint", "OrangePaint", "BluePaint", "RedPaint"))
    m.say(
        kind,
        MACHINES,
        f"{word(paint if kind != 'TreadwheelCrane' else 'Oak').capitalize()} {word(kind)}.",
        camel(paint),
        tags="crane machine lift",
    )
    b = m.b
    if kind == "HarbourCrane":
        for x in (-160, 160):
            for y in (-160, 160):
                b.box(paint, (34, 34, 500), (x, y, 0))
        b.box(paint, (380, 380, 50), (0, 0, 500))
        b.box(paint, (320, 240, 240), (-60, 0, 550))
        b.box("WindowGlass", (8, 180, 90), (101, 0, 660), body=None)
        b.box(paint, (1100, 40, 40), (420, 0, 1000), (38, 0, 0), body=None)
        b.tube("Iron", [(-120, 0, 790), (-60, 0, 1250), (800, 0, 1330)], 5)
        b.tube("Iron", [(845, 0, 1340), (845, 0, 500)], 3)
        b.box("Iron", (30, 20, 50), (845, 0, 450), body=None)
    elif kind == "TowerCrane":
        b.box("Concrete", (420, 420, 60))
        for x in (-60, 60):
            for y in (-60, 60):
                b.box(paint, (14, 14, 2600), (x, y, 60), body=None)
        for k in range(17):
            for y in (-60, 60):
                b.tube(paint, [(-60, y, 60 + 150 * k), (60, y, 210 + 150 * k)], 4)
                b.tube(paint, [(y, -60, 60 + 150 * k), (y, 60, 210 + 150 * k)], 4)
        b.body_box((134, 134, 2600), (0, 0, 60))
        b.box(paint, (2200, 60, 50), (700, 0, 2600), body=None)
        b.box("Concrete", (160, 140, 180), (-360, 0, 2460), body=None)
        b.box("WhitePaint", (110, 110, 140), (90, 80, 2450), body=None)
        b.tube("Iron", [(-350, 0, 2650), (0, 0, 2850), (1500, 0, 2650)], 4)
        b.tube("Iron", [(1200, 0, 2600), (1200, 0, 1500)], 3)
        b.box("Iron", (40, 30, 60), (1200, 0, 1450), body=None)
    elif kind == "GantryCrane":
        for y in (-700, 700):
            for x in (-200, 200):
                b.box(paint, (40, 40, 900), (x, y, 0))
            b.box(paint, (480, 40, 50), (0, y, 860), body=None)
        b.box(paint, (120, 1900, 90), (0, 0, 900))
        b.box("WhitePaint", (140, 160, 160), (0, 180, 740), body=None)
        b.tube("Iron", [(0, 0, 900), (0, 0, 520)], 4)
        b.box("Iron", (240, 60, 20), (0, 0, 500), body=None)
    else:
        for x in (-100, 100):
            b.box("Oak", (24, 24, 520), (x, 0, 0))
            b.cylinder("Oak", 150, 20, (x * 0.6, 0, 190), (-90, 0, 0), segments=20, body=None)
        b.box("Oak", (300, 300, 20))
        b.box("Oak", (240, 160, 20), (0, 0, 510))
        b.gable("Shingle", (200, 280, 100), (0, 0, 520), (0, 90, 0))
        b.box("Oak", (22, 520, 22), (0, 200, 560), (0, 0, 22), body=None)
        b.tube("Rope", [(0, 430, 650), (0, 430, 200)], 3)
        b.box("Pine", (60, 60, 50), (0, 430, 150), body=None)
