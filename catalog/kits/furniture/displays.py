"""Show cases, pedestals with exhibits, table cases."""

from __future__ import annotations

import math

from catalog.kits.furniture.frames import legs
from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull


@family("display")
def display(m: KitMaker) -> None:
    """A show case, a pedestal with an exhibit, or a table case."""
    kind = m.opt("kind", m.pick("TableCase", "TallCase", "Pedestal", "SkeletonPlinth", "VasePedestal", "MapCase"))
    stone, exhibit = (
        m.mat("stone"),
        m.opt("exhibit", m.pick("Amphora", "Mask", "Crystal", "Coins", "Helmet", "Globe", "Sword", "Fossil")),
    )
    m.say(
        f"{exhibit}Exhibit" if kind in ("TallCase", "Pedestal", "TableCase") else kind,
        "exhibits",
        f"{word(kind).capitalize()} with {exhibit.lower()} of a museum.",
        {"TableCase": "Cased", "TallCase": "TallCased"}.get(kind, camel(stone)),
        tags="museum exhibit display case",
    )
    b, wood = m.b, m.mat("wood")
    if kind == "TableCase" or kind == "MapCase":
        b.box(wood, (140, 70, 8), (0, 0, 76))
        legs(m, wood, 136, 66, 76, 6)
        b.box("Glass", (136, 66, 22), (0, 0, 84))
        b.box("Linen", (130, 60, 1), (0, 0, 84), body=None)
        for i in range(5):
            b.ellipsoid(
                {"Coins": "Gold", "Crystal": "CrystalBlue", "Fossil": "Limestone"}.get(exhibit, "Bronze"),
                (14, 14, 8),
                (-52 + 26 * i, (i % 2) * 16 - 8, 85),
                segments=10,
                body=None,
            )
        return
    if kind == "SkeletonPlinth":
        b.box(stone, (420, 160, 30))
        b.tube("CreamPaint", [(-190, 0, 60), (-90, 0, 120), (40, 0, 150), (130, 0, 210)], 7)
        b.ellipsoid("CreamPaint", (60, 34, 36), (150, 0, 200), segments=10, body=None)
        for x in (-80, -50, -20, 10, 40):
            for s in (-1, 1):
                b.tube("CreamPaint", [(x, 0, 136), (x, s * 36, 110), (x, s * 20, 74)], 3)
        for x in (-70, 50):
            for s in (-1, 1):
                b.tube("CreamPaint", [(x, s * 14, 120), (x + 12, s * 30, 78), (x, s * 32, 30)], 5)
        b.body_box((340, 80, 170), (0, 0, 30))
        return
    b.box(stone, (60, 60, 100 if kind != "TallCase" else 60), bevel=1)
    z = 100 if kind != "TallCase" else 60
    if kind == "TallCase":
        b.box("Glass", (58, 58, 120), (0, 0, 60))
        b.box(stone, (62, 62, 8), (0, 0, 180))
    with b.moved((0, 0, z)):
        if exhibit == "Amphora" or kind == "VasePedestal":
            b.lathe("Terracotta", [(0, 0), (8, 0), (20, 24), (18, 40), (7, 52), (10, 58)])
            b.lathe("BlackPaint", [(19.5, 22), (20.5, 26), (20, 32)], body=None)
        elif exhibit in ("Helmet", "Mask"):
            b.cylinder(wood, 3, 20, segments=8, body=None)
            b.ellipsoid("Bronze" if exhibit == "Helmet" else "Gold", (26, 28, 32), (0, 0, 18))
        elif exhibit == "Globe":
            b.ellipsoid("SkyPaint", (38, 38, 38), (0, 0, 8))
            b.cylinder(wood, 12, 8, segments=12, body=None)
        elif exhibit == "Sword":
            b.box("Steel", (6, 1.5, 80), (0, 0, 4), body="box")
            b.box("Gold", (24, 3, 4), (0, 0, 20), body=None)
        elif exhibit == "Crystal":
            for i in range(4):
                b.cylinder(
                    "CrystalViolet",
                    6,
                    30 + 6 * i,
                    (6 * math.cos(i * 2.0), 6 * math.sin(i * 2.0), 0),
                    (8 * math.cos(i * 2), 0, 8 * math.sin(i * 2)),
                    top=1,
                    segments=6,
                    body=None,
                )
        else:
            b.add(
                "Limestone",
                hull(
                    [
                        (-18.0, -10.0, 0.0),
                        (18.0, -12.0, 0.0),
                        (16.0, 12.0, 0.0),
                        (-16.0, 10.0, 0.0),
                        (-8.0, 0.0, 26.0),
                        (10.0, 2.0, 18.0),
                    ]
                ),
            )
