"""Ground, water, plants, rocks and animals."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import Point3, hull

PLANTS, GROUND, ROCKS, ANIMALS = "plants", "ground", "rocks", "animals"
PAVED = {
    "Cobble": "CobblePavement",
    "Paving": "StonePavement",
    "Flagstone": "FlagstonePavement",
    "RedPaving": "RedPavement",
    "Asphalt": "AsphaltRoad",
    "Concrete": "ConcreteGround",
    "Gravel": "GravelGround",
    "Planks": "PlankGround",
    "Rubber": "RubberGround",
    "Cinder": "CinderGround",
}


@family("ground", flat=True)
def ground(m: KitMaker) -> None:
    """A square piece of ground; its upper face is at the pivot."""
    material, side = m.opt("of", "Grass"), m.opt("side", 1000.0)
    noun = PAVED.get(material, f"{material}Ground")
    m.say(
        noun,
        GROUND,
        f"Square of {word(material)}, {side / 100:.0f} x {side / 100:.0f} m, its upper face at the pivot.",
        tags="ground floor tile",
    )
    m.b.box(material, (side, side, 4), (0, 0, -4))


@family("road", flat=True)
def road(m: KitMaker) -> None:
    """A piece of road along X with markings, upper face at the pivot."""
    length, wide, of = m.opt("length", 800.0), m.opt("wide", 700.0), m.opt("of", "Asphalt")
    mark = m.opt("mark", "line")
    m.say(
        {"line": "RoadStraight", "zebra": "RoadZebraCrossing", "bays": "RoadParkingBays"}[mark],
        GROUND,
        f"Piece of road of {word(of)}, {length / 100:.0f} m long along X and {wide / 100:.0f} m wide, with {mark}.",
        tags="road ground street asphalt",
    )
    m.b.box(of, (length, wide, 4), (0, 0, -4))
    if mark == "line":
        for i in range(int(length // 400)):
            m.b.box("WhitePaint", (180, 12, 0.5), (-length / 2 + 200 + 400 * i, 0, 0), body=None)
    elif mark == "zebra":
        for i in range(int(wide // 90)):
            m.b.box("WhitePaint", (260, 45, 0.5), (0, -wide / 2 + 55 + 90 * i, 0), body=None)
    else:
        for i in range(int(length // 270) + 1):
            m.b.box(
                "WhitePaint",
                (10, wide - 60, 0.5),
                (-length / 2 + 6 + i * (length - 12) / int(length // 270), 0, 0),
                body=None,
            )


@family("water", flat=True)
def water(m: KitMaker) -> None:
    """A square of water."""
    side = m.opt("side", 1000.0)
    m.say(
        "WaterSurface",
        GROUND,
        f"Calm water, {side / 100:.0f} x {side / 100:.0f} m, its surface at the pivot.",
        "Calm",
        tags="water sea river lake surface",
    )
    m.b.box("Water", (side, side, 4), (0, 0, -4), body=None)


@family("bed", flat=True)
def bed(m: KitMaker) -> None:
    """A garden bed edged with stones or boards, upper face near the pivot."""
    edge, soil = m.opt("edge", m.pick("Fieldstone", "Oak", "RedBrick", "Limestone")), "DarkSoil"
    length, wide = m.opt("length", 400.0), m.opt("wide", 160.0)
    m.say(
        "GardenBedGround",
        GROUND,
        f"Bed of dark soil edged with {word(edge)}, {length / 100:.1f} x {wide / 100:.1f} m.",
        camel(edge),
        tags="bed garden soil ground",
    )
    m.b.box(soil, (length, wide, 4), (0, 0, -2))
    for s in (-1, 1):
        m.b.box(edge, (length, 10, 9), (0, s * wide / 2, -3), body=None)
        m.b.box(edge, (10, wide, 9), (s * length / 2, 0, -3), body=None)


def crown(m: KitMaker, material: str, at: Point3, size: float, balls: int, squash: float = 0.8) -> None:
    """A cloud of leaves."""
    m.b.ellipsoid(material, (size, size, size * squash), at, segments=12, body=None)
    for i in range(balls):
        a, r = i * 2.4 + 0.5, size * 0.34
        s = size * m.uni(0.5, 0.68, 0.02)
        m.b.ellipsoid(
            material,
            (s, s, s * squash),
            (at[0] + r * math.cos(a), at[1] + r * math.sin(a), at[2] + size * (0.05 + 0.1 * (i % 4))),
            segments=10,
            body=None,
        )


TREES = {
    "Leaf": "Lime",
    "DarkLeaf": "Oak",
    "PaleLeaf": "Ash",
    "AutumnLeaf": "Maple",
    "GoldenLeaf": "Birch",
    "Blossom": "Cherry",
    "VioletLeaf": "Plum",
}


@family("tree")
def tree(m: KitMaker) -> None:
    """A broad-leaved tree."""
    leaf = m.mat("leaf")
    height = m.opt("height", m.uni(450, 900, 25))
    size = "Young" if height < 560 else "Great" if height > 780 else "Broad"
    m.say(
        f"{TREES[leaf]}Tree",
        PLANTS,
        f"{size} {TREES[leaf].lower()} tree with {word(leaf)} crown, about {height / 100:.0f} m high.",
        "",
        size,
        tags="tree plant leafy",
    )
    trunk, bark = height * 0.42, m.mat("bark") if leaf != "GoldenLeaf" else "PaleBark"
    m.b.cylinder(bark, height * 0.045, trunk, top=height * 0.026, segments=9, body=None)
    for k in range(3):
        a = k * 2.1
        m.b.tube(
            bark,
            [(0, 0, trunk * 0.7), (height * 0.1 * math.cos(a), height * 0.1 * math.sin(a), trunk * 1.05)],
            height * 0.014,
        )
    crown(m, leaf, (0, 0, trunk * 0.82), height * 0.55, m.pick(4, 5, 6), m.uni(0.75, 0.95, 0.05))
    m.b.body_box((height * 0.09, height * 0.09, trunk))


@family("conifer")
def conifer(m: KitMaker) -> None:
    """A fir, spruce or pine."""
    leaf = m.opt("leaf", m.pick("Needle", "Needle", "DarkLeaf"))
    height, kind = m.uni(500, 1100, 25), m.pick("Spruce", "Fir", "Pine", "Cypress")
    m.say(
        f"{kind}Tree",
        PLANTS,
        f"{kind} of about {height / 100:.0f} m.",
        "",
        "Tall" if height > 800 else "Young",
        tags="tree conifer plant needle",
    )
    m.b.cylinder("Bark", height * 0.025, height * 0.3, top=height * 0.018, segments=8, body=None)
    if kind == "Cypress":
        m.b.lathe(
            leaf,
            [
                (0, height * 0.06),
                (height * 0.08, height * 0.16),
                (height * 0.09, height * 0.4),
                (height * 0.05, height * 0.8),
                (0, height),
            ],
            segments=12,
            body=None,
        )
    elif kind == "Pine":
        m.b.cylinder("Bark", height * 0.025, height * 0.7, segments=8, body=None)
        crown(m, leaf, (0, 0, height * 0.6), height * 0.4, 4, 0.55)
    else:
        for i in range(5):
            z = height * (0.12 + 0.16 * i)
            m.b.cylinder(
                leaf, height * (0.22 - 0.035 * i), height * 0.3, (0, 0, z), top=height * 0.01, segments=11, body=None
            )
    m.b.body_box((height * 0.06, height * 0.06, height * 0.4))


@family("palm")
def palm(m: KitMaker) -> None:
    """A palm."""
    height = m.uni(450, 800, 25)
    m.say(
        "PalmTree",
        PLANTS,
        f"Palm of about {height / 100:.0f} m.",
        m.pick("Date", "Coconut", "Fan"),
        tags="tree palm plant",
    )
    m.b.tube("Bark", [(0, 0, 0), (10, 4, height * 0.5), (26, 10, height)], 16)
    for k in range(9):
        with m.b.moved((26, 10, height), (0, 40 * k, 0)):
            for i, (x, z) in enumerate(((30, 22), (90, 24), (150, -6), (195, -56))):
                m.b.box("Leaf", (66, 34 - 6 * i, 3), (x, 0, z), (-8 - 22 * i, 0, 0), body=None)
    m.b.body_box((40, 36, height * 0.9), (8, 4, 0))


@family("bush")
def bush(m: KitMaker) -> None:
    """A bush, with flowers or berries or clipped."""
    leaf = m.opt("leaf", m.pick("Leaf", "DarkLeaf", "PaleLeaf"))
    kind = m.pick("Round", "Flowering", "Berry", "Clipped")
    size, dots = m.uni(90, 170, 10), m.pick("PinkPaint", "WhitePaint", "YellowPaint", "VioletPaint")
    m.say(
        "Bush" if kind != "Flowering" else f"{camel(dots)}RoseBush",
        PLANTS,
        f"{kind} bush, {size / 100:.1f} m.",
        kind if kind != "Flowering" else "",
        "Small" if size < 120 else "Large",
        tags="bush shrub plant",
    )
    if kind == "Clipped":
        m.pick(1, 2)
        m.b.cylinder(leaf, size * 0.4, size, top=size * 0.1, segments=14) if m.chance(0.5) else m.b.ellipsoid(
            leaf, (size, size, size)
        )
        return
    crown(m, leaf, (0, 0, 0), size * 0.85, 4)
    if kind != "Round":
        for i in range(14):
            a, r = i * 2.4, size * 0.4
            m.b.ellipsoid(
                "RedPaint" if kind == "Berry" else dots,
                (9, 9, 9),
                (r * math.cos(a), r * math.sin(a), size * (0.25 + 0.03 * i)),
                segments=6,
                body=None,
            )
    m.b.body_box((size * 0.8, size * 0.8, size * 0.6))


@family("hedge")
def hedge(m: KitMaker) -> None:
    """A clipped hedge along X."""
    leaf, length, high = (
        m.opt("leaf", m.pick("Leaf", "DarkLeaf")),
        m.opt("length", 300.0),
        m.opt("high", m.uni(80, 160, 20)),
    )
    m.say(
        "ClippedHedge",
        PLANTS,
        f"Clipped hedge, {length / 100:.0f} m long, {high / 100:.1f} m high.",
        "High" if high > 120 else "Low",
        camel(leaf),
        tags="hedge plant border",
    )
    m.b.box(leaf, (length, 70, high), bevel=8)


@family("flowers")
def flowers(m: KitMaker) -> None:
    """A clump of flowers, herbs or grass."""
    kind = m.opt(
        "kind",
        m.pick("Tulips", "Lavender", "Daisies", "Poppies", "Sunflowers", "Ferns", "TallGrass", "Reeds", "Marigolds"),
    )
    colour = {
        "Tulips": "RedPaint",
        "Lavender": "VioletPaint",
        "Daisies": "WhitePaint",
        "Poppies": "OrangePaint",
        "Sunflowers": "YellowPaint",
        "Marigolds": "OrangePaint",
    }.get(kind, "PaleLeaf")
    high = {"Sunflowers": 165.0, "TallGrass": 70.0, "Reeds": 130.0, "Ferns": 55.0}.get(kind, 45.0)
    m.say(kind, PLANTS, f"Clump of {word(kind)}, {high / 100:.1f} m high.", tags="flowers plant garden")
    for i in range(12):
        a, r = i * 2.4, 9.5 * math.sqrt(i)
        x, y = r * math.cos(a), r * math.sin(a)
        h = high * (0.8 + 0.2 * ((i * 7) % 5) / 4)
        if kind == "Ferns":
            with m.b.moved((0, 0, 0), (0, 30 * i, 0)):
                m.b.box("Leaf", (60, 16, 2), (28, 0, 12.4), (24, 0, 0), body=None)
            continue
        m.b.cylinder(
            "Leaf", 2.2, h, (x, y, 0), top=0.6 if kind in ("TallGrass", "Reeds") else 1.2, segments=5, body=None
        )
        if kind == "Reeds":
            m.b.cylinder("Bark", 3, 16, (x, y, h - 10), segments=6, body=None)
        elif kind == "Sunflowers":
            m.b.cylinder(colour, 14, 3, (x, y + 4, h), (0, 0, 70), segments=10, body=None)
            m.b.cylinder("Bark", 7, 5, (x, y + 4, h), (0, 0, 70), segments=8, body=None)
        elif kind != "TallGrass":
            m.b.ellipsoid(colour, (8, 8, 16 if kind == "Lavender" else 7), (x, y, h - 3), segments=6, body=None)
    m.b.body_box((56, 56, high * 0.7))


BLOOMS = {"Tulip": "RedPaint", "YellowTulip": "YellowPaint", "Lavender": "VioletPaint", "PinkTulip": "PinkPaint"}
CROP_PLANTS = {"Maize": 9, "Pumpkin": 6, "Vine": 8, "Strawberry": 12, "Carrot": 14, "Leek": 14, "Lettuce": 10}


@family("crop")
def crop(m: KitMaker) -> None:
    """A row of a crop along X."""
    kind = m.opt(
        "kind", m.pick("Cabbage", "Maize", "Wheat", "Pumpkin", "Vine", "Lettuce", "Carrot", "Strawberry", "Leek")
    )
    m.say(f"{kind}Row", PLANTS, f"Row of {kind.lower()}, 4 m long along X.", tags="crop row field vegetable plant")
    if kind == "Wheat":
        m.b.box("Wheat", (400, 60, 70), body=None)
        for i in range(40):
            m.b.cylinder("Wheat", 6, 28, (-195 + 10 * i, 22 * math.sin(i * 2.4), 66), top=1, segments=5, body=None)
        m.b.body_box((400, 60, 70))
        return
    if kind == "Vine":
        for post in (-190, 0, 190):
            m.b.box("GreyWood", (8, 8, 150), (post, 0, 0), body=None)
        m.b.tube("Iron", [(-190, 0, 110), (190, 0, 110)], 1)
    n = 13 if kind in BLOOMS else CROP_PLANTS.get(kind, 8)
    for i in range(n):
        x = (i - (n - 1) / 2) * 390 / n
        if kind == "Maize":
            m.b.cylinder("Crop", 3, 190, (x, 0, 0), top=1.5, segments=6, body=None)
            for k in range(4):
                with m.b.moved((x, 0, 45 + 34 * k), (0, 90 * k + 37 * i, 0)):
                    m.b.box("Crop", (50, 7, 1.5), (24, 0, 6), (20, 0, 0), body=None)
            m.b.ellipsoid("Wheat", (9, 9, 26), (x + 5, 0, 110), segments=8, body=None)
        elif kind == "Pumpkin":
            s = 40 + (i * 7) % 16
            m.b.ellipsoid("OrangePaint", (s, s, s * 0.7), (x, (i % 2) * 16 - 8, 0), segments=12, body=None)
            m.b.ellipsoid("Crop", (40, 30, 20), (x + 20, 14, 0), segments=8, body=None)
        elif kind == "Vine":
            m.b.ellipsoid("Leaf", (56, 40, 70), (x, 0, 70), segments=9, body=None)
            m.b.ellipsoid("Plum", (14, 12, 24), (x + 10, 18, 62), segments=7, body=None)
        elif kind in ("Carrot", "Leek"):
            m.b.cylinder("PaleLeaf" if kind == "Leek" else "Orange", 4, 10, (x, 0, 0), segments=6, body=None)
            m.b.ellipsoid("Crop", (20, 20, 32), (x, 0, 6), segments=7, body=None)
        else:
            s = {"Strawberry": 26, "Lettuce": 32}.get(kind, 30 if kind in BLOOMS else 42)
            leaf = "Crop" if kind != "Lettuce" else "PaleLeaf"
            m.b.ellipsoid(leaf, (s, s, s * 0.7), (x, 0, 0), segments=9, body=None)
            if kind == "Strawberry":
                m.b.ellipsoid("RedPaint", (6, 6, 8), (x + 9, 9, 9), segments=6, body=None)
            for k in range(3 if kind in BLOOMS else 0):
                at = (x - 9 + 9 * k, 8.0 * (k % 2) - 4, 14.0)
                m.b.ellipsoid(BLOOMS[kind], (13, 13, 16), at, segments=6, body=None)
    m.b.body_box((390, 36, {"Maize": 185, "Vine": 130}.get(kind, 26)))


@family("log")
def log(m: KitMaker) -> None:
    """Trunks, stumps and piles of wood."""
    kind = m.opt("kind", m.pick("FallenLog", "TreeStump", "WoodPile", "Firewood"))
    m.say(kind, PLANTS, f"{word(kind).capitalize()} of bark-covered wood.", tags="log wood trunk")
    if kind == "FallenLog":
        m.b.cylinder("Bark", 32, 380, (-190, 0, 30), (-90, 0, 0), top=24, segments=12)
        m.b.cylinder("Pine", 25, 2, (190, 0, 30), (-90, 0, 0), segments=12, body=None)
        m.b.body_box((370, 40, 8))
        for i in range(5):
            m.b.ellipsoid("Moss", (50, 36, 14), (-140 + 66 * i, 0, 52), segments=8, body=None)
    elif kind == "TreeStump":
        m.b.cylinder("Bark", 46, 44, top=34, segments=12)
        m.b.cylinder("Pine", 32, 1, (0, 0, 44), segments=12, body=None)
    else:
        rows, r, length = (3, 20, 260) if kind == "WoodPile" else (4, 8, 50)
        for row in range(rows):
            for i in range(rows + 2 - row):
                y = (i - (rows + 1 - row) / 2) * 2 * r
                m.b.cylinder(
                    "Bark", r, length, (-length / 2, y, r + row * r * 1.75), (-90, 0, 0), segments=9, body=None
                )
                m.b.cylinder(
                    "Pine",
                    r - 2,
                    length + 1,
                    (-length / 2 - 0.5, y, r + row * r * 1.75),
                    (-90, 0, 0),
                    segments=9,
                    body=None,
                )
        m.b.body_box((length, 2 * r * (rows + 1), r * 1.75 * rows))


@family("rock")
def rock(m: KitMaker) -> None:
    """A boulder or a group of stones."""
    stone = m.opt("stone", m.pick("Rock", "Rock", "RedRock" if m.style.name == "fantasy" else "Rock"))
    size = m.opt("size", m.uni(60, 240, 10))
    m.say(
        "FieldStone" if size < 100 else "Boulder" if size < 180 else "GreatBoulder",
        ROCKS,
        f"{word(stone).capitalize()} of {size / 100:.1f} m.",
        "",
        m.pick("Round", "Flat", "Jagged", "Mossy", "Leaning", "Grey"),
        tags="rock stone boulder",
    )
    stretch, flat = m.uni(0.7, 1.0, 0.05), m.uni(0.55, 0.9, 0.05)
    points = []
    for i in range(26):
        z = 1 - 2 * (i + 0.5) / 26
        r, a = math.sqrt(1 - z * z), i * 2.39996
        k = m.uni(0.8, 1.0, 0.02) * size / 2
        points.append((r * math.cos(a) * k, r * math.sin(a) * k * stretch, max(0.0, z * k * flat + size * 0.26)))
    m.b.add(stone, hull(points))


@family("mushroom")
def mushroom(m: KitMaker) -> None:
    """A giant mushroom or a group of crystals."""
    if m.opt("crystal", m.chance(0.4)):
        glow = m.pick("CrystalBlue", "CrystalViolet")
        m.say(
            "CrystalCluster",
            ROCKS,
            f"Cluster of {word(glow)} crystals.",
            "Blue" if glow == "CrystalBlue" else "Violet",
            tags="crystal magic glow",
        )
        for i in range(6):
            a, h = i * 2.4, m.uni(60, 190, 10)
            with m.b.moved(
                (14 * math.cos(a), 14 * math.sin(a), 0), (m.uni(-16, 16, 2), math.degrees(a), m.uni(-16, 16, 2))
            ):
                m.b.cylinder(glow, 18, h * 0.8, segments=6, body=None)
                m.b.cylinder(glow, 18, h * 0.2, (0, 0, h * 0.8), top=1, segments=6, body=None)
        m.b.body_box((70, 70, 90))
        return
    cap, high = m.mat("paint"), m.uni(60, 260, 20)
    m.say(
        "GiantMushroom",
        PLANTS,
        f"Giant mushroom with a {word(cap)} cap, {high / 100:.1f} m high.",
        camel(cap),
        tags="mushroom giant fantasy",
    )
    m.b.lathe("CreamPaint", [(0, 0), (high * 0.16, 0), (high * 0.1, high * 0.5), (high * 0.08, high * 0.8)], body=None)
    m.b.lathe(
        cap,
        [(0, high * 0.7), (high * 0.42, high * 0.66), (high * 0.4, high * 0.8), (high * 0.2, high * 0.96), (0, high)],
        body=None,
    )
    for i in range(7):
        a, r = i * 2.4, high * 0.06 * (i + 0.6)
        m.b.ellipsoid(
            "WhitePaint",
            (high * 0.08, high * 0.08, high * 0.04),
            (r * math.cos(a), r * math.sin(a), high * (0.97 - 0.028 * i)),
            segments=6,
            body=None,
        )
    m.b.body_box((high * 0.24, high * 0.24, high * 0.9))


@family("animal")
def animal(m: KitMaker) -> None:
    """A farm animal or a pet, standing."""
    kind = m.opt("kind", m.pick("Cow", "Sheep", "Horse", "Pig", "Goat", "Dog", "Hen", "Duck", "Donkey", "Cat"))
    long_, tall, coat = {
        "Cow": (170, 130, "CreamPaint"),
        "Sheep": (90, 75, "Linen"),
        "Horse": (180, 150, "Walnut"),
        "Pig": (110, 65, "PinkPaint"),
        "Goat": (85, 75, "GreyPaint"),
        "Dog": (65, 55, "Fur"),
        "Hen": (34, 34, "Fur"),
        "Duck": (34, 30, "WhitePaint"),
        "Donkey": (130, 110, "GreyPaint"),
        "Cat": (40, 30, "BlackPaint"),
    }[kind]
    coat = m.opt("coat", m.pick(coat, coat, "BrownPaint", "WhitePaint"))
    m.say(
        kind,
        ANIMALS,
        f"{word(coat).capitalize()} {kind.lower()}, {long_ / 100:.1f} m long, head to +Y.",
        camel(coat),
        tags="animal farm",
    )
    bird = kind in ("Hen", "Duck")
    leg = tall * (0.3 if bird else 0.45)
    for x in (-1, 1):
        for y in (0,) if bird else (-1, 1):
            m.b.cylinder(
                "OrangePaint" if bird else coat,
                max(1.5, long_ * 0.04),
                leg + 4,
                (x * long_ * 0.11, y * long_ * 0.3, 0),
                segments=7,
                body=None,
            )
    m.b.ellipsoid(coat, (long_ * 0.42, long_ * 0.86, tall * 0.52), (0, 0, leg), segments=12, body=None)
    neck = long_ * (0.42 if not bird else 0.3)
    head_z = tall * (0.78 if kind not in ("Pig",) else 0.5)
    m.b.tube(coat, [(0, neck * 0.8, leg + tall * 0.3), (0, neck * 1.15, head_z + tall * 0.08)], long_ * 0.08)
    m.b.ellipsoid(coat, (long_ * 0.2, long_ * 0.34, tall * 0.2), (0, neck * 1.3, head_z), segments=10, body=None)
    if bird:
        m.b.cylinder("OrangePaint", 2.5, 6, (0, neck * 1.65, head_z + 4), (0, 0, -90), top=0.5, segments=6, body=None)
        m.b.ellipsoid("RedPaint", (3, 7, 7), (0, neck * 1.3, head_z + tall * 0.18), segments=6, body=None)
    else:
        for x in (-1, 1):
            m.b.ellipsoid(
                coat,
                (long_ * 0.07, long_ * 0.05, tall * 0.14),
                (x * long_ * 0.08, neck * 1.15, head_z + tall * 0.15),
                segments=6,
                body=None,
            )
        m.b.tube(coat, [(0, -long_ * 0.42, leg + tall * 0.36), (0, -long_ * 0.5, leg + tall * 0.06)], long_ * 0.02)
        if kind in ("Cow",):
            for x in (-1, 1):
                m.b.ellipsoid("BlackPaint", (10, 60, 44), (x * long_ * 0.19, 8, leg + 12), segments=8, body=None)
    m.b.body_box((long_ * 0.4, long_ * 0.86, tall * 0.9))


@family("mound", flat=False)
def mound(m: KitMaker) -> None:
    """A flat-topped terrace of earth with sloping sides: things may stand on it."""
    of, wide, depth, high = m.opt("of", "Grass"), m.opt("width", 1600.0), m.opt("depth", 1200.0), m.opt("high", 120.0)
    m.say(
        f"{of}TerrainTerrace",
        GROUND,
        f"Terrace of {word(of)} with sloping sides, {high / 100:.1f} m high.",
        tags="terrain terrace hill ground",
    )
    s = high * 1.2
    m.b.add(
        of,
        hull(
            [
                (x * (wide / 2 - e), y * (depth / 2 - e), z)
                for x in (-1, 1)
                for y in (-1, 1)
                for e, z in ((0.0, 0.0), (s, high))
            ]
        ),
    )
    m.top(high, wide - 2 * s - 60, depth - 2 * s - 60)


@family("hill")
def hill(m: KitMaker) -> None:
    """A rounded hill or a mountain of the background."""
    of, wide, high = m.opt("of", "Grass"), m.opt("width", m.uni(2000, 3600, 100)), m.opt("high", m.uni(500, 1400, 50))
    m.say(
        "TerrainHill",
        GROUND,
        f"Rounded hill of {word(of)}, {wide / 100:.0f} m wide, {high / 100:.0f} m high.",
        camel(of),
        "Far",
        tags="terrain hill background landscape",
    )
    points = []
    for ring in range(5):
        r, z = wide / 2 * math.cos(ring * math.pi / 9), high * math.sin(ring * math.pi / 8)
        for k in range(14):
            a = k * math.pi / 7 + ring * 0.2
            points.append((r * math.cos(a) * m.uni(0.88, 1, 0.02), 0.7 * r * math.sin(a), z))
    m.b.add(of, hull(points))
