"""Blocks of flats and towers of offices."""

from __future__ import annotations

import math

from catalog.kits.facade import BUILDINGS, battlements, door, flat_roof, hip_roof
from catalog.kits.maker import KitMaker, camel, family, word


@family("block")
def block(m: KitMaker) -> None:
    """A large building with many equal windows: flats, offices, a hotel, a school, a hospital."""
    use = m.opt("use", m.pick("ApartmentBlock", "OfficeBlock", "Hotel", "School", "Hospital"))
    storeys = m.opt("storeys", m.uni(3, 8, 1))
    width, depth, floor, wall = (
        m.opt("width", m.uni(1400, 2400, 100)),
        m.opt("depth", m.uni(1000, 1300, 100)),
        320.0,
        m.mat("wall"),
    )
    m.say(
        use,
        BUILDINGS,
        f"{word(wall).capitalize()} {word(use)} of {int(storeys)} storeys with a flat roof, "
        f"{width / 100:.0f} x {depth / 100:.0f} m.",
        camel(wall),
        tags="building block tall",
    )
    m.b.box(wall, (width, depth, storeys * floor))
    band = m.chance(0.5)
    for yaw, length, reach in ((0, width, depth), (180, width, depth), (90, depth, width), (-90, depth, width)):
        with m.b.moved((0, 0, 0), (0, yaw, 0)):
            for level in range(int(storeys)):
                z = level * floor + 100
                if band:
                    m.b.box(m.mat("window"), (length - 80, 8, 150), (0, reach / 2 + 1, z), body=None)
                    for i in range(int(length // 200) + 1):
                        m.b.box(
                            m.mat("trim"),
                            (14, 12, 150),
                            (-length / 2 + 40 + i * (length - 80) / int(length // 200), reach / 2 + 1, z),
                            body=None,
                        )
                else:
                    count = int(length // 280)
                    for i in range(count):
                        x = (i - (count - 1) / 2) * length / count
                        m.b.box(m.mat("trim"), (150, 6, 170), (x, reach / 2 + 1, z - 10), body=None)
                        m.b.box(m.mat("window"), (130, 9, 150), (x, reach / 2 + 1, z), body=None)
                m.b.box(
                    m.mat("trim"),
                    (length + 10, 8, 18),
                    (0, reach / 2 + 1, level * floor - 9 if level else 0),
                    body=None,
                )
    with m.b.moved((0, depth / 2, 0)):
        m.b.box(m.mat("trim"), (420, 160, 20), (0, 60, 280), body="box")
        m.b.box(m.mat("window"), (300, 12, 250), (0, 2, 0), body=None)
        for x in (-190, 190):
            m.b.box(m.mat("metal"), (14, 14, 280), (x, 125, 0))
    flat_roof(m, width, depth, storeys * floor)
    m.b.box("DarkConcrete", (350, 300, 220), (width * 0.2, 0, storeys * floor + 12), body="box")


@family("tower")
def tower(m: KitMaker) -> None:
    """A tower, round or square, with battlements or a spire."""
    round_ = m.opt("round", m.chance(0.5))
    height, radius, stone = m.opt("height", m.uni(900, 1700, 50)), m.opt("radius", m.uni(220, 340, 10)), m.mat("stone")
    spire = m.opt("spire", m.chance(0.6))
    roof = m.mat("roof")
    noun = (
        m.pick("WatchTower", "Tower", "Keep")
        if not spire
        else m.pick("SpireTower", "BellTower", "WizardTower" if m.style.name == "fantasy" else "StairTower")
    )
    m.say(
        noun,
        BUILDINGS,
        f"{'Round' if round_ else 'Square'} {word(stone)} tower, {height / 100:.0f} m high, with "
        f"{'a spire of ' + word(roof) if spire else 'battlements'}.",
        "Round" if round_ else "Square",
        camel(stone),
        tags="tower castle",
    )
    if round_:
        m.b.cylinder(stone, radius * 1.08, height, top=radius, segments=22)
        m.b.cylinder(stone, radius * 1.18, 60, (0, 0, height), segments=22)
    else:
        m.b.box(stone, (2 * radius, 2 * radius, height))
        m.b.box(stone, (2.24 * radius, 2.24 * radius, 60), (0, 0, height))
    for level in range(int(height // 400)):
        for yaw in (0, 90, 180, -90):
            with m.b.moved((0, 0, 0), (0, yaw, 0)):
                m.b.box(
                    m.mat("window"),
                    (40, 14, 110),
                    (0, radius * (1.03 if round_ else 1.0), 260 + 400 * level),
                    body=None,
                )
    door(m, 120, 220, (0, radius * (1.07 if round_ else 1.0), 0))
    if spire:
        rise = radius * 2.2 * m.style.steep
        m.b.cylinder(
            roof, radius * 1.3, rise, (0, 0, height + 60), top=0, segments=22 if round_ else 4, body="hull"
        ) if round_ else hip_roof(m, 2.2 * radius, 2.2 * radius, height + 60, rise, roof)
        m.b.cylinder(m.mat("metal"), 5, 120, (0, 0, height + 40 + rise), top=1, segments=8, body=None)
    elif round_:
        for i in range(12):
            a = i * math.pi / 6
            m.b.box(
                stone,
                (50, 40, 80),
                (radius * 1.08 * math.cos(a), radius * 1.08 * math.sin(a), height + 60),
                (0, math.degrees(a) + 90, 0),
                body=None,
            )
    else:
        battlements(m, stone, 2.24 * radius, 2.24 * radius, height + 60)
