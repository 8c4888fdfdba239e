"""Jetties and quays."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.vehicles.categories import BOATS


@family("jetty")
def jetty(m: KitMaker) -> None:
    """A jetty of planks along X on piles, or a quay."""
    length, wide, high = m.opt("length", 800.0), m.opt("wide", 300.0), m.opt("high", 60.0)
    wood = m.opt("wood", m.pick("Planks", "GreyPlanks", "DarkPlanks"))
    m.say(
        "PlankJetty",
        BOATS,
        f"Jetty of {word(wood)} on piles, {length / 100:.0f} m long, deck at {high / 100:.1f} m.",
        camel(wood),
        tags="jetty pier dock",
    )
    m.b.box(wood, (length, wide, 12), (0, 0, high - 12))
    for i in range(int(length // 200) + 1):
        for s in (-1, 1):
            m.b.cylinder(
                "Bark",
                13,
                high,
                (-length / 2 + 15 + i * (length - 30) / int(length // 200), s * (wide / 2 - 14), 0),
                segments=9,
                body=None,
            )
    for s in (-1, 1):
        m.b.body_box((length, 26, high - 12), (0, s * (wide / 2 - 14), 0))
    m.top(high, length - 60, wide - 80)


@family("quay")
def quay(m: KitMaker) -> None:
    """A quay block: things stand on it."""
    length, wide, high, stone = (
        m.opt("length", 1000.0),
        m.opt("wide", 1000.0),
        m.opt("high", 100.0),
        m.opt("stone", m.mat("stone")),
    )
    m.say(
        "QuayBlock",
        BOATS,
        f"Quay of {word(stone)}, {length / 100:.0f} x {wide / 100:.0f} m, {high / 100:.1f} m high.",
        camel(stone),
        tags="quay harbour stone wall",
    )
    m.b.box(stone, (length, wide, high - 12))
    m.b.box(m.opt("paving", "Cobble"), (length, wide, 12), (0, 0, high - 12))
    m.top(high, length, wide)
