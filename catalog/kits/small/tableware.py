"""Tableware and food."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.small.categories import DISHES


@family("dish")
def dish(m: KitMaker) -> None:
    """Tableware and food."""
    old = m.style.old
    kind = m.opt(
        "kind",
        m.pick(
            "Plate",
            "Mug",
            "Jug",
            "Bowl",
            "Bottle",
            "Goblet",
            "Bread",
            "CheeseBoard",
            "Candlestick",
            "FruitBowl",
            "Tankard",
            "SoupPot",
            "Pie",
        )
        if old
        else m.pick(
            "Plate",
            "Cup",
            "Jug",
            "Bowl",
            "Bottle",
            "WineGlass",
            "Teapot",
            "FruitBowl",
            "Cake",
            "Toaster",
            "SoupPot",
            "SaltMill",
            "Napkins",
        ),
    )
    clay = m.opt(
        "clay",
        m.pick("Porcelain", "Terracotta", "BluePaint", "TealPaint", "CreamPaint")
        if not old
        else m.pick("Terracotta", "Clay", "Bronze", "Oak"),
    )
    noun = {"Bread": "BreadLoaf"}.get(kind, kind)
    m.say(
        noun, DISHES, f"{word(clay).capitalize()} {word(noun)} for a table.", camel(clay), tags="tableware food small"
    )
    b = m.b
    if kind == "Plate":
        b.lathe(clay, [(0, 0), (8, 0), (13, 2), (13, 2.6), (0, 1)])
        b.ellipsoid(m.pick("Bread", "Tomato", "PaleLeaf", "Cheese"), (12, 9, 4), (0, 0, 1), segments=8, body=None)
    elif kind in ("Mug", "Tankard", "Cup"):
        h = 9 if kind == "Cup" else 13
        b.lathe(clay, [(0, 0), (4.2, 0), (4.6, h), (4.0, h), (3.6, 1), (0, 1)])
        b.cylinder("Wheat" if kind == "Tankard" else "Soil", 4, 0.6, (0, 0, h - 2), segments=12, body=None)
        b.tube(clay, [(4.4, 0, h * 0.8), (7.5, 0, h * 0.7), (7.5, 0, h * 0.3), (4.4, 0, h * 0.2)], 0.7)
    elif kind in ("Jug", "Teapot"):
        b.lathe(clay, [(0, 0), (6, 0), (9, 8), (7, 17), (4.5, 22), (5.5, 25)])
        b.tube(clay, [(7, 0, 19), (13, 0, 16), (9, 0, 7)], 0.9)
        if kind == "Teapot":
            b.tube(clay, [(-7, 0, 8), (-13, 0, 14), (-15, 0, 19)], 1.3)
            b.ellipsoid(clay, (8, 8, 5), (0, 0, 23), segments=10, body=None)
    elif kind in ("Bowl", "FruitBowl", "SoupPot"):
        r = {"Bowl": 9, "FruitBowl": 15, "SoupPot": 14}[kind]
        pot = "Iron" if kind == "SoupPot" else clay
        b.lathe(pot, [(0, 0), (r * 0.5, 0), (r, r * 0.7), (r * 0.94, r * 0.7), (r * 0.4, 1), (0, 1)])
        if kind == "FruitBowl":
            for i in range(7):
                a, rr = i * 2.4, 3.4 * math.sqrt(i)
                b.ellipsoid(
                    m.pick("Apple", "Orange", "Lemon", "Plum"),
                    (8, 8, 8),
                    (rr * math.cos(a), rr * math.sin(a), 5 + (3 if i < 3 else 0)),
                    segments=8,
                    body=None,
                )
        else:
            b.cylinder(m.pick("Orange", "Cheese", "PaleLeaf"), r * 0.8, 0.6, (0, 0, r * 0.5), segments=14, body=None)
    elif kind in ("Bottle", "SaltMill"):
        glass = m.pick("GreenBottle", "BrownBottle") if kind == "Bottle" else m.mat("wood")
        b.lathe(glass, [(0, 0), (3.8, 0), (3.8, 16), (1.4, 22), (1.4, 29), (0, 29)])
        b.cylinder("Paper", 3.95, 7, (0, 0, 5), segments=12, body=None)
    elif kind in ("Goblet", "WineGlass"):
        of = "Gold" if kind == "Goblet" else "Glass"
        b.lathe(of, [(0, 0), (4, 0), (0.8, 1), (0.8, 8), (4, 12), (3.8, 18), (3.4, 18), (3.5, 12), (0, 9)])
    elif kind == "Bread":
        b.ellipsoid("Bread", (26, 14, 12), (0, 0, -1))
        for i in range(3):
            b.box("Wax", (1.2, 9, 1), (-6 + 6 * i, 0, 10), (0, 20, 0), body=None)
    elif kind in ("CheeseBoard", "Pie", "Cake"):
        b.cylinder(m.mat("wood") if kind == "CheeseBoard" else clay, 16, 2, segments=18)
        b.cylinder({"CheeseBoard": "Cheese", "Pie": "Bread", "Cake": "PinkPaint"}[kind], 11, 7, (0, 0, 2), segments=18)
        for i in range(6):
            b.ellipsoid(
                "Tomato" if kind != "CheeseBoard" else "Plum",
                (3, 3, 3),
                (8 * math.cos(i * 1.05), 8 * math.sin(i * 1.05), 8.4),
                segments=6,
                body=None,
            )
    elif kind == "Candlestick":
        b.lathe("Brass", [(0, 0), (6, 0), (2, 3), (1.4, 12), (3, 14), (0, 14)])
        b.cylinder("Wax", 1.4, 14, (0, 0, 14), segments=8, body=None)
        b.ellipsoid("WarmGlow", (2, 2, 4), (0, 0, 28), segments=6, body=None)
    elif kind == "Toaster":
        b.box(m.mat("paint"), (28, 16, 18), bevel=3)
        for y in (-3, 3):
            b.box("BlackPaint", (20, 2, 0.5), (0, y, 18), body=None)
    else:
        b.box("RedPaint", (12, 12, 4))
        b.box("WhitePaint", (11, 11, 2), (0, 0, 4), body=None)
