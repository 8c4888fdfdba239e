"""Furniture of streets: lamps, benches, bins, signs, shelters."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.outdoors.categories import STREET


@family("streetlamp")
def streetlamp(m: KitMaker) -> None:
    """A lamp on a post."""
    metal, kind = m.mat("metal"), m.opt("kind", m.pick("Lantern", "Globe", "Arm", "Twin"))
    height = m.uni(320, 480, 20)
    m.say(
        "LampPost",
        STREET,
        f"{word(metal).capitalize()} lamp post with {kind.lower()} head, {height / 100:.1f} m high.",
        kind,
        camel(metal),
        tags="lamp light street",
    )
    m.b.cylinder(metal, 16, 40, top=9, segments=12, body=None)
    m.b.cylinder(metal, 6, height, segments=10)
    if kind == "Globe":
        m.b.ellipsoid(m.mat("glow"), (42, 42, 42), (0, 0, height - 5), segments=14, body=None)
    elif kind in ("Arm", "Twin"):
        for side in (1, -1) if kind == "Twin" else (1,):
            m.b.tube(metal, [(0, 0, height - 20), (0, side * 60, height + 10), (0, side * 110, height)], 4)
            m.b.box(metal, (26, 60, 10), (0, side * 120, height - 8), body=None)
            m.b.box(m.mat("glow"), (18, 46, 4), (0, side * 120, height - 11), body=None)
    else:
        m.b.cylinder(m.mat("glow"), 13, 40, (0, 0, height), top=18, segments=6, body=None)
        m.b.cylinder(metal, 24, 18, (0, 0, height + 40), top=3, segments=6, body=None)


@family("bench")
def bench(m: KitMaker) -> None:
    """A bench for two or three."""
    wood, metal = m.mat("wood"), m.mat("metal")
    long_, back = m.uni(140, 200, 10), m.opt("back", m.chance(0.7))
    kind = m.opt("kind", m.pick("Park", "Garden", "Slatted") if back else m.pick("Backless", "Plain"))
    m.say(
        "Bench",
        STREET,
        f"{word(wood).capitalize()} bench on {word(metal)} legs{' with a back' if back else ''}, "
        f"{long_ / 100:.1f} m long.",
        kind,
        camel(wood),
        tags="bench seat",
    )
    for i in range(4):
        m.b.box(wood, (long_, 9, 4), (0, -15 + 11 * i, 42), body=None)
    for x in (-1, 1):
        m.b.box(metal, (6, 42, 42), (x * (long_ / 2 - 18), 0, 0), body=None)
    m.b.body_box((long_, 44, 46))
    m.top(46, long_ - 10, 36)
    if back:
        for z in (54, 68, 82):
            m.b.box(wood, (long_, 3, 10), (0, -21 - (z - 54) * 0.15, z), body=None)
        for x in (-1, 1):
            m.b.box(metal, (6, 5, 52), (x * (long_ / 2 - 18), -22, 42), (0, 0, -6), body=None)
        m.b.body_box((long_, 8, 48), (0, -23, 46))


@family("bin")
def bin_(m: KitMaker) -> None:
    """A litter bin."""
    paint, round_ = m.mat("paint"), m.chance(0.6)
    m.say(
        m.pick("LitterBin", "WasteBin", "RecyclingBin"),
        STREET,
        f"{word(paint).capitalize()} {'round' if round_ else 'square'} litter bin, 0.9 m high.",
        camel(paint),
        tags="bin trash waste",
    )
    if round_:
        m.b.cylinder(paint, 26, 80, top=29, segments=16)
        m.b.cylinder("Iron", 30, 12, (0, 0, 80), top=20, segments=16, body=None)
    else:
        m.b.box(paint, (52, 46, 86), bevel=2)
        m.b.box("BlackPaint", (36, 4, 14), (0, 23, 62), body=None)
        m.b.box("Iron", (56, 50, 6), (0, 0, 86), body=None)


@family("bollard")
def bollard(m: KitMaker) -> None:
    """A bollard."""
    metal = m.opt("stone", m.pick(m.mat("metal"), m.mat("stone")))
    m.say("Bollard", STREET, f"{word(metal).capitalize()} bollard, 0.9 m high.", camel(metal), tags="bollard post")
    m.b.lathe(metal, [(0, 0), (16, 0), (14, 8), (10, 14), (10, 70), (15, 76), (12, 88), (0, 94)], segments=12)


@family("sign")
def sign(m: KitMaker) -> None:
    """A sign on a post."""
    paint = m.mat("paint")
    kind = m.opt(
        "kind",
        m.pick("DirectionSign", "InfoSign", "NoticeBoard", "ParkingSign", "StopSign", "StreetNameSign", "WarningSign"),
    )
    m.say(kind, STREET, f"{word(paint).capitalize()} {word(kind)} on a post.", camel(paint), tags="sign board post")
    m.b.cylinder(m.mat("metal"), 4, 230, segments=8)
    if kind in ("DirectionSign", "StreetNameSign"):
        for i, yaw in enumerate((0, 70, 150)):
            m.b.box(paint if i != 1 else m.another("paint"), (90, 4, 18), (0, 0, 170 + 22 * i), (0, yaw, 0), body=None)
    elif kind == "NoticeBoard":
        m.b.box(m.mat("wood"), (130, 8, 90), (0, 0, 110), body="box")
        m.b.box("Paper", (110, 2, 72), (0, 5, 118), body=None)
        m.b.box(m.mat("roof"), (146, 30, 8), (0, 0, 204), body=None)
    elif kind in ("StopSign", "WarningSign"):
        m.b.cylinder(paint, 36, 3, (0, 4, 200), (0, 0, 90), segments=8 if kind == "StopSign" else 3, body=None)
        m.b.box("WhitePaint", (40, 2, 10), (0, 7, 196), body=None)
    else:
        m.b.box(paint, (60, 4, 60), (0, 3, 165), body=None)
        m.b.box("WhitePaint", (24, 2, 34), (0, 6, 178), body=None)


@family("bike-rack")
def bike_rack(m: KitMaker) -> None:
    """Hoops for bicycles."""
    metal = m.mat("metal")
    m.say(
        "BicycleRack",
        STREET,
        f"Rack of five {word(metal)} hoops for bicycles, 2.6 m long.",
        camel(metal),
        tags="bicycle rack stand",
    )
    for i in range(5):
        x = -110 + 55 * i
        m.b.tube(metal, [(x, -30, 0), (x, -30, 60), (x, -15, 78), (x, 15, 78), (x, 30, 60), (x, 30, 0)], 2.5)
    m.b.box(metal, (240, 5, 4), (0, -30, 0), body=None)
    m.b.body_box((236, 66, 80))


@family("hydrant")
def hydrant(m: KitMaker) -> None:
    """A hydrant or a post box."""
    kind = m.opt("kind", m.pick("Hydrant", "PostBox", "ParkingMeter", "PhoneBooth", "ElectricBox"))
    paint = m.opt("paint", m.pick("RedPaint", "YellowPaint", "BluePaint", "GreenPaint"))
    m.say(kind, STREET, f"{word(paint).capitalize()} {word(kind)} of a street.", camel(paint), tags="street small")
    if kind == "Hydrant":
        m.b.lathe(paint, [(0, 0), (18, 0), (18, 6), (12, 8), (12, 55), (15, 58), (10, 72), (0, 78)])
        m.b.cylinder(paint, 6, 38, (-19, 0, 42), (-90, 0, 0), segments=10, body=None)
    elif kind == "PostBox":
        m.b.cylinder(paint, 24, 120, segments=18)
        m.b.lathe(paint, [(27, 0), (26, 8), (0, 18)], (0, 0, 120), body=None)
        m.b.box("BlackPaint", (26, 6, 5), (0, 23, 100), body=None)
    elif kind == "PhoneBooth":
        m.b.box(paint, (92, 92, 12))
        m.b.box("WindowGlass", (80, 80, 190), (0, 0, 12), body="box")
        for x in (-1, 1):
            for y in (-1, 1):
                m.b.box(paint, (10, 10, 200), (x * 40, y * 40, 12), body=None)
        for z in (60, 110, 160):
            m.b.box(paint, (90, 90, 4), (0, 0, z), body=None)
        m.b.box(paint, (94, 94, 30), (0, 0, 205), bevel=8)
    elif kind == "ParkingMeter":
        m.b.cylinder("Iron", 4, 110, segments=8)
        m.b.box(paint, (20, 14, 34), (0, 0, 108), bevel=5)
    else:
        m.b.box(paint, (90, 40, 110), bevel=1)
        m.b.box("BlackPaint", (2, 4, 100), (0, 19, 5), body=None)


@family("bus-shelter")
def bus_shelter(m: KitMaker) -> None:
    """A glass shelter with a bench."""
    metal = m.mat("metal")
    m.say(
        "BusShelter",
        STREET,
        f"Glass bus shelter on {word(metal)} posts with a bench, 4 m wide.",
        camel(metal),
        tags="bus stop shelter",
    )
    for x in (-195, 195):
        for y in (-60, 60):
            m.b.box(metal, (9, 9, 240), (x, y, 0))
    m.b.box("Glass", (385, 3, 190), (0, -62, 30))
    for x in (-196, 196):
        m.b.box("Glass", (3, 110, 190), (x, 0, 30), body=None)
    m.b.box(metal, (420, 160, 10), (0, 0, 240))
    m.b.box(m.mat("wood"), (260, 36, 5), (-40, -36, 44))
    m.b.box(metal, (240, 6, 44), (-40, -36, 0), body=None)
    m.b.box("TimetableScreen", (60, 4, 90), (140, -58, 100), body=None)


@family("planter")
def planter(m: KitMaker) -> None:
    """A box or pot with plants outdoors."""
    stone, flower = (
        m.opt("stone", m.pick("Terracotta", m.mat("stone"), m.mat("wood"))),
        m.pick("RedPaint", "PinkPaint", "YellowPaint", "VioletPaint", "WhitePaint"),
    )
    long_ = m.chance(0.5)
    m.say(
        "FlowerPlanter",
        STREET,
        f"{word(stone).capitalize()} planter with {word(flower)} flowers.",
        camel(flower),
        camel(stone),
        tags="planter flowers plant",
    )
    if long_:
        m.b.box(stone, (130, 48, 46), bevel=2)
        m.b.box("Soil", (120, 40, 3), (0, 0, 45), body=None)
    else:
        m.b.lathe(stone, [(0, 0), (24, 0), (38, 46), (40, 50), (34, 50)], segments=18)
    for i in range(10):
        x, y = (-54 + 12 * i, m.uni(-14, 14, 1)) if long_ else (22 * math.cos(i * 2.4), 22 * math.sin(i * 2.4))
        m.b.ellipsoid(m.mat("leaf"), (26, 26, 28), (x, y, 42), segments=8, body=None)
        m.b.ellipsoid(flower, (11, 11, 9), (x + 3, y, 66 + (i % 3) * 4), segments=6, body=None)


@family("traffic-light")
def traffic_light(m: KitMaker) -> None:
    """A set of traffic lights on a post."""
    m.say(
        "TrafficSignal",
        STREET,
        "Traffic signal with red, yellow and green lamps, 3.2 m high.",
        m.pick("Black", "Yellow"),
        tags="traffic signal lamp",
    )
    m.b.cylinder("Iron", 7, 310, segments=10)
    m.b.box("BlackPaint", (34, 26, 92), (0, 14, 225))
    for i, glow in enumerate(("GreenGlow", "YellowPaint", "RedGlow")):
        m.b.cylinder(glow, 10, 3, (0, 27, 242 + 28 * i), (0, 0, 90), segments=14, body=None)


@family("clock")
def clock(m: KitMaker) -> None:
    """A clock on a post."""
    metal = m.mat("metal")
    m.say(
        "StreetClock",
        STREET,
        f"{word(metal).capitalize()} clock on a post, 3.6 m high.",
        camel(metal),
        tags="clock post time",
    )
    m.b.cylinder(metal, 18, 40, top=10, segments=12, body=None)
    m.b.cylinder(metal, 7, 300, segments=10)
    for side in (90, -90):
        m.b.cylinder("WhitePaint", 34, 10, (0, 0, 330), (0, 0, side), segments=24, body=None)
    m.b.cylinder(metal, 38, 12, (0, -6, 330), (0, 0, 90), segments=24)
    for side in (-1, 1):
        m.b.box("BlackPaint", (3, 2, 24), (0, side * 11, 330), body=None)
        m.b.box("BlackPaint", (18, 2, 3), (8, side * 11, 330), body=None)
