"""Instruments and stage things."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word


@family("music")
def music(m: KitMaker) -> None:
    """Instruments and stage things."""
    kind = m.opt(
        "kind",
        m.pick(
            "Piano", "GrandPiano", "DrumKit", "Harp", "MusicStand", "Loudspeaker", "Organ", "Lectern", "Globe", "Easel"
        ),
    )
    wood = m.mat("wood")
    m.say(
        {"Globe": "FloorGlobe"}.get(kind, kind),
        "decor",
        f"{word(wood).capitalize()} {word(kind)}.",
        camel(wood),
        tags="music stage decor",
    )
    b = m.b
    if kind in ("Piano", "Organ"):
        b.box(wood, (150, 40, 125), (0, -10, 0), bevel=1)
        b.box(wood, (150, 34, 8), (0, 24, 64))
        b.box("WhitePaint", (124, 14, 2), (0, 30, 72), body=None)
        for i in range(16):
            b.box("BlackPaint", (3, 8, 1.5), (-58 + 7.6 * i, 27, 74), body=None)
        for x in (-66, 66):
            b.box(wood, (8, 8, 64), (x, 34, 0))
        if kind == "Organ":
            for i in range(11):
                b.cylinder("Brass", 5, 110 + 12 * abs(5 - i), (-60 + 12 * i, -10, 125), segments=10, body=None)
            b.body_box((140, 20, 110), (0, -10, 125))
    elif kind == "GrandPiano":
        b.extrude("BlackPaint", [(-75, 60), (75, 60), (75, 20), (40, -60), (0, -110), (-75, -120)], 28, (0, 0, 70))
        b.box("WhitePaint", (124, 14, 2), (0, 52, 98), body=None)
        for x, y in ((-62, 45), (62, 45), (-50, -95)):
            b.cylinder("BlackPaint", 5, 70, (x, y, 0), segments=10)
        b.box("BlackPaint", (150, 2, 90), (-20, -20, 98), (0, 20, 0), body=None)
    elif kind == "DrumKit":
        b.cylinder(m.mat("paint"), 28, 44, (0, -22, 30), (0, 0, 90), segments=20)
        for x, y, z in ((-34, -14, 62), (34, -14, 62), (44, -40, 30)):
            b.cylinder(m.mat("paint"), 18, 20, (x, y, z), segments=16, body=None)
            b.cylinder("Iron", 2, z, (x, y, 0), segments=6, body=None)
        for x in (-60, 62):
            b.cylinder("Iron", 1.2, 110, (x, 0, 0), segments=6, body=None)
            b.cylinder("Brass", 22, 1.5, (x, 0, 110), top=4, segments=18, body=None)
        b.body_box((130, 70, 80), (0, -10, 0))
    elif kind == "Harp":
        b.box(wood, (30, 50, 8))
        b.tube("Gold", [(0, 20, 8), (0, 34, 150), (0, 0, 165), (0, -30, 130), (0, -20, 8)], 4)
        for i in range(9):
            b.tube("Linen", [(0, -14 + 5 * i, 20), (0, -20 + 6 * i, 140)], 0.4)
        b.body_box((24, 70, 150))
    elif kind == "Loudspeaker":
        b.box("BlackPaint", (44, 40, 110), bevel=2)
        for z, r in ((28, 16), (64, 16), (92, 8)):
            b.cylinder("GreyPaint", r, 2, (0, 20, z), (0, 0, 90), segments=16, body=None)
    elif kind in ("MusicStand", "Lectern"):
        b.cylinder(wood, 22, 4, segments=14)
        b.cylinder(wood, 3.5, 105, segments=8)
        b.box(wood, (54, 38, 3), (0, 0, 104), (0, 0, 24), body="box")
        b.box("Paper", (40, 28, 1), (0, 0, 107.5), (0, 0, 24), body=None)
    elif kind == "Globe":
        for k in range(3):
            b.tube(
                wood,
                [
                    (26 * math.cos(k * 2.1), 26 * math.sin(k * 2.1), 0),
                    (8 * math.cos(k * 2.1), 8 * math.sin(k * 2.1), 56),
                ],
                2.5,
            )
        b.ellipsoid("SkyPaint", (52, 52, 52), (0, 0, 54))
        b.lathe("Brass", [(27, 0), (29, 0), (29, 3), (27, 3), (27, 0)], (0, 0, 78), smooth=False, body=None)
        b.body_box((44, 44, 54))
    else:
        for x in (-26, 26):
            b.tube(wood, [(x, 14, 0), (0, 0, 170)], 2.2)
        b.tube(wood, [(0, -44, 0), (0, 0, 168)], 2.2)
        b.box(wood, (60, 5, 4), (0, 14, 66))
        b.box("CreamPaint", (74, 3, 60), (0, 12, 70), (0, 0, -8), body="box")
        b.panel(m.pick("Landscape", "Sunset", "Seascape"), 66, 52, (0, 15.4, 74), (0, 0, -8))
        b.body_box((50, 56, 40), (0, -12, 0))
