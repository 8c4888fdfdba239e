"""Churches and temples."""

from __future__ import annotations

from catalog.kits.facade import BUILDINGS, door, hip_roof
from catalog.kits.maker import KitMaker, camel, family, word


@family("church")
def church(m: KitMaker) -> None:
    """A church or chapel with a bell tower at its front."""
    wall, roof = m.mat("stone"), m.mat("roof")
    width, length, high = m.uni(700, 950, 50), m.uni(1400, 1900, 50), m.uni(550, 750, 50)
    m.say(
        m.pick("Church", "Chapel"),
        BUILDINGS,
        f"{word(wall).capitalize()} church with a bell tower in front and a {word(roof)} roof.",
        camel(wall),
        tags="church chapel building",
    )
    m.b.box(wall, (width, length, high))
    m.b.gable(roof, (width + 80, length + 50, width * 0.5 * m.style.steep), (0, 0, high))
    for side in (-90, 90):
        with m.b.moved((0, 0, 0), (0, side, 0)):
            for i in range(5):
                x = (i - 2) * length / 5
                m.b.box(m.mat("window"), (80, 8, 260), (x, width / 2, 160), body=None)
                m.b.box(wall, (50, 60, high * 0.9), (x + length / 10, width / 2 + 25, 0), body=None)
    with m.b.moved((0, length / 2 + 150, 0)):
        m.b.box(wall, (380, 320, high * 1.9))
        door(m, 150, 260, (0, 160, 0))
        for yaw in (0, 90, -90):
            with m.b.moved((0, 0, 0), (0, yaw, 0)):
                m.b.box("DarkStone", (90, 8, 150), (0, (160 if yaw == 0 else 190), high * 1.5), body=None)
        hip_roof(m, 340, 280, high * 1.9, 420 * m.style.steep, roof)


@family("temple")
def temple(m: KitMaker) -> None:
    """A temple front: steps, columns all around, a low gable."""
    stone = m.mat("stone")
    width, depth = m.uni(900, 1300, 100), m.uni(1200, 1600, 100)
    m.say(
        m.opt("use", m.pick("Temple", "Shrine", "CourtHouse")),
        BUILDINGS,
        f"{word(stone).capitalize()} temple on three steps with columns all around.",
        camel(stone),
        tags="temple columns classical",
    )
    for i in range(3):
        m.b.box(stone, (width + 160 - 60 * i, depth + 160 - 60 * i, 20), (0, 0, 20 * i))
    for n, span, other, turn in ((6, width, depth, False), (7, depth, width, True)):
        for i in range(n):
            for side in (-1, 1):
                a, c = (i - (n - 1) / 2) * (span - 70) / (n - 1), side * (other - 70) / 2
                m.b.cylinder(
                    "Marble" if stone == "Limestone" else stone,
                    34,
                    430,
                    (c, a, 60) if turn else (a, c, 60),
                    top=28,
                    segments=14,
                )
    m.b.box(stone, (width - 300, depth - 300, 430), (0, 0, 60))
    door(m, 140, 300, (0, depth / 2 - 150, 60))
    m.b.box(stone, (width + 10, depth + 10, 70), (0, 0, 490))
    m.b.gable(m.mat("roof"), (width + 60, depth + 40, width * 0.22), (0, 0, 560))
