"""Walls that fell, and what fell off them."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import RUINS


@family("ruin-wall")
def ruin_wall(m: KitMaker) -> None:
    """A broken wall with a stepped top."""
    stone, length = m.mat("stone"), m.opt("length", m.uni(300, 700, 50))
    opening = m.chance(0.4)
    m.say(
        "RuinedArch" if opening else "RuinedWall",
        RUINS,
        f"Ruined {word(stone)} wall{' with an arch' if opening else ''}, {length / 100:.1f} m long.",
        camel(stone),
        tags="ruin wall broken",
    )
    if opening:
        m.b.arch(stone, (max(length, 360), 70, 400), (220, 300))
        m.b.box(stone, (90, 70, 60), (-max(length, 360) / 2 + 46, 0, 400))
    else:
        count = int(length // 70)
        for i in range(count):
            m.b.box(stone, (length / count, 66, m.uni(60, 330, 15)), (-length / 2 + (i + 0.5) * length / count, 0, 0))
    for _ in range(5):
        s = m.uni(18, 40, 2)
        m.b.box(
            stone,
            (s, s, s * 0.7),
            (m.uni(-length / 2, length / 2), m.pick(-1, 1) * m.uni(50, 75), 0),
            (0, m.uni(0, 90), 0),
            body=None,
        )


@family("rubble")
def rubble(m: KitMaker) -> None:
    """A heap of broken stones."""
    stone = m.mat("stone")
    m.say(
        m.pick("RubbleHeap", "StonePile", "FallenStones"),
        RUINS,
        f"Heap of {word(stone)} blocks.",
        camel(stone),
        tags="rubble stones heap",
    )
    for i in range(9):
        a, r, s = i * 2.4, 18.0 * math.sqrt(i), m.uni(30, 60, 2)
        m.b.box(
            stone,
            (s, s * 0.8, s * 0.6),
            (r * math.cos(a), r * math.sin(a), 24 if i < 3 else 0),
            (m.uni(-12, 12), m.uni(0, 90), 0),
            body=None,
        )
    m.b.body_box((110, 110, 45), (0, 0, -5))
