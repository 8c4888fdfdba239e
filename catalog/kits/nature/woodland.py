"""Logs, rocks and mushrooms."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.nature.categories import PLANTS, ROCKS
from catalog.shapes.patches import hull


@family("log")
def log(m: KitMaker) -> None:
    """Trunks, stumps and piles of wood."""
    kind = m.opt("kind", m.pick("FallenLog", "TreeStump", "WoodPile", "Firewood"))
    m.say(kind, PLANTS, f"{word(kind).capitalize()} of bark-covered wood.", tags="log wood trunk")
    if kind == "FallenLog":
        m.b.cylinder("Bark", 32, 380, (-190, 0, 30), (-90, 0, 0), top=24, segments=12)
        m.b.cylinder("Pine", 25, 2, (190, 0, 30), (-90, 0, 0), segments=12, body=None)
        m.b.body_box((370, 40, 8))
        for i in range(5):
            m.b.ellipsoid("Moss", (50, 36, 14), (-140 + 66 * i, 0, 52), segments=8, body=None)
    elif kind == "TreeStump":
        m.b.cylinder("Bark", 46, 44, top=34, segments=12)
        m.b.cylinder("Pine", 32, 1, (0, 0, 44), segments=12, body=None)
    else:
        rows, r, length = (3, 20, 260) if kind == "WoodPile" else (4, 8, 50)
        for row in range(rows):
            for i in range(rows + 2 - row):
                y = (i - (rows + 1 - row) / 2) * 2 * r
                m.b.cylinder(
                    "Bark", r, length, (-length / 2, y, r + row * r * 1.75), (-90, 0, 0), segments=9, body=None
                )
                m.b.cylinder(
                    "Pine",
                    r - 2,
                    length + 1,
                    (-length / 2 - 0.5, y, r + row * r * 1.75),
                    (-90, 0, 0),
                    segments=9,
                    body=None,
                )
        m.b.body_box((length, 2 * r * (rows + 1), r * 1.75 * rows))


@family("rock")
def rock(m: KitMaker) -> None:
    """A boulder or a group of stones."""
    stone = m.opt("stone", m.pick("Rock", "Rock", "RedRock" if m.style.name == "fantasy" else "Rock"))
    size = m.opt("size", m.uni(60, 240, 10))
    m.say(
        "FieldStone" if size < 100 else "Boulder" if size < 180 else "GreatBoulder",
        ROCKS,
        f"{word(stone).capitalize()} of {size / 100:.1f} m.",
        "",
        m.pick("Round", "Flat", "Jagged", "Mossy", "Leaning", "Grey"),
        tags="rock stone boulder",
    )
    stretch, flat = m.uni(0.7, 1.0, 0.05), m.uni(0.55, 0.9, 0.05)
    points = []
    for i in range(26):
        z = 1 - 2 * (i + 0.5) / 26
        r, a = math.sqrt(1 - z * z), i * 2.39996
        k = m.uni(0.8, 1.0, 0.02) * size / 2
        points.append((r * math.cos(a) * k, r * math.sin(a) * k * stretch, max(0.0, z * k * flat + size * 0.26)))
    m.b.add(stone, hull(points))


@family("mushroom")
def mushroom(m: KitMaker) -> None:
    """A giant mushroom or a group of crystals."""
    if m.opt("crystal", m.chance(0.4)):
        glow = m.pick("CrystalBlue", "CrystalViolet")
        m.say(
            "CrystalCluster",
            ROCKS,
            f"Cluster of {word(glow)} crystals.",
            "Blue" if glow == "CrystalBlue" else "Violet",
            tags="crystal magic glow",
        )
        for i in range(6):
            a, h = i * 2.4, m.uni(60, 190, 10)
            with m.b.moved(
                (14 * math.cos(a), 14 * math.sin(a), 0), (m.uni(-16, 16, 2), math.degrees(a), m.uni(-16, 16, 2))
            ):
                m.b.cylinder(glow, 18, h * 0.8, segments=6, body=None)
                m.b.cylinder(glow, 18, h * 0.2, (0, 0, h * 0.8), top=1, segments=6, body=None)
        m.b.body_box((70, 70, 90))
        return
    cap, high = m.mat("paint"), m.uni(60, 260, 20)
    m.say(
        "GiantMushroom",
        PLANTS,
        f"Giant mushroom with a {word(cap)} cap, {high / 100:.1f} m high.",
        camel(cap),
        tags="mushroom giant fantasy",
    )
    m.b.lathe("CreamPaint", [(0, 0), (high * 0.16, 0), (high * 0.1, high * 0.5), (high * 0.08, high * 0.8)], body=None)
    m.b.lathe(
        cap,
        [(0, high * 0.7), (high * 0.42, high * 0.66), (high * 0.4, high * 0.8), (high * 0.2, high * 0.96), (0, high)],
        body=None,
    )
    for i in range(7):
        a, r = i * 2.4, high * 0.06 * (i + 0.6)
        m.b.ellipsoid(
            "WhitePaint",
            (high * 0.08, high * 0.08, high * 0.04),
            (r * math.cos(a), r * math.sin(a), high * (0.97 - 0.028 * i)),
            segments=6,
            body=None,
        )
    m.b.body_box((high * 0.24, high * 0.24, high * 0.9))
