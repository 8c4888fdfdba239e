"""Pieces of playgrounds."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import PLAY


@family("play")
def play(m: KitMaker) -> None:
    """A piece of a playground."""
    kind = m.opt(
        "kind", m.pick("Slide", "Swing", "Seesaw", "Sandbox", "ClimbingFrame", "Roundabout", "SpringHorse", "PlayHouse")
    )
    paint, second = m.mat("paint"), m.another("paint")
    m.say(
        kind,
        PLAY,
        f"{word(paint).capitalize()} {word(kind)} for children.",
        camel(paint),
        tags="playground children play",
    )
    b = m.b
    if kind == "Slide":
        b.box(second, (90, 90, 6), (0, -140, 150))
        for x in (-42, 42):
            for y in (-180, -100):
                b.box(paint, (8, 8, 240 if y else 150), (x, y, 0))
        b.gable("RedPaint", (120, 110, 50), (0, -140, 240), body=None)
        for i in range(6):
            b.box(second, (60, 20, 5), (0, -195 - 0, 22 + 24 * i), body=None)
        b.box("SilverPaint", (56, 250, 5), (0, -6, 72), (0, 0, 33), body="box")
        for x in (-30, 30):
            b.box(paint, (5, 250, 20), (x, -6, 72), (0, 0, 33), body=None)
    elif kind == "Swing":
        for x in (-160, 160):
            for y in (-1, 1):
                b.tube(paint, [(x, y * 80, 0), (x, 0, 230)], 5)
            b.body_box((12, 160, 60), (x, 0, 0))
        b.tube(paint, [(-165, 0, 230), (165, 0, 230)], 5)
        for x in (-70, 70):
            for s in (-20, 20):
                b.tube("Iron", [(x + s, 0, 230), (x + s, 0, 50)], 1)
            b.box(second, (46, 20, 4), (x, 0, 46))
    elif kind == "Seesaw":
        b.cylinder(second, 20, 50, top=8, segments=10)
        b.box(paint, (320, 28, 7), (0, 0, 48), (8, 0, 0))
        for x in (-130, 130):
            b.tube(
                "Iron",
                [(x, -14, 56 + x * 0.14), (x, -14, 84 + x * 0.14), (x, 14, 84 + x * 0.14), (x, 14, 56 + x * 0.14)],
                2,
            )
    elif kind == "Sandbox":
        for side in (-1, 1):
            b.box(paint, (300, 20, 30), (0, side * 140, 0))
            b.box(paint, (20, 260, 30), (side * 140, 0, 0))
        b.box("Sand", (260, 260, 14), body="box")
        b.cylinder("Sand", 40, 34, (40, 20, 12), top=5, segments=12, body=None)
        b.cylinder(second, 10, 18, (-50, -30, 14), top=13, segments=12, body=None)
    elif kind == "ClimbingFrame":
        for x in (-120, -40, 40, 120):
            for y in (-80, 0, 80):
                b.cylinder(paint if (x + y) % 3 else second, 3.5, 220, (x, y, 0), segments=8, body=None)
        for z in (70, 140, 215):
            for y in (-80, 0, 80):
                b.tube(second, [(-122, y, z), (122, y, z)], 3)
            for x in (-120, -40, 40, 120):
                b.tube(paint, [(x, -82, z), (x, 82, z)], 3)
        b.body_box((250, 170, 220))
    elif kind == "Roundabout":
        b.cylinder("Iron", 20, 20, segments=12)
        b.cylinder(paint, 120, 8, (0, 0, 18), segments=24)
        for k in range(6):
            a = k * math.pi / 3
            b.tube(
                second,
                [(0, 0, 80), (60 * math.cos(a), 60 * math.sin(a), 84), (105 * math.cos(a), 105 * math.sin(a), 26)],
                2.5,
            )
        b.body_box((90, 90, 60), (0, 0, 26))
    elif kind == "SpringHorse":
        b.lathe("Iron", [(16, 0), (12, 10), (16, 20), (12, 30), (14, 36)], smooth=False)
        b.ellipsoid(paint, (40, 90, 36), (0, 0, 36))
        b.ellipsoid(second, (24, 36, 44), (0, 46, 58), body=None)
        b.tube("BlackPaint", [(-22, 34, 84), (22, 34, 84)], 2)
    else:
        b.box("PalePlanks", (160, 150, 130))
        b.gable(paint, (190, 180, 80), (0, 0, 130))
        b.box("BlackPaint", (50, 6, 90), (-30, 74, 0), body=None)
        b.box(second, (40, 8, 36), (40, 74, 60), body=None)
