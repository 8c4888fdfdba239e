"""Ornaments and plants in pots."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.small.categories import DECOR


@family("decor")
def decor(m: KitMaker) -> None:
    """Vases, plants in pots, clocks, figures, boxes: on tables, shelves and floors."""
    kind = m.opt(
        "kind",
        m.pick(
            "Vase",
            "PottedPlant",
            "FlowerVase",
            "Clock",
            "Figurine",
            "JewelBox",
            "BookStack",
            "OpenBook",
            "Scroll",
            "Basket",
            "PictureFrame",
            "Hourglass" if m.style.old else "Radio",
        ),
    )
    clay = m.pick("Porcelain", "Terracotta", "BluePaint", "TealPaint", "Bronze", "Clay")
    m.say(
        kind, DECOR, f"{word(clay).capitalize()} {word(kind)} as decoration.", camel(clay), tags="decor small ornament"
    )
    b = m.b
    if kind in ("Vase", "FlowerVase"):
        b.lathe(clay, [(0, 0), (5, 0), (9, 10), (5, 22), (4, 26), (6, 29), (5, 29)])
        if kind == "FlowerVase":
            for i in range(8):
                a, r = i * 2.4, 3 + i
                b.tube("Leaf", [(0, 0, 26), (r * math.cos(a), r * math.sin(a), 42)], 0.5, segments=5)
                b.ellipsoid(
                    m.pick("RedPaint", "YellowPaint", "PinkPaint", "WhitePaint"),
                    (6, 6, 5),
                    (r * math.cos(a), r * math.sin(a), 41),
                    segments=7,
                    body=None,
                )
    elif kind == "PottedPlant":
        b.lathe(clay, [(0, 0), (7, 0), (10, 14), (9, 14), (0, 12)])
        for i in range(9):
            with b.moved((0, 0, 12), (0, 40 * i, 0)):
                b.box("Leaf", (22, 6, 0.8), (10, 0, 6 + 2 * (i % 3)), (35 + 8 * (i % 3), 0, 0), body=None)
    elif kind == "Clock":
        b.box(m.mat("wood"), (20, 9, 26), bevel=2)
        b.cylinder("WhitePaint", 7, 1, (0, 4.5, 15), (0, 0, 90), segments=16, body=None)
    elif kind == "Figurine":
        b.cylinder("BlackPaint", 6, 3, segments=12)
        b.lathe(clay, [(0, 0), (5, 0), (3.5, 10), (5, 16), (2, 20), (0, 20)], (0, 0, 3), squash=0.7)
        b.ellipsoid(clay, (5, 5, 6), (0, 0, 22), segments=8, body=None)
    elif kind == "JewelBox":
        b.box(m.mat("wood"), (24, 16, 10), bevel=1)
        b.box("Gold", (4, 1, 4), (0, 8, 5), body=None)
    elif kind == "BookStack":
        for i in range(4):
            b.box(
                m.pick("MaroonPaint", "NavyPaint", "GreenPaint", "CreamPaint", "BrownPaint"),
                (22 - i, 16, 4),
                (0, 0, 4 * i),
                (0, m.uni(-14, 14, 2), 0),
                body=None,
            )
        b.body_box((22, 17, 16))
    elif kind == "OpenBook":
        for s in (-1, 1):
            b.box("Paper", (15, 21, 2.5), (s * 7.5, 0, 0.6), (s * 4, 0, 0), body=None)
        b.box("MaroonPaint", (31, 22, 0.6), body=None)
        b.body_box((31, 22, 4))
    elif kind == "Scroll":
        b.cylinder("Paper", 3, 30, (-15, 0, 3), (-90, 0, 0), segments=12)
        b.box("RedPaint", (3, 6.4, 6.4), (0, 0, 0), body=None)
    elif kind == "Basket":
        b.lathe("Straw", [(0, 0), (11, 0), (15, 14), (13, 14), (10, 2), (0, 2)])
    elif kind == "PictureFrame":
        b.box(m.mat("wood"), (24, 3, 18), (0, 0, 0), (0, 0, -10))
        b.panel(m.pick("Landscape", "Sunset", "Seascape"), 20, 14, (0, 1.8, 2), (0, 0, -10))
    elif kind == "Hourglass":
        for z in (0, 20):
            b.cylinder(m.mat("wood"), 7, 2, (0, 0, z), segments=12)
        b.lathe("Sand", [(0, 2), (5, 3), (1, 11), (5, 19), (0, 20)])
    else:
        b.box(m.mat("wood"), (30, 11, 18), bevel=1.5)
        b.cylinder("BlackPaint", 6, 1, (-7, 5.4, 9), (0, 0, 90), segments=14, body=None)


@family("house-plant")
def house_plant(m: KitMaker) -> None:
    """A large plant in a pot on the floor."""
    kind, pot = (
        m.pick("Palm", "Fig", "Snake", "Fern"),
        m.pick("Terracotta", "WhitePaint", "GreyPaint", "BlackPaint", "TealPaint"),
    )
    m.say(
        f"{kind}Plant",
        "plants",
        f"{kind} plant in a {word(pot)} pot on the floor.",
        camel(pot),
        tags="plant pot indoor",
    )
    m.b.lathe(pot, [(0, 0), (16, 0), (21, 34), (18, 34), (0, 30)], segments=16)
    m.b.cylinder("Soil", 17, 1, (0, 0, 30), segments=14, body=None)
    if kind == "Fig":
        m.b.cylinder("Bark", 2.5, 70, (0, 0, 30), segments=7, body=None)
        for i in range(9):
            a = i * 2.4
            m.b.ellipsoid("Leaf", (34, 34, 26), (18 * math.cos(a), 18 * math.sin(a), 80 + 9 * i), segments=8, body=None)
    else:
        for i in range(12):
            with m.b.moved((0, 0, 32), (0, 30 * i, 0)):
                if kind == "Snake":
                    m.b.box("DarkLeaf", (6, 1.5, 60 + 6 * (i % 4)), (5 + 0.5 * i, 0, 0), (-8, 0, 0), body=None)
                else:
                    for x, z, p in ((8, 26, 70), (22, 58, 48), (42, 76, 6)):
                        m.b.box(
                            "Leaf",
                            (32, 8 if kind == "Palm" else 5, 1),
                            (x, 0, z * (1.1 if kind == "Palm" else 0.5)),
                            (p, 0, 0),
                            body=None,
                        )
    m.b.body_box((40, 40, 70))
