"""Shelves, bookcases and cupboards."""

from __future__ import annotations

from catalog.kits.furniture.frames import STORAGE
from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import Point3

BOOKS = ("MaroonPaint", "NavyPaint", "GreenPaint", "CreamPaint", "BrownPaint", "RedPaint", "TealPaint", "MustardCloth")


@family("shelf")
def shelf(m: KitMaker) -> None:
    """An open shelf whose boards carry things."""
    boards, w, d, high = (
        m.opt("boards", m.pick(4, 5)),
        m.opt("width", m.uni(80, 120, 10)),
        m.opt("depth", 40.0),
        m.opt("high", 190.0),
    )
    kind = m.opt("kind", m.pick("Wood", "Metal"))
    of, post = (m.mat("wood"),) * 2 if kind == "Wood" else (m.mat("trim"), m.mat("metal"))
    m.say(
        "OpenShelf",
        STORAGE,
        f"Open shelf of {word(of)} with {boards} boards, {w:.0f} x {d:.0f} cm, {high / 100:.1f} m high.",
        camel(of),
        "Wide" if w > 100 else "Narrow",
        tags="shelf rack storage open",
    )
    for x in (-1, 1):
        for y in (-1, 1):
            m.b.box(post, (4, 4, high), (x * (w / 2 - 2), y * (d / 2 - 2), 0))
    step = (high - 16) / (boards - 1)
    for i in range(boards):
        z = 8 + i * step
        m.b.box(of, (w, d, 3), (0, 0, z))
        m.top(z + 3, w - 14, d - 12, room=step - 8 if i < boards - 1 else 60)


@family("bookcase")
def bookcase(m: KitMaker) -> None:
    """A bookcase full of books."""
    wood, w, high = m.mat("wood"), m.opt("width", m.uni(80, 120, 10)), m.opt("high", m.pick(190.0, 210.0, 230.0))
    m.say(
        "FilledBookcase",
        STORAGE,
        f"{word(wood).capitalize()} bookcase full of books, {w:.0f} cm wide, {high / 100:.1f} m high.",
        camel(wood),
        "Wide" if w > 100 else "Tall",
        tags="bookcase books shelf library",
    )
    for side in (-1, 1):
        m.b.box(wood, (3, 32, high), (side * (w / 2 - 1.5), 0, 0), body=None)
    m.b.box(wood, (w - 4, 1.5, high - 4), (0, -14, 2), body=None)
    m.b.body_box((w, 32, high))
    rows = int(high // 36)
    for i in range(rows + 1):
        z = 4.0 + i * (high - 8) / rows
        m.b.box(wood, (w - 4, 30, 2.5), (0, 0, z), body=None)
        x = -w / 2 + 5
        while i < rows and x < w / 2 - 12:
            t, h = m.uni(5, 14, 1), m.uni(20, 29, 1)
            if not m.chance(0.08):
                m.b.box(m.pick(*BOOKS), (t - 0.5, 20, h), (x + t / 2, 0, z + 2.5), body=None)
            x += t
    m.top(high, w - 10, 24, room=60)


@family("cupboard")
def cupboard(m: KitMaker) -> None:
    """A closed cupboard: wardrobe, chest of drawers, cabinet, sideboard, locker, file cabinet, dresser."""
    kind = m.opt(
        "kind",
        m.pick("Wardrobe", "ChestOfDrawers", "Sideboard", "Cabinet")
        if m.style.old
        else m.pick("Wardrobe", "ChestOfDrawers", "Sideboard", "Cabinet", "LockerRow", "FilingCabinet"),
    )
    w, d, h = {
        "Wardrobe": (130.0, 60.0, 205.0),
        "ChestOfDrawers": (95.0, 48.0, 86.0),
        "Sideboard": (170.0, 46.0, 82.0),
        "Cabinet": (90.0, 42.0, 150.0),
        "LockerRow": (120.0, 50.0, 185.0),
        "FilingCabinet": (46.0, 60.0, 132.0),
        "Nightstand": (45.0, 40.0, 52.0),
    }[kind]
    of = m.mat("paint") if kind in ("LockerRow", "FilingCabinet") else m.mat("wood")
    front = m.mat("trim") if m.chance(0.4) and kind not in ("LockerRow", "FilingCabinet") else of
    m.say(
        kind,
        STORAGE,
        f"{word(of).capitalize()} {word(kind)}, {w:.0f} x {d:.0f} cm, {h:.0f} cm high.",
        camel(of),
        camel(front),
        tags="cupboard cabinet storage",
    )
    b = m.b
    b.box(of, (w, d, h - 8), (0, 0, 6))
    b.box(of, (w - 10, d - 10, 6))
    b.box(of, (w + 3, d + 3, 3), (0, 0, h - 3), bevel=0.6)
    cols, rows = {
        "Wardrobe": (2, 1),
        "ChestOfDrawers": (1, 4),
        "Sideboard": (3, 1),
        "Cabinet": (2, 2),
        "LockerRow": (4, 1),
        "FilingCabinet": (1, 4),
        "Nightstand": (1, 2),
    }[kind]
    for i in range(cols):
        for j in range(rows):
            cw, ch = (w - 6) / cols, (h - 16) / rows
            at: Point3 = (-w / 2 + 3 + (i + 0.5) * cw, d / 2, 9 + j * ch)
            b.box(front, (cw - 2, 2.4, ch - 2), at, bevel=0.3, body=None)
            b.box(
                "Brass" if m.style.old else "Steel",
                (10, 2, 2) if rows > 1 else (2, 2, 14),
                (at[0] + (0 if rows > 1 else cw * 0.34 * (1 if i % 2 == 0 else -1)), at[1] + 2, at[2] + ch * 0.55),
                body=None,
            )
            if kind == "LockerRow":
                for k in range(3):
                    b.box("BlackPaint", (cw * 0.5, 1, 1.5), (at[0], at[1] + 1.4, at[2] + ch - 22 + 5 * k), body=None)
    m.top(h, w - 8, d - 8, room=90)
