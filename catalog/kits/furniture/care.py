"""Equipment of a ward, a laboratory, a gymnasium, a salon."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word


@family("care")
def care(m: KitMaker) -> None:
    """Equipment of a ward, a laboratory, a gymnasium, a salon."""
    kind = m.opt(
        "kind",
        m.pick(
            "DripStand",
            "BedScreen",
            "Wheelchair",
            "PatientMonitor",
            "MedicineTrolley",
            "LabBench",
            "Microscope",
            "Treadmill",
            "WeightBench",
            "ExerciseBike",
            "VaultingBox",
        ),
    )
    paint = m.mat("paint")
    m.say(kind, "equipment", f"{word(paint).capitalize()} {word(kind)}.", camel(paint), tags="equipment medical sport")
    b = m.b
    if kind == "DripStand":
        for k in range(5):
            b.box("Steel", (28, 3, 3), (0, 0, 3), (0, 72 * k, 0), body=None)
        b.cylinder("Steel", 1.6, 180, segments=8)
        b.box("SkyPaint", (12, 4, 24), (9, 0, 150), body=None)
        b.body_box((44, 44, 6))
    elif kind == "BedScreen":
        for x in (-60, 0, 60):
            b.box("Steel", (3, 30, 3), (x, 0, 0))
            b.box("Steel", (3, 3, 180), (x, 0, 0), body=None)
        b.box(m.mat("cloth"), (120, 2, 150), (0, 0, 25), body="box")
    elif kind == "Wheelchair":
        b.box("BlackCloth", (44, 44, 5), (0, 0, 48))
        b.box("BlackCloth", (44, 4, 44), (0, -22, 52))
        for s in (-1, 1):
            points = [
                (s * 27, 28 * math.cos(a) - 6, 30 + 28 * math.sin(a)) for a in [k * math.pi / 8 for k in range(17)]
            ]
            b.tube("Rubber", points, 2)
            b.tube("Steel", [(s * 22, -22, 96), (s * 22, -22, 30), (s * 22, 30, 20)], 1.5)
            b.cylinder("BlackPaint", 8, 4, (s * 20 - 2, 30, 8), (-90, 0, 0), segments=10, body=None)
        b.body_box((54, 60, 48))
    elif kind == "PatientMonitor":
        b.cylinder("Steel", 24, 4, segments=12)
        b.cylinder("Steel", 2.5, 120, segments=8)
        b.box("WhitePaint", (44, 14, 34), (0, 0, 118), bevel=2)
        b.box("Screen", (36, 1, 26), (0, 7.4, 122), body=None)
    elif kind == "MedicineTrolley":
        b.box(paint, (60, 46, 80), (0, 0, 12), bevel=1)
        for i in range(4):
            b.box("WhitePaint", (54, 2, 16), (0, 23, 18 + 18 * i), body=None)
        for x in (-24, 24):
            for y in (-18, 18):
                b.cylinder("BlackPaint", 5, 3, (x, y - 1.5, 6), (0, 0, 90), segments=8, body=None)
        b.body_box((56, 42, 12))
        m.top(92, 50, 36)
    elif kind == "LabBench":
        b.box("WhitePaint", (180, 70, 84))
        b.box("BlackPaint", (186, 76, 4), (0, 0, 84))
        for i in range(3):
            b.box(paint, (54, 2, 60), (-60 + 60 * i, 35, 16), body=None)
        m.top(88, 170, 60)
    elif kind == "Microscope":
        b.box("BlackPaint", (18, 24, 3))
        b.box("GreyPaint", (5, 6, 30), (0, -8, 3), body=None)
        b.cylinder("GreyPaint", 3, 22, (0, 2, 16), (0, 0, 12), segments=10, body=None)
        b.box("BlackPaint", (12, 12, 1.5), (0, 2, 12), body=None)
        b.body_box((18, 24, 36))
    elif kind == "Treadmill":
        b.box("BlackPaint", (180, 76, 18), bevel=3)
        b.box("Rubber", (150, 50, 1), (-6, 0, 18), body=None)
        for y in (-34, 34):
            b.tube("GreyPaint", [(60, y, 18), (80, y, 120)], 3.5)
        b.box("BlackPaint", (14, 70, 34), (80, 0, 110))
        b.box("Screen", (2, 34, 20), (72, 0, 118), body=None)
    elif kind == "WeightBench":
        b.box("BlackCloth", (120, 30, 8), (0, 0, 40), bevel=2)
        for x in (-45, 45):
            b.box(paint, (6, 40, 40), (x, 0, 0))
        for y in (-50, 50):
            b.box(paint, (6, 6, 110), (50, y, 0))
        b.cylinder("Steel", 1.6, 180, (50, -90, 112), (0, 0, 90), segments=8)
        for y in (-84, 70):
            b.cylinder("BlackPaint", 22, 12, (50, y, 112), (0, 0, 90), segments=18)
    elif kind == "ExerciseBike":
        b.box("BlackPaint", (100, 40, 8))
        b.box(paint, (70, 14, 44), (0, 0, 8), bevel=4)
        b.box("BlackCloth", (28, 22, 6), (-30, 0, 86), body=None)
        b.cylinder("Steel", 3, 40, (-30, 0, 48), segments=8)
        b.tube("Steel", [(30, 0, 50), (38, 0, 100), (48, 0, 104)], 2.5)
        b.body_box((20, 40, 60), (38, 0, 50))
    else:
        for i in range(4):
            w = 150 - 6 * i
            b.box("Pine", (w, 70 - 8 * i, 24), (0, 0, 25 * i))
        b.box("BrownLeather", (130, 46, 12), (0, 0, 100), bevel=4)
