"""Stalls, tables under parasols, and flags."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import MARKET, STREET

GOODS = {
    "Fruit": ("Apple", "Orange", "Lemon", "Tomato"),
    "Vegetable": ("Leaf", "Tomato", "PaleLeaf", "Orange"),
    "Bread": ("Bread", "Bread", "Wheat", "Straw"),
    "Cheese": ("Cheese", "Cheese", "Wax", "Lemon"),
    "Fish": ("Steel", "Aluminium", "SilverPaint", "PinkPaint"),
    "Cloth": ("RedCloth", "TealCloth", "MustardCloth", "NavyCloth"),
    "Pottery": ("Terracotta", "Clay", "Porcelain", "BluePaint"),
    "Spice": ("Orange", "Rust", "Sand", "MaroonPaint"),
    "Flower": ("PinkPaint", "YellowPaint", "RedPaint", "VioletPaint"),
    "Book": ("MaroonPaint", "NavyPaint", "GreenPaint", "Paper"),
}


@family("stall")
def stall(m: KitMaker) -> None:
    """A market stall with goods under an awning."""
    ware = m.opt("ware", m.pick(*GOODS))
    wood, cloth = m.mat("wood"), m.mat("awning")
    m.say(
        f"{ware}Stall",
        MARKET,
        f"Market stall of {word(wood)} with {ware.lower()} under an awning of {word(cloth)}, 2.6 m wide.",
        "",
        camel(cloth),
        tags="market stall goods awning",
    )
    m.b.box(wood, (260, 110, 6), (0, 10, 84))
    m.b.box(wood, (250, 6, 84), (0, 60, 0))
    for x in (-124, 124):
        for y in (-60, 60):
            m.b.box(wood, (9, 9, 250 if y < 0 else 225), (x, y, 0), body=None)
    m.b.body_box((250, 120, 84))
    with m.b.moved((0, 0, 232)):
        m.b.box(cloth, (290, 170, 5), (0, 10, 0), (0, 0, -8), body=None)
        m.b.box(cloth, (290, 3, 24), (0, 95, -34), body=None)
    m.b.body_box((280, 150, 20), (0, 0, 232))
    for row in range(2):
        for i in range(5):
            with m.b.moved((-100 + 50 * i, -12 + 44 * row, 90)):
                m.b.box("Pine", (44, 38, 12), body=None)
                for k in range(6):
                    m.b.ellipsoid(
                        GOODS[ware][(i + row) % 4],
                        (13, 13, 12),
                        (-14 + 14 * (k % 3), -8 + 16 * (k // 3), 8),
                        segments=8,
                        body=None,
                    )
    m.b.body_box((250, 90, 22), (0, 10, 90))


@family("parasol-table")
def parasol_table(m: KitMaker) -> None:
    """A round cafe table with a parasol through it."""
    cloth, metal = m.mat("awning"), m.mat("metal")
    m.say(
        "ParasolTable",
        STREET,
        f"Round cafe table with a parasol of {word(cloth)}.",
        camel(cloth),
        tags="table cafe parasol umbrella",
    )
    m.b.cylinder(metal, 40, 4, (0, 0, 70), segments=20)
    m.b.cylinder(metal, 26, 4, segments=16)
    m.b.cylinder(metal, 3, 240, segments=8)
    m.b.cylinder(cloth, 130, 44, (0, 0, 210), top=3, segments=8)


@family("flag")
def flag(m: KitMaker) -> None:
    """A flag on a pole, or a banner."""
    cloth = m.mat("cloth")
    banner = m.opt("banner", m.style.old)
    m.say(
        "BannerPole" if banner else "FlagPole",
        STREET,
        f"Pole with a {word(cloth)} {'banner' if banner else 'flag'}, 6 m high.",
        camel(cloth),
        tags="flag banner pole",
    )
    m.b.cylinder(m.mat("metal"), 18, 8, segments=12, body=None)
    m.b.cylinder(m.mat("metal"), 4.5, 600, segments=8)
    m.b.ellipsoid("Gold", (16, 16, 16), (0, 0, 598), segments=8, body=None)
    if banner:
        m.b.box(m.mat("wood"), (90, 4, 5), (44, 0, 580), body=None)
        m.b.box(cloth, (76, 2, 230), (46, 0, 350), body=None)
    else:
        for i in range(5):
            m.b.box(
                cloth,
                (32, 1.5, 92),
                (20 + 30 * i, 5 * math.sin(i * 1.4), 495),
                (0, 14 * math.cos(i * 1.4), 0),
                body=None,
            )
