"""Windmills, lighthouses and bridges."""

from __future__ import annotations

from catalog.kits.facade import BUILDINGS, door
from catalog.kits.maker import KitMaker, camel, family, word


@family("windmill")
def windmill(m: KitMaker) -> None:
    """A tower mill with four sails."""
    wall = m.opt("wall", m.pick("WhitePlaster", "RedBrick", "Fieldstone"))
    m.say(
        "Windmill",
        BUILDINGS,
        f"{word(wall).capitalize()} windmill with four sails that face the front.",
        camel(wall),
        tags="windmill mill building",
    )
    m.b.cylinder(wall, 320, 900, top=220, segments=20)
    m.b.lathe(m.mat("roof"), [(240, 0), (230, 60), (140, 200), (0, 260)], (0, 0, 900))
    door(m, 110, 210, (0, 316, 0))
    for z in (380, 640):
        m.b.box(m.mat("window"), (60, 12, 80), (0, 306 - z * 0.11, z), body=None)
    with m.b.moved((0, 285, 960)):
        m.b.cylinder("DarkOak", 14, 90, (0, -45, 0), (0, 0, 90), segments=8, body=None)
        for k in range(4):
            with m.b.moved((0, 40, 0), (45 + 90 * k, 0, 0)):
                m.b.box("DarkOak", (14, 10, 620), (0, 0, 0), body=None)
                m.b.box("WhiteSail", (110, 4, 460), (62, 0, 140), body=None)


@family("lighthouse")
def lighthouse(m: KitMaker) -> None:
    """A lighthouse in bands of two colours."""
    m.say(
        "LighthouseTower",
        BUILDINGS,
        "Red and white lighthouse tower, 15 m high.",
        "RedWhite",
        tags="lighthouse tower beacon",
    )
    for i in range(6):
        m.b.cylinder(
            "WhitePaint" if i % 2 else "RedPaint", 230 - 18 * i, 200, (0, 0, 200 * i), top=212 - 18 * i, segments=20
        )
    m.b.cylinder("Iron", 170, 14, (0, 0, 1200), segments=20)
    m.b.cylinder("WarmGlow", 80, 120, (0, 0, 1214), segments=14)
    m.b.cylinder("RedPaint", 110, 110, (0, 0, 1334), top=10, segments=16)
    door(m, 100, 200, (0, 228, 0))


@family("bridge")
def bridge(m: KitMaker) -> None:
    """A level bridge of planks or stone along X with railings."""
    length, stone = m.opt("length", 800.0), m.opt("stone", m.pick("Planks", "Fieldstone", "Limestone", "DarkPlanks"))
    wide = m.opt("width", 300.0)
    m.say(
        "FootBridge",
        BUILDINGS,
        f"{word(stone).capitalize()} footbridge with railings, {length / 100:.0f} m long, {wide / 100:.0f} m wide.",
        camel(stone),
        tags="bridge crossing",
    )
    m.b.box(stone, (length, wide, 20), (0, 0, 0))
    for side in (-1, 1):
        y = side * (wide / 2 - 8)
        for i in range(int(length // 100) + 1):
            m.b.box(
                "DarkOak", (10, 10, 105), (-length / 2 + 6 + i * (length - 12) / int(length // 100), y, 20), body=None
            )
        m.b.box("DarkOak", (length, 9, 8), (0, y, 118), body=None)
        m.b.box("DarkOak", (length, 6, 6), (0, y, 72), body=None)
        m.b.body_box((length, 12, 105), (0, y, 20))
