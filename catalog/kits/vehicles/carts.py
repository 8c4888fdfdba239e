"""Tractors and wagons."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.carts import wheel
from catalog.kits.vehicles.categories import VEHICLES
from catalog.kits.vehicles.wheels import tyres
from catalog.shapes.patches import hull


@family("tractor")
def tractor(m: KitMaker) -> None:
    """A tractor, a digger, a forklift or a roller."""
    kind = m.opt("kind", m.pick("Tractor", "Excavator", "Forklift", "RoadRoller", "Bulldozer"))
    paint = m.opt("paint", m.pick("YellowPaint", "OrangePaint", "RedPaint", "GreenPaint"))
    m.say(
        kind,
        VEHICLES,
        f"{word(paint).capitalize()} {word(kind)}, nose to +X.",
        camel(paint),
        tags="vehicle machine work",
    )
    b = m.b
    if kind == "Tractor":
        b.box(paint, (180, 80, 60), (50, 0, 70), bevel=6)
        b.box("BlackPaint", (4, 60, 44), (141, 0, 78), body=None)
        b.box(paint, (110, 110, 40), (-70, 0, 80))
        for s in (-1, 1):
            for x in (-115, -25):
                b.box("Iron", (6, 6, 100), (x, s * 48, 120), body=None)
            b.cylinder("Rubber", 70, 36, (-80, s * 84 - 18, 70), (0, 0, 90), segments=18)
            b.cylinder("YellowPaint", 36, 38, (-80, s * 84 - 19, 70), (0, 0, 90), segments=12, body=None)
            b.cylinder("Rubber", 40, 26, (105, s * 66 - 13, 40), (0, 0, 90), segments=16)
        b.box(paint, (120, 116, 8), (-70, 0, 218))
        b.box("WindowGlass", (86, 92, 92), (-70, 0, 124), body=None)
        b.cylinder("Iron", 5, 90, (80, 26, 130), segments=8, body=None)
    elif kind == "Forklift":
        b.box(paint, (170, 100, 70), (-20, 0, 24), bevel=5)
        b.box("BlackPaint", (50, 60, 10), (-20, 0, 94), body=None)
        for s in (-1, 1):
            for x in (-90, 50):
                b.box("Iron", (6, 6, 120), (x, s * 44, 90), body=None)
            b.box("Iron", (12, 8, 230), (84, s * 34, 10))
            b.box("Iron", (110, 12, 5), (140, s * 26, 6))
        b.box(paint, (150, 100, 6), (-20, 0, 210))
        b.box("Iron", (8, 80, 60), (92, 0, 8), body=None)
        tyres(m, (-70, 40), 50, 26, 22)
    elif kind == "RoadRoller":
        b.cylinder("Iron", 65, 170, (110, -85, 65), (0, 0, 90), segments=24)
        b.cylinder("Iron", 65, 170, (-120, -85, 65), (0, 0, 90), segments=24)
        b.box(paint, (210, 120, 70), (0, 0, 90), bevel=6)
        b.box(paint, (130, 130, 8), (-10, 0, 262))
        for x in (-66, 46):
            for s in (-1, 1):
                b.box("Iron", (6, 6, 105), (x, s * 56, 158), body=None)
    else:
        for s in (-1, 1):
            b.box("Rubber", (260, 50, 70), (0, s * 85, 0), bevel=24)
        b.box(paint, (220, 150, 80), (-10, 0, 72), bevel=8)
        b.box("WindowGlass", (90, 100, 100), (-10, 20, 150), body="box")
        b.box(paint, (100, 110, 8), (-10, 20, 250), body=None)
        if kind == "Excavator":
            b.box(paint, (240, 30, 34), (170, -40, 190), (38, 0, 0))
            b.box(paint, (200, 24, 28), (310, -40, 200), (-52, 0, 0))
            b.box("Iron", (80, 70, 60), (350, -40, 60), (20, 0, 0))
        else:
            b.box("Iron", (24, 240, 100), (190, 0, 8), (8, 0, 0))
            for s in (-1, 1):
                b.box(paint, (90, 14, 16), (140, s * 70, 40), body=None)


@family("cart")
def wagon(m: KitMaker) -> None:
    """A four-wheeled wagon, a coach or a covered wagon."""
    kind, wood = m.opt("kind", m.pick("HayWagon", "CoveredWagon", "Coach", "BarrelWagon")), m.mat("wood")
    m.say(
        kind,
        VEHICLES,
        f"{word(wood).capitalize()} {word(kind)} on four wheels, pole to +X.",
        camel(wood),
        tags="wagon cart vehicle wood",
    )
    m.b.box(wood, (300, 140, 14), (0, 0, 70))
    for x in (-100, 100):
        for y in (-86, 86):
            wheel(m, m.mat("trim"), 55, (x, y, 58), 90)
    m.b.body_box((300, 176, 70))
    m.b.box(wood, (170, 10, 10), (230, 0, 66), body=None)
    if kind == "Coach":
        m.b.box(m.mat("paint"), (190, 140, 150), (-10, 0, 92), bevel=10)
        for s in (-1, 1):
            m.b.box("WindowGlass", (60, 4, 50), (-10, s * 70, 170), body=None)
        m.b.box("Gold", (200, 150, 6), (-10, 0, 240), body=None)
    else:
        for s in (-1, 1):
            m.b.box(wood, (300, 6, 44), (0, s * 68, 84))
        if kind == "CoveredWagon":
            points = [
                (x, 74 * math.cos(a), 120 + 110 * math.sin(a))
                for x in (-145.0, 145.0)
                for a in [k * math.pi / 8 for k in range(9)]
            ]
            m.b.add("WhiteSail", hull(points))
        elif kind == "HayWagon":
            m.b.ellipsoid("Hay", (290, 140, 150), (0, 0, 66))
        else:
            for i in range(4):
                m.b.lathe("Oak", [(0, 0), (26, 0), (32, 40), (26, 80), (0, 80)], (-105 + 70 * i, 0, 84), segments=12)
