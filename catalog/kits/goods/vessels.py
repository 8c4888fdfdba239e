"""Crates, barrels, sacks, pallets and containers."""

from __future__ import annotations

import math

from catalog.kits.goods.categories import GOODS
from catalog.kits.maker import KitMaker, camel, family, word


@family("crate")
def crate(m: KitMaker) -> None:
    """A crate, a chest or a box."""
    kind = m.opt(
        "kind",
        m.pick("Crate", "Crate", "Chest", "CardboardBox", "AppleCrate", "PackingCase")
        if not m.style.old
        else m.pick("Crate", "Chest", "AppleCrate", "Trunk"),
    )
    wood = {"CardboardBox": "Burlap"}.get(kind) or m.opt(
        "wood", m.pick("Pine", "Planks", "GreyWood", "DarkPlanks", "Oak")
    )
    w, d, h = m.uni(50, 110, 10), m.uni(45, 80, 5), m.uni(40, 90, 10)
    if kind == "AppleCrate":
        w, d, h = 60, 42, 30
    m.say(
        kind,
        GOODS,
        f"{word(wood).capitalize()} {word(kind)}, {w:.0f} x {d:.0f} x {h:.0f} cm.",
        camel(wood),
        "Large" if w > 80 else "Small",
        tags="crate box container",
    )
    if kind == "AppleCrate":
        m.b.box(wood, (w, d, 24), body="box")
        for i in range(12):
            m.b.ellipsoid(
                m.pick("Apple", "Tomato", "Orange"),
                (12, 12, 12),
                (-22 + 15 * (i % 4), -13 + 13 * (i // 4), 20),
                segments=8,
                body=None,
            )
        m.b.body_box((w, d, 30))
        return
    m.b.box(wood, (w, d, h))
    trim = m.mat("trim") if kind in ("Chest", "Trunk") else wood
    if kind in ("Chest", "Trunk"):
        m.b.cylinder(wood, d / 5, w, (-w / 2, 0, h), (-90, 0, 0), segments=16, squash=2.5)
        for x in (-0.4, 0, 0.4):
            m.b.box(m.mat("metal"), (6, d + 2, h + 2), (x * w, 0, 0), body=None)
        m.b.box("Gold", (12, 4, 14), (0, d / 2, h - 10), body=None)
    elif kind == "CardboardBox":
        m.b.box("Paper", (w + 0.6, 8, h + 0.6), (0, 0, 0), body=None)
        m.top(h, w - 6, d - 6)
    else:
        for y in (-1, 1):
            for x in (-1, 1):
                m.b.box(trim, (7, 4, h), (x * (w / 2 - 3.5), y * (d / 2 + 1), 0), body=None)
            for z in (0, h - 7):
                m.b.box(trim, (w, 4, 7), (0, y * (d / 2 + 1), z), body=None)
        m.top(h, w - 6, d - 6)


@family("barrel")
def barrel(m: KitMaker) -> None:
    """A barrel, a drum or a churn."""
    kind = m.opt(
        "kind",
        m.pick("Barrel", "WineCask", "RainButt")
        if m.style.old
        else m.pick("OilDrum", "ChemicalDrum", "Barrel", "GasBottle", "MilkChurn"),
    )
    paint = m.mat("paint")
    wooden = kind in ("Barrel", "WineCask", "RainButt")
    body = m.mat("wood") if wooden else paint
    m.say(kind, GOODS, f"{word(body).capitalize()} {word(kind)}, standing.", camel(body), tags="barrel drum container")
    if wooden:
        h = m.uni(75, 100, 5)
        m.b.lathe(body, [(0, 0), (h * 0.3, 0), (h * 0.37, h * 0.5), (h * 0.3, h), (0, h)], segments=16)
        for z in (0.14, 0.8):
            m.b.cylinder(m.mat("metal"), h * 0.335, 5, (0, 0, h * z), segments=16, body=None)
        m.top(h, h * 0.36, h * 0.36)
    elif kind == "GasBottle":
        m.b.lathe(paint, [(0, 0), (16, 0), (16, 110), (8, 126), (5, 130), (5, 140), (0, 140)])
    elif kind == "MilkChurn":
        m.b.lathe("Aluminium", [(0, 0), (17, 0), (17, 44), (9, 54), (11, 66), (0, 68)])
    else:
        m.b.cylinder(paint, 29, 88, segments=18)
        for z in (28, 58):
            m.b.cylinder(paint, 30.5, 4, (0, 0, z), segments=18, body=None)
        m.b.cylinder("Iron", 4, 3, (14, 0, 88), segments=8, body=None)
        m.top(88, 36, 36)


@family("sack")
def sack(m: KitMaker) -> None:
    """Sacks and baskets."""
    kind = m.opt("kind", m.pick("GrainSack", "FlourSacks", "Basket", "FruitBasket", "CoalSack", "LaundryBasket"))
    m.say(
        kind,
        GOODS,
        f"{word(kind).capitalize()}, about half a metre.",
        m.pick("", "Full"),
        m.pick("Small", "Large"),
        tags="sack basket bag",
    )
    if kind == "FlourSacks":
        for x, y, z in ((0, -14, 0), (0, 14, 0), (0, 0, 20)):
            m.b.ellipsoid("Linen", (72, 42, 24), (x, y, z))
    elif "Sack" in kind:
        m.b.lathe("Burlap", [(0, 0), (24, 2), (28, 20), (22, 44), (10, 54), (14, 60), (0, 58)], squash=0.8)
        if kind == "CoalSack":
            m.b.ellipsoid("Cinder", (30, 24, 16), (0, 0, 52), body=None)
    else:
        m.b.lathe("Straw", [(0, 0), (22, 0), (30, 36), (33, 36), (31, 40), (26, 40), (22, 30), (0, 30)], body="hull")
        for i in range(9):
            a, r = i * 2.4, 6.5 * math.sqrt(i)
            m.b.ellipsoid(
                m.pick("Apple", "Tomato", "Orange", "Lemon") if kind != "LaundryBasket" else "Linen",
                (13, 13, 12),
                (r * math.cos(a), r * math.sin(a), 30),
                segments=8,
                body=None,
            )


@family("pallet")
def pallet(m: KitMaker) -> None:
    """A pallet, empty or with a load."""
    load = m.opt("load", m.pick("", "Sacks", "Bricks", "Boxes", "Drums", "Timber"))
    m.say(
        f"{load}Pallet" if load else "EmptyPallet",
        GOODS,
        f"Wooden pallet{' with ' + load.lower() if load else ''}, 120 x 80 cm.",
        m.pick("", "Euro"),
        m.pick("Full", "Grey"),
        tags="pallet load goods",
    )
    for y in (-36, 0, 36):
        m.b.box("Pine", (120, 9, 9), (0, y, 0), body=None)
    for i in range(6):
        m.b.box("Pine", (14, 80, 3), (-52 + 21 * i, 0, 9), body=None)
    m.b.body_box((120, 80, 12))
    if not load:
        m.top(12, 110, 70)
        return
    if load == "Sacks":
        for layer in range(3):
            for x in (-30, 30):
                for y in (-20, 20):
                    m.b.ellipsoid("Burlap", (60, 42, 22), (x, y, 12 + 19 * layer), segments=10, body=None)
        m.b.body_box((116, 78, 58), (0, 0, 12))
    elif load == "Bricks":
        m.b.box("RedBrick", (112, 74, 76), (0, 0, 12))
        m.top(88, 100, 66)
    elif load == "Boxes":
        for layer in range(2):
            for x in (-29, 29):
                for y in (-19, 19):
                    m.b.box("Burlap", (56, 37, 40), (x, y, 12 + 40 * layer), body=None)
                    m.b.box("Paper", (56.4, 6, 40.2), (x, y, 12 + 40 * layer), body=None)
        m.b.body_box((116, 76, 80), (0, 0, 12))
        m.top(92, 106, 66)
    elif load == "Drums":
        for x in (-29, 29):
            for y in (-19, 19):
                m.b.cylinder(m.mat("paint"), 18, 70, (x, y, 12), segments=12)
    else:
        for row in range(4):
            for i in range(4):
                m.b.box("Pine", (160, 17, 12), (0, -30 + 20 * i, 12 + 13 * row), body=None)
        m.b.body_box((160, 78, 52), (0, 0, 12))
        m.top(63, 120, 66)


@family("container")
def container(m: KitMaker) -> None:
    """A freight container."""
    paint, long_ = m.mat("paint"), m.opt("long", m.chance(0.4))
    length = 1219.0 if long_ else 606.0
    m.say(
        "FreightContainer",
        GOODS,
        f"{word(paint).capitalize()} freight container of corrugated steel, {length / 100:.1f} m long along X.",
        camel(paint),
        "Long" if long_ else "Short",
        tags="container shipping cargo freight",
    )
    m.b.box(paint, (length, 244, 259))
    n = int(length // 30)
    for s in (-1, 1):
        for i in range(n):
            m.b.box(paint, (13, 4, 240), (-length / 2 + (i + 0.5) * length / n, s * 122, 10), body=None)
    for y in (-60, 60):
        m.b.box("SilverPaint", (4, 5, 240), (length / 2 + 1, y, 8), body=None)
    m.b.box("WhitePaint", (90, 9, 40), (length * 0.2, 122, 190), body=None)
