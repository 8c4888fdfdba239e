"""Crates, barrels and sacks; machines, pipes and tanks; tools of trades."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull

GOODS, MACHINES, TOOLS = "containers", "machines", "tools"


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


@family("crane")
def crane(m: KitMaker) -> None:
    """A tall crane: a harbour crane, a tower crane or a treadwheel crane."""
    kind = m.opt("kind", m.pick("HarbourCrane", "TowerCrane", "GantryCrane") if not m.style.old else "TreadwheelCrane")
    paint = m.opt("paint", m.pick("YellowPaint", "OrangePaint", "BluePaint", "RedPaint"))
    m.say(
        kind,
        MACHINES,
        f"{word(paint if kind != 'TreadwheelCrane' else 'Oak').capitalize()} {word(kind)}.",
        camel(paint),
        tags="crane machine lift",
    )
    b = m.b
    if kind == "HarbourCrane":
        for x in (-160, 160):
            for y in (-160, 160):
                b.box(paint, (34, 34, 500), (x, y, 0))
        b.box(paint, (380, 380, 50), (0, 0, 500))
        b.box(paint, (320, 240, 240), (-60, 0, 550))
        b.box("WindowGlass", (8, 180, 90), (101, 0, 660), body=None)
        b.box(paint, (1100, 40, 40), (420, 0, 1000), (38, 0, 0), body=None)
        b.tube("Iron", [(-120, 0, 790), (-60, 0, 1250), (800, 0, 1330)], 5)
        b.tube("Iron", [(845, 0, 1340), (845, 0, 500)], 3)
        b.box("Iron", (30, 20, 50), (845, 0, 450), body=None)
    elif kind == "TowerCrane":
        b.box("Concrete", (420, 420, 60))
        for x in (-60, 60):
            for y in (-60, 60):
                b.box(paint, (14, 14, 2600), (x, y, 60), body=None)
        for k in range(17):
            for y in (-60, 60):
                b.tube(paint, [(-60, y, 60 + 150 * k), (60, y, 210 + 150 * k)], 4)
                b.tube(paint, [(y, -60, 60 + 150 * k), (y, 60, 210 + 150 * k)], 4)
        b.body_box((134, 134, 2600), (0, 0, 60))
        b.box(paint, (2200, 60, 50), (700, 0, 2600), body=None)
        b.box("Concrete", (160, 140, 180), (-360, 0, 2460), body=None)
        b.box("WhitePaint", (110, 110, 140), (90, 80, 2450), body=None)
        b.tube("Iron", [(-350, 0, 2650), (0, 0, 2850), (1500, 0, 2650)], 4)
        b.tube("Iron", [(1200, 0, 2600), (1200, 0, 1500)], 3)
        b.box("Iron", (40, 30, 60), (1200, 0, 1450), body=None)
    elif kind == "GantryCrane":
        for y in (-700, 700):
            for x in (-200, 200):
                b.box(paint, (40, 40, 900), (x, y, 0))
            b.box(paint, (480, 40, 50), (0, y, 860), body=None)
        b.box(paint, (120, 1900, 90), (0, 0, 900))
        b.box("WhitePaint", (140, 160, 160), (0, 180, 740), body=None)
        b.tube("Iron", [(0, 0, 900), (0, 0, 520)], 4)
        b.box("Iron", (240, 60, 20), (0, 0, 500), body=None)
    else:
        for x in (-100, 100):
            b.box("Oak", (24, 24, 520), (x, 0, 0))
            b.cylinder("Oak", 150, 20, (x * 0.6, 0, 190), (-90, 0, 0), segments=20, body=None)
        b.box("Oak", (300, 300, 20))
        b.box("Oak", (240, 160, 20), (0, 0, 510))
        b.gable("Shingle", (200, 280, 100), (0, 0, 520), (0, 90, 0))
        b.box("Oak", (22, 520, 22), (0, 200, 560), (0, 0, 22), body=None)
        b.tube("Rope", [(0, 430, 650), (0, 430, 200)], 3)
        b.box("Pine", (60, 60, 50), (0, 430, 150), body=None)


@family("machine")
def machine(m: KitMaker) -> None:
    """A machine of a workshop or factory."""
    kind = m.opt(
        "kind",
        m.pick(
            "Lathe",
            "MillingMachine",
            "DrillPress",
            "Generator",
            "Compressor",
            "Boiler",
            "HydraulicPress",
            "RobotArm",
            "ConveyorBelt",
            "PackingMachine",
            "BandSaw",
            "GrindingMachine",
            "WaterPump",
            "CncMachine",
            "PrintingPress",
            "Loom",
        ),
    )
    paint = m.mat("paint")
    m.say(
        kind,
        MACHINES,
        f"{word(paint).capitalize()} {word(kind)} of a workshop.",
        camel(paint),
        tags="machine industry workshop",
    )
    b = m.b
    if kind == "Lathe":
        b.box(paint, (220, 70, 60), (0, 0, 20), bevel=3)
        for x in (-80, 80):
            b.box(paint, (50, 60, 20), (x, 0, 0))
        b.box(paint, (60, 60, 60), (-80, 0, 80), bevel=3)
        b.cylinder("Steel", 5, 130, (-50, 0, 106), (-90, 0, 0), segments=10, body=None)
        b.box("Steel", (40, 50, 24), (20, 6, 80))
        b.cylinder("SilverPaint", 16, 10, (-50, 0, 106), (-90, 0, 0), segments=14, body=None)
        b.cylinder("BlackPaint", 10, 3, (20, 36, 88), (0, 0, 90), segments=12, body=None)
    elif kind in ("MillingMachine", "DrillPress"):
        b.box(paint, (80, 90, 20), bevel=2)
        b.box(paint, (44, 50, 170), (0, -18, 20), bevel=4)
        b.box(paint, (50, 80, 44), (0, 10, 150), bevel=5)
        b.cylinder("Steel", 4, 36, (0, 32, 116), segments=8, body=None)
        b.box("Steel", (100 if kind == "MillingMachine" else 44, 40, 8), (0, 30, 78))
        for k in range(3):
            b.tube("BlackPaint", [(26, 20, 165), (34, 20 + 24 * math.cos(k * 2.1), 165 + 24 * math.sin(k * 2.1))], 2)
    elif kind == "Generator":
        b.box("Iron", (260, 100, 14))
        b.box(paint, (150, 90, 110), (-40, 0, 14), bevel=4)
        b.cylinder(m.another("paint"), 44, 80, (40, 0, 62), (-90, 0, 0), segments=18)
        b.cylinder("Iron", 7, 70, (-80, 0, 124), segments=10, body=None)
        for i in range(5):
            b.box("BlackPaint", (80, 2, 5), (-40, 45, 50 + 12 * i), body=None)
    elif kind == "Compressor":
        b.cylinder(paint, 34, 160, (-80, 0, 60), (-90, 0, 0), segments=18)
        for x in (-60, 60):
            b.box("Iron", (10, 50, 30), (x, 0, 0))
        b.box("Iron", (60, 50, 44), (-10, 0, 92), bevel=4)
        b.cylinder("BlackPaint", 22, 8, (30, 20, 116), (0, 0, 90), segments=16, body=None)
    elif kind == "Boiler":
        b.cylinder(paint, 70, 220, (0, 0, 20), segments=24)
        b.ellipsoid(paint, (140, 140, 60), (0, 0, 210), body=None)
        b.cylinder("Copper", 12, 120, (0, 0, 240), segments=12, body=None)
        b.box("Iron", (50, 8, 40), (0, 68, 60), body=None)
        for s in (-1, 1):
            b.cylinder("WhitePaint", 11, 4, (s * 24, 69, 160), (0, 0, 90), segments=14, body=None)
        b.cylinder("Iron", 60, 20, segments=16)
    elif kind == "HydraulicPress":
        for x in (-55, 55):
            b.box(paint, (24, 60, 220), (x, 0, 0))
        b.box(paint, (150, 80, 60), (0, 0, 190), bevel=4)
        b.box(paint, (140, 80, 60))
        b.cylinder("Steel", 14, 60, (0, 0, 130), segments=12, body=None)
        b.box("Steel", (70, 56, 12), (0, 0, 120))
    elif kind == "RobotArm":
        b.cylinder("Iron", 40, 30, segments=18)
        b.cylinder(paint, 28, 50, (0, 0, 30), segments=16)
        b.box(paint, (28, 30, 110), (0, 0, 70), (0, 0, -18))
        b.box(paint, (24, 110, 24), (0, 60, 166), (0, 0, -10), body="box")
        b.cylinder("Iron", 8, 30, (0, 118, 136), segments=10, body=None)
    elif kind == "ConveyorBelt":
        b.box(paint, (300, 70, 12), (0, 0, 70))
        b.box("Rubber", (296, 56, 4), (0, 0, 82))
        for x in (-120, 0, 120):
            for y in (-30, 30):
                b.box("Iron", (7, 7, 70), (x, y, 0))
        m.top(86, 270, 40)
    elif kind in ("BandSaw", "GrindingMachine"):
        b.box(paint, (70, 60, 80), bevel=3)
        b.box("Steel", (90, 70, 5), (0, 0, 80))
        if kind == "BandSaw":
            b.box(paint, (60, 30, 60), (-8, 0, 140), bevel=10)
            b.box(paint, (14, 26, 70), (-32, 0, 85))
            b.box("Steel", (1, 3, 60), (14, 0, 85), body=None)
        else:
            b.cylinder("GreyPaint", 22, 60, (-30, 0, 108), (-90, 0, 0), segments=14)
            for x in (-40, 34):
                b.cylinder("Cinder", 19, 8, (x, 0, 108), (-90, 0, 0), segments=16, body=None)
    elif kind == "WaterPump":
        b.box("Concrete", (160, 70, 16))
        b.cylinder(paint, 28, 80, (-70, 0, 50), (-90, 0, 0), segments=16)
        b.cylinder(paint, 32, 24, (30, 0, 52), (-90, 0, 0), segments=18)
        b.cylinder("Steel", 10, 60, (42, 0, 60), segments=12, body=None)
    elif kind == "PrintingPress":
        b.box(m.mat("wood"), (90, 160, 14), (0, 0, 66))
        for x in (-46, 46):
            b.box(m.mat("wood"), (16, 20, 200), (x, 0, 0))
        b.box(m.mat("wood"), (110, 26, 20), (0, 0, 180))
        b.cylinder("Iron", 8, 70, (0, 0, 112), segments=10, body=None)
        b.box("Iron", (70, 60, 8), (0, 0, 104))
        b.tube("Oak", [(0, 0, 140), (0, 90, 146)], 3)
    elif kind == "Loom":
        for x in (-70, 70):
            for y in (-70, 70):
                b.box(m.mat("wood"), (10, 10, 160), (x, y, 0))
            b.box(m.mat("wood"), (10, 150, 8), (x, 0, 150), body=None)
        b.box(m.mat("cloth"), (120, 60, 3), (0, 40, 80), body="box")
        b.box("Linen", (120, 80, 1), (0, -30, 86), (0, 0, 8), body=None)
        b.cylinder(m.mat("wood"), 8, 140, (-70, -70, 90), (-90, 0, 0), segments=10)
    else:
        b.box(paint, (200, 120, 180), bevel=4)
        b.box("WindowGlass", (90, 4, 70), (-30, 59, 80), body=None)
        b.box("Screen", (34, 6, 26), (66, 60, 116), body=None)
        b.box("GreyPaint", (44, 10, 60), (66, 56, 84), body=None)
        b.cylinder("RedGlow", 5, 12, (80, 40, 180), segments=8, body=None)
        b.box("BlackPaint", (200, 122, 10), body=None)


@family("tank")
def tank(m: KitMaker) -> None:
    """A storage tank, a silo or a factory chimney."""
    kind = m.opt(
        "kind",
        m.pick(
            "StorageTank", "GrainSilo", "FactoryChimney", "GasHolder", "CoolingTower", "HorizontalTank", "TankOnLegs"
        ),
    )
    paint, h, r = m.mat("paint"), m.uni(600, 1200, 50), m.uni(180, 320, 20)
    wall = "RedBrick" if kind == "FactoryChimney" else "Concrete" if kind == "CoolingTower" else paint
    m.say(
        kind,
        MACHINES,
        f"{word(wall).capitalize()} {word(kind)} of a works.",
        camel(wall),
        "Tall" if h > 900 else "Low",
        tags="tank industry storage",
    )
    b = m.b
    if kind == "FactoryChimney":
        b.box("RedBrick", (300, 300, 300))
        b.cylinder("RedBrick", 110, 2000, (0, 0, 300), top=70, segments=18)
        for z in (900, 1600, 2260):
            b.cylinder("WhitePaint", 104 - z * 0.013, 40, (0, 0, z), segments=18, body=None)
    elif kind == "CoolingTower":
        b.lathe(
            "Concrete", [(0, 0), (900, 0), (680, 600), (560, 1100), (600, 1500), (560, 1500), (0, 1420)], segments=28
        )
    elif kind == "HorizontalTank":
        b.cylinder(paint, r * 0.6, 800, (-400, 0, r * 0.6 + 60), (-90, 0, 0), segments=22)
        for x in (-260, 260):
            b.box("Concrete", (60, r * 1.1, 90), (x, 0, 0))
    elif kind == "TankOnLegs":
        for x in (-1, 1):
            for y in (-1, 1):
                b.tube("Iron", [(x * 190, y * 190, 0), (x * 140, y * 140, 900)], 12)
        b.body_box((400, 400, 900))
        b.cylinder(paint, 240, 340, (0, 0, 900), segments=22)
        b.cylinder(paint, 250, 110, (0, 0, 1240), top=10, segments=22)
    else:
        b.cylinder(paint, r, h, segments=24)
        if kind == "GrainSilo":
            b.cylinder("SilverPaint", r + 8, r * 0.6, (0, 0, h), top=20, segments=24)
        else:
            b.ellipsoid(paint, (2 * r, 2 * r, r * 0.5), (0, 0, h - r * 0.25))
        for i in range(int(h // 150)):
            b.cylinder("GreyPaint", r + 2, 6, (0, 0, 140 + 150 * i), segments=24, body=None)
        for s in (-16, 16):
            b.box("Iron", (4, 5, h), (s, r + 10, 0), body=None)
        for i in range(int(h // 40)):
            b.box("Iron", (34, 3, 3), (0, r + 10, 30 + 40 * i), body=None)


@family("pipe")
def pipe(m: KitMaker) -> None:
    """Pipes on stands along X, or an elbow, a valve."""
    kind = m.opt("kind", m.pick("PipeRack", "PipeStraight", "PipeValve", "PipeStack", "PipeBend"))
    paint = m.opt("paint", m.pick("GreenPaint", "YellowPaint", "SilverPaint", "RedPaint", "BluePaint", "Copper"))
    m.say(kind, MACHINES, f"{word(paint).capitalize()} {word(kind)}.", camel(paint), tags="pipe industry")
    b = m.b
    if kind == "PipeRack":
        for x in (-230, 0, 230):
            b.box("Iron", (12, 12, 300), (x, -80, 0))
            b.box("Iron", (12, 12, 300), (x, 80, 0))
            b.box("Iron", (14, 190, 12), (x, 0, 200))
            b.box("Iron", (14, 190, 12), (x, 0, 288))
        for i, z in ((0, 212), (1, 212), (2, 212), (0, 300), (1, 300)):
            b.cylinder(
                m.pick(paint, "SilverPaint", "Copper"),
                20,
                500,
                (-250, -56 + 56 * i, z + 20),
                (-90, 0, 0),
                segments=14,
                body=None,
            )
        b.body_box((500, 160, 130), (0, 0, 205))
    elif kind == "PipeStack":
        for row in range(3):
            for i in range(4 - row):
                b.cylinder(
                    paint, 24, 400, (-200, (i - (3 - row) / 2) * 49, 24 + 42 * row), (-90, 0, 0), segments=14, body=None
                )
        b.body_box((400, 190, 44))
        b.body_box((400, 90, 84), (0, 0, 44))
    else:
        z = 60
        b.cylinder(paint, 22, 300, (-150, 0, z), (-90, 0, 0), segments=16)
        for x in (-110, 110):
            b.box("Concrete", (30, 60, 40), (x, 0, 0))
            b.cylinder(paint, 30, 8, (x * 1.33, 0, z), (-90, 0, 0), segments=16, body=None)
        if kind == "PipeValve":
            b.box("Iron", (50, 50, 56), (0, 0, z - 28))
            b.cylinder("Iron", 5, 40, (0, 0, z + 24), segments=8, body=None)
            b.cylinder("RedPaint", 30, 5, (0, 0, z + 60), segments=16, body=None)
        elif kind == "PipeBend":
            b.cylinder(paint, 22, 200, (150, 0, z - 22), segments=16)
            b.cylinder(paint, 22, 30, (150, 0, 0), top=26, segments=16)


@family("forge")
def forge(m: KitMaker) -> None:
    """What a smith, a cooper, a potter or a carpenter works with."""
    kind = m.opt(
        "kind",
        m.pick(
            "Anvil",
            "ForgeHearth",
            "Bellows",
            "Grindstone",
            "PotterWheel",
            "Sawhorse",
            "CopperStill",
            "Kiln",
            "Cauldron",
            "BreadOven",
            "WinePress",
        ),
    )
    m.say(
        kind,
        TOOLS,
        f"{word(kind).capitalize()} of a craftsman.",
        m.pick("Old", "Heavy"),
        "Worn",
        tags="craft tool workshop",
    )
    b, wood, stone = m.b, m.mat("wood"), m.mat("stone")
    if kind == "Anvil":
        b.cylinder(wood, 26, 50, top=24, segments=12)
        b.box("Iron", (24, 18, 14), (0, 0, 50))
        b.box("Iron", (50, 16, 12), (4, 0, 64))
        b.cylinder("Iron", 7, 24, (-20, 0, 70), (90, 0, 0), top=1, segments=10, body=None)
    elif kind in ("ForgeHearth", "BreadOven", "Kiln"):
        b.box(stone, (170, 130, 85))
        if kind == "ForgeHearth":
            b.box("Ember", (90, 70, 5), (0, 10, 84), body=None)
            b.box("Cinder", (120, 90, 3), (0, 10, 83), body=None)
            b.add(
                "DarkStone",
                hull(
                    [
                        (x, y, z)
                        for x, y, z in (
                            (-85.0, -65.0, 150.0),
                            (85.0, -65.0, 150.0),
                            (85.0, 65.0, 150.0),
                            (-85.0, 65.0, 150.0),
                            (-30.0, -40.0, 250.0),
                            (30.0, -40.0, 250.0),
                            (30.0, 10.0, 250.0),
                            (-30.0, 10.0, 250.0),
                        )
                    ]
                ),
            )
            b.box("DarkStone", (60, 50, 160), (0, -15, 250), body="box")
            for x in (-80, 80):
                b.box(stone, (14, 20, 65), (x, -55, 85))
        else:
            b.ellipsoid("Clay", (170, 130, 130), (0, 0, 40), body="hull")
            b.box("Ember", (46, 8, 30), (0, 62, 90), body=None)
            b.cylinder("Clay", 14, 80, (0, -30, 150), segments=10, body=None)
    elif kind == "Bellows":
        b.box(wood, (120, 50, 6), (0, 0, 60))
        b.add(
            "BrownLeather",
            hull(
                [(-60.0, y, 66.0) for y in (-25.0, 25.0)]
                + [(60.0, y, 66.0) for y in (-8.0, 8.0)]
                + [(-60.0, y, 100.0) for y in (-25.0, 25.0)]
            ),
        )
        for x in (-50, 40):
            b.box(wood, (10, 40, 60), (x, 0, 0))
    elif kind in ("Grindstone", "PotterWheel"):
        for x in (-24, 24):
            b.box(wood, (8, 50, 60), (x, 0, 0))
        if kind == "Grindstone":
            b.cylinder("Granite", 34, 12, (-6, 0, 62), (-90, 0, 0), segments=20)
        else:
            b.box(wood, (70, 60, 6), (0, 0, 60))
            b.cylinder("Terracotta", 20, 4, (0, 0, 66), segments=16)
            b.lathe("Clay", [(0, 0), (10, 0), (14, 14), (9, 26), (11, 28)], (0, 0, 70), body=None)
    elif kind == "Sawhorse":
        for x in (-50, 50):
            for y in (-1, 1):
                b.tube(wood, [(x, y * 28, 0), (x, y * 4, 72)], 3.5)
        b.box(wood, (140, 12, 10), (0, 0, 70))
        b.body_box((110, 50, 30))
    elif kind == "CopperStill":
        b.cylinder(stone, 50, 40, segments=16)
        b.lathe("Copper", [(0, 0), (44, 0), (52, 40), (40, 80), (14, 104), (12, 130), (0, 132)], (0, 0, 40))
        b.tube("Copper", [(0, 0, 164), (40, 0, 178), (84, 0, 120), (88, 0, 60)], 5)
        b.cylinder("Oak", 26, 60, (92, 0, 0), segments=12)
    elif kind == "Cauldron":
        for k in range(3):
            b.tube("Iron", [(50 * math.cos(k * 2.1), 50 * math.sin(k * 2.1), 0), (0, 0, 120)], 2.5)
        b.lathe("Iron", [(0, 20), (26, 26), (34, 50), (28, 66), (32, 70), (26, 70)])
        b.body_box((56, 56, 30))
        b.cylinder("PaleLeaf", 26, 2, (0, 0, 62), segments=16, body=None)
        for k in range(5):
            b.cylinder("Bark", 5, 34, (0, 0, 5), (80, 72 * k, 0), segments=7, body=None)
        b.ellipsoid("Ember", (24, 24, 12), segments=8, body=None)
    else:
        b.cylinder(wood, 50, 60, (0, 0, 20), segments=16)
        for x in (-60, 60):
            b.box(wood, (14, 20, 190), (x, 0, 0))
        b.box(wood, (140, 24, 20), (0, 0, 170))
        b.cylinder("Iron", 6, 90, (0, 0, 90), segments=8, body=None)
        b.box(wood, (80, 10, 8), (0, 0, 150), body=None)


@family("works")
def works(m: KitMaker) -> None:
    """Things of a building site."""
    kind = m.opt(
        "kind",
        m.pick(
            "TrafficCone",
            "SandHeap",
            "GravelHeap",
            "Scaffold",
            "CementMixer",
            "BrickStack",
            "PlankStack",
            "Barrier",
            "Wheelbarrow",
            "Ladder",
            "CableDrum",
            "PortableToilet",
            "SteelBeams",
        ),
    )
    m.say(
        kind,
        TOOLS,
        f"{word(kind).capitalize()} of a building site.",
        m.pick("", "Yard"),
        m.pick("Orange", "Grey"),
        tags="building site construction",
    )
    b = m.b
    if kind == "TrafficCone":
        b.box("BlackPaint", (36, 36, 4))
        b.cylinder("OrangePaint", 14, 60, (0, 0, 4), top=3, segments=14)
        b.cylinder("WhitePaint", 10.6, 10, (0, 0, 26), top=8.7, segments=14, body=None)
    elif kind.endswith("Heap"):
        b.lathe(
            "Sand" if kind == "SandHeap" else "Gravel", [(0, 0), (170, 0), (120, 50), (50, 100), (0, 116)], squash=0.8
        )
    elif kind == "Scaffold":
        for x in (-120, 0, 120):
            for y in (-45, 45):
                b.cylinder("Steel", 3, 400, (x, y, 0), segments=8)
        for z in (195, 390):
            b.box("Planks", (250, 90, 5), (0, 0, z))
            for y in (-45, 45):
                b.tube("Steel", [(-125, y, z - 50), (125, y, z - 50)], 2.5)
        b.tube("Steel", [(-120, 45, 0), (0, 45, 195)], 2.5)
        b.tube("Steel", [(120, 45, 195), (0, 45, 390)], 2.5)
    elif kind == "CementMixer":
        b.lathe("OrangePaint", [(0, 0), (30, 4), (40, 40), (24, 80), (20, 80)], (0, -10, 70), (0, 0, 50))
        for x in (-40, 40):
            b.tube("Iron", [(x, -40, 0), (x * 0.8, 0, 90), (x, 40, 0)], 4)
            b.cylinder("Rubber", 20, 8, (x * 1.2 - 4, -40, 20), (-90, 0, 0), segments=14, body=None)
        b.body_box((100, 100, 90))
    elif kind == "BrickStack":
        for layer in range(5):
            b.box("RedBrick", (100 - 4 * (layer % 2), 60 - 3 * (layer % 2), 13.5), (0, 0, 14 * layer), body=None)
        b.body_box((100, 60, 69.5))
        m.top(69.5, 80, 46)
    elif kind in ("PlankStack", "SteelBeams"):
        of = "Pine" if kind == "PlankStack" else "Rust"
        for x in (-130, 130):
            b.box("DarkOak", (12, 90, 10), (x, 0, 0))
        for layer in range(4):
            for i in range(4):
                b.box(of, (380 - 10 * ((layer + i) % 3), 19, 9), (0, -33 + 22 * i, 10 + 10 * layer), body=None)
        b.body_box((380, 88, 40), (0, 0, 10))
        m.top(50, 300, 60)
    elif kind == "Barrier":
        for x in (-80, 80):
            b.box("WhitePaint", (8, 50, 8), (x, 0, 0))
            b.box("WhitePaint", (8, 8, 100), (x, 0, 0))
        for i in range(6):
            b.box("RedPaint" if i % 2 else "WhitePaint", (32, 5, 24), (-80 + 32 * i, 4, 74), body=None)
        b.body_box((180, 10, 26), (0, 2, 74))
    elif kind == "Wheelbarrow":
        b.add(
            "GreenPaint",
            hull(
                [
                    (x, y, z)
                    for x, y, z in (
                        (-30.0, -22.0, 30.0),
                        (-30.0, 22.0, 30.0),
                        (20.0, -16.0, 30.0),
                        (20.0, 16.0, 30.0),
                        (-44.0, -32.0, 62.0),
                        (-44.0, 32.0, 62.0),
                        (48.0, -28.0, 62.0),
                        (48.0, 28.0, 62.0),
                    )
                ]
            ),
        )
        b.cylinder("Rubber", 18, 8, (52, -4, 18), (0, 0, 90), segments=14)
        for y in (-22, 22):
            b.tube("Pine", [(52, y * 0.2, 18), (-30, y, 30), (-90, y * 1.2, 56)], 2.2)
            b.box("Iron", (4, 4, 30), (-28, y, 0))
        b.ellipsoid("Soil", (80, 52, 20), (0, 0, 52), body=None)
    elif kind == "Ladder":
        for y in (-22, 22):
            b.tube("Pine", [(0, y, 0), (0, y, 300)], 2.5)
        for i in range(9):
            b.tube("Pine", [(0, -22, 30 + 30 * i), (0, 22, 30 + 30 * i)], 1.6)
        for y in (-22, 22):
            b.tube("Pine", [(-80, y, 0), (0, y, 290)], 2.2)
        b.body_box((84, 48, 40), (-38, 0, 0))
        b.body_box((10, 48, 300))
    elif kind == "CableDrum":
        for y in (-46, 38):
            b.cylinder("Pine", 70, 8, (0, y, 70), (0, 0, 90), segments=22)
        b.cylinder("BlackPaint", 48, 80, (0, -40, 70), (0, 0, 90), segments=20)
    else:
        b.box("TealPaint", (110, 110, 220), bevel=4)
        b.box("WhitePaint", (120, 120, 14), (0, 0, 218), bevel=6)
        b.box("SkyPaint", (80, 4, 190), (0, 55, 14), body=None)
