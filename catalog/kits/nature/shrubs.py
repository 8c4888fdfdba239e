"""Bushes, hedges and flowers."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.nature.categories import PLANTS
from catalog.kits.nature.trees import crown


@family("bush")
def bush(m: KitMaker) -> None:
    """A bush, with flowers or berries or clipped."""
    leaf = m.opt("leaf", m.pick("Leaf", "DarkLeaf", "PaleLeaf"))
    kind = m.pick("Round", "Flowering", "Berry", "Clipped")
    size, dots = m.uni(90, 170, 10), m.pick("PinkPaint", "WhitePaint", "YellowPaint", "VioletPaint")
    m.say(
        "Bush" if kind != "Flowering" else f"{camel(dots)}RoseBush",
        PLANTS,
        f"{kind} bush, {size / 100:.1f} m.",
        kind if kind != "Flowering" else "",
        "Small" if size < 120 else "Large",
        tags="bush shrub plant",
    )
    if kind == "Clipped":
        m.pick(1, 2)
        m.b.cylinder(leaf, size * 0.4, size, top=size * 0.1, segments=14) if m.chance(0.5) else m.b.ellipsoid(
            leaf, (size, size, size)
        )
        return
    crown(m, leaf, (0, 0, 0), size * 0.85, 4)
    if kind != "Round":
        for i in range(14):
            a, r = i * 2.4, size * 0.4
            m.b.ellipsoid(
                "RedPaint" if kind == "Berry" else dots,
                (9, 9, 9),
                (r * math.cos(a), r * math.sin(a), size * (0.25 + 0.03 * i)),
                segments=6,
                body=None,
            )
    m.b.body_box((size * 0.8, size * 0.8, size * 0.6))


@family("hedge")
def hedge(m: KitMaker) -> None:
    """A clipped hedge along X."""
    leaf, length, high = (
        m.opt("leaf", m.pick("Leaf", "DarkLeaf")),
        m.opt("length", 300.0),
        m.opt("high", m.uni(80, 160, 20)),
    )
    m.say(
        "ClippedHedge",
        PLANTS,
        f"Clipped hedge, {length / 100:.0f} m long, {high / 100:.1f} m high.",
        "High" if high > 120 else "Low",
        camel(leaf),
        tags="hedge plant border",
    )
    m.b.box(leaf, (length, 70, high), bevel=8)


@family("flowers")
def flowers(m: KitMaker) -> None:
    """A clump of flowers, herbs or grass."""
    kind = m.opt(
        "kind",
        m.pick("Tulips", "Lavender", "Daisies", "Poppies", "Sunflowers", "Ferns", "TallGrass", "Reeds", "Marigolds"),
    )
    colour = {
        "Tulips": "RedPaint",
        "Lavender": "VioletPaint",
        "Daisies": "WhitePaint",
        "Poppies": "OrangePaint",
        "Sunflowers": "YellowPaint",
        "Marigolds": "OrangePaint",
    }.get(kind, "PaleLeaf")
    high = {"Sunflowers": 165.0, "TallGrass": 70.0, "Reeds": 130.0, "Ferns": 55.0}.get(kind, 45.0)
    m.say(kind, PLANTS, f"Clump of {word(kind)}, {high / 100:.1f} m high.", tags="flowers plant garden")
    for i in range(12):
        a, r = i * 2.4, 9.5 * math.sqrt(i)
        x, y = r * math.cos(a), r * math.sin(a)
        h = high * (0.8 + 0.2 * ((i * 7) % 5) / 4)
        if kind == "Ferns":
            with m.b.moved((0, 0, 0), (0, 30 * i, 0)):
                m.b.box("Leaf", (60, 16, 2), (28, 0, 12.4), (24, 0, 0), body=None)
            continue
        m.b.cylinder(
            "Leaf", 2.2, h, (x, y, 0), top=0.6 if kind in ("TallGrass", "Reeds") else 1.2, segments=5, body=None
        )
        if kind == "Reeds":
            m.b.cylinder("Bark", 3, 16, (x, y, h - 10), segments=6, body=None)
        elif kind == "Sunflowers":
            m.b.cylinder(colour, 14, 3, (x, y + 4, h), (0, 0, 70), segments=10, body=None)
            m.b.cylinder("Bark", 7, 5, (x, y + 4, h), (0, 0, 70), segments=8, body=None)
        elif kind != "TallGrass":
            m.b.ellipsoid(colour, (8, 8, 16 if kind == "Lavender" else 7), (x, y, h - 3), segments=6, body=None)
    m.b.body_box((56, 56, high * 0.7))
