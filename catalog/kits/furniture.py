"""Furniture of rooms: seats, tables, beds, shelves, cupboards, counters. Fronts look to +Y."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import Point3, hull

SEATS, TABLES, BEDS, STORAGE, KITCHEN, BATH = "seating", "tables", "beds", "storage", "kitchen", "bathroom"
BOOKS = ("MaroonPaint", "NavyPaint", "GreenPaint", "CreamPaint", "BrownPaint", "RedPaint", "TealPaint", "MustardCloth")


def legs(
    m: KitMaker, of: str, width: float, depth: float, height: float, thick: float = 5.0, *, round_: bool = False
) -> None:
    """Four legs at the corners of a rectangle."""
    for x in (-1, 1):
        for y in (-1, 1):
            at = (x * (width - thick) / 2, y * (depth - thick) / 2, 0.0)
            if round_:
                m.b.cylinder(of, thick / 2, height, at, top=thick / 2.6, segments=8)
            else:
                m.b.box(of, (thick, thick, height), at)


@family("chair")
def chair(m: KitMaker) -> None:
    """A chair."""
    kind = m.opt(
        "kind",
        m.pick("Ladderback", "Slatted", "Upholstered", "Windsor")
        if m.style.old
        else m.pick("Dining", "Shell", "Upholstered", "Metal", "Slatted"),
    )
    wood, cloth, metal = m.mat("wood"), m.mat("cloth"), m.mat("metal")
    b = m.b
    if kind in ("Shell", "Metal"):
        paint = m.mat("paint")
        m.say(
            f"{kind}Chair",
            SEATS,
            f"{word(paint).capitalize()} {kind.lower()} chair on {word(metal)} legs.",
            camel(paint),
            tags="chair seat",
        )
        for x in (-19, 19):
            for y in (-19, 19):
                b.tube(metal, [(x * 1.1, y * 1.1, 0), (x * 0.8, y * 0.8, 43)], 1.5)
        b.box(paint, (44, 42, 4), (0, 0, 43), bevel=1.5)
        b.box(paint, (42, 3, 34), (0, -21, 50), (0, 0, -8), bevel=1)
        b.body_box((40, 40, 43))
        return
    m.say(
        f"{kind}Chair",
        SEATS,
        f"{kind} chair of {word(wood)}{' with ' + word(cloth) + ' cushion' if kind == 'Upholstered' else ''}.",
        camel(cloth if kind == "Upholstered" else wood),
        camel(wood),
        tags="chair seat",
    )
    for x in (-19, 19):
        b.box(wood, (3.8, 3.8, 44), (x, 18, 0))
        b.box(wood, (3.8, 3.8, 94), (x, -19, 0))
    b.box(wood, (43, 42, 3), (0, 0, 43), bevel=0.8)
    if kind == "Upholstered":
        b.box(cloth, (40, 38, 5), (0, 0, 46), bevel=2)
        b.box(cloth, (36, 4, 34), (0, -19, 56), bevel=1.5)
    elif kind == "Ladderback":
        for z in (56, 69, 82):
            b.box(wood, (36, 2, 7), (0, -19, z), body=None)
    elif kind == "Windsor":
        for x in range(-15, 16, 5):
            b.cylinder(wood, 0.8, 46, (x, -19, 46), segments=5, body=None)
        b.box(wood, (42, 4, 5), (0, -19, 90), body=None)
    else:
        b.box(wood, (36, 2.4, 9), (0, -19, 83), body=None)
        for x in (-12, -4, 4, 12):
            b.box(wood, (3, 1.6, 38), (x, -19, 46), body=None)
    b.body_box((38, 4, 46), (0, -19, 46))


@family("stool")
def stool(m: KitMaker) -> None:
    """A stool, low or of a bar."""
    high, wood = m.opt("high", m.pick(45.0, 45.0, 75.0)), m.mat("wood")
    pad = m.chance(0.4)
    m.say(
        "BarStool" if high > 60 else "Stool",
        SEATS,
        f"Round {word(wood)} stool, {high:.0f} cm high.",
        camel(m.mat("cloth") if pad else wood),
        camel(wood),
        tags="stool seat",
    )
    m.b.cylinder(m.mat("cloth") if pad else wood, 17, 4, (0, 0, high - 4), segments=16)
    for x, y in ((12, 12), (-12, 12), (-12, -12), (12, -12)):
        m.b.tube(m.mat("metal") if pad else wood, [(x * 1.2, y * 1.2, 0), (x * 0.8, y * 0.8, high - 3)], 1.7)
    m.b.body_box((30, 30, high - 4))


@family("sofa")
def sofa(m: KitMaker) -> None:
    """A sofa or an armchair."""
    seats, cloth = m.opt("seats", m.pick(1, 2, 3)), m.mat("cloth")
    m.say(
        {1: "Armchair", 2: "TwoSeatSofa", 3: "Sofa"}[seats],
        SEATS,
        f"{word(cloth).capitalize()} {'armchair' if seats == 1 else 'sofa'} for {seats}.",
        camel(cloth),
        "Deep",
        tags="sofa couch armchair seat",
    )
    inner = 62 * seats
    width, depth = inner + 30, 86.0
    legs(m, m.mat("wood"), width - 10, depth - 10, 11, 5, round_=True)
    m.b.box(cloth, (width, depth, 20), (0, 0, 11), bevel=3)
    for i in range(seats):
        x = (i + 0.5) * 62 - inner / 2
        m.b.box(cloth, (60, 58, 14), (x, 12, 31), bevel=4)
        m.b.box(
            m.another("cloth") if i == 0 and m.style.ornate else cloth,
            (58, 14, 40),
            (x, -22, 44),
            (0, 0, -10),
            bevel=4,
            body=None,
        )
    m.b.box(cloth, (width, 16, 54), (0, -depth / 2 + 8, 31), bevel=4)
    for x in (-1, 1):
        m.b.box(cloth, (15, depth - 4, 34), (x * (width - 15) / 2, 0, 28), bevel=4)


@family("pew")
def pew(m: KitMaker) -> None:
    """A long bench: a pew, a waiting bench, a school bench, a plain bench."""
    kind, wood, long_ = m.opt("kind", m.pick("Pew", "PlainBench")), m.mat("wood"), m.opt("length", 240.0)
    m.say(
        kind,
        SEATS,
        f"{word(wood if kind != 'WaitingBench' else m.mat('metal')).capitalize()} {word(kind)}, "
        f"{long_ / 100:.1f} m long.",
        camel(wood if kind != "WaitingBench" else m.mat("cloth")),
        tags="bench pew seat",
    )
    b = m.b
    if kind == "Pew":
        for x in (-1, 1):
            b.box(wood, (5, 56, 60), (x * (long_ / 2 - 2.5), 4, 0))
            b.box(wood, (5, 8, 96), (x * (long_ / 2 - 2.5), -22, 0), body=None)
        b.box(wood, (long_ - 10, 40, 4), (0, 4, 42))
        b.box(wood, (long_, 4, 50), (0, -20, 44), (0, 0, -6), body="box")
        b.box(wood, (long_ - 10, 3, 40), (0, -18, 2), body=None)
    elif kind == "WaitingBench":
        b.box(m.mat("metal"), (long_, 8, 8), (0, 0, 30))
        n = int(long_ // 58)
        for i in range(n):
            px = (i - (n - 1) / 2) * long_ / n
            b.box(m.mat("cloth"), (50, 46, 6), (px, 2, 40), bevel=2)
            b.box(m.mat("cloth"), (50, 5, 40), (px, -22, 48), (0, 0, -8), bevel=2)
        for side in (-0.4, 0.4):
            b.box(m.mat("metal"), (6, 50, 30), (side * long_, 0, 0))
    else:
        b.box(wood, (long_, 34, 5), (0, 0, 41))
        for x in (-1, 1):
            b.box(wood, (6, 30, 41), (x * (long_ / 2 - 22), 0, 0))
        b.body_box((long_ - 60, 6, 41))
    if kind == "PlainBench":
        m.top(46, long_ - 20, 24)


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


@family("cot")
def cot(m: KitMaker) -> None:
    """A bed: double, single, bunk, of a hospital, a cot of straw."""
    kind = m.opt(
        "kind",
        m.pick("DoubleBed", "SingleBed", "BunkBed", "HospitalBed")
        if not m.style.old
        else m.pick("DoubleBed", "SingleBed", "StrawBed", "CanopyBed"),
    )
    wood, cloth = m.mat("wood"), m.mat("cloth")
    w = 165.0 if kind in ("DoubleBed", "CanopyBed") else 95.0
    frame = m.mat("metal") if kind == "HospitalBed" else wood
    m.say(
        kind,
        BEDS,
        f"{word(frame).capitalize()} {word(kind)} with {word(cloth)} cover, {w:.0f} x 205 cm.",
        camel(cloth),
        camel(frame),
        tags="bed sleep bedroom",
    )
    b = m.b
    levels = (0, 100) if kind == "BunkBed" else (22,) if kind == "HospitalBed" else (0,)
    for z in levels:
        b.box(frame, (w, 200, 14), (0, 0, z + 20))
        b.box("Linen", (w - 6, 194, 16), (0, 0, z + 34), bevel=3)
        b.box(cloth if kind != "StrawBed" else "Burlap", (w - 1, 136, 11), (0, 28, z + 44), bevel=3)
        for x in (-0.24, 0.24) if w > 120 else (0,):
            b.box("Linen", (w * 0.4 if w > 120 else 60, 40, 12), (x * w, -74, z + 50), bevel=4)
    high = {"BunkBed": 170, "CanopyBed": 210}.get(kind, 50)
    for x in (-1, 1):
        b.box(frame, (6, 6, high), (x * (w - 6) / 2, 97, 0))
        b.box(frame, (6, 6, max(high, 95)), (x * (w - 6) / 2, -97, 0))
    b.box(frame, (w, 4, 40), (0, -99, 44))
    b.box(frame, (w, 4, 22), (0, 99, 30))
    if kind == "CanopyBed":
        b.box(cloth, (w, 205, 8), (0, 0, 206))
        b.box(cloth, (w, 3, 40), (0, 101, 168), body=None)
    if kind == "BunkBed":
        for i in range(5):
            b.box(frame, (34, 3, 4), (w / 2 - 20, 102, 30 + 26 * i), body=None)
    if kind == "HospitalBed":
        for x in (-1, 1):
            b.box("SilverPaint", (3, 120, 4), (x * w / 2, 10, 90), body=None)
            b.box("SilverPaint", (3, 120, 4), (x * w / 2, 10, 76), body=None)


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


@family("counter")
def counter(m: KitMaker) -> None:
    """A counter: of a bar, a shop, a reception."""
    kind, wood = m.opt("kind", m.pick("BarCounter", "ShopCounter", "ReceptionDesk", "ServingCounter")), m.mat("wood")
    long_, top = m.opt("length", 200.0), m.opt("top", m.pick("Worktop", m.mat("wood"), "Marble"))
    m.say(
        kind,
        TABLES,
        f"{word(kind).capitalize()} of {word(wood)} with a {word(top)} top, {long_ / 100:.0f} m long, 1.05 m high.",
        camel(wood),
        tags="counter bar shop desk",
    )
    m.b.box(wood, (long_, 50, 101))
    m.b.box(top, (long_ + 6, 64, 4), (0, 3, 101), bevel=0.8)
    for i in range(int(long_ // 50)):
        m.b.box(
            m.mat("trim"), (40, 2, 74), (-long_ / 2 + 25 + i * long_ / int(long_ // 50), 26, 14), bevel=0.4, body=None
        )
    m.b.tube("Brass", [(-long_ / 2, 36, 16), (long_ / 2, 36, 16)], 2)
    m.top(105, long_ - 10, 46, y=3, room=100)


@family("kitchen-unit")
def kitchen_unit(m: KitMaker) -> None:
    """A unit of a kitchen: base, sink, stove, fridge, wall oven."""
    kind = m.opt("kind", m.pick("KitchenBase", "KitchenSink", "Stove", "Fridge", "Dishwasher"))
    paint, top = m.mat("paint"), m.opt("top", "Worktop")
    h, w = (185.0, 65.0) if kind == "Fridge" else (90.0, 70.0)
    m.say(
        kind,
        KITCHEN,
        f"{word(paint).capitalize()} {word(kind)} unit, {w:.0f} cm wide.",
        camel(paint),
        tags="kitchen unit appliance",
    )
    b = m.b
    body = "WhitePaint" if kind in ("Fridge", "Stove", "Dishwasher") else paint
    b.box(body, (w, 58, h - 4), (0, 0, 0))
    if kind == "Fridge":
        for z, hh in ((4, 110), (118, 62)):
            b.box("SilverPaint", (w - 2, 3, hh), (0, 29, z), bevel=0.6, body=None)
            b.box("Steel", (2, 4, 30), (-w / 2 + 8, 32, z + 30), body=None)
        b.box(body, (w, 58, 4), (0, 0, h - 4))
        return
    b.box(top, (w, 62, 4), (0, 1, h - 4))
    if kind == "Stove":
        b.box("BlackPaint", (w - 4, 56, 1), (0, 0, h), body=None)
        for x in (-16, 16):
            for y in (-14, 14):
                b.cylinder("Iron", 8, 1.5, (x, y, h), segments=14, body=None)
        b.box("BlackPaint", (w - 14, 2, 44), (0, 30, 18), body=None)
        for i in range(4):
            b.cylinder("SilverPaint", 2, 3, (-18 + 12 * i, 29, 76), (0, 0, 90), segments=8, body=None)
    elif kind == "KitchenSink":
        b.box("Steel", (48, 38, 1), (0, 2, h), body=None)
        b.box("GreyPaint", (42, 32, 1.2), (0, 2, h), body=None)
        b.tube("Steel", [(0, -20, h), (0, -20, h + 24), (0, -4, h + 24), (0, -4, h + 16)], 1.4)
    else:
        for z in (6, 46) if kind == "KitchenBase" else (6,):
            b.box(
                paint if kind == "KitchenBase" else "SilverPaint",
                (w - 2, 2.4, 38 if kind == "KitchenBase" else 76),
                (0, 29, z),
                bevel=0.3,
                body=None,
            )
            b.box("Steel", (16, 2, 2), (0, 31, z + 30), body=None)
        m.top(h, w - 8, 46, room=60)


@family("bath-thing")
def bath_thing(m: KitMaker) -> None:
    """Bath, toilet, basin, shower, urinal row."""
    kind = m.opt("kind", m.pick("Bathtub", "Toilet", "Washbasin", "ShowerCabin", "TowelShelf"))
    m.say(
        kind,
        BATH,
        f"White {word(kind)} of a bathroom.",
        m.pick("White", "Porcelain"),
        "Modern",
        tags="bathroom sanitary",
    )
    b = m.b
    if kind == "Bathtub":
        b.box("Porcelain", (170, 76, 56), bevel=8)
        b.box("WhitePaint", (150, 58, 1), (0, 0, 56), body=None)
        b.box("SkyPaint", (140, 50, 1.5), (0, 0, 56), body=None)
        b.tube("Steel", [(-70, -30, 56), (-70, -30, 76), (-54, -24, 74)], 2)
    elif kind == "Toilet":
        b.lathe("Porcelain", [(0, 0), (13, 0), (14, 20), (20, 38), (0, 38)], (0, 6, 0), squash=1.35)
        b.box("Porcelain", (40, 18, 40), (0, -26, 36), bevel=3)
        b.cylinder("WhitePaint", 20, 4, (0, 6, 38), segments=16, squash=1.3)
    elif kind == "Washbasin":
        b.cylinder("Porcelain", 9, 76, top=11, segments=12)
        b.lathe("Porcelain", [(0, 0), (14, 0), (30, 14), (30, 18), (24, 18), (0, 8)], (0, 4, 70))
        b.tube("Steel", [(0, -16, 86), (0, -16, 102), (0, -4, 100)], 1.5)
    elif kind == "ShowerCabin":
        b.box("Porcelain", (90, 90, 12))
        for x, y, s in ((0, 44, (90, 2, 190)), (44, 0, (2, 90, 190)), (-44, 0, (2, 90, 190)), (0, -44, (90, 2, 190))):
            b.box("Glass", s, (x, y, 12))
        b.tube("Steel", [(0, -40, 12), (0, -40, 200), (0, -10, 206)], 1.5)
    else:
        legs(m, "Steel", 60, 34, 110, 3)
        for z in (20, 60, 106):
            b.box("WhitePaint", (60, 34, 2), (0, 0, z))
        for z in (22, 62):
            b.box("TealCloth", (40, 26, 14), (0, 0, z), bevel=4, body=None)


@family("fireplace")
def fireplace(m: KitMaker) -> None:
    """A fireplace with a chimney breast."""
    stone = m.mat("stone")
    m.say(
        "Fireplace",
        "decor",
        f"{word(stone).capitalize()} hearth with glowing logs and a mantel shelf.",
        camel(stone),
        tags="fireplace hearth chimney",
    )
    b = m.b
    for x in (-75, 75):
        b.box(stone, (40, 50, 120), (x, 0, 0))
    b.box(stone, (190, 50, 40), (0, 0, 120))
    b.box(m.mat("wood"), (210, 62, 8), (0, 4, 160))
    b.box(stone, (150, 40, 130), (0, -5, 168), body="box")
    b.box("DarkStone", (112, 6, 120), (0, -22, 0))
    b.box("DarkStone", (112, 44, 6), body=None)
    for i in range(4):
        b.cylinder("Bark", 6, 70, (-35, -8 + 5 * i, 12 + 5 * (i % 2)), (-90, 8 * i - 12, 0), segments=8, body=None)
    b.ellipsoid("Ember", (50, 26, 20), (0, 0, 8), segments=10, body=None)


@family("display")
def display(m: KitMaker) -> None:
    """A show case, a pedestal with an exhibit, or a table case."""
    kind = m.opt("kind", m.pick("TableCase", "TallCase", "Pedestal", "SkeletonPlinth", "VasePedestal", "MapCase"))
    stone, exhibit = (
        m.mat("stone"),
        m.opt("exhibit", m.pick("Amphora", "Mask", "Crystal", "Coins", "Helmet", "Globe", "Sword", "Fossil")),
    )
    m.say(
        f"{exhibit}Exhibit" if kind in ("TallCase", "Pedestal", "TableCase") else kind,
        "exhibits",
        f"{word(kind).capitalize()} with {exhibit.lower()} of a museum.",
        {"TableCase": "Cased", "TallCase": "TallCased"}.get(kind, camel(stone)),
        tags="museum exhibit display case",
    )
    b, wood = m.b, m.mat("wood")
    if kind == "TableCase" or kind == "MapCase":
        b.box(wood, (140, 70, 8), (0, 0, 76))
        legs(m, wood, 136, 66, 76, 6)
        b.box("Glass", (136, 66, 22), (0, 0, 84))
        b.box("Linen", (130, 60, 1), (0, 0, 84), body=None)
        for i in range(5):
            b.ellipsoid(
                {"Coins": "Gold", "Crystal": "CrystalBlue", "Fossil": "Limestone"}.get(exhibit, "Bronze"),
                (14, 14, 8),
                (-52 + 26 * i, (i % 2) * 16 - 8, 85),
                segments=10,
                body=None,
            )
        return
    if kind == "SkeletonPlinth":
        b.box(stone, (420, 160, 30))
        b.tube("CreamPaint", [(-190, 0, 60), (-90, 0, 120), (40, 0, 150), (130, 0, 210)], 7)
        b.ellipsoid("CreamPaint", (60, 34, 36), (150, 0, 200), segments=10, body=None)
        for x in (-80, -50, -20, 10, 40):
            for s in (-1, 1):
                b.tube("CreamPaint", [(x, 0, 136), (x, s * 36, 110), (x, s * 20, 74)], 3)
        for x in (-70, 50):
            for s in (-1, 1):
                b.tube("CreamPaint", [(x, s * 14, 120), (x + 12, s * 30, 78), (x, s * 32, 30)], 5)
        b.body_box((340, 80, 170), (0, 0, 30))
        return
    b.box(stone, (60, 60, 100 if kind != "TallCase" else 60), bevel=1)
    z = 100 if kind != "TallCase" else 60
    if kind == "TallCase":
        b.box("Glass", (58, 58, 120), (0, 0, 60))
        b.box(stone, (62, 62, 8), (0, 0, 180))
    with b.moved((0, 0, z)):
        if exhibit == "Amphora" or kind == "VasePedestal":
            b.lathe("Terracotta", [(0, 0), (8, 0), (20, 24), (18, 40), (7, 52), (10, 58)])
            b.lathe("BlackPaint", [(19.5, 22), (20.5, 26), (20, 32)], body=None)
        elif exhibit in ("Helmet", "Mask"):
            b.cylinder(wood, 3, 20, segments=8, body=None)
            b.ellipsoid("Bronze" if exhibit == "Helmet" else "Gold", (26, 28, 32), (0, 0, 18))
        elif exhibit == "Globe":
            b.ellipsoid("SkyPaint", (38, 38, 38), (0, 0, 8))
            b.cylinder(wood, 12, 8, segments=12, body=None)
        elif exhibit == "Sword":
            b.box("Steel", (6, 1.5, 80), (0, 0, 4), body="box")
            b.box("Gold", (24, 3, 4), (0, 0, 20), body=None)
        elif exhibit == "Crystal":
            for i in range(4):
                b.cylinder(
                    "CrystalViolet",
                    6,
                    30 + 6 * i,
                    (6 * math.cos(i * 2.0), 6 * math.sin(i * 2.0), 0),
                    (8 * math.cos(i * 2), 0, 8 * math.sin(i * 2)),
                    top=1,
                    segments=6,
                    body=None,
                )
        else:
            b.add(
                "Limestone",
                hull(
                    [
                        (-18.0, -10.0, 0.0),
                        (18.0, -12.0, 0.0),
                        (16.0, 12.0, 0.0),
                        (-16.0, 10.0, 0.0),
                        (-8.0, 0.0, 26.0),
                        (10.0, 2.0, 18.0),
                    ]
                ),
            )


@family("service")
def service(m: KitMaker) -> None:
    """Machines of public rooms: vending, tickets, lockers, checkout, gates, freezers."""
    kind = m.opt(
        "kind",
        m.pick(
            "VendingMachine",
            "TicketMachine",
            "Checkout",
            "TicketGate",
            "ChestFreezer",
            "FridgeDisplay",
            "PhotoBooth",
            "CashMachine",
            "ShoppingCart",
            "Arcade",
            "Jukebox",
        ),
    )
    paint = m.mat("paint")
    m.say(
        {"Arcade": "ArcadeCabinet"}.get(kind, kind),
        "equipment",
        f"{word(paint).capitalize()} {word(kind)}.",
        camel(paint),
        tags="machine shop public",
    )
    b = m.b
    if kind in ("VendingMachine", "FridgeDisplay"):
        b.box(paint, (95, 75, 185), bevel=2)
        b.box("BlackPaint", (64, 3, 130), (-10, 37, 40), body=None)
        for row in range(5):
            for i in range(5):
                b.box(m.another("paint"), (8, 3, 16), (-34 + 12 * i, 39, 46 + 25 * row), body=None)
        b.box("WhiteGlow", (88, 2, 12), (0, 38, 170), body=None)
    elif kind in ("TicketMachine", "CashMachine"):
        b.box(paint, (70, 50, 170), bevel=2)
        b.box("TimetableScreen", (44, 3, 30), (0, 25, 110), body=None)
        b.box("BlackPaint", (50, 3, 14), (0, 25, 60), body=None)
        b.box("WhiteGlow", (66, 2, 12), (0, 25, 154), body=None)
    elif kind == "Checkout":
        b.box(paint, (240, 60, 80), (0, 0, 0))
        b.box("Rubber", (150, 50, 3), (-40, 0, 80), body=None)
        b.box("GreyPaint", (60, 50, 12), (80, 0, 80))
        b.box("Screen", (30, 4, 24), (80, -10, 104), body=None)
        b.box("Iron", (4, 4, 26), (80, -14, 90), body=None)
        b.cylinder("Iron", 2, 150, (-110, -26, 80), segments=6, body=None)
        b.box("YellowPaint", (24, 6, 24), (-110, -26, 206), body=None)
    elif kind == "TicketGate":
        b.box("SilverPaint", (160, 26, 100), bevel=4)
        b.box("BluePaint", (40, 27, 3), (50, 0, 100), body=None)
        b.box("GreenGlow", (8, 28, 8), (72, 0, 84), body=None)
        b.box("RedPaint", (6, 40, 40), (0, 28, 50), body=None)
    elif kind == "ChestFreezer":
        b.box("WhitePaint", (180, 80, 80), bevel=3)
        b.box("Glass", (170, 70, 4), (0, 0, 80))
        for i in range(12):
            b.box(m.another("paint"), (22, 16, 8), (-70 + 28 * (i % 6), -16 + 32 * (i // 6), 73), body=None)
    elif kind == "ShoppingCart":
        for x in (-40, 40):
            for y in (-22, 22):
                b.cylinder("BlackPaint", 5, 4, (x, y - 2, 5), (0, 0, 90), segments=8, body=None)
        b.box("Steel", (90, 48, 3), (0, 0, 20), body=None)
        b.add(
            "SilverPaint",
            hull(
                [
                    (x, y, z)
                    for x, y, z in (
                        (-36.0, -20.0, 50.0),
                        (-36.0, 20.0, 50.0),
                        (36.0, -16.0, 50.0),
                        (36.0, 16.0, 50.0),
                        (-46.0, -27.0, 96.0),
                        (-46.0, 27.0, 96.0),
                        (46.0, -22.0, 90.0),
                        (46.0, 22.0, 90.0),
                    )
                ]
            ),
        )
        b.tube("RedPaint", [(-56, -24, 100), (-56, 24, 100)], 2)
        b.body_box((84, 44, 50))
    elif kind == "Jukebox":
        b.box(paint, (80, 55, 120), bevel=6)
        b.cylinder("NeonPink", 40, 52, (0, -26, 118), (0, 0, 90), segments=24, body="hull")
        b.cylinder("YellowPaint", 32, 54, (0, -26, 118), (0, 0, 90), segments=24, body=None)
        b.box("NeonBlue", (64, 2, 40), (0, 28, 60), body=None)
    elif kind == "Arcade":
        b.add(
            paint,
            hull(
                [
                    (x, y, z)
                    for x in (-35.0, 35.0)
                    for y, z in (
                        (-40.0, 0.0),
                        (40.0, 0.0),
                        (40.0, 95.0),
                        (10.0, 110.0),
                        (0.0, 150.0),
                        (30.0, 180.0),
                        (-40.0, 180.0),
                    )
                ]
            ),
        )
        b.box("Screen", (54, 2, 40), (0, 26, 112), (0, 0, 14), body=None)
        b.box("NeonPink", (60, 2, 16), (0, 34, 160), body=None)
    else:
        b.box(paint, (150, 80, 195), bevel=3)
        b.box("BlackCloth", (60, 3, 120), (-30, 40, 60), body=None)
        b.box("WhiteGlow", (50, 2, 30), (40, 40, 150), body=None)


@family("care")
def care(m: KitMaker) -> None:
    """Equipment of a ward, a laboratory, a gymnasium, a salon."""
    kind = m.opt(
        "kind",
        m.pick(
            "DripStand",
            "BedScreen",
            "Wheelchair",
            "PatientMonitor",
            "MedicineTrolley",
            "LabBench",
            "Microscope",
            "Treadmill",
            "WeightBench",
            "ExerciseBike",
            "VaultingBox",
        ),
    )
    paint = m.mat("paint")
    m.say(kind, "equipment", f"{word(paint).capitalize()} {word(kind)}.", camel(paint), tags="equipment medical sport")
    b = m.b
    if kind == "DripStand":
        for k in range(5):
            b.box("Steel", (28, 3, 3), (0, 0, 3), (0, 72 * k, 0), body=None)
        b.cylinder("Steel", 1.6, 180, segments=8)
        b.box("SkyPaint", (12, 4, 24), (9, 0, 150), body=None)
        b.body_box((44, 44, 6))
    elif kind == "BedScreen":
        for x in (-60, 0, 60):
            b.box("Steel", (3, 30, 3), (x, 0, 0))
            b.box("Steel", (3, 3, 180), (x, 0, 0), body=None)
        b.box(m.mat("cloth"), (120, 2, 150), (0, 0, 25), body="box")
    elif kind == "Wheelchair":
        b.box("BlackCloth", (44, 44, 5), (0, 0, 48))
        b.box("BlackCloth", (44, 4, 44), (0, -22, 52))
        for s in (-1, 1):
            points = [
                (s * 27, 28 * math.cos(a) - 6, 30 + 28 * math.sin(a)) for a in [k * math.pi / 8 for k in range(17)]
            ]
            b.tube("Rubber", points, 2)
            b.tube("Steel", [(s * 22, -22, 96), (s * 22, -22, 30), (s * 22, 30, 20)], 1.5)
            b.cylinder("BlackPaint", 8, 4, (s * 20 - 2, 30, 8), (-90, 0, 0), segments=10, body=None)
        b.body_box((54, 60, 48))
    elif kind == "PatientMonitor":
        b.cylinder("Steel", 24, 4, segments=12)
        b.cylinder("Steel", 2.5, 120, segments=8)
        b.box("WhitePaint", (44, 14, 34), (0, 0, 118), bevel=2)
        b.box("Screen", (36, 1, 26), (0, 7.4, 122), body=None)
    elif kind == "MedicineTrolley":
        b.box(paint, (60, 46, 80), (0, 0, 12), bevel=1)
        for i in range(4):
            b.box("WhitePaint", (54, 2, 16), (0, 23, 18 + 18 * i), body=None)
        for x in (-24, 24):
            for y in (-18, 18):
                b.cylinder("BlackPaint", 5, 3, (x, y - 1.5, 6), (0, 0, 90), segments=8, body=None)
        b.body_box((56, 42, 12))
        m.top(92, 50, 36)
    elif kind == "LabBench":
        b.box("WhitePaint", (180, 70, 84))
        b.box("BlackPaint", (186, 76, 4), (0, 0, 84))
        for i in range(3):
            b.box(paint, (54, 2, 60), (-60 + 60 * i, 35, 16), body=None)
        m.top(88, 170, 60)
    elif kind == "Microscope":
        b.box("BlackPaint", (18, 24, 3))
        b.box("GreyPaint", (5, 6, 30), (0, -8, 3), body=None)
        b.cylinder("GreyPaint", 3, 22, (0, 2, 16), (0, 0, 12), segments=10, body=None)
        b.box("BlackPaint", (12, 12, 1.5), (0, 2, 12), body=None)
        b.body_box((18, 24, 36))
    elif kind == "Treadmill":
        b.box("BlackPaint", (180, 76, 18), bevel=3)
        b.box("Rubber", (150, 50, 1), (-6, 0, 18), body=None)
        for y in (-34, 34):
            b.tube("GreyPaint", [(60, y, 18), (80, y, 120)], 3.5)
        b.box("BlackPaint", (14, 70, 34), (80, 0, 110))
        b.box("Screen", (2, 34, 20), (72, 0, 118), body=None)
    elif kind == "WeightBench":
        b.box("BlackCloth", (120, 30, 8), (0, 0, 40), bevel=2)
        for x in (-45, 45):
            b.box(paint, (6, 40, 40), (x, 0, 0))
        for y in (-50, 50):
            b.box(paint, (6, 6, 110), (50, y, 0))
        b.cylinder("Steel", 1.6, 180, (50, -90, 112), (0, 0, 90), segments=8)
        for y in (-84, 70):
            b.cylinder("BlackPaint", 22, 12, (50, y, 112), (0, 0, 90), segments=18)
    elif kind == "ExerciseBike":
        b.box("BlackPaint", (100, 40, 8))
        b.box(paint, (70, 14, 44), (0, 0, 8), bevel=4)
        b.box("BlackCloth", (28, 22, 6), (-30, 0, 86), body=None)
        b.cylinder("Steel", 3, 40, (-30, 0, 48), segments=8)
        b.tube("Steel", [(30, 0, 50), (38, 0, 100), (48, 0, 104)], 2.5)
        b.body_box((20, 40, 60), (38, 0, 50))
    else:
        for i in range(4):
            w = 150 - 6 * i
            b.box("Pine", (w, 70 - 8 * i, 24), (0, 0, 25 * i))
        b.box("BrownLeather", (130, 46, 12), (0, 0, 100), bevel=4)


@family("music")
def music(m: KitMaker) -> None:
    """Instruments and stage things."""
    kind = m.opt(
        "kind",
        m.pick(
            "Piano", "GrandPiano", "DrumKit", "Harp", "MusicStand", "Loudspeaker", "Organ", "Lectern", "Globe", "Easel"
        ),
    )
    wood = m.mat("wood")
    m.say(
        {"Globe": "FloorGlobe"}.get(kind, kind),
        "decor",
        f"{word(wood).capitalize()} {word(kind)}.",
        camel(wood),
        tags="music stage decor",
    )
    b = m.b
    if kind in ("Piano", "Organ"):
        b.box(wood, (150, 40, 125), (0, -10, 0), bevel=1)
        b.box(wood, (150, 34, 8), (0, 24, 64))
        b.box("WhitePaint", (124, 14, 2), (0, 30, 72), body=None)
        for i in range(16):
            b.box("BlackPaint", (3, 8, 1.5), (-58 + 7.6 * i, 27, 74), body=None)
        for x in (-66, 66):
            b.box(wood, (8, 8, 64), (x, 34, 0))
        if kind == "Organ":
            for i in range(11):
                b.cylinder("Brass", 5, 110 + 12 * abs(5 - i), (-60 + 12 * i, -10, 125), segments=10, body=None)
            b.body_box((140, 20, 110), (0, -10, 125))
    elif kind == "GrandPiano":
        b.extrude("BlackPaint", [(-75, 60), (75, 60), (75, 20), (40, -60), (0, -110), (-75, -120)], 28, (0, 0, 70))
        b.box("WhitePaint", (124, 14, 2), (0, 52, 98), body=None)
        for x, y in ((-62, 45), (62, 45), (-50, -95)):
            b.cylinder("BlackPaint", 5, 70, (x, y, 0), segments=10)
        b.box("BlackPaint", (150, 2, 90), (-20, -20, 98), (0, 20, 0), body=None)
    elif kind == "DrumKit":
        b.cylinder(m.mat("paint"), 28, 44, (0, -22, 30), (0, 0, 90), segments=20)
        for x, y, z in ((-34, -14, 62), (34, -14, 62), (44, -40, 30)):
            b.cylinder(m.mat("paint"), 18, 20, (x, y, z), segments=16, body=None)
            b.cylinder("Iron", 2, z, (x, y, 0), segments=6, body=None)
        for x in (-60, 62):
            b.cylinder("Iron", 1.2, 110, (x, 0, 0), segments=6, body=None)
            b.cylinder("Brass", 22, 1.5, (x, 0, 110), top=4, segments=18, body=None)
        b.body_box((130, 70, 80), (0, -10, 0))
    elif kind == "Harp":
        b.box(wood, (30, 50, 8))
        b.tube("Gold", [(0, 20, 8), (0, 34, 150), (0, 0, 165), (0, -30, 130), (0, -20, 8)], 4)
        for i in range(9):
            b.tube("Linen", [(0, -14 + 5 * i, 20), (0, -20 + 6 * i, 140)], 0.4)
        b.body_box((24, 70, 150))
    elif kind == "Loudspeaker":
        b.box("BlackPaint", (44, 40, 110), bevel=2)
        for z, r in ((28, 16), (64, 16), (92, 8)):
            b.cylinder("GreyPaint", r, 2, (0, 20, z), (0, 0, 90), segments=16, body=None)
    elif kind in ("MusicStand", "Lectern"):
        b.cylinder(wood, 22, 4, segments=14)
        b.cylinder(wood, 3.5, 105, segments=8)
        b.box(wood, (54, 38, 3), (0, 0, 104), (0, 0, 24), body="box")
        b.box("Paper", (40, 28, 1), (0, 0, 107.5), (0, 0, 24), body=None)
    elif kind == "Globe":
        for k in range(3):
            b.tube(
                wood,
                [
                    (26 * math.cos(k * 2.1), 26 * math.sin(k * 2.1), 0),
                    (8 * math.cos(k * 2.1), 8 * math.sin(k * 2.1), 56),
                ],
                2.5,
            )
        b.ellipsoid("SkyPaint", (52, 52, 52), (0, 0, 54))
        b.lathe("Brass", [(27, 0), (29, 0), (29, 3), (27, 3), (27, 0)], (0, 0, 78), smooth=False, body=None)
        b.body_box((44, 44, 54))
    else:
        for x in (-26, 26):
            b.tube(wood, [(x, 14, 0), (0, 0, 170)], 2.2)
        b.tube(wood, [(0, -44, 0), (0, 0, 168)], 2.2)
        b.box(wood, (60, 5, 4), (0, 14, 66))
        b.box("CreamPaint", (74, 3, 60), (0, 12, 70), (0, 0, -8), body="box")
        b.panel(m.pick("Landscape", "Sunset", "Seascape"), 66, 52, (0, 15.4, 74), (0, 0, -8))
        b.body_box((50, 56, 40), (0, -12, 0))
