"""Fountains, statues, columns, tombs and wells."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import ART, RUINS, STREET
from catalog.shapes.patches import hull


@family("fountain")
def fountain(m: KitMaker) -> None:
    """A fountain with a round or eight-sided basin."""
    stone = m.mat("stone")
    r, tiers = m.opt("radius", m.uni(180, 320, 20)), m.pick(1, 2)
    m.say(
        "Fountain",
        ART,
        f"{word(stone).capitalize()} fountain with {tiers} bowl{'s' if tiers > 1 else ''}, {2 * r / 100:.1f} m wide.",
        camel(stone),
        "Tiered" if tiers > 1 else "Simple",
        tags="fountain basin square",
    )
    m.b.lathe(
        stone,
        [(0, 0), (r, 0), (r, 50), (r - 6, 58), (r - 28, 58), (r - 30, 20), (0, 20)],
        segments=m.pick(8, 24),
        smooth=False,
    )
    m.b.cylinder("Water", r - 28, 2, (0, 0, 42), segments=24, body=None)
    m.b.cylinder(stone, 26, 150, top=16, segments=14, body=None)
    for t in range(tiers):
        z, rr = 130 + 75 * t, 90 - 35 * t
        m.b.lathe(stone, [(12, 0), (rr, 18), (rr + 4, 26), (rr - 6, 24), (0, 14)], (0, 0, z), body=None)
        m.b.cylinder("Water", rr - 8, 1.5, (0, 0, z + 20), segments=18, body=None)
    m.b.cylinder(stone, 11, 90, (0, 0, 140), segments=10, body=None)
    m.b.ellipsoid(m.mat("metal"), (30, 30, 44), (0, 0, 225), body=None)


@family("statue")
def statue(m: KitMaker) -> None:
    """A figure or a beast on a pedestal."""
    stone = m.opt("stone", m.pick("Bronze", "Marble", "Verdigris", m.mat("stone")))
    kind = m.opt("kind", m.pick("Figure", "Rider", "Obelisk", "Bust", "Lion", "Urn"))
    m.say(
        f"{kind}Statue" if kind not in ("Obelisk",) else "Obelisk",
        ART,
        f"{word(stone).capitalize()} statue ({kind.lower()}) on a pedestal.",
        camel(stone),
        tags="statue monument sculpture",
    )
    base = m.mat("stone")
    high = m.uni(90, 160, 10)
    m.b.box(base, (130, 130, 16))
    m.b.box(base, (96, 96, high), (0, 0, 16), bevel=3)
    m.b.box(base, (112, 112, 12), (0, 0, 16 + high), bevel=2)
    with m.b.moved((0, 0, 28 + high)):
        if kind == "Obelisk":
            m.b.cylinder(stone, 42, 380, top=26, segments=4)
            m.b.cylinder(stone, 26, 40, (0, 0, 380), top=0, segments=4)
        elif kind == "Urn":
            m.b.lathe(stone, [(0, 0), (24, 0), (14, 14), (18, 24), (44, 70), (30, 92), (38, 104), (0, 104)])
        elif kind == "Bust":
            m.b.lathe(stone, [(0, 0), (20, 0), (14, 20), (34, 46), (20, 60), (12, 66), (0, 66)], squash=0.7)
            m.b.ellipsoid(stone, (28, 32, 38), (0, 4, 60))
        elif kind in ("Lion", "Rider"):
            m.b.ellipsoid(stone, (48, 120, 56), (0, 0, 42))
            for x in (-14, 14):
                for y in (-38, 38):
                    m.b.cylinder(stone, 9, 56, (x, y, 0), segments=8, body=None)
            m.b.ellipsoid(stone, (40, 52, 52), (0, 62, 78))
            m.b.tube(stone, [(0, -58, 70), (0, -80, 50), (0, -76, 20)], 5)
            if kind == "Rider":
                m.b.lathe(stone, [(0, 0), (22, 4), (20, 40), (26, 62), (10, 76), (0, 78)], (0, -6, 88), squash=0.7)
                m.b.ellipsoid(stone, (24, 26, 30), (0, -6, 164))
        else:
            m.b.lathe(stone, [(0, 0), (34, 0), (28, 60), (20, 92), (28, 140), (12, 158), (0, 160)], squash=0.7)
            m.b.ellipsoid(stone, (26, 28, 34), (0, 2, 156))
            m.b.tube(stone, [(22, 0, 136), (44, 14, 110), (40, 36, 128)], 7)
            m.b.tube(stone, [(-22, 0, 136), (-36, 6, 100), (-26, 20, 76)], 7)


@family("column")
def column(m: KitMaker) -> None:
    """A standing column, or a broken one."""
    stone = m.opt("stone", m.pick(m.mat("stone"), "Marble"))
    broken = m.opt("broken", m.chance(0.5))
    height = m.opt("height", m.uni(140, 300, 20) if broken else m.uni(380, 520, 20))
    m.say(
        "BrokenColumn" if broken else "Column",
        RUINS,
        f"{'Broken' if broken else 'Whole'} {word(stone)} column, {height / 100:.1f} m high.",
        camel(stone),
        tags="column pillar ruin",
    )
    m.b.box(stone, (96, 96, 18))
    m.b.cylinder(stone, 36, height - 18, (0, 0, 18), top=32, segments=16)
    if broken:
        m.b.add(
            stone,
            hull(
                [
                    (30 * math.cos(a), 30 * math.sin(a), height + (26 if i % 3 == 0 else 4))
                    for i, a in enumerate([k * math.pi / 4 for k in range(8)])
                ]
                + [(0.0, 0.0, height - 10)]
            ),
            body=None,
        )
    else:
        m.b.lathe(stone, [(32, 0), (46, 22), (0, 22)], (0, 0, height), body=None)
        m.b.box(stone, (104, 104, 18), (0, 0, height + 22))


@family("tomb")
def tomb(m: KitMaker) -> None:
    """A gravestone or a tomb."""
    stone = m.mat("stone")
    kind = m.pick("Gravestone", "GraveCross", "StoneTomb")
    m.say(kind, RUINS, f"{word(stone).capitalize()} {word(kind)}.", camel(stone), tags="grave tomb cemetery")
    if kind == "Gravestone":
        m.b.box(stone, (70, 30, 12))
        m.b.box(stone, (56, 14, 70), (0, 0, 12))
        m.b.cylinder(stone, 28, 14, (0, -7, 82), (0, 0, 90), segments=18, body=None)
    elif kind == "GraveCross":
        m.b.box(stone, (70, 50, 20))
        m.b.box(stone, (16, 14, 120), (0, 0, 20))
        m.b.box(stone, (70, 14, 16), (0, 0, 96))
    else:
        m.b.box(stone, (110, 220, 16))
        m.b.box(stone, (84, 190, 70), (0, 0, 16), bevel=3)
        m.b.box(stone, (100, 206, 14), (0, 0, 86), bevel=3)


@family("well")
def well(m: KitMaker) -> None:
    """A draw well under a small roof."""
    stone = m.mat("stone")
    m.say(
        "DrawWell",
        STREET,
        f"{word(stone).capitalize()} draw well with a roof and a bucket.",
        camel(stone),
        tags="well bucket",
    )
    m.b.lathe(stone, [(0, 0), (80, 0), (80, 84), (58, 84), (58, 30), (0, 30)], smooth=False)
    m.b.cylinder("Water", 57, 2, (0, 0, 40), body=None)
    for x in (-72, 72):
        m.b.box(m.mat("wood"), (12, 12, 210), (x, 0, 0))
    m.b.gable(m.mat("roof"), (150, 200, 60), (0, 0, 205), (0, 90, 0))
    m.b.cylinder(m.mat("wood"), 8, 140, (-70, 0, 160), (-90, 0, 0), segments=8, body=None)
    m.b.cylinder(m.mat("wood"), 13, 26, (0, 0, 96), top=16, segments=10, body=None)
    m.b.tube("Rope", [(0, 0, 122), (0, 0, 160)], 1.5)
