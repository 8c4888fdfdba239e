"""Text scenes of times without engines: historical and fantasy places."""

from __future__ import annotations

import math

from cases.open190.districts import (
    border,
    castle,
    cemetery,
    enclosure,
    field,
    forest,
    frontage,
    garden,
    market,
    ring,
    waterfront,
)
from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


def goods(p: StagedPlace) -> list[str]:
    """What stands about in yards."""
    return [*p.kit("crate", 3), *p.kit("barrel", 3), *p.kit("sack", 3), *p.kit("handcart", 2)]


@scene("market-town", "text", "Medieval market town", styles.HISTORICAL, 130)
def market_town(p: StagedPlace) -> None:
    """Timbered houses around a cobbled market with a well, a church and a gate."""
    p.plate(130, "Grass")
    p.ground((-2600, -2200, 2600, 2200), "Cobble", tile=650, z=0.5)
    houses = p.kit("house", 8, storeys=2) + p.kit("house", 4, storeys=3)
    frontage(p, (2500, 2300), (-2500, 2300), houses, (0, 30))
    frontage(p, (-2500, -2300), (-420, -2300), houses[5:] + houses[:5], (0, 30))
    frontage(p, (420, -2300), (2500, -2300), houses[3:] + houses[:3], (0, 30))
    frontage(p, (-2700, 2200), (-2700, -2200), houses[::-1], (0, 60))
    frontage(p, (2700, -2200), (2700, 2200), houses[7:] + houses[:7], (0, 60))
    p.put(p.one("church"), -1500, 1150, yaw=180)
    p.put(p.one("gatehouse"), 0, -2650)
    market(p, (-800, -1700, 2300, -200), 7, 3, goods(p))
    p.put(p.one("well"), 300, 700)
    p.put(p.one("statue", kind="Figure"), 1500, 1200, yaw=180)
    ring(p, 300, 700, 420, p.kit("bench", 2, back=False), 6, face=-90)
    p.scatter((-2400, -2000, 2400, 2000), goods(p), 60, clear=40)
    p.scatter((-2400, -2000, 2400, 2000), p.kinds("animal", "Hen", "Dog", "Goat", "Horse"), 14, clear=40)
    p.row((-2300, -2050), (2300, -2050), p.kit("flag", 4, banner=True), 8)
    forest(p, (-6200, 3600, 6200, 6200), p.kit("tree", 5), 60, under=[*p.kit("bush", 3), *p.kit("rock", 3)], floor=60)
    for x in (-5200, 4200):
        field(p, (x - 900, -5800, x + 1300, -3400), p.random.choice(("Wheat", "Cabbage")), step=190)
    p.trail([(0, -6400), (0, -2850)], 420, "Cobble")
    p.palette(140, "house", "stall", "crate", "barrel", "fence", "tree", "animal", "sign", "cart", "shed", "forge")


@scene(
    "mountain-monastery",
    "text",
    "Mountain monastery",
    styles.HISTORICAL.but(
        wall=("WhitePlaster", "Limestone", "Sandstone"), roof=("BrownTile", "RedTile"), stone=("Limestone", "Sandstone")
    ),
    130,
)
def monastery(p: StagedPlace) -> None:
    """A cloister with a herb garden, a church on a terrace, vines, graves, a bell tower."""
    p.plate(130, "DryGrass")
    mound = p.put(p.one("mound", of="DryGrass", width=3400.0, depth=2600.0, high=150.0), 0, 3300)
    p.relate("on", p.put(p.one("church"), 0, 3300, 150.2, 180), mound)
    p.scatter((-1200, 2400, 1200, 2700), p.kit("bench", 2), 5, z=150.2, clear=40)
    p.put(p.one("stairs", width=500.0, steps=9), 0, 1780, yaw=180)
    enclosure(
        p, (-2800, -2200, 2800, 1500), p.kit("wall", 2, stone="Limestone", high=180.0), gate=p.one("gate", width=360.0)
    )
    halls = p.kit("house", 4, storeys=2, depth=600.0)
    frontage(p, (-2700, 1400), (-2700, -1800), halls, (20, 60))
    frontage(p, (2700, -1800), (2700, 1400), halls[::-1], (20, 60))
    columns = p.kit("column", 2, broken=False, height=380.0)
    for x in range(-1500, 1501, 300):
        for y in (-1300, 1100):
            p.put(columns, x, y)
    for y in range(-1000, 1000, 300):
        for x in (-1500, 1500):
            p.put(columns, x, y)
    garden(
        p,
        (-1250, -1050, 1250, 850),
        beds=3,
        centre=p.one("well"),
        hedge=False,
        benches=p.kit("bench", 2),
        trees=p.kit("tree", 2, height=480.0),
    )
    p.put(p.one("tower", round=False, spire=True, height=1400.0), -2100, 2300, yaw=180)
    cemetery(p, (1900, 2200, 3200, 3400), 5, 4)
    field(p, (-5800, -5600, -3200, -2600), "Vine", step=200)
    field(p, (3200, -5600, 5800, -2600), "Vine", step=200)
    p.row((-2600, 1650), (2600, 1650), p.kit("conifer", 3), 9)
    p.scatter((-2500, -2100, 2500, 1350), [*goods(p), *p.kit("planter", 3)], 30, clear=60)
    forest(
        p,
        (-6200, 1800, 6200, 6200),
        p.kit("conifer", 5),
        90,
        under=p.kit("rock", 6),
        floor=40,
        avoid=((-2600, 1500, 3400, 4800),),
    )
    p.trail([(0, -6400), (0, -2300)], 300, "Gravel")
    p.put(p.one("hill", of="Rock"), -4300, 5300)
    p.palette(110, "column", "statue", "tomb", "flowers", "tree", "bench", "fence", "planter", "barrel", "house")


@scene(
    "viking-harbour",
    "text",
    "Viking harbour",
    styles.HISTORICAL.but(
        wall=("DarkPlanks", "Planks", "GreyPlanks"),
        roof=("Thatch", "Shingle"),
        awning=("RedStripes", "BlueStripes"),
        trim=("DarkOak",),
    ),
    130,
)
def viking_harbour(p: StagedPlace) -> None:
    """Longhouses above a beach with longships, a smithy, drying racks and a palisade."""
    p.plate(130, "Grass")
    p.ground((-6400, 900, 6400, 1700), "Sand", tile=800, z=0.5)
    waterfront(
        p,
        -6400,
        6400,
        1700,
        deep=4700,
        boats=p.kit("boat", 3, kind="Longship") + p.kit("boat", 3, kind="RowingBoat"),
        jetties=4,
        gear=[*p.kit("barrel", 2), *p.kit("crate", 2)],
        wood="GreyPlanks",
    )
    houses = p.kit("house", 6, storeys=1, noun="Longhouse", width=1300.0, form="gable")
    for x in range(-5000, 5001, 2000):
        p.put(houses, x, -500 + p.uni(-100, 100), yaw=p.uni(-12, 12))
        p.put(houses, x + 400, -2300 + p.uni(-200, 200), yaw=p.uni(-25, 25))
    p.put(p.one("hall", use="MeadHall", width=2200.0, depth=1000.0), 0, -4200, yaw=0)
    border(p, (-6300, -5600), (6300, -5600), p.kit("fence", 2, kind="Plank"))
    for k, kind in enumerate(("ForgeHearth", "Anvil", "Bellows", "Grindstone", "Cauldron", "Sawhorse")):
        p.put(p.one("forge", kind=kind), -2300 + 280 * k, -3400, yaw=180)
    p.row(
        (-5800, 1250),
        (5800, 1250),
        p.kinds("boat-gear", "FishRack", "NetHeap", "OarRack", "RopeCoil", "Anchor", "LobsterPot"),
        20,
        jitter=60,
    )
    ring(p, 2600, -3700, 380, p.kinds("log", "FallenLog"), 5, face=0)
    p.put(p.one("forge", kind="Cauldron"), 2600, -3700)
    p.scatter(
        (-5800, -3200, 5800, 700),
        [*goods(p), *p.kinds("log", "Firewood", "WoodPile"), *p.kinds("animal", "Goat", "Hen", "Dog", "Sheep")],
        90,
        clear=50,
    )
    p.row((-6000, 780), (6000, 780), p.kit("flag", 4, banner=True), 9)
    forest(p, (-6300, -6300, 6300, -4900), p.kit("conifer", 6), 60)
    p.palette(95, "boat", "boat-gear", "crate", "barrel", "house", "forge", "tent", "log", "animal", "rock")


@scene(
    "caravanserai",
    "text",
    "Desert caravanserai",
    styles.HISTORICAL.but(
        wall=("SandPlaster", "Clay", "OchrePlaster"),
        roof=("DarkConcrete",),
        stone=("Sandstone",),
        leaf=("PaleLeaf",),
        awning=("RedStripes", "BlueStripes", "YellowStripes", "TealCloth"),
    ),
    130,
)
def caravanserai(p: StagedPlace) -> None:
    """A walled inn of sandstone with an arcade, a bazaar, tents, palms and a pool."""
    p.plate(130, "Sand")
    castle(
        p,
        (-3000, -2600, 3000, 2600),
        towers=p.kit("tower", 2, round=True, spire=False, height=900.0, radius=260.0),
        gatehouse=p.one("gatehouse"),
        wall=p.one("castle-wall", length=700.0),
    )
    p.ground((-1700, -1500, 1700, 1500), "Flagstone", tile=600, z=0.5)
    houses = p.kit("house", 6, storeys=2, form="flat", depth=600.0)
    frontage(p, (-2650, 2200), (-2650, -2050), houses, (10, 40))
    frontage(p, (2650, -2050), (2650, 2200), houses[::-1], (10, 40))
    p.ground((-500, -400, 500, 400), family="water", tile=500, z=1.0)
    ring(p, 0, 0, 850, p.kit("palm", 3), 8)
    market(p, (-1600, -1450, 1600, -650), 7, 2, [*p.kit("sack", 3), *p.kit("crate", 2), *p.kit("handcart", 2)])
    for x in (-1000, 0, 1000):
        p.put(p.kit("tent", 3, round=True), x, 1300, yaw=180)
    p.row((-1500, 800), (1500, 800), [*p.kit("rug", 3), *p.kit("sack", 2)], 8)
    p.row((-1600, 2150), (1600, 2150), p.kit("column", 2, broken=False, height=380.0), 11)
    p.scatter((-2000, -1900, 2000, 2000), [*goods(p), *p.kinds("animal", "Donkey", "Horse", "Goat")], 60, clear=50)
    for x, y in ((-4700, -3600), (-4300, 900), (4600, -800), (4300, 3900), (-4800, 4400)):
        ring(p, x, y, 500, p.kit("tent", 5), 5)
        p.put(p.kit("cart", 2), x, y, yaw=p.uni(0, 360))
    p.scatter(
        (-6300, -6300, 6300, 6300),
        [*p.kit("palm", 3), *p.kit("rock", 5), *p.kit("flowers", 1, kind="TallGrass")],
        110,
        clear=120,
        avoid=((-3400, -3000, 3400, 3000), (-350, -6400, 350, -2500)),
    )
    p.trail([(0, -6400), (0, -1600)], 400, "RedSand")
    p.palette(120, "tent", "stall", "palm", "rock", "house", "barrel", "crate", "sack", "column", "animal", "planter")


@scene(
    "windmill-village",
    "text",
    "Windmill village",
    styles.HISTORICAL.but(wall=("RedBrick", "WhiteBoards", "GreenBoards"), trim=("WhitePaint",), old=False),
    200,
)
def windmill_village(p: StagedPlace) -> None:
    """Mills along a canal, fields of tulips in coloured rows, brick houses, a bridge."""
    p.plate(200, "Grass")
    p.ground((-9900, -600, 9900, 200), family="water", tile=800, z=0.6)
    mills = p.kit("windmill", 3)
    for x in range(-8000, 8001, 3200):
        p.put(mills, x, 900, yaw=p.uni(-30, 30) + 180)
    for x in (-4800, 0, 4800):
        p.put(p.one("bridge", length=1000.0, width=320.0), x, -200, yaw=90)
    houses = p.kit("house", 9)
    frontage(p, (-7000, -2300), (7000, -2300), houses, (200, 500))
    p.trail([(-9800, -1150), (9800, -1150)], 300, "RedPaving")
    for k, x0 in enumerate((-9000, -4600, 600, 5000)):
        for strip in range(8):
            kind = ("Tulip", "YellowTulip", "PinkTulip", "Lavender")[(k + strip) % 4]
            y0 = 2200 + 820 * strip
            field(p, (x0, y0, x0 + 3900, y0 + 800), kind, soil="DarkSoil", step=180)
    p.row((-9500, -850), (9500, -850), p.kit("tree", 3, height=600.0), 26, scale=(0.6, 0.8))
    p.row((-9000, -1450), (9000, -1450), p.kit("streetlamp", 2), 14)
    for x in (-6400, -2500, 2600, 6500):
        p.put(p.kit("boat", 3, kind="Barge") + p.kit("boat", 2, kind="RowingBoat"), x, -200)
    market(p, (-1500, -5000, 1500, -4200), 6, 2, goods(p))
    p.put(p.one("church"), 0, -6500, yaw=0)
    p.scatter(
        (-9000, -9500, 9000, -3500),
        [*p.kinds("animal", "Cow", "Sheep", "Horse"), *p.kit("tree", 3), *p.kit("bush", 3)],
        130,
        clear=150,
        avoid=((-1800, -7600, 1800, -3900),),
    )
    p.scatter(
        (-9000, -1650, 9000, -1250), [*p.kit("bicycle", 4), *p.kit("bench", 3), *p.kit("planter", 4)], 50, clear=60
    )
    p.palette(150, "house", "windmill", "flowers", "boat", "bicycle", "animal", "fence", "tree", "shed", "crop", "sign")


@scene(
    "vineyard",
    "text",
    "Vineyard estate",
    styles.HISTORICAL.but(
        wall=("OchrePlaster", "PinkPlaster", "CreamPlaster"),
        roof=("OrangeTile", "RedTile"),
        stone=("Sandstone", "Limestone"),
    ),
    200,
)
def vineyard(p: StagedPlace) -> None:
    """A villa with a formal garden on an avenue of cypresses, vines in long rows, a winery."""
    p.plate(200, "DryGrass")
    p.put(p.one("block", use="Villa", storeys=2.0, width=2200.0, depth=1200.0), 0, 3000, yaw=180)
    garden(
        p,
        (-2000, 200, 2000, 1900),
        beds=3,
        centre=p.one("fountain", radius=260.0),
        benches=p.kit("bench", 3),
        trees=p.kit("tree", 3, height=500.0),
    )
    p.trail([(0, -9800), (0, 100)], 400, "Gravel")
    for side in (-1, 1):
        p.row((side * 420, -9600), (side * 420, -100), p.kit("conifer", 3), 22)
        for y0 in (-9300, -6200, -3100):
            field(p, (side * 5400 - 4200, y0, side * 5400 + 4200, y0 + 2700), "Vine", step=300)
        p.put(p.kit("statue", 3), side * 900, 2200, yaw=180)
    p.put(p.one("hall", use="Winery", width=2000.0, depth=1100.0), -5000, 2600, yaw=180)
    p.put(p.one("hall", use="CaskHouse", width=1500.0, depth=900.0), 4800, 2700, yaw=180)
    p.ground((-6400, 300, -3200, 1800), "Gravel", tile=800, z=0.5)
    p.grid((-6100, 500, -3600, 1200), [*p.kit("barrel", 4, kind="WineCask")], 9, 4, jitter=20)
    p.row((-6200, 1650), (-3400, 1650), p.kit("cart", 4), 4)
    p.put(p.one("forge", kind="WinePress"), 3900, 1500)
    p.scatter((3300, 400, 6400, 1800), goods(p), 40, clear=40)
    enclosure(p, (-2600, 4300, 2600, 6500), p.kit("wall", 2, high=150.0), gate=p.one("gate"))
    p.grid((-2200, 4700, 2200, 6100), p.kit("tree", 4, height=450.0, leaf="PaleLeaf"), 8, 4, jitter=40)
    forest(p, (-9700, 7000, 9700, 9700), p.kit("tree", 5), 90)
    p.palette(
        130,
        "barrel",
        "crate",
        "statue",
        "planter",
        "tree",
        "conifer",
        "house",
        "flowers",
        "handcart",
        "column",
        "fence",
        "arbour",
    )


@scene(
    "roman-forum",
    "text",
    "Roman forum",
    styles.HISTORICAL.but(
        wall=("Sandstone", "CreamPlaster"),
        roof=("OrangeTile", "RedTile"),
        stone=("Limestone", "Marble", "Sandstone"),
        awning=("RedCloth", "YellowStripes"),
    ),
    130,
)
def roman_forum(p: StagedPlace) -> None:
    """Temples and colonnades around a paved forum with statues, stalls and an obelisk."""
    p.plate(130, "DryGrass")
    p.ground((-3600, -2800, 3600, 2800), "Flagstone", tile=700, z=0.5)
    for x, y, yaw in ((0, 3900, 180), (-4700, 900, -90), (4700, 900, 90)):
        p.put(p.kit("temple", 3, use="Temple"), x, y, yaw=yaw)
    whole = p.kit("column", 3, broken=False, height=460.0)
    for side in (-1, 1):
        p.row((side * 3300, -2600), (side * 3300, 2600), whole, 14)
        p.row((side * 2900, -2600), (side * 2900, 2600), whole, 14)
    p.row((-2600, -2650), (2600, -2650), whole, 13)
    p.put(p.one("statue", kind="Obelisk"), 0, 0)
    p.put(p.one("fountain"), -1500, 1200)
    p.put(p.one("fountain"), 1500, 1200)
    p.row((-2200, 2500), (2200, 2500), p.kit("statue", 6), 9, yaw=180)
    market(p, (-2200, -1900, 2200, -500), 7, 3, [*p.kit("sack", 3), *p.kit("crate", 3)])
    p.row((-2400, 700), (2400, 700), [*p.kit("bench", 2, back=False), *p.kit("planter", 3)], 10)
    frontage(p, (-6000, -4600), (6000, -4600), p.kit("house", 7), (60, 200))
    p.put(p.one("ruin-wall", length=700.0), -5400, -1600, yaw=80)
    p.scatter(
        (-3300, -2500, 3300, 2400),
        [*p.kit("crate", 2), *p.kit("sack", 3), *p.kit("handcart", 2), *p.kinds("animal", "Dog", "Donkey")],
        35,
        clear=60,
    )
    p.scatter(
        (-6200, -4300, -3900, 6000),
        [*p.kit("conifer", 3), *p.kit("column", 4, broken=True), *p.kit("rubble", 3), *p.kit("bush", 3)],
        50,
        clear=60,
    )
    p.scatter(
        (3900, -4300, 6200, 6000),
        [*p.kit("conifer", 3), *p.kit("column", 4, broken=True), *p.kit("rubble", 3), *p.kit("bush", 3)],
        50,
        clear=60,
    )
    p.palette(100, "column", "statue", "temple", "stall", "rubble", "conifer", "planter", "ruin-wall", "bench", "house")


@scene("wizard-village", "text", "Wizard village", styles.FANTASY, 130)
def wizard_village(p: StagedPlace) -> None:
    """Crooked towers and violet roofs among giant mushrooms, crystals and lantern stalls."""
    p.plate(130, "Grass")
    p.put(p.one("tower", round=True, spire=True, height=1700.0), 0, 2600, yaw=180)
    ring(p, 0, -400, 2300, p.kit("house", 8), 10, face=90, start=18)
    ring(p, 0, -400, 4300, [*p.kit("tower", 4, spire=True), *p.kit("house", 5)], 13, face=90)
    p.ground((-1200, -1600, 1200, 800), "Cobble", tile=600, z=0.5)
    p.put(p.one("fountain"), 0, -400)
    ring(p, 0, -400, 620, p.kinds_of("stall", "ware", "Spice", "Book", "Flower", "Fruit", "Pottery"), 7, face=-90)
    ring(p, 0, -400, 1050, p.kit("streetlamp", 3, kind="Lantern"), 10)
    for yaw in range(0, 360, 72):
        p.trail(
            [(0, -400), (5200 * math.cos(math.radians(yaw)), -400 + 5200 * math.sin(math.radians(yaw)))],
            240,
            "Flagstone",
            z=1.2,
        )
    p.scatter(
        (-6200, -6200, 6200, 6200),
        [*p.kit("mushroom", 6, crystal=False), *p.kit("mushroom", 3, crystal=True)],
        80,
        clear=90,
        avoid=((-1300, -1700, 1300, 900),),
    )
    p.scatter(
        (-1100, -1500, 1100, 700),
        [*p.kinds("forge", "Cauldron"), *p.kit("crate", 3), *p.kit("barrel", 3), *p.kit("flag", 4)],
        24,
        clear=40,
    )
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 6),
        110,
        under=[*p.kit("bush", 3), *p.kit("flowers", 5), *p.kit("rock", 3)],
        floor=120,
        avoid=((-2900, -3300, 2900, 2500),),
    )
    p.palette(
        125,
        "house",
        "tower",
        "mushroom",
        "tree",
        "stall",
        "flag",
        "crate",
        "barrel",
        "statue",
        "rock",
        "tent",
        "flowers",
    )


@scene(
    "crystal-camp",
    "text",
    "Crystal miners' camp",
    styles.FANTASY.but(stone=("DarkStone", "Granite"), leaf=("VioletLeaf", "DarkLeaf")),
    130,
)
def crystal_camp(p: StagedPlace) -> None:
    """Tents around a fire, carts of rock, crystals in a ring of boulders, a palisade."""
    p.plate(130, "Cinder")
    ring(p, 0, 0, 1400, p.kit("tent", 6), 9, face=90)
    p.put(p.one("forge", kind="Cauldron"), 0, 0)
    ring(p, 0, 0, 420, p.kinds("log", "FallenLog"), 5, face=0)
    ring(p, 0, 0, 2300, p.kit("flag", 4, banner=True), 12)
    for x, y in ((-3800, 2400), (3600, 2600), (3700, -2500), (-3600, -2700)):
        ring(p, x, y, 700, p.kit("rock", 6), 9, jitter=80)
        p.scatter((x - 420, y - 420, x + 420, y + 420), p.kit("mushroom", 4, crystal=True), 12, clear=20)
        ring(p, x, y, 1150, [*p.kit("handcart", 3, load="Rock"), *p.kit("crate", 3), *p.kit("barrel", 2)], 8)
    p.put(p.one("crane", kind="TreadwheelCrane"), 2600, 0)
    p.put(p.one("tower", round=False, spire=False, height=900.0), -2700, 0)
    p.row((-900, 2600), (900, 2600), p.kinds("forge", "ForgeHearth", "Anvil", "Grindstone", "Bellows"), 6)
    p.scatter(
        (-2400, -2400, 2400, 2400),
        [*goods(p), *p.kinds("works", "Ladder", "Wheelbarrow", "PlankStack"), *p.kinds("log", "Firewood")],
        70,
        clear=50,
    )
    for a, b in (((-6200, -6200), (6200, -6200)), ((-6200, 6200), (6200, 6200))):
        border(p, a, b, p.kit("fence", 2, kind="Plank"), opening=600)
    p.scatter(
        (-6200, -6000, 6200, 6000),
        [*p.kit("rock", 6), *p.kit("tree", 4), *p.kit("mushroom", 3, crystal=False)],
        110,
        clear=100,
        avoid=((-3000, -3000, 3000, 3000),),
    )
    p.put(p.one("hill", of="Rock"), 0, 5000)
    p.palette(80, "tent", "mushroom", "rock", "crate", "barrel", "forge", "flag", "tree", "handcart")


@scene(
    "elf-river",
    "text",
    "River town of the elves",
    styles.FANTASY.but(
        wall=("WhitePlaster", "GreenPlaster", "TealPlaster"),
        roof=("GreenTile", "BlueTile"),
        leaf=("GoldenLeaf", "Leaf", "Blossom"),
        stone=("Limestone", "Marble"),
    ),
    200,
)
def elf_river(p: StagedPlace) -> None:
    """White houses with green spires on both banks, bridges, gardens and slender boats."""
    p.plate(200, "Grass")
    p.ground((-9900, -900, 9900, 900), family="water", tile=1000, z=0.6)
    for x in (-6000, 0, 6000):
        p.put(p.one("bridge", length=2000.0, width=400.0, stone="Limestone"), x, 0, yaw=90)
    houses = p.kit("house", 9)
    for side in (-1, 1):
        p.ground(
            (-9800, side * 1000 - (500 if side < 0 else 0), 9800, side * 1000 + (500 if side > 0 else 0)),
            "Paving",
            tile=500,
            z=0.5,
        )
        frontage(
            p,
            (9500, 2000) if side > 0 else (-9500, -2000),
            (-9500, 2000) if side > 0 else (9500, -2000),
            [*houses, *p.kit("tower", 3, spire=True)],
            (150, 400),
        )
        p.row(
            (-9500, side * 1080),
            (9500, side * 1080),
            [*p.kit("streetlamp", 2, kind="Lantern"), *p.kit("planter", 3)],
            24,
        )
        for x in (-7000, -2400, 2400, 7000):
            garden(
                p,
                (x - 1100, side * 5200 - 1000, x + 1100, side * 5200 + 1000),
                beds=2,
                centre=p.kit("fountain", 2)[side > 0],
                benches=p.kit("bench", 3),
                trees=p.kit("tree", 4),
            )
    p.row(
        (-8800, -450),
        (8800, 500),
        p.kit("boat", 3, kind="RowingBoat") + p.kit("boat", 3, kind="SailingBoat"),
        14,
        jitter=150,
    )
    p.put(p.one("temple", use="Shrine"), 0, 8000, yaw=180)
    p.row((-1500, 6700), (1500, 6700), p.kit("statue", 5), 6, yaw=180)
    forest(
        p,
        (-9800, -9800, 9800, 9800),
        p.kit("tree", 7),
        170,
        under=[*p.kit("flowers", 5), *p.kit("bush", 4)],
        floor=120,
        avoid=(
            (-9900, -3600, 9900, 3600),
            (-1500, 6400, 1500, 9500),
            (-8300, 4000, 8300, 6400),
            (-8300, -6400, 8300, -4000),
        ),
    )
    p.palette(
        160,
        "house",
        "tower",
        "tree",
        "boat",
        "statue",
        "fountain",
        "flowers",
        "bench",
        "planter",
        "flag",
        "mushroom",
        "stall",
    )


@scene(
    "war-camp",
    "text",
    "Army camp under a castle",
    styles.HISTORICAL.but(
        awning=("RedStripes", "BlueStripes", "YellowStripes", "GreenStripes"), stone=("Granite", "DarkStone")
    ),
    200,
)
def war_camp(p: StagedPlace) -> None:
    """Rows of striped tents with banners and fires before a castle with a gatehouse."""
    p.plate(200, "Grass")
    castle(
        p,
        (-3500, 3200, 3500, 8200),
        towers=p.kit("tower", 3, round=True, height=1300.0, radius=320.0),
        gatehouse=p.one("gatehouse"),
        wall=p.one("castle-wall", length=700.0),
    )
    p.put(p.one("tower", round=False, spire=True, height=1700.0, radius=450.0, noun="GreatKeep"), 0, 6500, yaw=180)
    frontage(p, (-3100, 7800), (-3100, 3700), p.kit("house", 4), (50, 150))
    for x in range(-8500, 8501, 1700):
        for y in (-8600, -6900, -5200, -3500):
            p.put(p.kit("tent", 8), x + p.uni(-150, 150), y + p.uni(-150, 150), yaw=p.uni(-20, 20))
            p.put(p.kit("flag", 5, banner=True), x + 430, y)
    for x in range(-7600, 7601, 3400):
        for y in (-7700, -4400):
            ring(p, x, y, 330, p.kinds("log", "FallenLog"), 3, face=0)
            p.put(p.kit("forge", 2, kind="Cauldron"), x, y)
    p.row((-7500, -1800), (7500, -1800), [*p.kit("cart", 4), *p.kit("handcart", 3)], 13, jitter=80)
    enclosure(p, (-8800, -1200, -4800, 1600), p.kit("fence", 2, kind="Rail"), gate=p.one("gate"))
    p.scatter((-8600, -1000, -5000, 1400), p.kit("animal", 4, kind="Horse"), 20, clear=60)
    for k in range(5):
        p.put(
            p.kinds("forge", "Anvil", "ForgeHearth", "Grindstone", "Bellows", "Sawhorse")[k], 5200 + 420 * k, 0, yaw=180
        )
    p.scatter((-8800, -9000, 8800, -1500), goods(p), 120, clear=60)
    p.trail([(0, -9800), (0, 3000)], 500, "Soil")
    forest(
        p,
        (-9800, 800, 9800, 9800),
        p.kit("tree", 5),
        150,
        under=p.kit("rock", 4),
        floor=50,
        avoid=((-4400, 600, 4400, 9000), (-9000, -1400, -4600, 1800), (4800, -400, 7600, 400)),
    )
    p.palette(105, "tent", "flag", "cart", "barrel", "crate", "forge", "tower", "tree", "animal", "sack")


@scene(
    "cemetery-hill",
    "text",
    "Cemetery with a chapel",
    styles.HISTORICAL.but(leaf=("AutumnLeaf", "GoldenLeaf", "DarkLeaf"), stone=("Granite", "MossyStone", "DarkStone")),
    130,
)
def cemetery_hill(p: StagedPlace) -> None:
    """Graves in rows inside a wall, a chapel, tombs, statues, autumn trees, an iron gate."""
    p.plate(130, "Grass")
    enclosure(p, (-5200, -4600, 5200, 4600), p.kit("wall", 2, high=140.0), gate=p.one("gate", width=400.0))
    p.trail([(0, -6400), (0, 2200)], 300, "Gravel")
    p.trail([(-5000, -400), (5000, -400)], 300, "Gravel", z=1.8)
    p.put(p.one("church"), 0, 3300, yaw=180)
    for side in (-1, 1):
        cemetery(p, (side * 2700 - 2100, -4100, side * 2700 + 2100, -1000), 9, 7)
        cemetery(p, (side * 3200 - 1600, 300, side * 3200 + 1600, 3900), 7, 8)
        p.row(
            (side * 330, -4300), (side * 330, 1800), [*p.kit("conifer", 2), *p.kit("streetlamp", 2, kind="Lantern")], 10
        )
        p.row((side * 600, -250), (side * 4800, -250), p.kit("bench", 3), 5, yaw=180)
    p.row((-4800, 4300), (4800, 4300), p.kit("statue", 5), 9, yaw=180)
    p.put(p.one("statue", kind="Obelisk"), 800, 900)
    p.put(p.one("shed", use="GraveDiggerHut"), -4700, -4100)
    p.scatter(
        (-5000, -4400, 5000, 4400),
        [*p.kit("tree", 5), *p.kit("bush", 3), *p.kit("flowers", 4), *p.kit("planter", 2)],
        90,
        clear=40,
        avoid=((-300, -4600, 300, 2400), (-5000, -650, 5000, -150)),
    )
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 5),
        90,
        avoid=((-5500, -4900, 5500, 4900), (-400, -6400, 400, -4000)),
    )
    p.palette(60, "tomb", "statue", "tree", "bench", "planter", "column", "flowers")
