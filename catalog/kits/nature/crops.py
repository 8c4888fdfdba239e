"""What grows in fields."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, family
from catalog.kits.nature.categories import PLANTS

BLOOMS = {"Tulip": "RedPaint", "YellowTulip": "YellowPaint", "Lavender": "VioletPaint", "PinkTulip": "PinkPaint"}


CROP_PLANTS = {"Maize": 9, "Pumpkin": 6, "Vine": 8, "Strawberry": 12, "Carrot": 14, "Leek": 14, "Lettuce": 10}


@family("crop")
def crop(m: KitMaker) -> None:
    """A row of a crop along X."""
    kind = m.opt(
        "kind", m.pick("Cabbage", "Maize", "Wheat", "Pumpkin", "Vine", "Lettuce", "Carrot", "Strawberry", "Leek")
    )
    m.say(f"{kind}Row", PLANTS, f"Row of {kind.lower()}, 4 m long along X.", tags="crop row field vegetable plant")
    if kind == "Wheat":
        m.b.box("Wheat", (400, 60, 70), body=None)
        for i in range(40):
            m.b.cylinder("Wheat", 6, 28, (-195 + 10 * i, 22 * math.sin(i * 2.4), 66), top=1, segments=5, body=None)
        m.b.body_box((400, 60, 70))
        return
    if kind == "Vine":
        for post in (-190, 0, 190):
            m.b.box("GreyWood", (8, 8, 150), (post, 0, 0), body=None)
        m.b.tube("Iron", [(-190, 0, 110), (190, 0, 110)], 1)
    n = 13 if kind in BLOOMS else CROP_PLANTS.get(kind, 8)
    for i in range(n):
        x = (i - (n - 1) / 2) * 390 / n
        if kind == "Maize":
            m.b.cylinder("Crop", 3, 190, (x, 0, 0), top=1.5, segments=6, body=None)
            for k in range(4):
                with m.b.moved((x, 0, 45 + 34 * k), (0, 90 * k + 37 * i, 0)):
                    m.b.box("Crop", (50, 7, 1.5), (24, 0, 6), (20, 0, 0), body=None)
            m.b.ellipsoid("Wheat", (9, 9, 26), (x + 5, 0, 110), segments=8, body=None)
        elif kind == "Pumpkin":
            s = 40 + (i * 7) % 16
            m.b.ellipsoid("OrangePaint", (s, s, s * 0.7), (x, (i % 2) * 16 - 8, 0), segments=12, body=None)
            m.b.ellipsoid("Crop", (40, 30, 20), (x + 20, 14, 0), segments=8, body=None)
        elif kind == "Vine":
            m.b.ellipsoid("Leaf", (56, 40, 70), (x, 0, 70), segments=9, body=None)
            m.b.ellipsoid("Plum", (14, 12, 24), (x + 10, 18, 62), segments=7, body=None)
        elif kind in ("Carrot", "Leek"):
            m.b.cylinder("PaleLeaf" if kind == "Leek" else "Orange", 4, 10, (x, 0, 0), segments=6, body=None)
            m.b.ellipsoid("Crop", (20, 20, 32), (x, 0, 6), segments=7, body=None)
        else:
            s = {"Strawberry": 26, "Lettuce": 32}.get(kind, 30 if kind in BLOOMS else 42)
            leaf = "Crop" if kind != "Lettuce" else "PaleLeaf"
            m.b.ellipsoid(leaf, (s, s, s * 0.7), (x, 0, 0), segments=9, body=None)
            if kind == "Strawberry":
                m.b.ellipsoid("RedPaint", (6, 6, 8), (x + 9, 9, 9), segments=6, body=None)
            for k in range(3 if kind in BLOOMS else 0):
                at = (x - 9 + 9 * k, 8.0 * (k % 2) - 4, 14.0)
                m.b.ellipsoid(BLOOMS[kind], (13, 13, 16), at, segments=6, body=None)
    m.b.body_box((390, 36, {"Maize": 185, "Vine": 130}.get(kind, 26)))
