"""Small things that stand on others: dishes, food, books, lamps, plants, machines of a desk, and floor lamps."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word

DISHES, DECOR, LIGHTS, DESK = "tableware", "decor", "lighting", "desk things"


@family("dish")
def dish(m: KitMaker) -> None:
    """Tableware and food."""
    old = m.style.old
    kind = m.opt(
        "kind",
        m.pick(
            "Plate",
            "Mug",
            "Jug",
            "Bowl",
            "Bottle",
            "Goblet",
            "Bread",
            "CheeseBoard",
            "Candlestick",
            "FruitBowl",
            "Tankard",
            "SoupPot",
            "Pie",
        )
        if old
        else m.pick(
            "Plate",
            "Cup",
            "Jug",
            "Bowl",
            "Bottle",
            "WineGlass",
            "Teapot",
            "FruitBowl",
            "Cake",
            "Toaster",
            "SoupPot",
            "SaltMill",
            "Napkins",
        ),
    )
    clay = m.opt(
        "clay",
        m.pick("Porcelain", "Terracotta", "BluePaint", "TealPaint", "CreamPaint")
        if not old
        else m.pick("Terracotta", "Clay", "Bronze", "Oak"),
    )
    noun = {"Bread": "BreadLoaf"}.get(kind, kind)
    m.say(
        noun, DISHES, f"{word(clay).capitalize()} {word(noun)} for a table.", camel(clay), tags="tableware food small"
    )
    b = m.b
    if kind == "Plate":
        b.lathe(clay, [(0, 0), (8, 0), (13, 2), (13, 2.6), (0, 1)])
        b.ellipsoid(m.pick("Bread", "Tomato", "PaleLeaf", "Cheese"), (12, 9, 4), (0, 0, 1), segments=8, body=None)
    elif kind in ("Mug", "Tankard", "Cup"):
        h = 9 if kind == "Cup" else 13
        b.lathe(clay, [(0, 0), (4.2, 0), (4.6, h), (4.0, h), (3.6, 1), (0, 1)])
        b.cylinder("Wheat" if kind == "Tankard" else "Soil", 4, 0.6, (0, 0, h - 2), segments=12, body=None)
        b.tube(clay, [(4.4, 0, h * 0.8), (7.5, 0, h * 0.7), (7.5, 0, h * 0.3), (4.4, 0, h * 0.2)], 0.7)
    elif kind in ("Jug", "Teapot"):
        b.lathe(clay, [(0, 0), (6, 0), (9, 8), (7, 17), (4.5, 22), (5.5, 25)])
        b.tube(clay, [(7, 0, 19), (13, 0, 16), (9, 0, 7)], 0.9)
        if kind == "Teapot":
            b.tube(clay, [(-7, 0, 8), (-13, 0, 14), (-15, 0, 19)], 1.3)
            b.ellipsoid(clay, (8, 8, 5), (0, 0, 23), segments=10, body=None)
    elif kind in ("Bowl", "FruitBowl", "SoupPot"):
        r = {"Bowl": 9, "FruitBowl": 15, "SoupPot": 14}[kind]
        pot = "Iron" if kind == "SoupPot" else clay
        b.lathe(pot, [(0, 0), (r * 0.5, 0), (r, r * 0.7), (r * 0.94, r * 0.7), (r * 0.4, 1), (0, 1)])
        if kind == "FruitBowl":
            for i in range(7):
                a, rr = i * 2.4, 3.4 * math.sqrt(i)
                b.ellipsoid(
                    m.pick("Apple", "Orange", "Lemon", "Plum"),
                    (8, 8, 8),
                    (rr * math.cos(a), rr * math.sin(a), 5 + (3 if i < 3 else 0)),
                    segments=8,
                    body=None,
                )
        else:
            b.cylinder(m.pick("Orange", "Cheese", "PaleLeaf"), r * 0.8, 0.6, (0, 0, r * 0.5), segments=14, body=None)
    elif kind in ("Bottle", "SaltMill"):
        glass = m.pick("GreenBottle", "BrownBottle") if kind == "Bottle" else m.mat("wood")
        b.lathe(glass, [(0, 0), (3.8, 0), (3.8, 16), (1.4, 22), (1.4, 29), (0, 29)])
        b.cylinder("Paper", 3.95, 7, (0, 0, 5), segments=12, body=None)
    elif kind in ("Goblet", "WineGlass"):
        of = "Gold" if kind == "Goblet" else "Glass"
        b.lathe(of, [(0, 0), (4, 0), (0.8, 1), (0.8, 8), (4, 12), (3.8, 18), (3.4, 18), (3.5, 12), (0, 9)])
    elif kind == "Bread":
        b.ellipsoid("Bread", (26, 14, 12), (0, 0, -1))
        for i in range(3):
            b.box("Wax", (1.2, 9, 1), (-6 + 6 * i, 0, 10), (0, 20, 0), body=None)
    elif kind in ("CheeseBoard", "Pie", "Cake"):
        b.cylinder(m.mat("wood") if kind == "CheeseBoard" else clay, 16, 2, segments=18)
        b.cylinder({"CheeseBoard": "Cheese", "Pie": "Bread", "Cake": "PinkPaint"}[kind], 11, 7, (0, 0, 2), segments=18)
        for i in range(6):
            b.ellipsoid(
                "Tomato" if kind != "CheeseBoard" else "Plum",
                (3, 3, 3),
                (8 * math.cos(i * 1.05), 8 * math.sin(i * 1.05), 8.4),
                segments=6,
                body=None,
            )
    elif kind == "Candlestick":
        b.lathe("Brass", [(0, 0), (6, 0), (2, 3), (1.4, 12), (3, 14), (0, 14)])
        b.cylinder("Wax", 1.4, 14, (0, 0, 14), segments=8, body=None)
        b.ellipsoid("WarmGlow", (2, 2, 4), (0, 0, 28), segments=6, body=None)
    elif kind == "Toaster":
        b.box(m.mat("paint"), (28, 16, 18), bevel=3)
        for y in (-3, 3):
            b.box("BlackPaint", (20, 2, 0.5), (0, y, 18), body=None)
    else:
        b.box("RedPaint", (12, 12, 4))
        b.box("WhitePaint", (11, 11, 2), (0, 0, 4), body=None)


@family("decor")
def decor(m: KitMaker) -> None:
    """Vases, plants in pots, clocks, figures, boxes: on tables, shelves and floors."""
    kind = m.opt(
        "kind",
        m.pick(
            "Vase",
            "PottedPlant",
            "FlowerVase",
            "Clock",
            "Figurine",
            "JewelBox",
            "BookStack",
            "OpenBook",
            "Scroll",
            "Basket",
            "PictureFrame",
            "Hourglass" if m.style.old else "Radio",
        ),
    )
    clay = m.pick("Porcelain", "Terracotta", "BluePaint", "TealPaint", "Bronze", "Clay")
    m.say(
        kind, DECOR, f"{word(clay).capitalize()} {word(kind)} as decoration.", camel(clay), tags="decor small ornament"
    )
    b = m.b
    if kind in ("Vase", "FlowerVase"):
        b.lathe(clay, [(0, 0), (5, 0), (9, 10), (5, 22), (4, 26), (6, 29), (5, 29)])
        if kind == "FlowerVase":
            for i in range(8):
                a, r = i * 2.4, 3 + i
                b.tube("Leaf", [(0, 0, 26), (r * math.cos(a), r * math.sin(a), 42)], 0.5, segments=5)
                b.ellipsoid(
                    m.pick("RedPaint", "YellowPaint", "PinkPaint", "WhitePaint"),
                    (6, 6, 5),
                    (r * math.cos(a), r * math.sin(a), 41),
                    segments=7,
                    body=None,
                )
    elif kind == "PottedPlant":
        b.lathe(clay, [(0, 0), (7, 0), (10, 14), (9, 14), (0, 12)])
        for i in range(9):
            with b.moved((0, 0, 12), (0, 40 * i, 0)):
                b.box("Leaf", (22, 6, 0.8), (10, 0, 6 + 2 * (i % 3)), (35 + 8 * (i % 3), 0, 0), body=None)
    elif kind == "Clock":
        b.box(m.mat("wood"), (20, 9, 26), bevel=2)
        b.cylinder("WhitePaint", 7, 1, (0, 4.5, 15), (0, 0, 90), segments=16, body=None)
    elif kind == "Figurine":
        b.cylinder("BlackPaint", 6, 3, segments=12)
        b.lathe(clay, [(0, 0), (5, 0), (3.5, 10), (5, 16), (2, 20), (0, 20)], (0, 0, 3), squash=0.7)
        b.ellipsoid(clay, (5, 5, 6), (0, 0, 22), segments=8, body=None)
    elif kind == "JewelBox":
        b.box(m.mat("wood"), (24, 16, 10), bevel=1)
        b.box("Gold", (4, 1, 4), (0, 8, 5), body=None)
    elif kind == "BookStack":
        for i in range(4):
            b.box(
                m.pick("MaroonPaint", "NavyPaint", "GreenPaint", "CreamPaint", "BrownPaint"),
                (22 - i, 16, 4),
                (0, 0, 4 * i),
                (0, m.uni(-14, 14, 2), 0),
                body=None,
            )
        b.body_box((22, 17, 16))
    elif kind == "OpenBook":
        for s in (-1, 1):
            b.box("Paper", (15, 21, 2.5), (s * 7.5, 0, 0.6), (s * 4, 0, 0), body=None)
        b.box("MaroonPaint", (31, 22, 0.6), body=None)
        b.body_box((31, 22, 4))
    elif kind == "Scroll":
        b.cylinder("Paper", 3, 30, (-15, 0, 3), (-90, 0, 0), segments=12)
        b.box("RedPaint", (3, 6.4, 6.4), (0, 0, 0), body=None)
    elif kind == "Basket":
        b.lathe("Straw", [(0, 0), (11, 0), (15, 14), (13, 14), (10, 2), (0, 2)])
    elif kind == "PictureFrame":
        b.box(m.mat("wood"), (24, 3, 18), (0, 0, 0), (0, 0, -10))
        b.panel(m.pick("Landscape", "Sunset", "Seascape"), 20, 14, (0, 1.8, 2), (0, 0, -10))
    elif kind == "Hourglass":
        for z in (0, 20):
            b.cylinder(m.mat("wood"), 7, 2, (0, 0, z), segments=12)
        b.lathe("Sand", [(0, 2), (5, 3), (1, 11), (5, 19), (0, 20)])
    else:
        b.box(m.mat("wood"), (30, 11, 18), bevel=1.5)
        b.cylinder("BlackPaint", 6, 1, (-7, 5.4, 9), (0, 0, 90), segments=14, body=None)


@family("house-plant")
def house_plant(m: KitMaker) -> None:
    """A large plant in a pot on the floor."""
    kind, pot = (
        m.pick("Palm", "Fig", "Snake", "Fern"),
        m.pick("Terracotta", "WhitePaint", "GreyPaint", "BlackPaint", "TealPaint"),
    )
    m.say(
        f"{kind}Plant",
        "plants",
        f"{kind} plant in a {word(pot)} pot on the floor.",
        camel(pot),
        tags="plant pot indoor",
    )
    m.b.lathe(pot, [(0, 0), (16, 0), (21, 34), (18, 34), (0, 30)], segments=16)
    m.b.cylinder("Soil", 17, 1, (0, 0, 30), segments=14, body=None)
    if kind == "Fig":
        m.b.cylinder("Bark", 2.5, 70, (0, 0, 30), segments=7, body=None)
        for i in range(9):
            a = i * 2.4
            m.b.ellipsoid("Leaf", (34, 34, 26), (18 * math.cos(a), 18 * math.sin(a), 80 + 9 * i), segments=8, body=None)
    else:
        for i in range(12):
            with m.b.moved((0, 0, 32), (0, 30 * i, 0)):
                if kind == "Snake":
                    m.b.box("DarkLeaf", (6, 1.5, 60 + 6 * (i % 4)), (5 + 0.5 * i, 0, 0), (-8, 0, 0), body=None)
                else:
                    for x, z, p in ((8, 26, 70), (22, 58, 48), (42, 76, 6)):
                        m.b.box(
                            "Leaf",
                            (32, 8 if kind == "Palm" else 5, 1),
                            (x, 0, z * (1.1 if kind == "Palm" else 0.5)),
                            (p, 0, 0),
                            body=None,
                        )
    m.b.body_box((40, 40, 70))


@family("lamp")
def lamp(m: KitMaker) -> None:
    """A lamp: on a table, on the floor, a candelabrum, a lantern."""
    kind = m.opt(
        "kind",
        m.pick("Lantern", "Candelabrum", "OilLamp")
        if m.style.old
        else m.pick("TableLamp", "DeskLamp", "FloorLamp", "ArcLamp"),
    )
    metal, glow = m.mat("metal"), m.mat("glow")
    m.say(
        kind,
        LIGHTS,
        f"{word(metal).capitalize()} {word(kind)}, lit.",
        camel(metal),
        camel(m.mat("cloth")),
        tags="lamp light",
    )
    b = m.b
    if kind == "TableLamp":
        b.lathe(m.mat("paint"), [(0, 0), (8, 0), (9, 6), (4, 18), (1.5, 26), (0, 26)])
        b.cylinder("WarmGlow", 15, 20, (0, 0, 26), top=9, segments=16, body="hull")
    elif kind == "DeskLamp":
        b.cylinder(metal, 10, 2, segments=16)
        b.tube(metal, [(0, -4, 2), (0, -12, 26), (0, 8, 42)], 1)
        b.cylinder(metal, 9, 10, (0, 12, 34), top=3, segments=14, body=None)
        b.cylinder(glow, 6, 1, (0, 12, 33.4), segments=10, body=None)
        b.body_box((18, 24, 40))
    elif kind == "FloorLamp":
        b.cylinder(metal, 16, 3, segments=16)
        b.cylinder(metal, 1.6, 140, segments=8)
        b.cylinder("WarmGlow", 22, 28, (0, 0, 138), top=15, segments=16)
    elif kind == "ArcLamp":
        b.cylinder("Marble", 18, 6, segments=16)
        b.tube(metal, [(0, 0, 6), (0, 0, 130), (0, 30, 180), (0, 80, 190), (0, 110, 170)], 1.6)
        b.ellipsoid("WarmGlow", (34, 34, 22), (0, 110, 148), segments=14, body=None)
        b.body_box((10, 10, 180))
    elif kind == "Lantern":
        b.box(metal, (16, 16, 3))
        b.box(glow, (10, 10, 18), (0, 0, 3), body="box")
        for x in (-6, 6):
            for y in (-6, 6):
                b.box(metal, (1.5, 1.5, 18), (x, y, 3), body=None)
        b.cylinder(metal, 11, 8, (0, 0, 21), top=2, segments=4)
    elif kind == "OilLamp":
        b.lathe("Brass", [(0, 0), (6, 0), (3, 4), (7, 9), (5, 13), (0, 13)])
        b.ellipsoid(glow, (8, 8, 14), (0, 0, 12), segments=10, body="hull")
    else:
        b.cylinder(metal, 18, 4, segments=14)
        b.cylinder(metal, 2.2, 130, segments=8)
        for k in range(5):
            a = k * 1.2566
            px, py = 24 * math.cos(a), 24 * math.sin(a)
            b.tube(metal, [(0, 0, 110), (px, py, 118), (px, py, 130)], 1.2)
            b.cylinder("Wax", 2, 14, (px, py, 130), segments=8, body=None)
            b.ellipsoid("WarmGlow", (3, 3, 6), (px, py, 144), segments=6, body=None)
        b.body_box((44, 44, 40), (0, 0, 105))


@family("desk-thing")
def desk_thing(m: KitMaker) -> None:
    """What lies on desks today."""
    kind = m.opt(
        "kind",
        m.pick(
            "Monitor",
            "Laptop",
            "Keyboard",
            "Telephone",
            "PaperTray",
            "Mug",
            "PencilCup",
            "Printer",
            "Binders",
            "Notebook",
            "Microwave",
            "CoffeeMachine",
            "CashRegister",
        ),
    )
    paint = m.mat("paint")
    m.say(
        {"Mug": "CoffeeMug"}.get(kind, kind),
        DESK,
        f"{word(paint).capitalize()} {word(kind)} for a desk.",
        camel(paint),
        tags="desk office computer small",
    )
    b = m.b
    if kind == "Monitor":
        b.box("BlackPlastic", (22, 18, 1.5))
        b.box("BlackPlastic", (4, 3, 16), (0, -3, 1), body=None)
        b.box("BlackPlastic", (56, 3.4, 34), (0, 0, 12), bevel=0.6)
        b.panel("Screen", 53, 30, (0, 1.9, 14))
    elif kind == "Laptop":
        b.box("GreyPlastic", (34, 24, 2))
        b.box("BlackPlastic", (28, 10, 0.4), (0, -2, 2), body=None)
        with b.moved((0, -11, 2), (0, 0, 14)):
            b.box("GreyPlastic", (34, 1, 22), body="box")
            b.panel("Screen", 31, 19, (0, 0.7, 1.5))
    elif kind == "Keyboard":
        b.box(paint, (44, 14, 2), bevel=0.4)
        for i in range(4):
            b.box("GreyPlastic", (41, 2.4, 0.5), (0, -4.6 + 3.1 * i, 2), body=None)
    elif kind == "Telephone":
        b.box(paint, (20, 20, 5), bevel=1)
        b.box(paint, (5, 22, 4), (-6, 0, 5), bevel=1, body=None)
    elif kind == "PaperTray":
        for z in (0, 8, 16):
            b.box(paint, (24, 33, 1), (0, 0, z), body=None)
            b.box("Paper", (21, 30, 2), (0, 0, z + 1), body=None)
        b.body_box((24, 33, 19))
    elif kind in ("Mug", "PencilCup"):
        b.cylinder(paint, 4.4, 10, segments=14)
        if kind == "PencilCup":
            for i in range(5):
                b.tube(m.another("paint"), [(i - 2, 0, 4), (2 * (i - 2), 1, 18)], 0.5)
    elif kind == "Printer":
        b.box("WhitePlastic", (44, 38, 24), bevel=2)
        b.box("Paper", (22, 20, 1), (0, 16, 14), body=None)
        b.box("BlackPlastic", (30, 2, 6), (0, 19, 8), body=None)
    elif kind == "Binders":
        for i in range(5):
            b.box(m.another("paint"), (7, 26, 31), (-15 + 7.6 * i, 0, 0), body=None)
        b.body_box((38, 26, 31))
    elif kind == "Notebook":
        b.box(paint, (16, 22, 1.6))
        b.tube("BlackPaint", [(10, -6, 1.2), (11, 8, 1.2)], 0.5)
    elif kind == "Microwave":
        b.box("BlackPlastic", (50, 36, 28), bevel=1)
        b.box("WindowGlass", (30, 1, 18), (-6, 18, 5), body=None)
    elif kind == "CoffeeMachine":
        b.box(paint, (26, 32, 38), bevel=2)
        b.box("BlackPaint", (16, 2, 18), (0, 16, 6), body=None)
        b.cylinder("Glass", 5, 10, (0, 18, 2), segments=10, body=None)
    else:
        b.box("GreyPlastic", (36, 38, 12), bevel=1)
        b.box("GreyPlastic", (32, 10, 18), (0, -8, 12), (0, 0, -20), body=None)
        b.box("Screen", (22, 2, 12), (0, 0, 16), (0, 0, -20), body=None)
        b.body_box((34, 24, 30))


@family("package")
def package(m: KitMaker) -> None:
    """Goods of a shop shelf: tins, boxes, bottles, jars, rolls in a row."""
    kind, paint = (
        m.opt(
            "kind",
            m.pick(
                "CerealBoxes",
                "SoupTins",
                "SodaBottles",
                "JamJars",
                "PaintTins",
                "TeaBoxes",
                "Detergent",
                "ShoeBoxes",
                "Potions" if m.style.name == "fantasy" else "SpiceJars",
                "ToolBox",
            ),
        ),
        m.mat("paint"),
    )
    m.say(
        kind,
        "goods",
        f"{word(kind).capitalize()} in {word(paint)} for a shelf.",
        camel(paint),
        tags="goods package shop",
    )
    b = m.b
    w, d, h, n = {
        "CerealBoxes": (9, 20, 26, 4),
        "SoupTins": (9, 9, 11, 4),
        "SodaBottles": (8, 8, 26, 4),
        "JamJars": (8, 8, 11, 4),
        "PaintTins": (16, 16, 18, 2),
        "TeaBoxes": (12, 9, 9, 3),
        "Detergent": (14, 9, 24, 3),
        "ShoeBoxes": (34, 20, 12, 1),
        "Potions": (8, 8, 14, 4),
        "SpiceJars": (7, 7, 9, 5),
        "ToolBox": (40, 20, 16, 1),
    }[kind]
    for i in range(n):
        x = (i - (n - 1) / 2) * (w + 0.6)
        if kind in ("CerealBoxes", "TeaBoxes", "Detergent", "ShoeBoxes", "ToolBox"):
            b.box(paint, (w, d, h), (x, 0, 0), body=None)
            b.box("WhitePaint", (w * 0.7, 0.6, h * 0.4), (x, d / 2, h * 0.35), body=None)
            if kind == "ShoeBoxes":
                b.box("WhitePaint", (w - 1, d - 1, h), (x, 0, h), body=None)
            if kind == "ToolBox":
                b.box("BlackPaint", (16, 3, 4), (x, 0, h), body=None)
        elif kind in ("SodaBottles", "Potions"):
            r = w / 2
            b.lathe(
                paint if kind == "SodaBottles" else m.pick("CrystalBlue", "CrystalViolet", "NeonGreen"),
                [(0, 0), (r, 0), (r, h * 0.55), (r * 0.35, h * 0.8), (r * 0.35, h), (0, h)],
                (x, 0, 0),
                segments=12,
                body=None,
            )
            b.cylinder("WhitePaint", r * 1.02, h * 0.2, (x, 0, h * 0.2), segments=12, body=None)
        else:
            b.cylinder(paint, w / 2, h, (x, 0, 0), segments=12, body=None)
            b.cylinder(
                "WhitePaint" if kind != "PaintTins" else "SilverPaint",
                w / 2 + 0.2,
                h * 0.4,
                (x, 0, h * 0.3),
                segments=12,
                body=None,
            )
    b.body_box((n * (w + 0.6), d, h * (2 if kind == "ShoeBoxes" else 1)))


@family("board")
def board(m: KitMaker) -> None:
    """A standing board: whiteboard, blackboard, screen, painting on a stand, mirror, map."""
    kind = m.opt(
        "kind", m.pick("Whiteboard", "Blackboard", "PosterStand", "FloorMirror", "ProjectionScreen", "TimetableBoard")
    )
    w, h = {
        "Whiteboard": (180, 100),
        "Blackboard": (220, 110),
        "PosterStand": (90, 130),
        "FloorMirror": (60, 150),
        "ProjectionScreen": (240, 150),
        "TimetableBoard": (200, 90),
    }[kind]
    frame = m.mat("wood") if kind in ("Blackboard", "FloorMirror") else m.mat("metal")
    m.say(
        kind,
        "equipment",
        f"{word(kind).capitalize()} on a stand of {word(frame)}.",
        camel(frame),
        tags="board stand wall",
    )
    face = {
        "Whiteboard": "WhitePaint",
        "Blackboard": "DarkLeaf",
        "FloorMirror": "Mirror",
        "ProjectionScreen": "WhitePaint",
        "TimetableBoard": "TimetableScreen",
    }.get(kind) or m.pick("Landscape", "Sunset", "Seascape")
    low = 20 if kind in ("FloorMirror", "PosterStand") else 80
    for x in (-1, 1):
        m.b.box(frame, (4, 46, 4), (x * (w / 2 - 8), 0, 0))
        m.b.box(frame, (4, 4, low + h), (x * (w / 2 - 8), 0, 0))
    m.b.box(frame, (w, 5, h), (0, 0, low))
    m.b.panel(face, w - 8, h - 8, (0, 2.8, low + 4))
    m.b.panel(face, w - 8, h - 8, (0, -2.8, low + 4), (0, 180, 0))


@family("ceiling-lamp")
def ceiling_lamp(m: KitMaker) -> None:
    """A lamp on a stand-alone gallows: a tall lamp post of a hall with hanging shades."""
    metal, high = m.mat("metal"), m.opt("high", 270.0)
    kind = m.pick("Globe", "Cone", "Ring")
    m.say(
        f"{kind}HallLamp",
        LIGHTS,
        f"Tall {word(metal)} lamp of a hall with a {kind.lower()} shade, {high / 100:.1f} m.",
        camel(metal),
        tags="lamp light tall",
    )
    m.b.cylinder(metal, 22, 4, segments=16)
    m.b.cylinder(metal, 2.4, high - 20, segments=8)
    if kind == "Globe":
        m.b.ellipsoid("WarmGlow", (40, 40, 40), (0, 0, high - 30), segments=14)
    elif kind == "Cone":
        m.b.cylinder("WarmGlow", 32, 26, (0, 0, high - 30), top=12, segments=16)
    else:
        m.b.lathe(
            "WhiteGlow", [(34, 0), (40, 0), (40, 8), (34, 8), (34, 0)], (0, 0, high - 24), smooth=False, body=None
        )
        for k in range(3):
            m.b.tube(metal, [(0, 0, high - 20), (36 * math.cos(k * 2.1), 36 * math.sin(k * 2.1), high - 20)], 1)
