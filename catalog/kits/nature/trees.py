"""Trees: broad, needle and palm."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, family, word
from catalog.kits.nature.categories import PLANTS
from catalog.shapes.patches import Point3


def crown(m: KitMaker, material: str, at: Point3, size: float, balls: int, squash: float = 0.8) -> None:
    """A cloud of leaves."""
    m.b.ellipsoid(material, (size, size, size * squash), at, segments=12, body=None)
    for i in range(balls):
        a, r = i * 2.4 + 0.5, size * 0.34
        s = size * m.uni(0.5, 0.68, 0.02)
        m.b.ellipsoid(
            material,
            (s, s, s * squash),
            (at[0] + r * math.cos(a), at[1] + r * math.sin(a), at[2] + size * (0.05 + 0.1 * (i % 4))),
            segments=10,
            body=None,
        )


TREES = {
    "Leaf": "Lime",
    "DarkLeaf": "Oak",
    "PaleLeaf": "Ash",
    "AutumnLeaf": "Maple",
    "GoldenLeaf": "Birch",
    "Blossom": "Cherry",
    "VioletLeaf": "Plum",
}


@family("tree")
def tree(m: KitMaker) -> None:
    """A broad-leaved tree."""
    leaf = m.mat("leaf")
    height = m.opt("height", m.uni(450, 900, 25))
    size = "Young" if height < 560 else "Great" if height > 780 else "Broad"
    m.say(
        f"{TREES[leaf]}Tree",
        PLANTS,
        f"{size} {TREES[leaf].lower()} tree with {word(leaf)} crown, about {height / 100:.0f} m high.",
        "",
        size,
        tags="tree plant leafy",
    )
    trunk, bark = height * 0.42, m.mat("bark") if leaf != "GoldenLeaf" else "PaleBark"
    m.b.cylinder(bark, height * 0.045, trunk, top=height * 0.026, segments=9, body=None)
    for k in range(3):
        a = k * 2.1
        m.b.tube(
            bark,
            [(0, 0, trunk * 0.7), (height * 0.1 * math.cos(a), height * 0.1 * math.sin(a), trunk * 1.05)],
            height * 0.014,
        )
    crown(m, leaf, (0, 0, trunk * 0.82), height * 0.55, m.pick(4, 5, 6), m.uni(0.75, 0.95, 0.05))
    m.b.body_box((height * 0.09, height * 0.09, trunk))


@family("conifer")
def conifer(m: KitMaker) -> None:
    """A fir, spruce or pine."""
    leaf = m.opt("leaf", m.pick("Needle", "Needle", "DarkLeaf"))
    height, kind = m.uni(500, 1100, 25), m.pick("Spruce", "Fir", "Pine", "Cypress")
    m.say(
        f"{kind}Tree",
        PLANTS,
        f"{kind} of about {height / 100:.0f} m.",
        "",
        "Tall" if height > 800 else "Young",
        tags="tree conifer plant needle",
    )
    m.b.cylinder("Bark", height * 0.025, height * 0.3, top=height * 0.018, segments=8, body=None)
    if kind == "Cypress":
        m.b.lathe(
            leaf,
            [
                (0, height * 0.06),
                (height * 0.08, height * 0.16),
                (height * 0.09, height * 0.4),
                (height * 0.05, height * 0.8),
                (0, height),
            ],
            segments=12,
            body=None,
        )
    elif kind == "Pine":
        m.b.cylinder("Bark", height * 0.025, height * 0.7, segments=8, body=None)
        crown(m, leaf, (0, 0, height * 0.6), height * 0.4, 4, 0.55)
    else:
        for i in range(5):
            z = height * (0.12 + 0.16 * i)
            m.b.cylinder(
                leaf, height * (0.22 - 0.035 * i), height * 0.3, (0, 0, z), top=height * 0.01, segments=11, body=None
            )
    m.b.body_box((height * 0.06, height * 0.06, height * 0.4))


@family("palm")
def palm(m: KitMaker) -> None:
    """A palm."""
    height = m.uni(450, 800, 25)
    m.say(
        "PalmTree",
        PLANTS,
        f"Palm of about {height / 100:.0f} m.",
        m.pick("Date", "Coconut", "Fan"),
        tags="tree palm plant",
    )
    m.b.tube("Bark", [(0, 0, 0), (10, 4, height * 0.5), (26, 10, height)], 16)
    for k in range(9):
        with m.b.moved((26, 10, height), (0, 40 * k, 0)):
            for i, (x, z) in enumerate(((30, 22), (90, 24), (150, -6), (195, -56))):
                m.b.box("Leaf", (66, 34 - 6 * i, 3), (x, 0, z), (-8 - 22 * i, 0, 0), body=None)
    m.b.body_box((40, 36, height * 0.9), (8, 4, 0))
