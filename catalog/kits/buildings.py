"""Houses, towers, halls and other buildings. Fronts look to +Y."""

from __future__ import annotations

import math

from catalog.kits.facade import battlements, chimney, door, facade, flat_roof, gable_roof, hip_roof, timbers, window
from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull

BUILDINGS = "buildings"


@family("house")
def house(m: KitMaker) -> None:
    """A dwelling of one to four storeys."""
    storeys = m.opt("storeys", m.pick(1, 2, 2, 3))
    width, depth = m.opt("width", m.uni(650, 1150, 50)), m.opt("depth", m.uni(600, 850, 50))
    floor, wall, roof = 285.0, m.mat("wall"), m.mat("roof")
    form = m.opt("form", m.pick("gable", "gable", "hip", "cross") if "Concrete" not in roof else "flat")
    noun = (
        m.pick("Cottage", "Bungalow") if storeys == 1 else m.pick("House", "Townhouse") if storeys < 3 else "Tenement"
    )
    if m.style.old:
        noun = m.pick("Cottage", "Longhouse") if storeys == 1 else m.pick("House", "TownHouse", "MerchantHouse")
    m.say(
        noun,
        BUILDINGS,
        f"{word(wall).capitalize()} house of {storeys} storeys with a {word(roof)} {form} roof, "
        f"{width / 100:.1f} x {depth / 100:.1f} m.",
        camel(wall),
        f"{camel(roof)}Roofed",
        tags="house building home",
    )
    m.b.box(wall, (width, depth, storeys * floor))
    m.b.box(m.mat("stone"), (width + 14, depth + 14, 40), body=None)
    facade(m, width, depth, storeys, floor)
    if m.style.ornate and wall.endswith("Plaster") and m.chance(0.6):
        timbers(m, width, depth, storeys, floor)
    top, rise = storeys * floor, depth * 0.42 * m.style.steep
    if form == "flat":
        flat_roof(m, width, depth, top)
    elif form == "hip":
        hip_roof(m, width, depth, top, rise * 0.9, roof)
    else:
        m.b.gable(wall, (depth, width, rise * 0.94), (0, 0, top), (0, 90, 0), body=None)
        gable_roof(m, width, depth, top, rise, roof)
        if form == "cross":
            with m.b.moved((m.pick(-1, 1) * width * 0.22, depth * 0.25, top)):
                m.b.gable(wall, (width * 0.32, depth * 0.52, rise * 0.8), (0, 0, 0), body=None)
                m.b.gable(roof, (width * 0.4, depth * 0.5, rise * 0.88), (0, -8, 0), body=None)
                window(m, 70, 80, (0, depth * 0.26, rise * 0.2))
    if form != "flat":
        chimney(m, (m.pick(-1, 1) * width * 0.3, -depth * 0.1, top + rise * 0.35), rise * 0.8)
    if m.opt("shop", False):
        awning(m, width * 0.8, depth / 2, 255)


def awning(m: KitMaker, width: float, y: float, z: float) -> None:
    """A sloped awning and a signboard over a shop window."""
    m.b.add(
        m.mat("awning"),
        hull(
            [
                (sx * width / 2, yy, zz)
                for sx in (-1, 1)
                for yy, zz in ((0.0, 0.0), (0.0, -6.0), (120.0, -50.0), (120.0, -56.0))
            ]
        ),
        (0, y, z),
        body=None,
    )
    m.b.box(m.mat("door"), (width, 8, 45), (0, y + 4, z + 8), body=None)


@family("shop")
def shop(m: KitMaker) -> None:
    """A narrow building of a street with a shop at its foot."""
    trade = m.opt(
        "trade",
        m.pick(
            "Bakery",
            "Bookshop",
            "Grocery",
            "Pharmacy",
            "Cafe",
            "FlowerShop",
            "BarberShop",
            "ShoeShop",
            "ToyShop",
            "Butchery",
            "Restaurant",
            "TeaHouse",
            "TailorShop",
            "Bank",
        ),
    )
    storeys = m.opt("storeys", m.pick(2, 3, 3, 4))
    width, depth, floor, wall = m.uni(650, 950, 50), m.opt("depth", 800.0), 300.0, m.mat("wall")
    m.say(
        trade,
        BUILDINGS,
        f"{word(wall).capitalize()} building of {storeys} storeys with a {trade.lower()} at street level, "
        f"{width / 100:.1f} m wide.",
        "",
        camel(wall),
        tags="shop building store",
    )
    m.b.box(wall, (width, depth, storeys * floor + 20))
    m.b.box(m.mat("door"), (width - 40, 10, 250), (0, depth / 2 + 2, 0), body=None)
    m.b.box(m.mat("window"), (width * 0.5, 10, 170), (-width * 0.16, depth / 2 + 5, 50), body=None)
    door(m, 100, 215, (width * 0.28, depth / 2 + 4, 0))
    awning(m, width - 60, depth / 2 + 6, 270)
    with m.b.moved((0, 0, floor)):
        facade(m, width, depth, storeys - 1, floor, doors=False)
    top = storeys * floor + 20
    if "Concrete" in m.mat("roof") or m.chance(0.35):
        flat_roof(m, width, depth, top)
    else:
        gable_roof(m, width - 58, depth, top, depth * 0.36 * m.style.steep, m.mat("roof"))
        chimney(m, (width * 0.3, -60, top + 100), 190)


@family("block")
def block(m: KitMaker) -> None:
    """A large building with many equal windows: flats, offices, a hotel, a school, a hospital."""
    use = m.opt("use", m.pick("ApartmentBlock", "OfficeBlock", "Hotel", "School", "Hospital"))
    storeys = m.opt("storeys", m.uni(3, 8, 1))
    width, depth, floor, wall = (
        m.opt("width", m.uni(1400, 2400, 100)),
        m.opt("depth", m.uni(1000, 1300, 100)),
        320.0,
        m.mat("wall"),
    )
    m.say(
        use,
        BUILDINGS,
        f"{word(wall).capitalize()} {word(use)} of {int(storeys)} storeys with a flat roof, "
        f"{width / 100:.0f} x {depth / 100:.0f} m.",
        camel(wall),
        tags="building block tall",
    )
    m.b.box(wall, (width, depth, storeys * floor))
    band = m.chance(0.5)
    for yaw, length, reach in ((0, width, depth), (180, width, depth), (90, depth, width), (-90, depth, width)):
        with m.b.moved((0, 0, 0), (0, yaw, 0)):
            for level in range(int(storeys)):
                z = level * floor + 100
                if band:
                    m.b.box(m.mat("window"), (length - 80, 8, 150), (0, reach / 2 + 1, z), body=None)
                    for i in range(int(length // 200) + 1):
                        m.b.box(
                            m.mat("trim"),
                            (14, 12, 150),
                            (-length / 2 + 40 + i * (length - 80) / int(length // 200), reach / 2 + 1, z),
                            body=None,
                        )
                else:
                    count = int(length // 280)
                    for i in range(count):
                        x = (i - (count - 1) / 2) * length / count
                        m.b.box(m.mat("trim"), (150, 6, 170), (x, reach / 2 + 1, z - 10), body=None)
                        m.b.box(m.mat("window"), (130, 9, 150), (x, reach / 2 + 1, z), body=None)
                m.b.box(
                    m.mat("trim"),
                    (length + 10, 8, 18),
                    (0, reach / 2 + 1, level * floor - 9 if level else 0),
                    body=None,
                )
    with m.b.moved((0, depth / 2, 0)):
        m.b.box(m.mat("trim"), (420, 160, 20), (0, 60, 280), body="box")
        m.b.box(m.mat("window"), (300, 12, 250), (0, 2, 0), body=None)
        for x in (-190, 190):
            m.b.box(m.mat("metal"), (14, 14, 280), (x, 125, 0))
    flat_roof(m, width, depth, storeys * floor)
    m.b.box("DarkConcrete", (350, 300, 220), (width * 0.2, 0, storeys * floor + 12), body="box")


@family("tower")
def tower(m: KitMaker) -> None:
    """A tower, round or square, with battlements or a spire."""
    round_ = m.opt("round", m.chance(0.5))
    height, radius, stone = m.opt("height", m.uni(900, 1700, 50)), m.opt("radius", m.uni(220, 340, 10)), m.mat("stone")
    spire = m.opt("spire", m.chance(0.6))
    roof = m.mat("roof")
    noun = (
        m.pick("WatchTower", "Tower", "Keep")
        if not spire
        else m.pick("SpireTower", "BellTower", "WizardTower" if m.style.name == "fantasy" else "StairTower")
    )
    m.say(
        noun,
        BUILDINGS,
        f"{'Round' if round_ else 'Square'} {word(stone)} tower, {height / 100:.0f} m high, with "
        f"{'a spire of ' + word(roof) if spire else 'battlements'}.",
        "Round" if round_ else "Square",
        camel(stone),
        tags="tower castle",
    )
    if round_:
        m.b.cylinder(stone, radius * 1.08, height, top=radius, segments=22)
        m.b.cylinder(stone, radius * 1.18, 60, (0, 0, height), segments=22)
    else:
        m.b.box(stone, (2 * radius, 2 * radius, height))
        m.b.box(stone, (2.24 * radius, 2.24 * radius, 60), (0, 0, height))
    for level in range(int(height // 400)):
        for yaw in (0, 90, 180, -90):
            with m.b.moved((0, 0, 0), (0, yaw, 0)):
                m.b.box(
                    m.mat("window"),
                    (40, 14, 110),
                    (0, radius * (1.03 if round_ else 1.0), 260 + 400 * level),
                    body=None,
                )
    door(m, 120, 220, (0, radius * (1.07 if round_ else 1.0), 0))
    if spire:
        rise = radius * 2.2 * m.style.steep
        m.b.cylinder(
            roof, radius * 1.3, rise, (0, 0, height + 60), top=0, segments=22 if round_ else 4, body="hull"
        ) if round_ else hip_roof(m, 2.2 * radius, 2.2 * radius, height + 60, rise, roof)
        m.b.cylinder(m.mat("metal"), 5, 120, (0, 0, height + 40 + rise), top=1, segments=8, body=None)
    elif round_:
        for i in range(12):
            a = i * math.pi / 6
            m.b.box(
                stone,
                (50, 40, 80),
                (radius * 1.08 * math.cos(a), radius * 1.08 * math.sin(a), height + 60),
                (0, math.degrees(a) + 90, 0),
                body=None,
            )
    else:
        battlements(m, stone, 2.24 * radius, 2.24 * radius, height + 60)


@family("church")
def church(m: KitMaker) -> None:
    """A church or chapel with a bell tower at its front."""
    wall, roof = m.mat("stone"), m.mat("roof")
    width, length, high = m.uni(700, 950, 50), m.uni(1400, 1900, 50), m.uni(550, 750, 50)
    m.say(
        m.pick("Church", "Chapel"),
        BUILDINGS,
        f"{word(wall).capitalize()} church with a bell tower in front and a {word(roof)} roof.",
        camel(wall),
        tags="church chapel building",
    )
    m.b.box(wall, (width, length, high))
    m.b.gable(roof, (width + 80, length + 50, width * 0.5 * m.style.steep), (0, 0, high))
    for side in (-90, 90):
        with m.b.moved((0, 0, 0), (0, side, 0)):
            for i in range(5):
                x = (i - 2) * length / 5
                m.b.box(m.mat("window"), (80, 8, 260), (x, width / 2, 160), body=None)
                m.b.box(wall, (50, 60, high * 0.9), (x + length / 10, width / 2 + 25, 0), body=None)
    with m.b.moved((0, length / 2 + 150, 0)):
        m.b.box(wall, (380, 320, high * 1.9))
        door(m, 150, 260, (0, 160, 0))
        for yaw in (0, 90, -90):
            with m.b.moved((0, 0, 0), (0, yaw, 0)):
                m.b.box("DarkStone", (90, 8, 150), (0, (160 if yaw == 0 else 190), high * 1.5), body=None)
        hip_roof(m, 340, 280, high * 1.9, 420 * m.style.steep, roof)


@family("hall")
def hall(m: KitMaker) -> None:
    """A large hall: a barn, a warehouse, a factory, a boat shed."""
    use = m.opt(
        "use",
        m.pick("Warehouse", "Workshop", "Factory", "Depot")
        if not m.style.old
        else m.pick("Barn", "Granary", "TitheBarn"),
    )
    wall, roof = m.opt("wall", m.mat("wall")), m.mat("roof")
    width, depth, high = (
        m.opt("width", m.uni(1200, 2200, 100)),
        m.opt("depth", m.uni(1000, 1500, 100)),
        m.opt("high", m.uni(450, 700, 50)),
    )
    saw = m.opt("saw", use == "Factory")
    m.say(
        use,
        BUILDINGS,
        f"{word(wall).capitalize()} {word(use)} with a wide gate{' and a sawtooth roof' if saw else ''}, "
        f"{width / 100:.0f} x {depth / 100:.0f} m.",
        camel(wall),
        tags="hall building large",
    )
    m.b.box(wall, (width, depth, high))
    if saw:
        teeth = max(3, int(width // 420))
        step = width / teeth
        for i in range(teeth):
            x = -width / 2 + i * step
            m.b.add(
                roof,
                hull(
                    [(x, sy * (depth / 2 + 10), high) for sy in (-1, 1)]
                    + [(x + step, sy * (depth / 2 + 10), high) for sy in (-1, 1)]
                    + [(x + step, sy * (depth / 2 + 10), high + 220) for sy in (-1, 1)]
                ),
                body=None,
            )
            m.b.box(m.mat("window"), (4, depth - 60, 150), (x + step + 2, 0, high + 40), body=None)
        m.b.body_box((width, depth, 200), (0, 0, high))
    else:
        m.b.gable(wall, (depth, width, depth * 0.28), (0, 0, high), (0, 90, 0), body=None)
        gable_roof(m, width, depth, high, depth * 0.3 * m.style.steep, roof)
    m.b.box(m.mat("trim"), (420, 12, high * 0.74), (0, depth / 2 + 2, 0), body=None)
    for side in (-1, 1):
        m.b.box(m.mat("door"), (190, 16, high * 0.7), (side * 97, depth / 2 + 2, 0), body=None)
    count = int(width // 300)
    for i in range(count):
        x = (i - (count - 1) / 2) * width / count
        if abs(x) > 300:
            window(m, 120, 100, (x, depth / 2, high * 0.5))
        window(m, 120, 100, (x, -depth / 2, high * 0.5), 180)


@family("shed")
def shed(m: KitMaker) -> None:
    """A small hut."""
    use = m.opt("use", m.pick("ToolShed", "Hut", "GuardHut", "Woodshed", "FishingHut", "GardenShed", "Sauna"))
    wall = m.opt("wall", m.pick("Planks", "DarkPlanks", "GreyPlanks", "RedBoards", "GreenBoards", "PalePlanks"))
    width, depth, roof = m.uni(260, 420, 20), m.uni(240, 360, 20), m.mat("roof")
    m.say(
        use,
        BUILDINGS,
        f"Small {word(use)} of {word(wall)} with a {word(roof)} roof, {width / 100:.1f} x {depth / 100:.1f} m.",
        camel(wall),
        tags="shed hut small building",
    )
    m.b.box(wall, (width, depth, 230))
    m.b.gable(wall, (width, depth, width * 0.4), (0, 0, 230), body=None)
    m.b.gable(roof, (width + 60, depth + 50, width * 0.44), (0, 0, 228))
    door(m, 85, 195, (-width * 0.16, depth / 2, 0))
    window(m, 55, 60, (width * 0.28, depth / 2, 110))


@family("kiosk")
def kiosk(m: KitMaker) -> None:
    """A kiosk with a counter and a striped canopy."""
    use = m.opt("use", m.pick("IceCreamKiosk", "NewsKiosk", "TicketBooth", "CoffeeKiosk", "SnackKiosk", "FlowerKiosk"))
    paint = m.mat("paint")
    m.say(
        use,
        BUILDINGS,
        f"{word(paint).capitalize()} {word(use)} with a serving hatch and a canopy, 2.6 m wide.",
        camel(paint),
        tags="kiosk booth stand",
    )
    m.b.box(paint, (260, 220, 100))
    m.b.box(m.mat("trim"), (280, 40, 6), (0, 118, 100), body=None)
    for x in (-122, 122):
        m.b.box(paint, (16, 220, 150), (x, 0, 100))
    m.b.box(paint, (228, 14, 150), (0, -103, 100))
    m.b.box(m.mat("trim"), (300, 260, 14), (0, 0, 250))
    m.b.box(m.mat("awning"), (270, 90, 8), (0, 150, 236), (0, 0, -18), body=None)
    m.b.box(m.mat("door"), (200, 10, 46), (0, 112, 264), body=None)
    for i in range(4):
        m.b.box(m.another("paint"), (30, 30, 34), (-80 + 50 * i, 60, 106), body=None)


@family("pavilion")
def pavilion(m: KitMaker) -> None:
    """An open roof on posts."""
    use = m.opt("use", m.pick("Pavilion", "Bandstand", "Gazebo", "Shelter"))
    wide, roof, post = m.opt("size", m.uni(400, 600, 50)), m.mat("roof"), m.mat("trim")
    m.say(
        use,
        BUILDINGS,
        f"Open {word(use)} with a {word(roof)} roof on posts, {wide / 100:.1f} m wide.",
        camel(roof),
        tags="pavilion open roof",
    )
    m.b.box(m.mat("stone"), (wide, wide, 18))
    for x in (-1, 1):
        for y in (-1, 1):
            m.b.cylinder(post, 12, 270, (x * (wide / 2 - 30), y * (wide / 2 - 30), 18), segments=10)
    hip_roof(m, wide - 20, wide - 20, 290, wide * 0.35 * m.style.steep, roof)


@family("canopy")
def canopy(m: KitMaker) -> None:
    """A platform roof on columns in a row."""
    length, metal = m.opt("length", 1000.0), m.mat("metal")
    m.say(
        "PlatformCanopy",
        BUILDINGS,
        f"Platform canopy of {word(metal)} on a row of columns, {length / 100:.0f} m long.",
        camel(metal),
        tags="canopy roof platform station",
    )
    for i in range(3):
        x = (i - 1) * length * 0.36
        m.b.cylinder(metal, 14, 330, (x, 0, 0), segments=12)
        for y in (-1, 1):
            m.b.tube(metal, [(x, 0, 250), (x, y * 130, 330)], 6)
    m.b.add(
        m.mat("roof"),
        hull(
            [
                (sx * length / 2, y, z)
                for sx in (-1, 1)
                for y, z in ((-240.0, 352.0), (0.0, 330.0), (240.0, 352.0), (-240.0, 366.0), (240.0, 366.0))
            ]
        ),
    )


@family("greenhouse")
def greenhouse(m: KitMaker) -> None:
    """A glass house with beds of plants."""
    width, depth = m.uni(500, 900, 50), m.uni(350, 500, 50)
    m.say(
        "Greenhouse",
        BUILDINGS,
        f"Glass greenhouse on a white frame, {width / 100:.1f} x {depth / 100:.1f} m.",
        m.pick("White", "Tall", "Old"),
        tags="greenhouse glass garden",
    )
    for x in range(int(width // 100) + 1):
        px = -width / 2 + x * width / int(width // 100)
        for side in (-1, 1):
            m.b.box("WhitePaint", (6, 6, 220), (px, side * depth / 2, 0), body=None)
            m.b.tube("WhitePaint", [(px, side * depth / 2, 220), (px, 0, 330)], 3)
    for side in (-1, 1):
        m.b.box("Glass", (width, 3, 180), (0, side * depth / 2, 40), body=None)
        m.b.box("Glass", (3, depth, 220), (side * width / 2, 0, 0), body=None)
        m.b.quad(
            "Glass",
            [
                (side * -width / 2, side * depth / 2, 220),
                (side * width / 2, side * depth / 2, 220),
                (side * width / 2, 0, 330),
                (side * -width / 2, 0, 330),
            ],
        )
        m.b.box("Soil", (width - 80, 90, 40), (0, side * (depth / 2 - 70), 0), body=None)
        for i in range(int(width // 80)):
            m.b.ellipsoid(
                m.another("leaf"),
                (60, 60, 50),
                (-width / 2 + 60 + i * 78, side * (depth / 2 - 70), 36),
                segments=8,
                body=None,
            )
    m.b.body_box((width, depth, 300))


@family("windmill")
def windmill(m: KitMaker) -> None:
    """A tower mill with four sails."""
    wall = m.opt("wall", m.pick("WhitePlaster", "RedBrick", "Fieldstone"))
    m.say(
        "Windmill",
        BUILDINGS,
        f"{word(wall).capitalize()} windmill with four sails that face the front.",
        camel(wall),
        tags="windmill mill building",
    )
    m.b.cylinder(wall, 320, 900, top=220, segments=20)
    m.b.lathe(m.mat("roof"), [(240, 0), (230, 60), (140, 200), (0, 260)], (0, 0, 900))
    door(m, 110, 210, (0, 316, 0))
    for z in (380, 640):
        m.b.box(m.mat("window"), (60, 12, 80), (0, 306 - z * 0.11, z), body=None)
    with m.b.moved((0, 285, 960)):
        m.b.cylinder("DarkOak", 14, 90, (0, -45, 0), (0, 0, 90), segments=8, body=None)
        for k in range(4):
            with m.b.moved((0, 40, 0), (45 + 90 * k, 0, 0)):
                m.b.box("DarkOak", (14, 10, 620), (0, 0, 0), body=None)
                m.b.box("WhiteSail", (110, 4, 460), (62, 0, 140), body=None)


@family("castle-wall")
def castle_wall(m: KitMaker) -> None:
    """A length of curtain wall with battlements and a walk."""
    length, stone = m.opt("length", 800.0), m.mat("stone")
    m.say(
        "CurtainWall",
        BUILDINGS,
        f"{word(stone).capitalize()} curtain wall with battlements, {length / 100:.0f} m long, 5 m high.",
        camel(stone),
        tags="wall castle battlement",
    )
    m.b.box(stone, (length, 140, 440))
    m.b.box(stone, (length, 36, 80), (0, 52, 440))
    for i in range(int(length // 100)):
        m.b.box(stone, (58, 36, 70), (-length / 2 + 50 + 100 * i, 52, 520), body=None)


@family("gatehouse")
def gatehouse(m: KitMaker) -> None:
    """A gate with a round arch between two short towers, open to pass."""
    stone = m.mat("stone")
    m.say(
        "Gatehouse",
        BUILDINGS,
        f"{word(stone).capitalize()} gatehouse with an open arch of 4 m between two square towers.",
        camel(stone),
        tags="gate castle entrance",
    )
    m.b.arch(stone, (520, 300, 640), (360, 430))
    battlements(m, stone, 520, 300, 640)
    for x in (-380, 380):
        with m.b.moved((x, 0, 0)):
            m.b.box(stone, (240, 400, 820))
            battlements(m, stone, 240, 400, 820)
            m.b.box("DarkStone", (30, 10, 120), (0, 200, 400), body=None)


@family("temple")
def temple(m: KitMaker) -> None:
    """A temple front: steps, columns all around, a low gable."""
    stone = m.mat("stone")
    width, depth = m.uni(900, 1300, 100), m.uni(1200, 1600, 100)
    m.say(
        m.opt("use", m.pick("Temple", "Shrine", "CourtHouse")),
        BUILDINGS,
        f"{word(stone).capitalize()} temple on three steps with columns all around.",
        camel(stone),
        tags="temple columns classical",
    )
    for i in range(3):
        m.b.box(stone, (width + 160 - 60 * i, depth + 160 - 60 * i, 20), (0, 0, 20 * i))
    for n, span, other, turn in ((6, width, depth, False), (7, depth, width, True)):
        for i in range(n):
            for side in (-1, 1):
                a, c = (i - (n - 1) / 2) * (span - 70) / (n - 1), side * (other - 70) / 2
                m.b.cylinder(
                    "Marble" if stone == "Limestone" else stone,
                    34,
                    430,
                    (c, a, 60) if turn else (a, c, 60),
                    top=28,
                    segments=14,
                )
    m.b.box(stone, (width - 300, depth - 300, 430), (0, 0, 60))
    door(m, 140, 300, (0, depth / 2 - 150, 60))
    m.b.box(stone, (width + 10, depth + 10, 70), (0, 0, 490))
    m.b.gable(m.mat("roof"), (width + 60, depth + 40, width * 0.22), (0, 0, 560))


@family("tent")
def tent(m: KitMaker) -> None:
    """A tent: round with a peak, or a ridge tent."""
    cloth = m.mat("awning")
    round_ = m.opt("round", m.chance(0.5))
    wide = m.opt("size", m.uni(360, 620, 20))
    m.say(
        m.opt("use", "RoundTent" if round_ else "RidgeTent"),
        BUILDINGS,
        f"{'Round' if round_ else 'Ridge'} tent of {word(cloth)}, {wide / 100:.1f} m wide.",
        camel(cloth),
        tags="tent canvas camp",
    )
    if round_:
        m.b.cylinder(cloth, wide / 2, 210, segments=18)
        m.b.cylinder(m.another("awning"), wide / 2 + 25, wide * 0.4, (0, 0, 205), top=4, segments=18)
        m.b.cylinder("Oak", 4, 90, (0, 0, 200 + wide * 0.4), segments=6, body=None)
        m.b.box("BlackCloth", (90, 8, 190), (0, wide / 2 - 4, 0), body=None)
    else:
        m.b.gable(cloth, (wide * 0.7, wide, wide * 0.5))
        m.b.add(
            "BlackCloth",
            hull(
                [
                    (-50.0, wide / 2 + 2, 0.0),
                    (50.0, wide / 2 + 2, 0.0),
                    (0.0, wide / 2 + 2, wide * 0.42),
                    (0.0, wide / 2 - 2, wide * 0.42),
                ]
            ),
            body=None,
        )


@family("lighthouse")
def lighthouse(m: KitMaker) -> None:
    """A lighthouse in bands of two colours."""
    m.say(
        "LighthouseTower",
        BUILDINGS,
        "Red and white lighthouse tower, 15 m high.",
        "RedWhite",
        tags="lighthouse tower beacon",
    )
    for i in range(6):
        m.b.cylinder(
            "WhitePaint" if i % 2 else "RedPaint", 230 - 18 * i, 200, (0, 0, 200 * i), top=212 - 18 * i, segments=20
        )
    m.b.cylinder("Iron", 170, 14, (0, 0, 1200), segments=20)
    m.b.cylinder("WarmGlow", 80, 120, (0, 0, 1214), segments=14)
    m.b.cylinder("RedPaint", 110, 110, (0, 0, 1334), top=10, segments=16)
    door(m, 100, 200, (0, 228, 0))


@family("bridge")
def bridge(m: KitMaker) -> None:
    """A level bridge of planks or stone along X with railings."""
    length, stone = m.opt("length", 800.0), m.opt("stone", m.pick("Planks", "Fieldstone", "Limestone", "DarkPlanks"))
    wide = m.opt("width", 300.0)
    m.say(
        "FootBridge",
        BUILDINGS,
        f"{word(stone).capitalize()} footbridge with railings, {length / 100:.0f} m long, {wide / 100:.0f} m wide.",
        camel(stone),
        tags="bridge crossing",
    )
    m.b.box(stone, (length, wide, 20), (0, 0, 0))
    for side in (-1, 1):
        y = side * (wide / 2 - 8)
        for i in range(int(length // 100) + 1):
            m.b.box(
                "DarkOak", (10, 10, 105), (-length / 2 + 6 + i * (length - 12) / int(length // 100), y, 20), body=None
            )
        m.b.box("DarkOak", (length, 9, 8), (0, y, 118), body=None)
        m.b.box("DarkOak", (length, 6, 6), (0, y, 72), body=None)
        m.b.body_box((length, 12, 105), (0, y, 20))
