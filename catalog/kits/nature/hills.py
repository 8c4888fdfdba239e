"""Mounds and hills."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.nature.categories import GROUND
from catalog.shapes.patches import hull


@family("mound", flat=False)
def mound(m: KitMaker) -> None:
    """A flat-topped terrace of earth with sloping sides: things may stand on it."""
    of, wide, depth, high = m.opt("of", "Grass"), m.opt("width", 1600.0), m.opt("depth", 1200.0), m.opt("high", 120.0)
    m.say(
        f"{of}TerrainTerrace",
        GROUND,
        f"Terrace of {word(of)} with sloping sides, {high / 100:.1f} m high.",
        tags="terrain terrace hill ground",
    )
    s = high * 1.2
    m.b.add(
        of,
        hull(
            [
                (x * (wide / 2 - e), y * (depth / 2 - e), z)
                for x in (-1, 1)
                for y in (-1, 1)
                for e, z in ((0.0, 0.0), (s, high))
            ]
        ),
    )
    m.top(high, wide - 2 * s - 60, depth - 2 * s - 60)


@family("hill")
def hill(m: KitMaker) -> None:
    """A rounded hill or a mountain of the background."""
    of, wide, high = m.opt("of", "Grass"), m.opt("width", m.uni(2000, 3600, 100)), m.opt("high", m.uni(500, 1400, 50))
    m.say(
        "TerrainHill",
        GROUND,
        f"Rounded hill of {word(of)}, {wide / 100:.0f} m wide, {high / 100:.0f} m high.",
        camel(of),
        "Far",
        tags="terrain hill background landscape",
    )
    points = []
    for ring in range(5):
        r, z = wide / 2 * math.cos(ring * math.pi / 9), high * math.sin(ring * math.pi / 8)
        for k in range(14):
            a = k * math.pi / 7 + ring * 0.2
            points.append((r * math.cos(a) * m.uni(0.88, 1, 0.02), 0.7 * r * math.sin(a), z))
    m.b.add(of, hull(points))
