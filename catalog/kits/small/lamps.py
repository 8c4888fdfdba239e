"""Lamps that stand and lamps that hang."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.small.categories import LIGHTS


@family("lamp")
def lamp(m: KitMaker) -> None:
    """A lamp: on a table, on the floor, a candelabrum, a lantern."""
    kind = m.opt(
        "kind",
        m.pick("Lantern", "Candelabrum", "OilLamp")
        if m.style.old
        else m.pick("TableLamp", "DeskLamp", "FloorLamp", "ArcLamp"),
    )
    metal, glow = m.mat("metal"), m.mat("glow")
    m.say(
        kind,
        LIGHTS,
        f"{word(metal).capitalize()} {word(kind)}, lit.",
        camel(metal),
        camel(m.mat("cloth")),
        tags="lamp light",
    )
    b = m.b
    if kind == "TableLamp":
        b.lathe(m.mat("paint"), [(0, 0), (8, 0), (9, 6), (4, 18), (1.5, 26), (0, 26)])
        b.cylinder("WarmGlow", 15, 20, (0, 0, 26), top=9, segments=16, body="hull")
    elif kind == "DeskLamp":
        b.cylinder(metal, 10, 2, segments=16)
        b.tube(metal, [(0, -4, 2), (0, -12, 26), (0, 8, 42)], 1)
        b.cylinder(metal, 9, 10, (0, 12, 34), top=3, segments=14, body=None)
        b.cylinder(glow, 6, 1, (0, 12, 33.4), segments=10, body=None)
        b.body_box((18, 24, 40))
    elif kind == "FloorLamp":
        b.cylinder(metal, 16, 3, segments=16)
        b.cylinder(metal, 1.6, 140, segments=8)
        b.cylinder("WarmGlow", 22, 28, (0, 0, 138), top=15, segments=16)
    elif kind == "ArcLamp":
        b.cylinder("Marble", 18, 6, segments=16)
        b.tube(metal, [(0, 0, 6), (0, 0, 130), (0, 30, 180), (0, 80, 190), (0, 110, 170)], 1.6)
        b.ellipsoid("WarmGlow", (34, 34, 22), (0, 110, 148), segments=14, body=None)
        b.body_box((10, 10, 180))
    elif kind == "Lantern":
        b.box(metal, (16, 16, 3))
        b.box(glow, (10, 10, 18), (0, 0, 3), body="box")
        for x in (-6, 6):
            for y in (-6, 6):
                b.box(metal, (1.5, 1.5, 18), (x, y, 3), body=None)
        b.cylinder(metal, 11, 8, (0, 0, 21), top=2, segments=4)
    elif kind == "OilLamp":
        b.lathe("Brass", [(0, 0), (6, 0), (3, 4), (7, 9), (5, 13), (0, 13)])
        b.ellipsoid(glow, (8, 8, 14), (0, 0, 12), segments=10, body="hull")
    else:
        b.cylinder(metal, 18, 4, segments=14)
        b.cylinder(metal, 2.2, 130, segments=8)
        for k in range(5):
            a = k * 1.2566
            px, py = 24 * math.cos(a), 24 * math.sin(a)
            b.tube(metal, [(0, 0, 110), (px, py, 118), (px, py, 130)], 1.2)
            b.cylinder("Wax", 2, 14, (px, py, 130), segments=8, body=None)
            b.ellipsoid("WarmGlow", (3, 3, 6), (px, py, 144), segments=6, body=None)
        b.body_box((44, 44, 40), (0, 0, 105))


@family("ceiling-lamp")
def ceiling_lamp(m: KitMaker) -> None:
    """A lamp on a stand-alone gallows: a tall lamp post of a hall with hanging shades."""
    metal, high = m.mat("metal"), m.opt("high", 270.0)
    kind = m.pick("Globe", "Cone", "Ring")
    m.say(
        f"{kind}HallLamp",
        LIGHTS,
        f"Tall {word(metal)} lamp of a hall with a {kind.lower()} shade, {high / 100:.1f} m.",
        camel(metal),
        tags="lamp light tall",
    )
    m.b.cylinder(metal, 22, 4, segments=16)
    m.b.cylinder(metal, 2.4, high - 20, segments=8)
    if kind == "Globe":
        m.b.ellipsoid("WarmGlow", (40, 40, 40), (0, 0, high - 30), segments=14)
    elif kind == "Cone":
        m.b.cylinder("WarmGlow", 32, 26, (0, 0, high - 30), top=12, segments=16)
    else:
        m.b.lathe(
            "WhiteGlow", [(34, 0), (40, 0), (40, 8), (34, 8), (34, 0)], (0, 0, high - 24), smooth=False, body=None
        )
        for k in range(3):
            m.b.tube(metal, [(0, 0, high - 20), (36 * math.cos(k * 2.1), 36 * math.sin(k * 2.1), high - 20)], 1)
