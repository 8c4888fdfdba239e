"""Fences, walls, gates and arbours."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import FENCES


@family("fence")
def fence(m: KitMaker) -> None:
    """A length of fence along X."""
    kind = m.opt("kind", m.pick("Picket", "Rail", "Plank", "Iron", "Wicker"))
    length = m.opt("length", 300.0)
    wood = m.mat("metal") if kind == "Iron" else m.opt("wood", m.pick(m.mat("wood"), "GreyWood"))
    m.say(
        f"{kind}Fence",
        FENCES,
        f"{kind} fence of {word(wood)}, {length / 100:.0f} m long.",
        camel(wood),
        tags="fence border",
    )
    posts, high = (
        max(2, round(length / 150) + 1),
        {"Rail": 115, "Plank": 180, "Iron": 140, "Picket": 95, "Wicker": 110}[kind],
    )
    for i in range(posts):
        m.b.box(wood, (9, 9, high + 8), (-length / 2 + 5 + i * (length - 10) / (posts - 1), 0, 0), body=None)
    if kind == "Rail":
        for z in (35, 65, 98):
            m.b.box(wood, (length, 4, 11), (0, 0, z), body=None)
    elif kind in ("Plank", "Wicker"):
        m.b.box(wood if kind == "Plank" else "Straw", (length - 4, 4, high - 8), (0, 0, 6), body=None)
    else:
        step = 15 if kind == "Picket" else 13
        for i in range(int(length // step)):
            x = -length / 2 + (i + 0.5) * length / int(length // step)
            if kind == "Picket":
                m.b.box(wood, (8, 2.5, high - 6), (x, 2.5, 5), body=None)
            else:
                m.b.cylinder(wood, 1.2, high, (x, 0, 4), segments=5, body=None)
        for z in (22, high - 24):
            m.b.box(wood, (length, 3.5, 6), (0, 0, z), body=None)
    m.b.body_box((length, 10, high))


@family("wall")
def wall(m: KitMaker) -> None:
    """A length of garden wall along X."""
    stone, length, high = (
        m.opt("stone", m.pick(m.mat("stone"), "RedBrick", "WhitePlaster")),
        m.opt("length", 400.0),
        m.opt("high", m.uni(100, 190, 10)),
    )
    m.say(
        "GardenWall",
        FENCES,
        f"{word(stone).capitalize()} wall with a coping, {length / 100:.0f} m long, {high / 100:.1f} m high.",
        camel(stone),
        tags="wall stone border",
    )
    m.b.box(stone, (length, 36, high))
    m.b.box(m.mat("stone"), (length, 46, 12), (0, 0, high))


@family("gate")
def gate(m: KitMaker) -> None:
    """An open gate to pass: two posts and wings turned back."""
    metal, stone = m.mat("metal"), m.mat("stone")
    wide = m.opt("width", 300.0)
    m.say(
        "OpenGate",
        FENCES,
        f"Open {word(metal)} gate between {word(stone)} posts, {wide / 100:.0f} m wide.",
        camel(metal),
        camel(stone),
        tags="gate entrance posts",
    )
    for side in (-1, 1):
        x = side * (wide / 2 + 30)
        m.b.box(stone, (56, 56, 220), (x, 0, 0))
        m.b.ellipsoid(stone, (44, 44, 44), (x, 0, 218), body=None)
        with m.b.moved((side * wide / 2, -30, 0), (0, -90, 0)):
            half = wide / 2 - 8
            for i in range(9):
                m.b.cylinder(metal, 1.6, 165, ((i + 0.5) * half / 9, 0, 8), segments=5, body=None)
            for z in (20, 150):
                m.b.box(metal, (half, 4, 6), (half / 2, 0, z), body=None)
            m.b.body_box((half, 5, 170), (half / 2, 0, 0))


@family("arbour")
def arbour(m: KitMaker) -> None:
    """A pergola with climbing plants, open to walk through along Y."""
    wood = m.mat("wood")
    m.say(
        "Pergola",
        FENCES,
        f"{word(wood).capitalize()} pergola with climbing plants, 3 m long.",
        camel(wood),
        tags="pergola garden arch",
    )
    for x in (-110, 110):
        for y in (-140, 0, 140):
            m.b.box(wood, (14, 14, 240), (x, y, 0))
        m.b.box(wood, (14, 310, 14), (x, 0, 240), body=None)
    for i in range(7):
        m.b.box(wood, (280, 8, 14), (0, -140 + 47 * i, 254), body=None)
    m.b.body_box((280, 310, 28), (0, 0, 240))
    for i in range(16):
        m.b.ellipsoid(m.mat("leaf"), (70, 70, 34), (m.uni(-120, 120), m.uni(-140, 140), 254), segments=8, body=None)
        if i % 3 == 0:
            m.b.ellipsoid("PinkPaint", (14, 14, 12), (m.uni(-120, 120), m.uni(-140, 140), 282), segments=6, body=None)
