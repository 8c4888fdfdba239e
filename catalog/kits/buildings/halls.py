"""Halls, sheds, canopies and greenhouses."""

from __future__ import annotations

from catalog.kits.facade import BUILDINGS, door, gable_roof, window
from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull


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
