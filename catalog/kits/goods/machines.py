"""Machines of workshops."""

from __future__ import annotations

import math

from catalog.kits.goods.categories import MACHINES
from catalog.kits.maker import KitMaker, camel, family, word


@family("machine")
def machine(m: KitMaker) -> None:
    """A machine of a workshop or factory."""
    kind = m.opt(
        "kind",
        m.pick(
            "Lathe",
            "MillingMachine",
            "DrillPress",
            "Generator",
            "Compressor",
            "Boiler",
            "HydraulicPress",
            "RobotArm",
            "ConveyorBelt",
            "PackingMachine",
            "BandSaw",
            "GrindingMachine",
            "WaterPump",
            "CncMachine",
            "PrintingPress",
            "Loom",
        ),
    )
    paint = m.mat("paint")
    m.say(
        kind,
        MACHINES,
        f"{word(paint).capitalize()} {word(kind)} of a workshop.",
        camel(paint),
        tags="machine industry workshop",
    )
    b = m.b
    if kind == "Lathe":
        b.box(paint, (220, 70, 60), (0, 0, 20), bevel=3)
        for x in (-80, 80):
            b.box(paint, (50, 60, 20), (x, 0, 0))
        b.box(paint, (60, 60, 60), (-80, 0, 80), bevel=3)
        b.cylinder("Steel", 5, 130, (-50, 0, 106), (-90, 0, 0), segments=10, body=None)
        b.box("Steel", (40, 50, 24), (20, 6, 80))
        b.cylinder("SilverPaint", 16, 10, (-50, 0, 106), (-90, 0, 0), segments=14, body=None)
        b.cylinder("BlackPaint", 10, 3, (20, 36, 88), (0, 0, 90), segments=12, body=None)
    elif kind in ("MillingMachine", "DrillPress"):
        b.box(paint, (80, 90, 20), bevel=2)
        b.box(paint, (44, 50, 170), (0, -18, 20), bevel=4)
        b.box(paint, (50, 80, 44), (0, 10, 150), bevel=5)
        b.cylinder("Steel", 4, 36, (0, 32, 116), segments=8, body=None)
        b.box("Steel", (100 if kind == "MillingMachine" else 44, 40, 8), (0, 30, 78))
        for k in range(3):
            b.tube("BlackPaint", [(26, 20, 165), (34, 20 + 24 * math.cos(k * 2.1), 165 + 24 * math.sin(k * 2.1))], 2)
    elif kind == "Generator":
        b.box("Iron", (260, 100, 14))
        b.box(paint, (150, 90, 110), (-40, 0, 14), bevel=4)
        b.cylinder(m.another("paint"), 44, 80, (40, 0, 62), (-90, 0, 0), segments=18)
        b.cylinder("Iron", 7, 70, (-80, 0, 124), segments=10, body=None)
        for i in range(5):
            b.box("BlackPaint", (80, 2, 5), (-40, 45, 50 + 12 * i), body=None)
    elif kind == "Compressor":
        b.cylinder(paint, 34, 160, (-80, 0, 60), (-90, 0, 0), segments=18)
        for x in (-60, 60):
            b.box("Iron", (10, 50, 30), (x, 0, 0))
        b.box("Iron", (60, 50, 44), (-10, 0, 92), bevel=4)
        b.cylinder("BlackPaint", 22, 8, (30, 20, 116), (0, 0, 90), segments=16, body=None)
    elif kind == "Boiler":
        b.cylinder(paint, 70, 220, (0, 0, 20), segments=24)
        b.ellipsoid(paint, (140, 140, 60), (0, 0, 210), body=None)
        b.cylinder("Copper", 12, 120, (0, 0, 240), segments=12, body=None)
        b.box("Iron", (50, 8, 40), (0, 68, 60), body=None)
        for s in (-1, 1):
            b.cylinder("WhitePaint", 11, 4, (s * 24, 69, 160), (0, 0, 90), segments=14, body=None)
        b.cylinder("Iron", 60, 20, segments=16)
    elif kind == "HydraulicPress":
        for x in (-55, 55):
            b.box(paint, (24, 60, 220), (x, 0, 0))
        b.box(paint, (150, 80, 60), (0, 0, 190), bevel=4)
        b.box(paint, (140, 80, 60))
        b.cylinder("Steel", 14, 60, (0, 0, 130), segments=12, body=None)
        b.box("Steel", (70, 56, 12), (0, 0, 120))
    elif kind == "RobotArm":
        b.cylinder("Iron", 40, 30, segments=18)
        b.cylinder(paint, 28, 50, (0, 0, 30), segments=16)
        b.box(paint, (28, 30, 110), (0, 0, 70), (0, 0, -18))
        b.box(paint, (24, 110, 24), (0, 60, 166), (0, 0, -10), body="box")
        b.cylinder("Iron", 8, 30, (0, 118, 136), segments=10, body=None)
    elif kind == "ConveyorBelt":
        b.box(paint, (300, 70, 12), (0, 0, 70))
        b.box("Rubber", (296, 56, 4), (0, 0, 82))
        for x in (-120, 0, 120):
            for y in (-30, 30):
                b.box("Iron", (7, 7, 70), (x, y, 0))
        m.top(86, 270, 40)
    elif kind in ("BandSaw", "GrindingMachine"):
        b.box(paint, (70, 60, 80), bevel=3)
        b.box("Steel", (90, 70, 5), (0, 0, 80))
        if kind == "BandSaw":
            b.box(paint, (60, 30, 60), (-8, 0, 140), bevel=10)
            b.box(paint, (14, 26, 70), (-32, 0, 85))
            b.box("Steel", (1, 3, 60), (14, 0, 85), body=None)
        else:
            b.cylinder("GreyPaint", 22, 60, (-30, 0, 108), (-90, 0, 0), segments=14)
            for x in (-40, 34):
                b.cylinder("Cinder", 19, 8, (x, 0, 108), (-90, 0, 0), segments=16, body=None)
    elif kind == "WaterPump":
        b.box("Concrete", (160, 70, 16))
        b.cylinder(paint, 28, 80, (-70, 0, 50), (-90, 0, 0), segments=16)
        b.cylinder(paint, 32, 24, (30, 0, 52), (-90, 0, 0), segments=18)
        b.cylinder("Steel", 10, 60, (42, 0, 60), segments=12, body=None)
    elif kind == "PrintingPress":
        b.box(m.mat("wood"), (90, 160, 14), (0, 0, 66))
        for x in (-46, 46):
            b.box(m.mat("wood"), (16, 20, 200), (x, 0, 0))
        b.box(m.mat("wood"), (110, 26, 20), (0, 0, 180))
        b.cylinder("Iron", 8, 70, (0, 0, 112), segments=10, body=None)
        b.box("Iron", (70, 60, 8), (0, 0, 104))
        b.tube("Oak", [(0, 0, 140), (0, 90, 146)], 3)
    elif kind == "Loom":
        for x in (-70, 70):
            for y in (-70, 70):
                b.box(m.mat("wood"), (10, 10, 160), (x, y, 0))
            b.box(m.mat("wood"), (10, 150, 8), (x, 0, 150), body=None)
        b.box(m.mat("cloth"), (120, 60, 3), (0, 40, 80), body="box")
        b.box("Linen", (120, 80, 1), (0, -30, 86), (0, 0, 8), body=None)
        b.cylinder(m.mat("wood"), 8, 140, (-70, -70, 90), (-90, 0, 0), segments=10)
    else:
        b.box(paint, (200, 120, 180), bevel=4)
        b.box("WindowGlass", (90, 4, 70), (-30, 59, 80), body=None)
        b.box("Screen", (34, 6, 26), (66, 60, 116), body=None)
        b.box("GreyPaint", (44, 10, 60), (66, 56, 84), body=None)
        b.cylinder("RedGlow", 5, 12, (80, 40, 180), segments=8, body=None)
        b.box("BlackPaint", (200, 122, 10), body=None)
