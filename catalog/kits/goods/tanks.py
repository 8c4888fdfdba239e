"""Tanks and pipes."""

from __future__ import annotations

from catalog.kits.goods.categories import MACHINES
from catalog.kits.maker import KitMaker, camel, family, word


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
