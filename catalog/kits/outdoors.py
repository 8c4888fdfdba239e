"""Street furniture, fences, gates, market stalls, playgrounds, ruins and statues."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull

STREET, FENCES, MARKET, PLAY, RUINS, ART = "street furniture", "fences", "market", "playground", "ruins", "monuments"


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


@family("fountain")
def fountain(m: KitMaker) -> None:
    """A fountain with a round or eight-sided basin."""
    stone = m.mat("stone")
    r, tiers = m.opt("radius", m.uni(180, 320, 20)), m.pick(1, 2)
    m.say(
        "Fountain",
        ART,
        f"{word(stone).capitalize()} fountain with {tiers} bowl{'s' if tiers > 1 else ''}, {2 * r / 100:.1f} m wide.",
        camel(stone),
        "Tiered" if tiers > 1 else "Simple",
        tags="fountain basin square",
    )
    m.b.lathe(
        stone,
        [(0, 0), (r, 0), (r, 50), (r - 6, 58), (r - 28, 58), (r - 30, 20), (0, 20)],
        segments=m.pick(8, 24),
        smooth=False,
    )
    m.b.cylinder("Water", r - 28, 2, (0, 0, 42), segments=24, body=None)
    m.b.cylinder(stone, 26, 150, top=16, segments=14, body=None)
    for t in range(tiers):
        z, rr = 130 + 75 * t, 90 - 35 * t
        m.b.lathe(stone, [(12, 0), (rr, 18), (rr + 4, 26), (rr - 6, 24), (0, 14)], (0, 0, z), body=None)
        m.b.cylinder("Water", rr - 8, 1.5, (0, 0, z + 20), segments=18, body=None)
    m.b.cylinder(stone, 11, 90, (0, 0, 140), segments=10, body=None)
    m.b.ellipsoid(m.mat("metal"), (30, 30, 44), (0, 0, 225), body=None)


@family("statue")
def statue(m: KitMaker) -> None:
    """A figure or a beast on a pedestal."""
    stone = m.opt("stone", m.pick("Bronze", "Marble", "Verdigris", m.mat("stone")))
    kind = m.opt("kind", m.pick("Figure", "Rider", "Obelisk", "Bust", "Lion", "Urn"))
    m.say(
        f"{kind}Statue" if kind not in ("Obelisk",) else "Obelisk",
        ART,
        f"{word(stone).capitalize()} statue ({kind.lower()}) on a pedestal.",
        camel(stone),
        tags="statue monument sculpture",
    )
    base = m.mat("stone")
    high = m.uni(90, 160, 10)
    m.b.box(base, (130, 130, 16))
    m.b.box(base, (96, 96, high), (0, 0, 16), bevel=3)
    m.b.box(base, (112, 112, 12), (0, 0, 16 + high), bevel=2)
    with m.b.moved((0, 0, 28 + high)):
        if kind == "Obelisk":
            m.b.cylinder(stone, 42, 380, top=26, segments=4)
            m.b.cylinder(stone, 26, 40, (0, 0, 380), top=0, segments=4)
        elif kind == "Urn":
            m.b.lathe(stone, [(0, 0), (24, 0), (14, 14), (18, 24), (44, 70), (30, 92), (38, 104), (0, 104)])
        elif kind == "Bust":
            m.b.lathe(stone, [(0, 0), (20, 0), (14, 20), (34, 46), (20, 60), (12, 66), (0, 66)], squash=0.7)
            m.b.ellipsoid(stone, (28, 32, 38), (0, 4, 60))
        elif kind in ("Lion", "Rider"):
            m.b.ellipsoid(stone, (48, 120, 56), (0, 0, 42))
            for x in (-14, 14):
                for y in (-38, 38):
                    m.b.cylinder(stone, 9, 56, (x, y, 0), segments=8, body=None)
            m.b.ellipsoid(stone, (40, 52, 52), (0, 62, 78))
            m.b.tube(stone, [(0, -58, 70), (0, -80, 50), (0, -76, 20)], 5)
            if kind == "Rider":
                m.b.lathe(stone, [(0, 0), (22, 4), (20, 40), (26, 62), (10, 76), (0, 78)], (0, -6, 88), squash=0.7)
                m.b.ellipsoid(stone, (24, 26, 30), (0, -6, 164))
        else:
            m.b.lathe(stone, [(0, 0), (34, 0), (28, 60), (20, 92), (28, 140), (12, 158), (0, 160)], squash=0.7)
            m.b.ellipsoid(stone, (26, 28, 34), (0, 2, 156))
            m.b.tube(stone, [(22, 0, 136), (44, 14, 110), (40, 36, 128)], 7)
            m.b.tube(stone, [(-22, 0, 136), (-36, 6, 100), (-26, 20, 76)], 7)


@family("column")
def column(m: KitMaker) -> None:
    """A standing column, or a broken one."""
    stone = m.opt("stone", m.pick(m.mat("stone"), "Marble"))
    broken = m.opt("broken", m.chance(0.5))
    height = m.opt("height", m.uni(140, 300, 20) if broken else m.uni(380, 520, 20))
    m.say(
        "BrokenColumn" if broken else "Column",
        RUINS,
        f"{'Broken' if broken else 'Whole'} {word(stone)} column, {height / 100:.1f} m high.",
        camel(stone),
        tags="column pillar ruin",
    )
    m.b.box(stone, (96, 96, 18))
    m.b.cylinder(stone, 36, height - 18, (0, 0, 18), top=32, segments=16)
    if broken:
        m.b.add(
            stone,
            hull(
                [
                    (30 * math.cos(a), 30 * math.sin(a), height + (26 if i % 3 == 0 else 4))
                    for i, a in enumerate([k * math.pi / 4 for k in range(8)])
                ]
                + [(0.0, 0.0, height - 10)]
            ),
            body=None,
        )
    else:
        m.b.lathe(stone, [(32, 0), (46, 22), (0, 22)], (0, 0, height), body=None)
        m.b.box(stone, (104, 104, 18), (0, 0, height + 22))


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


@family("tomb")
def tomb(m: KitMaker) -> None:
    """A gravestone or a tomb."""
    stone = m.mat("stone")
    kind = m.pick("Gravestone", "GraveCross", "StoneTomb")
    m.say(kind, RUINS, f"{word(stone).capitalize()} {word(kind)}.", camel(stone), tags="grave tomb cemetery")
    if kind == "Gravestone":
        m.b.box(stone, (70, 30, 12))
        m.b.box(stone, (56, 14, 70), (0, 0, 12))
        m.b.cylinder(stone, 28, 14, (0, -7, 82), (0, 0, 90), segments=18, body=None)
    elif kind == "GraveCross":
        m.b.box(stone, (70, 50, 20))
        m.b.box(stone, (16, 14, 120), (0, 0, 20))
        m.b.box(stone, (70, 14, 16), (0, 0, 96))
    else:
        m.b.box(stone, (110, 220, 16))
        m.b.box(stone, (84, 190, 70), (0, 0, 16), bevel=3)
        m.b.box(stone, (100, 206, 14), (0, 0, 86), bevel=3)


@family("fence")
def fence(m: KitMaker) -> None:
    """A length of fence along X."""
    kind = m.opt("kind", m.pick("Picket", "Rail", "Plank", "Iron", "Wicker"))
    length = m.opt("length", 300.0)
    wood = m.mat("metal") if kind == "Iron" else m.opt("wood", m.pick(m.mat("wood"), "GreyWood"))
    m.say(
        f"{kind}Fence",
        FENCES,
        f"{kind} fence of {word(wood)}, {length / 100:.0f} m long.",
        camel(wood),
        tags="fence border",
    )
    posts, high = (
        max(2, round(length / 150) + 1),
        {"Rail": 115, "Plank": 180, "Iron": 140, "Picket": 95, "Wicker": 110}[kind],
    )
    for i in range(posts):
        m.b.box(wood, (9, 9, high + 8), (-length / 2 + 5 + i * (length - 10) / (posts - 1), 0, 0), body=None)
    if kind == "Rail":
        for z in (35, 65, 98):
            m.b.box(wood, (length, 4, 11), (0, 0, z), body=None)
    elif kind in ("Plank", "Wicker"):
        m.b.box(wood if kind == "Plank" else "Straw", (length - 4, 4, high - 8), (0, 0, 6), body=None)
    else:
        step = 15 if kind == "Picket" else 13
        for i in range(int(length // step)):
            x = -length / 2 + (i + 0.5) * length / int(length // step)
            if kind == "Picket":
                m.b.box(wood, (8, 2.5, high - 6), (x, 2.5, 5), body=None)
            else:
                m.b.cylinder(wood, 1.2, high, (x, 0, 4), segments=5, body=None)
        for z in (22, high - 24):
            m.b.box(wood, (length, 3.5, 6), (0, 0, z), body=None)
    m.b.body_box((length, 10, high))


@family("wall")
def wall(m: KitMaker) -> None:
    """A length of garden wall along X."""
    stone, length, high = (
        m.opt("stone", m.pick(m.mat("stone"), "RedBrick", "WhitePlaster")),
        m.opt("length", 400.0),
        m.opt("high", m.uni(100, 190, 10)),
    )
    m.say(
        "GardenWall",
        FENCES,
        f"{word(stone).capitalize()} wall with a coping, {length / 100:.0f} m long, {high / 100:.1f} m high.",
        camel(stone),
        tags="wall stone border",
    )
    m.b.box(stone, (length, 36, high))
    m.b.box(m.mat("stone"), (length, 46, 12), (0, 0, high))


@family("gate")
def gate(m: KitMaker) -> None:
    """An open gate to pass: two posts and wings turned back."""
    metal, stone = m.mat("metal"), m.mat("stone")
    wide = m.opt("width", 300.0)
    m.say(
        "OpenGate",
        FENCES,
        f"Open {word(metal)} gate between {word(stone)} posts, {wide / 100:.0f} m wide.",
        camel(metal),
        camel(stone),
        tags="gate entrance posts",
    )
    for side in (-1, 1):
        x = side * (wide / 2 + 30)
        m.b.box(stone, (56, 56, 220), (x, 0, 0))
        m.b.ellipsoid(stone, (44, 44, 44), (x, 0, 218), body=None)
        with m.b.moved((side * wide / 2, -30, 0), (0, -90, 0)):
            half = wide / 2 - 8
            for i in range(9):
                m.b.cylinder(metal, 1.6, 165, ((i + 0.5) * half / 9, 0, 8), segments=5, body=None)
            for z in (20, 150):
                m.b.box(metal, (half, 4, 6), (half / 2, 0, z), body=None)
            m.b.body_box((half, 5, 170), (half / 2, 0, 0))


@family("arbour")
def arbour(m: KitMaker) -> None:
    """A pergola with climbing plants, open to walk through along Y."""
    wood = m.mat("wood")
    m.say(
        "Pergola",
        FENCES,
        f"{word(wood).capitalize()} pergola with climbing plants, 3 m long.",
        camel(wood),
        tags="pergola garden arch",
    )
    for x in (-110, 110):
        for y in (-140, 0, 140):
            m.b.box(wood, (14, 14, 240), (x, y, 0))
        m.b.box(wood, (14, 310, 14), (x, 0, 240), body=None)
    for i in range(7):
        m.b.box(wood, (280, 8, 14), (0, -140 + 47 * i, 254), body=None)
    m.b.body_box((280, 310, 28), (0, 0, 240))
    for i in range(16):
        m.b.ellipsoid(m.mat("leaf"), (70, 70, 34), (m.uni(-120, 120), m.uni(-140, 140), 254), segments=8, body=None)
        if i % 3 == 0:
            m.b.ellipsoid("PinkPaint", (14, 14, 12), (m.uni(-120, 120), m.uni(-140, 140), 282), segments=6, body=None)


GOODS = {
    "Fruit": ("Apple", "Orange", "Lemon", "Tomato"),
    "Vegetable": ("Leaf", "Tomato", "PaleLeaf", "Orange"),
    "Bread": ("Bread", "Bread", "Wheat", "Straw"),
    "Cheese": ("Cheese", "Cheese", "Wax", "Lemon"),
    "Fish": ("Steel", "Aluminium", "SilverPaint", "PinkPaint"),
    "Cloth": ("RedCloth", "TealCloth", "MustardCloth", "NavyCloth"),
    "Pottery": ("Terracotta", "Clay", "Porcelain", "BluePaint"),
    "Spice": ("Orange", "Rust", "Sand", "MaroonPaint"),
    "Flower": ("PinkPaint", "YellowPaint", "RedPaint", "VioletPaint"),
    "Book": ("MaroonPaint", "NavyPaint", "GreenPaint", "Paper"),
}


@family("stall")
def stall(m: KitMaker) -> None:
    """A market stall with goods under an awning."""
    ware = m.opt("ware", m.pick(*GOODS))
    wood, cloth = m.mat("wood"), m.mat("awning")
    m.say(
        f"{ware}Stall",
        MARKET,
        f"Market stall of {word(wood)} with {ware.lower()} under an awning of {word(cloth)}, 2.6 m wide.",
        "",
        camel(cloth),
        tags="market stall goods awning",
    )
    m.b.box(wood, (260, 110, 6), (0, 10, 84))
    m.b.box(wood, (250, 6, 84), (0, 60, 0))
    for x in (-124, 124):
        for y in (-60, 60):
            m.b.box(wood, (9, 9, 250 if y < 0 else 225), (x, y, 0), body=None)
    m.b.body_box((250, 120, 84))
    with m.b.moved((0, 0, 232)):
        m.b.box(cloth, (290, 170, 5), (0, 10, 0), (0, 0, -8), body=None)
        m.b.box(cloth, (290, 3, 24), (0, 95, -34), body=None)
    m.b.body_box((280, 150, 20), (0, 0, 232))
    for row in range(2):
        for i in range(5):
            with m.b.moved((-100 + 50 * i, -12 + 44 * row, 90)):
                m.b.box("Pine", (44, 38, 12), body=None)
                for k in range(6):
                    m.b.ellipsoid(
                        GOODS[ware][(i + row) % 4],
                        (13, 13, 12),
                        (-14 + 14 * (k % 3), -8 + 16 * (k // 3), 8),
                        segments=8,
                        body=None,
                    )
    m.b.body_box((250, 90, 22), (0, 10, 90))


@family("handcart")
def handcart(m: KitMaker) -> None:
    """A cart on two or four wheels."""
    load = m.opt("load", m.pick("Hay", "Soil", "Pine", "Empty", "Pottery", "Apple", "Rock"))
    wood = m.mat("wood")
    m.say(
        "Handcart",
        MARKET,
        f"{word(wood).capitalize()} cart on two wheels with {word(load)}.",
        "" if load == "Empty" else load,
        camel(wood),
        tags="cart wagon wheel",
    )
    m.b.box(wood, (180, 100, 8), (0, 0, 62))
    for y in (-50, 50):
        m.b.box(wood, (180, 5, 36), (0, y, 66), body=None)
        wheel(m, wood, 44, (-10, y * 1.16, 44), 90)
        m.b.box(wood, (130, 6, 6), (140, y * 0.7, 64), (-6, 0, 0), body=None)
    m.b.box(wood, (5, 100, 36), (-90, 0, 66), body=None)
    m.b.box(wood, (8, 8, 62), (86, 0, 0))
    m.b.body_box((180, 116, 100))
    if load != "Empty":
        m.b.ellipsoid({"Pottery": "Terracotta"}.get(load, load), (150, 84, 60), (0, 0, 66), body=None)


def wheel(m: KitMaker, material: str, radius: float, at: tuple[float, float, float], roll: float) -> None:
    """An upright spoked wheel whose axle runs along Y (``roll`` 90)."""
    from catalog.shapes.patches import tube

    points = [(radius * math.cos(a), 0.0, radius * math.sin(a)) for a in [k * math.pi / 8 for k in range(17)]]
    m.b.add(material, tube(points, 4, 6), at, body=None)
    for k in range(4):
        m.b.box(material, (2 * radius - 4, 4, 5), (at[0], at[1], at[2] - 2.5), (45 * k, 0, 0), body=None)


@family("parasol-table")
def parasol_table(m: KitMaker) -> None:
    """A round cafe table with a parasol through it."""
    cloth, metal = m.mat("awning"), m.mat("metal")
    m.say(
        "ParasolTable",
        STREET,
        f"Round cafe table with a parasol of {word(cloth)}.",
        camel(cloth),
        tags="table cafe parasol umbrella",
    )
    m.b.cylinder(metal, 40, 4, (0, 0, 70), segments=20)
    m.b.cylinder(metal, 26, 4, segments=16)
    m.b.cylinder(metal, 3, 240, segments=8)
    m.b.cylinder(cloth, 130, 44, (0, 0, 210), top=3, segments=8)


@family("well")
def well(m: KitMaker) -> None:
    """A draw well under a small roof."""
    stone = m.mat("stone")
    m.say(
        "DrawWell",
        STREET,
        f"{word(stone).capitalize()} draw well with a roof and a bucket.",
        camel(stone),
        tags="well bucket",
    )
    m.b.lathe(stone, [(0, 0), (80, 0), (80, 84), (58, 84), (58, 30), (0, 30)], smooth=False)
    m.b.cylinder("Water", 57, 2, (0, 0, 40), body=None)
    for x in (-72, 72):
        m.b.box(m.mat("wood"), (12, 12, 210), (x, 0, 0))
    m.b.gable(m.mat("roof"), (150, 200, 60), (0, 0, 205), (0, 90, 0))
    m.b.cylinder(m.mat("wood"), 8, 140, (-70, 0, 160), (-90, 0, 0), segments=8, body=None)
    m.b.cylinder(m.mat("wood"), 13, 26, (0, 0, 96), top=16, segments=10, body=None)
    m.b.tube("Rope", [(0, 0, 122), (0, 0, 160)], 1.5)


@family("flag")
def flag(m: KitMaker) -> None:
    """A flag on a pole, or a banner."""
    cloth = m.mat("cloth")
    banner = m.opt("banner", m.style.old)
    m.say(
        "BannerPole" if banner else "FlagPole",
        STREET,
        f"Pole with a {word(cloth)} {'banner' if banner else 'flag'}, 6 m high.",
        camel(cloth),
        tags="flag banner pole",
    )
    m.b.cylinder(m.mat("metal"), 18, 8, segments=12, body=None)
    m.b.cylinder(m.mat("metal"), 4.5, 600, segments=8)
    m.b.ellipsoid("Gold", (16, 16, 16), (0, 0, 598), segments=8, body=None)
    if banner:
        m.b.box(m.mat("wood"), (90, 4, 5), (44, 0, 580), body=None)
        m.b.box(cloth, (76, 2, 230), (46, 0, 350), body=None)
    else:
        for i in range(5):
            m.b.box(
                cloth,
                (32, 1.5, 92),
                (20 + 30 * i, 5 * math.sin(i * 1.4), 495),
                (0, 14 * math.cos(i * 1.4), 0),
                body=None,
            )


@family("play")
def play(m: KitMaker) -> None:
    """A piece of a playground."""
    kind = m.opt(
        "kind", m.pick("Slide", "Swing", "Seesaw", "Sandbox", "ClimbingFrame", "Roundabout", "SpringHorse", "PlayHouse")
    )
    paint, second = m.mat("paint"), m.another("paint")
    m.say(
        kind,
        PLAY,
        f"{word(paint).capitalize()} {word(kind)} for children.",
        camel(paint),
        tags="playground children play",
    )
    b = m.b
    if kind == "Slide":
        b.box(second, (90, 90, 6), (0, -140, 150))
        for x in (-42, 42):
            for y in (-180, -100):
                b.box(paint, (8, 8, 240 if y else 150), (x, y, 0))
        b.gable("RedPaint", (120, 110, 50), (0, -140, 240), body=None)
        for i in range(6):
            b.box(second, (60, 20, 5), (0, -195 - 0, 22 + 24 * i), body=None)
        b.box("SilverPaint", (56, 250, 5), (0, -6, 72), (0, 0, 33), body="box")
        for x in (-30, 30):
            b.box(paint, (5, 250, 20), (x, -6, 72), (0, 0, 33), body=None)
    elif kind == "Swing":
        for x in (-160, 160):
            for y in (-1, 1):
                b.tube(paint, [(x, y * 80, 0), (x, 0, 230)], 5)
            b.body_box((12, 160, 60), (x, 0, 0))
        b.tube(paint, [(-165, 0, 230), (165, 0, 230)], 5)
        for x in (-70, 70):
            for s in (-20, 20):
                b.tube("Iron", [(x + s, 0, 230), (x + s, 0, 50)], 1)
            b.box(second, (46, 20, 4), (x, 0, 46))
    elif kind == "Seesaw":
        b.cylinder(second, 20, 50, top=8, segments=10)
        b.box(paint, (320, 28, 7), (0, 0, 48), (8, 0, 0))
        for x in (-130, 130):
            b.tube(
                "Iron",
                [(x, -14, 56 + x * 0.14), (x, -14, 84 + x * 0.14), (x, 14, 84 + x * 0.14), (x, 14, 56 + x * 0.14)],
                2,
            )
    elif kind == "Sandbox":
        for side in (-1, 1):
            b.box(paint, (300, 20, 30), (0, side * 140, 0))
            b.box(paint, (20, 260, 30), (side * 140, 0, 0))
        b.box("Sand", (260, 260, 14), body="box")
        b.cylinder("Sand", 40, 34, (40, 20, 12), top=5, segments=12, body=None)
        b.cylinder(second, 10, 18, (-50, -30, 14), top=13, segments=12, body=None)
    elif kind == "ClimbingFrame":
        for x in (-120, -40, 40, 120):
            for y in (-80, 0, 80):
                b.cylinder(paint if (x + y) % 3 else second, 3.5, 220, (x, y, 0), segments=8, body=None)
        for z in (70, 140, 215):
            for y in (-80, 0, 80):
                b.tube(second, [(-122, y, z), (122, y, z)], 3)
            for x in (-120, -40, 40, 120):
                b.tube(paint, [(x, -82, z), (x, 82, z)], 3)
        b.body_box((250, 170, 220))
    elif kind == "Roundabout":
        b.cylinder("Iron", 20, 20, segments=12)
        b.cylinder(paint, 120, 8, (0, 0, 18), segments=24)
        for k in range(6):
            a = k * math.pi / 3
            b.tube(
                second,
                [(0, 0, 80), (60 * math.cos(a), 60 * math.sin(a), 84), (105 * math.cos(a), 105 * math.sin(a), 26)],
                2.5,
            )
        b.body_box((90, 90, 60), (0, 0, 26))
    elif kind == "SpringHorse":
        b.lathe("Iron", [(16, 0), (12, 10), (16, 20), (12, 30), (14, 36)], smooth=False)
        b.ellipsoid(paint, (40, 90, 36), (0, 0, 36))
        b.ellipsoid(second, (24, 36, 44), (0, 46, 58), body=None)
        b.tube("BlackPaint", [(-22, 34, 84), (22, 34, 84)], 2)
    else:
        b.box("PalePlanks", (160, 150, 130))
        b.gable(paint, (190, 180, 80), (0, 0, 130))
        b.box("BlackPaint", (50, 6, 90), (-30, 74, 0), body=None)
        b.box(second, (40, 8, 36), (40, 74, 60), body=None)


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
