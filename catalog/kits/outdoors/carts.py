"""Handcarts, and the wheels of carts."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import MARKET


def wheel(m: KitMaker, material: str, radius: float, at: tuple[float, float, float], roll: float) -> None:
    """An upright spoked wheel whose axle runs along Y (``roll`` 90)."""
    from catalog.shapes.patches import tube

    points = [(radius * math.cos(a), 0.0, radius * math.sin(a)) for a in [k * math.pi / 8 for k in range(17)]]
    m.b.add(material, tube(points, 4, 6), at, body=None)
    for k in range(4):
        m.b.box(material, (2 * radius - 4, 4, 5), (at[0], at[1], at[2] - 2.5), (45 * k, 0, 0), body=None)


@family("handcart")
def handcart(m: KitMaker) -> None:
    """A cart on two or four wheels."""
    load = m.opt("load", m.pick("Hay", "Soil", "Pine", "Empty", "Pottery", "Apple", "Rock"))
    wood = m.mat("wood")
    m.say(
        "Handcart",
        MARKET,
        f"{word(wood).capitalize()} cart on two wheels with {word(load)}.",
        "" if load == "Empty" else load,
        camel(wood),
        tags="cart wagon wheel",
    )
    m.b.box(wood, (180, 100, 8), (0, 0, 62))
    for y in (-50, 50):
        m.b.box(wood, (180, 5, 36), (0, y, 66), body=None)
        wheel(m, wood, 44, (-10, y * 1.16, 44), 90)
        m.b.box(wood, (130, 6, 6), (140, y * 0.7, 64), (-6, 0, 0), body=None)
    m.b.box(wood, (5, 100, 36), (-90, 0, 66), body=None)
    m.b.box(wood, (8, 8, 62), (86, 0, 0))
    m.b.body_box((180, 116, 100))
    if load != "Empty":
        m.b.ellipsoid({"Pottery": "Terracotta"}.get(load, load), (150, 84, 60), (0, 0, 66), body=None)
