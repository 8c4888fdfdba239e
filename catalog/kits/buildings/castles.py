"""Walls, towers and gatehouses of castles."""

from __future__ import annotations

from catalog.kits.facade import BUILDINGS, battlements
from catalog.kits.maker import KitMaker, camel, family, word


@family("castle-wall")
def castle_wall(m: KitMaker) -> None:
    """A length of curtain wall with battlements and a walk."""
    length, stone = m.opt("length", 800.0), m.mat("stone")
    m.say(
        "CurtainWall",
        BUILDINGS,
        f"{word(stone).capitalize()} curtain wall with battlements, {length / 100:.0f} m long, 5 m high.",
        camel(stone),
        tags="wall castle battlement",
    )
    m.b.box(stone, (length, 140, 440))
    m.b.box(stone, (length, 36, 80), (0, 52, 440))
    for i in range(int(length // 100)):
        m.b.box(stone, (58, 36, 70), (-length / 2 + 50 + 100 * i, 52, 520), body=None)


@family("gatehouse")
def gatehouse(m: KitMaker) -> None:
    """A gate with a round arch between two short towers, open to pass."""
    stone = m.mat("stone")
    m.say(
        "Gatehouse",
        BUILDINGS,
        f"{word(stone).capitalize()} gatehouse with an open arch of 4 m between two square towers.",
        camel(stone),
        tags="gate castle entrance",
    )
    m.b.arch(stone, (520, 300, 640), (360, 430))
    battlements(m, stone, 520, 300, 640)
    for x in (-380, 380):
        with m.b.moved((x, 0, 0)):
            m.b.box(stone, (240, 400, 820))
            battlements(m, stone, 240, 400, 820)
            m.b.box("DarkStone", (30, 10, 120), (0, 200, 400), body=None)
