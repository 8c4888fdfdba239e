"""Tables and desks."""

from __future__ import annotations

from catalog.kits.furniture.frames import TABLES, legs
from catalog.kits.maker import KitMaker, camel, family, word


@family("table")
def table(m: KitMaker) -> None:
    """A table that things stand on and chairs stand under."""
    kind = m.opt("kind", m.pick("Long", "Square", "Round", "Trestle", "Small"))
    wood, high = m.opt("wood", m.mat("wood")), m.opt("high", 74.0)
    w, d = {
        "Long": (m.uni(160, 220, 20), 85.0),
        "Square": (85.0, 85.0),
        "Round": (110.0, 110.0),
        "Trestle": (200.0, 80.0),
        "Small": (60.0, 60.0),
    }[kind]
    w, d = m.opt("width", w), m.opt("depth", d)
    m.say(
        f"{kind}Table",
        TABLES,
        f"{kind} table of {word(wood)}, {w:.0f} x {d:.0f} cm, {high:.0f} cm high.",
        camel(wood),
        tags="table",
    )
    b = m.b
    if kind == "Round":
        b.cylinder(wood, w / 2, 4, (0, 0, high - 4), segments=26)
        b.cylinder(wood, 7, high - 4, segments=12)
        b.cylinder(wood, 26, 6, top=10, segments=16)
        m.top(high, w * 0.66, w * 0.66)
        return
    b.box(wood, (w, d, 4), (0, 0, high - 4), bevel=0.6)
    if kind == "Trestle":
        for x in (-1, 1):
            b.box(wood, (6, d - 14, 8), (x * (w / 2 - 26), 0, high - 12))
            for y in (-1, 1):
                b.tube(wood, [(x * (w / 2 - 26), y * (d / 2 - 6), 0), (x * (w / 2 - 26), y * 8, high - 8)], 3.2)
            b.body_box((8, d - 20, 30), (x * (w / 2 - 26), 0, 0))
        b.box(wood, (w - 56, 5, 9), (0, 0, 34))
    else:
        legs(m, wood, w - 4, d - 4, high - 4, 7 if w > 100 else 5)
        for y in (-1, 1):
            b.box(wood, (w - 18, 2.4, 9), (0, y * (d / 2 - 6), high - 13), body=None)
    m.top(high, w - 16, d - 14, room=120)


@family("desk")
def desk(m: KitMaker) -> None:
    """A desk: of an office, a school, a writer."""
    kind = m.opt("kind", m.pick("Office", "Writing", "School", "Corner"))
    wood, metal = m.mat("wood"), m.mat("metal")
    w, d, high = {
        "Office": (150.0, 75.0, 73.0),
        "Writing": (125.0, 62.0, 75.0),
        "School": (70.0, 50.0, 70.0),
        "Corner": (170.0, 75.0, 73.0),
    }[kind]
    m.say(
        f"{kind}Desk",
        TABLES,
        f"{kind} desk with a {word(wood)} top, {w:.0f} x {d:.0f} cm.",
        camel(wood),
        tags="desk table work",
    )
    b = m.b
    b.box(wood, (w, d, 3), (0, 0, high - 3), bevel=0.4)
    if kind == "Writing":
        legs(m, wood, w - 6, d - 6, high - 3, 5)
        b.box(wood, (w - 14, d - 12, 12), (0, -1, high - 15))
        for x in (-1, 1):
            b.box("Brass", (10, 2, 2), (x * w * 0.22, d / 2 - 6, high - 9), body=None)
    elif kind == "School":
        for x in (-1, 1):
            b.box(metal, (3, d - 8, 4), (x * (w / 2 - 5), 0, 0))
            b.box(metal, (3, 3, high - 3), (x * (w / 2 - 5), -8, 0))
        b.box(wood, (w - 14, d - 14, 2), (0, 0, high - 17))
    else:
        for x in (-1, 1):
            b.box(metal, (5, d - 10, 3), (x * (w / 2 - 8), 0, 0))
            b.box(metal, (5, 6, high - 6), (x * (w / 2 - 8), -10, 3))
        b.box(m.mat("trim"), (w - 30, 2, 34), (0, -d / 2 + 6, high - 42))
        if kind == "Corner":
            b.box(m.mat("trim"), (42, d - 12, 60), (w / 2 - 34, -2, 4), bevel=0.6)
            for z in (8, 27, 46):
                b.box("WhitePaint", (38, 2, 16), (w / 2 - 34, d / 2 - 8, z), body=None)
    m.top(high, w - 16, d - 14, room=90)
