"""The indoor source scenes."""

from __future__ import annotations

from cases.open190.districts import aisles, desks, rails
from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("tavern", "indoor", "Tavern common room", styles.HISTORICAL.but(wall=("CreamPlaster",), window=("AmberWindow",)))
def tavern(p: StagedPlace) -> None:
    """A timbered common room: hearth, bar with casks, long tables, snug corners."""
    p.room(
        (-700, -500, 700, 500),
        "Planks",
        wall="CreamPlaster",
        base="DarkPlanks",
        high=320,
        S=("Window", "Door", "Window"),
        E=("Plain", "Window"),
        W=("Window", "Plain"),
    )
    chairs, stools = p.kit("chair", 3, kind="Ladderback") + p.kit("chair", 2, kind="Windsor"), p.kit("stool", 3)
    tables = (
        p.kit("table", 2, kind="Long")
        + p.kit("table", 2, kind="Round")
        + p.kit("table", 1, kind="Square")
        + p.kit("table", 1, kind="Trestle")
    )
    dishes = p.kinds(
        "dish", "Tankard", "Mug", "Jug", "Plate", "Bowl", "Bread", "CheeseBoard", "Goblet", "Bottle", "Pie"
    ) + p.kit("dish", 6, kind="Tankard")
    candles = p.kinds("dish", "Candlestick")
    hearth = p.put(p.one("fireplace"), 0, 462, yaw=180)
    p.on(hearth, p.kinds("decor", "Vase", "Clock", "Figurine") + candles, 5)
    p.light(0, 390, 90, intensity=5000, colour=(255, 168, 90), radius=800)
    p.along(
        (-190, 499),
        (-690, 499),
        [p.one("cupboard", kind="Cabinet"), p.one("shelf", kind="Wood"), *p.kit("crate", 3, kind="Chest")],
        14,
    )
    bar = p.one("counter", kind="BarCounter", length=200.0)
    barrels, shelf = p.kit("barrel", 4), p.one("shelf", kind="Wood", depth=44.0)
    for y in (-330, -124, 82):
        counter = p.put(bar, 440, y, yaw=90)
        p.on(counter, dishes, 5)
        p.put(p.kit("stool", 2, high=75.0), 372, y - 45)
        p.put(p.kit("stool", 2, high=75.0), 372, y + 45)
    bottles = p.kit("dish", 5, kind="Bottle") + p.kit("dish", 3, kind="Jug") + p.kit("dish", 2, kind="Goblet")
    for y in (-270, -140, 140):
        p.stock(p.put(shelf, 674, y, yaw=90), bottles, 3)
    for y in (240, 330, 420):
        p.stack(barrels, 640, y, 2)
        p.put(barrels, 550, y + 20)
    for x, y, table, n, turn in (
        (-420, -280, tables[0], 6, 0),
        (-420, 40, tables[1], 6, 0),
        (-60, -330, tables[2], 5, 0),
        (40, 40, tables[3], 5, 0),
        (-480, 300, tables[4], 4, 0),
        (180, -180, tables[2], 5, 20),
        (-130, 215, tables[5], 6, 8),
    ):
        made = p.put(table, x, y, yaw=turn)
        p.around(made, chairs if n != 6 else [*stools, *chairs], n)
        p.middle(made, candles)
        p.on(made, dishes, 9 if n == 6 else 6)
        p.light(x, y, 180, intensity=1500, radius=600)
    p.along(
        (-699, 380),
        (-699, -480),
        [
            *p.kit("pew", 1, kind="PlainBench"),
            *p.kit("barrel", 2),
            p.one("decor", kind="Basket"),
            *p.kit("sack", 3),
            p.one("music", kind="Harp"),
            *p.kit("crate", 2),
        ],
        16,
    )
    p.put(p.one("lamp", kind="Candelabrum"), 320, 440)
    p.put(p.one("lamp", kind="Candelabrum"), -640, 440)
    p.put(p.one("rug", width=260.0, depth=160.0), 0, 370)
    for x in (-260, 260):
        p.put(
            p.one("room-wall", kind="Plain", length=24.0, high=320.0, wall="DarkOak", noun="OakPost"), x, 140, slack=1
        )
    p.scatter(
        (-660, -460, 400, 420),
        [*p.kit("animal", 1, kind="Dog"), *p.kit("animal", 1, kind="Cat"), *p.kit("sack", 2), *barrels],
        6,
    )
    p.beams((-700, -500, 700, 500), 320, 5, "DarkOak")
    p.sun(-35, -60, intensity=2.0, sky=0.55, colour=(255, 232, 200))
    p.view("door", (-60, -470, 165), (100, 420, 110), 82)
    p.view("bar", (-660, 200, 165), (500, -140, 90), 75)


@scene("supermarket", "indoor", "Supermarket", styles.URBAN.but(wall=("WhitePlaster",), trim=("GreyPaint",)))
def supermarket(p: StagedPlace) -> None:
    """Aisles of stocked shelves, freezers, fruit tables, checkouts."""
    p.room(
        (-2000, -1400, 2000, 1400),
        "LinoTiles",
        wall="WhitePlaster",
        high=400,
        S=("Shopfront", "Shopfront", "Door", "Shopfront"),
    )
    shelf = p.one("shelf", kind="Metal", boards=6, width=120.0, depth=46.0, high=200.0)
    goods = [
        p.kit("package", 4, kind=kind)
        for kind in (
            "CerealBoxes",
            "SoupTins",
            "SodaBottles",
            "JamJars",
            "TeaBoxes",
            "Detergent",
            "SpiceJars",
            "PaintTins",
            "ShoeBoxes",
        )
    ]
    count = aisles(p, (-1500, -480, 780, 1190), 6, shelf, goods, gap=3, share=0.97)
    p.row((-1300, 1250), (900, 1250), p.kit("service", 2, kind="FridgeDisplay"), 16, yaw=180)
    p.row((1000, -350), (1000, 950), p.kit("service", 2, kind="ChestFreezer"), 6)
    p.row((1350, -350), (1350, 950), p.kit("service", 2, kind="ChestFreezer"), 6)
    fruit = p.kinds("crate", "AppleCrate") + p.kit("crate", 3, kind="AppleCrate")
    stand = p.one("table", kind="Trestle", width=200.0, depth=90.0)
    for x in range(-1700, -1000, 330):
        for y in (-980, -700):
            table = p.put(stand, x, y)
            p.on(table, fruit, 5, yaw=0)
    p.row((1800, -800), (1800, 1000), p.kit("stall", 2, ware="Bread") + p.kit("stall", 1, ware="Cheese"), 5, yaw=0)
    checkouts = p.kit("service", 2, kind="Checkout")
    for x in range(-700, 900, 320):
        p.put(checkouts, x, -930, yaw=90)
        p.put(p.kit("stool", 1, high=75.0), x + 62, -990)
        p.put(p.kit("service", 3, kind="ShoppingCart"), x - 110, -820, yaw=90)
    p.row((-1700, -1250), (-900, -1250), p.kit("service", 3, kind="ShoppingCart"), 9, yaw=90)
    p.row((1100, -1330), (1900, -1330), p.kinds("service", "VendingMachine", "CashMachine", "PhotoBooth"), 4)
    p.row((900, -1150), (1700, -1150), p.kit("planter", 3), 4)
    p.scatter(
        (-1900, -1350, 1900, -500),
        [*p.kit("bin", 2), *p.kit("house-plant", 3), *p.kit("sign", 1, kind="InfoSign")],
        14,
        clear=50,
    )
    p.scatter((1500, 200, 1950, 1350), p.kit("pallet", 3, load="Boxes"), 5, clear=30)
    p.beams((-2000, -1400, 2000, 1400), 400, 9, "Steel", truss=True)
    for x in (-1300, -400, 500, 1400):
        for y in (-900, 100, 900):
            p.light(x, y, 370, intensity=4500, radius=1400, colour=(244, 248, 255))
    p.sun(-55, -70, intensity=1.6, sky=0.75)
    p.view("checkouts", (-1700, -1300, 175), (300, -400, 90), 75)
    p.view("aisle", (-1620, 40, 165), (600, 130, 120), 70)
    if count < 2000:
        p.left_out["goods"] += 1


@scene(
    "library",
    "indoor",
    "Old library",
    styles.HISTORICAL.but(
        wall=("CreamPlaster",), wood=("Walnut", "DarkOak", "Cherry"), cloth=("GreenCloth", "BrownLeather", "RedCloth")
    ),
)
def library(p: StagedPlace) -> None:
    """Bays of bookcases around reading tables with lamps and globes."""
    p.room(
        (-1200, -800, 1200, 800),
        "Parquet",
        wall="GreenPlaster",
        base="DarkPlanks",
        high=420,
        S=("Window", "Window", "Door", "Window"),
        N=("Window", "Plain"),
    )
    cases_ = p.kit("bookcase", 6)
    p.along((1199, 799), (-1199, 799), cases_, 3, fill=True)
    p.along((-1199, 700), (-1199, -700), cases_, 3, fill=True)
    p.along((1199, -700), (1199, 700), cases_, 3, fill=True)
    for x in (-900, -560, 560, 900):
        for y in (300, -330):
            p.along((x - 2, y - 170), (x - 2, y + 170), cases_, 2, fill=True)
            p.along((x + 2, y + 170), (x + 2, y - 170), cases_, 2, fill=True)
    books = (
        p.kinds("decor", "OpenBook", "BookStack", "Scroll", "PictureFrame", "Hourglass")
        + p.kit("decor", 4, kind="BookStack")
        + p.kit("decor", 3, kind="OpenBook")
    )
    tables, chairs = p.kit("table", 2, kind="Long", width=220.0, depth=100.0), p.kit("chair", 3, kind="Upholstered")
    for y in (-430, -150, 130, 410):
        for x in (-180, 180):
            table = p.put(tables, x, y)
            p.around(table, chairs, 6)
            p.middle(table, p.kit("lamp", 2, style=styles.DOMESTIC, kind="TableLamp"))
            p.on(table, books, 6)
    for x, y in ((-400, 620), (400, 620), (-380, -640), (380, -640)):
        p.put(p.kit("music", 2, kind="Globe"), x, y)
        p.put(p.kit("sofa", 3, seats=1), x + 110, y, yaw=90 if x > 0 else -90)
        p.on(p.put(p.kit("table", 1, kind="Small"), x - 95, y), books, 2)
    p.put(p.one("counter", kind="ReceptionDesk", length=300.0), 700, -660, yaw=180)
    p.row((-500, -745), (300, -745), p.kit("display", 3, kind="TableCase"), 4)
    p.row((-1000, -640), (1000, -640), p.kinds("works", "Ladder"), 2)
    for x, y in ((-200, 0), (200, 0), (0, 560)):
        p.put(p.one("rug", width=300.0, depth=200.0), x, y)
    p.scatter(
        (-1100, -780, 1100, 700),
        [*p.kit("house-plant", 3), *p.kit("statue", 2, kind="Bust"), *p.kit("lamp", 2, kind="Candelabrum")],
        14,
        clear=25,
    )
    p.beams((-1200, -800, 1200, 800), 420, 7, "DarkOak")
    for x in (-750, 0, 750):
        for y in (-300, 300):
            p.light(x, y, 300, intensity=3200, radius=1000, colour=(255, 220, 170))
    p.sun(-38, 100, intensity=2.4, sky=0.6)
    p.view("nave", (-60, -760, 170), (30, 500, 100), 80)
    p.view("bays", (-1080, 60, 170), (900, -60, 120), 75)


@scene("metro-station", "indoor", "Metro station", styles.TRANSIT)
def metro_station(p: StagedPlace) -> None:
    """Two platforms with trains, a concourse with gates and ticket machines."""
    p.room(
        (-3200, -1500, 3200, 1500),
        "WhiteTiles",
        wall="WhiteTiles",
        base="BlueTiles",
        high=480,
        module=800.0,
        S=("Plain", "Plain", "Arch", "Plain"),
    )
    cars = p.kit("train", 2, kind="MetroCar")
    for y in (380, 1180):
        rails(p, -3100, 3100, y, [cars[0]] * 4 if y > 1000 else [cars[1]] * 3, start=60 if y > 1000 else 1400, gap=25)
    deck = p.one("platform", length=800.0, wide=440.0, of="Paving")
    benches, bins = p.kit("pew", 2, kind="WaitingBench", length=240.0), p.kit("bin", 2)
    for i in range(8):
        x = -2800 + 800 * i
        item = p.put(deck, x, 780)
        p.relate("in_row", item)
        with p.at(x, 780):
            for y, things in ((0, benches),):
                made = p.put(things, -150, y + 30, 90.2)
                p.relate("on", made, item)
                made = p.put(things, -150, y - 30, 90.2, 180)
            p.put(bins, 120, 0, 90.2)
            p.put(p.kit("pillar", 2, kind="Square", of="WhiteTiles", high=380.0), 300, 0, 90.2)
            p.put(p.kit("service", 3, kind="VendingMachine"), 220, 0, 90.2) if i % 2 else p.put(
                p.kit("board", 1, kind="TimetableBoard"), 220, 0, 90.2
            )
            p.put(p.kit("ceiling-lamp", 2, high=300.0), 20, 0, 90.2)
    gates = p.kit("service", 2, kind="TicketGate")
    p.row((-1600, -350), (1600, -350), gates, 26, yaw=90)
    p.along(
        (-3150, -1490),
        (-700, -1490),
        [
            *p.kit("service", 3, kind="TicketMachine"),
            *p.kit("service", 2, kind="PhotoBooth"),
            *p.kit("service", 3, kind="VendingMachine"),
            *p.kit("service", 1, kind="CashMachine"),
        ],
        40,
        fill=True,
    )
    p.along(
        (900, -1490),
        (3150, -1490),
        [p.one("kiosk", use="NewsKiosk"), p.one("kiosk", use="CoffeeKiosk"), p.one("kiosk", use="FlowerKiosk")],
        120,
        fill=True,
    )
    p.grid((-2600, -1000, 2600, -1000), p.kit("pillar", 2, kind="Square", of="WhiteTiles", high=380.0), 9, 1)
    p.grid(
        (-2200, -750, 2200, -750),
        p.kit("board", 2, kind="TimetableBoard") + p.kit("board", 2, kind="PosterStand"),
        8,
        1,
    )
    p.row((-3180, -900), (-3180, -300), p.kit("stairs", 1, width=300.0), 1, yaw=180)
    p.scatter(
        (-3000, -1350, 3000, -500),
        [
            *benches,
            *bins,
            *p.kit("sign", 3, kind="InfoSign"),
            *p.kit("planter", 3),
            *p.kit("house-plant", 2),
            *p.kit("bicycle", 3),
            *p.kit("crate", 2, kind="CardboardBox"),
        ],
        90,
        clear=40,
    )
    p.scatter(
        (-3000, -250, 3000, 80),
        [*bins, *p.kit("works", 1, kind="TrafficCone"), *p.kit("works", 1, kind="Barrier"), *p.kit("bollard", 2)],
        50,
        clear=50,
    )
    p.row((-3100, 175), (3100, 175), p.kit("bollard", 2), 60)
    p.beams((-3200, -1500, 3200, 1500), 480, 11, "Steel", truss=True)
    for x in (-2400, -800, 800, 2400):
        for y in (-800, 300, 900):
            p.light(x, y, 420, intensity=6000, radius=1700, colour=(240, 246, 255))
    p.sun(-70, -90, intensity=0.9, sky=0.7)
    p.view("platform", (-2950, 800, 270), (600, 700, 190), 75)
    p.view("concourse", (-2950, -620, 175), (900, -420, 130), 75)


@scene(
    "museum",
    "indoor",
    "Museum of antiquities",
    styles.URBAN.but(wall=("CreamPlaster",), stone=("Limestone", "Granite", "Marble"), wood=("Walnut", "Oak")),
    slot=True,
)
def museum(p: StagedPlace) -> None:
    """Halls with show cases, statues, columns, a skeleton, benches and barriers."""
    p.room(
        (-1600, -1000, 1600, 1000),
        "Marble",
        wall="CreamPlaster",
        high=460,
        S=("Plain", "Window", "Arch", "Window"),
        N=("Plain", "Window"),
    )
    for x in (-530, 530):
        for y, kind in ((-800, "Plain"), (-400, "Arch"), (0, "Plain"), (400, "Arch"), (800, "Plain")):
            p.put(p.one("room-wall", kind=kind, length=396.0, high=460.0, wall="CreamPlaster"), x, y, yaw=90)
    cased = p.kit("display", 9, kind="TallCase")
    tables, pedestals = p.kit("display", 6, kind="TableCase"), p.kit("display", 9, kind="Pedestal")
    p.put(p.one("display", kind="SkeletonPlinth"), 0, 0)
    p.put(p.one("display", kind="SkeletonPlinth", noun="DinosaurSkeleton"), 0, 560, yaw=180)
    p.row((-420, -800), (420, -800), p.kit("column", 2, broken=False, height=400.0), 4)
    ring_posts = p.kit("bollard", 1, stone="Brass")
    for x in range(-300, 301, 100):
        p.put(ring_posts, x, -210)
        p.put(ring_posts, x, 210)
    for side in (-1, 1):
        with p.at(side * 1060, 0):
            p.grid((-330, -760, 330, 760), cased + tables, 3, 6, jitter=10)
            p.grid((-165, -620, 165, 620), p.kit("bench", 3, back=False), 2, 4)
            p.along((489, -980), (489, 980), pedestals, 34, fill=True) if side > 0 else p.along(
                (-489, 980), (-489, -980), pedestals, 34, fill=True
            )
    p.row((-1450, 930), (-650, 930), p.kit("statue", 5), 5, yaw=180)
    p.row((1450, 930), (650, 930), p.kit("statue", 5), 5, yaw=0)
    p.row((-400, 930), (400, 930), p.kit("statue", 3, kind="Figure"), 4, yaw=180)
    p.put(p.one("counter", kind="ReceptionDesk", length=300.0), 330, -640, yaw=180)
    p.grid((-1500, -930, 1500, -930), [*p.kit("board", 3, kind="PosterStand"), *p.kit("house-plant", 3)], 14, 1)
    p.scatter(
        (-480, -560, 480, -260),
        [*p.kit("board", 2, kind="PosterStand"), *p.kit("bench", 2, back=False), *p.kit("house-plant", 2)],
        9,
        clear=30,
    )
    p.scatter(
        (-1550, -900, 1550, 900),
        [*pedestals, *p.kit("music", 2, kind="Easel"), *p.kit("bench", 2, back=False)],
        40,
        clear=50,
    )
    p.beams((-1600, -1000, 1600, 1000), 460, 8, "WhitePaint")
    for x in (-1060, 0, 1060):
        for y in (-600, 0, 600):
            p.light(x, y, 380, intensity=3600, radius=1200, colour=(255, 244, 226))
    p.sun(-60, 60, intensity=2.0, sky=0.7)
    p.view("hall", (-20, -760, 170), (10, 300, 110), 78)
    p.view("gallery", (1480, -900, 170), (900, 500, 100), 75)


@scene(
    "hospital-ward",
    "indoor",
    "Hospital ward",
    styles.OFFICE.but(
        wall=("WhitePlaster",),
        cloth=("TealCloth", "BlueCloth", "Linen", "GreenCloth"),
        paint=("WhitePaint", "TealPaint", "SkyPaint", "GreyPaint"),
    ),
)
def hospital_ward(p: StagedPlace) -> None:
    """Bays of beds with screens, a nurses' station, a corridor with trolleys, a bathroom."""
    p.room(
        (-1600, -800, 1600, 800),
        "LinoTiles",
        wall="WhitePlaster",
        base="GreenTiles",
        S=("Window", "Window", "Plain"),
        N=("Window", "Plain", "Window"),
        W=("Plain", "Door"),
    )
    beds, screens = p.kit("cot", 3, kind="HospitalBed"), p.kit("care", 3, kind="BedScreen")
    stands, monitors, trolleys = (
        p.kit("care", 1, kind="DripStand"),
        p.kit("care", 2, kind="PatientMonitor"),
        p.kit("care", 3, kind="MedicineTrolley"),
    )
    nightstand, small = (
        p.kit("cupboard", 2, kind="Nightstand"),
        p.kinds("decor", "FlowerVase", "OpenBook", "Clock", "Radio") + p.kinds("dish", "Cup", "Bottle", "FruitBowl"),
    )
    for i in range(10):
        x = -1420 + 300 * i
        if i == 9:
            continue
        for side in (-1, 1):
            with p.at(x, side * 690, 180 if side > 0 else 0):
                p.put(beds, 0, 0)
                p.on(p.put(nightstand, 84, -78), small, 3)
                p.put(stands, -72, -60)
                p.put(monitors, -84, -10, yaw=-90) if i % 2 else p.put(p.kit("stool", 2), -84, 20)
                p.put(screens, 144, 20, yaw=90)
                p.put(p.kit("chair", 3, kind="Metal"), 84, 30, yaw=90)
    station = p.one("counter", kind="ReceptionDesk", length=200.0)
    things = p.kinds("desk-thing", "Monitor", "Telephone", "Binders", "PaperTray", "Mug", "Keyboard")
    for x in (-220, 0, 220):
        p.on(p.put(station, x, 110), things, 4)
        p.on(p.put(p.kit("desk", 1, kind="Office"), x, -90, yaw=180), things, 5)
        p.put(p.kit("chair", 2, kind="Shell"), x, 10, yaw=180)
    p.row((-1300, 0), (-500, 0), [*trolleys, *p.kit("care", 2, kind="Wheelchair")], 8, yaw=90)
    p.row(
        (500, 0),
        (1200, 0),
        [*trolleys, *p.kit("care", 2, kind="Wheelchair"), *p.kit("cot", 1, kind="HospitalBed")],
        5,
        yaw=0,
    )
    p.along((1340, 799), (1340, 300), p.kit("cupboard", 2, kind="Cabinet"), 5, fill=True)
    p.along(
        (1599, -700),
        (1599, 700),
        [
            *p.kit("cupboard", 2, kind="LockerRow"),
            *p.kit("shelf", 1, kind="Metal"),
            *p.kit("bath-thing", 2, kind="Washbasin"),
        ],
        22,
        fill=True,
    )
    p.scatter(
        (-1550, -420, 1550, 420),
        [*p.kit("bin", 2), *p.kit("house-plant", 3), *p.kit("sack", 1, kind="LaundryBasket"), *stands, *trolleys],
        26,
        clear=40,
    )
    for x in (-1200, -400, 400, 1200):
        p.light(x, 0, 270, intensity=3800, radius=1300, colour=(244, 250, 255))
    p.sun(-42, -60, intensity=2.6, sky=0.8)
    p.view("ward", (-1560, -60, 165), (600, 60, 80), 75)
    p.view("beds", (300, 330, 165), (-700, -700, 70), 75)


@scene(
    "school",
    "indoor",
    "School with four classrooms",
    styles.DOMESTIC.but(
        wall=("CreamPlaster", "GreenPlaster", "BluePlaster"),
        wood=("Birch", "Pine", "Oak"),
        paint=("RedPaint", "BluePaint", "GreenPaint", "YellowPaint", "OrangePaint"),
    ),
)
def school(p: StagedPlace) -> None:
    """Classrooms on both sides of a corridor with lockers, an art room and a music room."""
    p.room(
        (-1600, -1000, 1600, 1000),
        "LinoTiles",
        wall="CreamPlaster",
        S=("Window",),
        N=("Window",),
        W=("Plain", "Plain", "Door", "Plain", "Plain"),
    )
    for side in (-1, 1):
        for i in range(8):
            kind = "Door" if i % 4 == 3 else "Plain"
            p.put(
                p.one("room-wall", kind=kind, length=398.0, wall="CreamPlaster"),
                -1400 + 400 * i,
                side * 200,
                yaw=0 if side > 0 else 180,
            )
        p.put(p.one("room-wall", kind="Plain", length=784.0, wall="CreamPlaster"), 0, side * 602, yaw=90)
    books = (
        p.kit("desk-thing", 4, kind="Notebook")
        + p.kit("desk-thing", 3, kind="PencilCup")
        + p.kit("decor", 3, kind="BookStack")
        + p.kit("decor", 2, kind="OpenBook")
    )
    desk_, chairs = p.kit("desk", 3, kind="School"), p.kit("chair", 3, kind="Shell") + p.kit("chair", 2, kind="Metal")
    for x, y, up in ((-800, 600, 1), (800, 600, 1), (-800, -600, -1), (800, -600, -1)):
        with p.at(x, y):
            p.put(p.kit("board", 2, kind="Blackboard"), -690, 40 * up, yaw=-90)
            teacher = p.put(p.one("desk", kind="Writing"), -540, -120 * up, yaw=-90)
            p.on(teacher, [*books, *p.kinds("desk-thing", "Laptop", "Mug"), *p.kinds("decor", "PottedPlant")], 4)
            p.put(chairs, -610, -120 * up, yaw=-90)
            if (x, y) == (800, -600):
                p.grid((-250, -250, 600, 250), p.kit("music", 3, kind="Easel"), 5, 3, jitter=18, yaw=90)
                p.grid((-250, -150, 600, 330), p.kit("stool", 3), 5, 3, jitter=10)
            elif (x, y) == (800, 600):
                p.put(p.one("music", kind="GrandPiano"), 560, 180, yaw=90)
                p.put(p.one("music", kind="DrumKit"), 560, -220, yaw=90)
                p.grid((-250, -220, 300, 220), p.kit("music", 2, kind="MusicStand"), 5, 4, yaw=90)
                p.grid((-180, -220, 370, 220), chairs, 5, 4, yaw=90)
                p.row((-250, 330), (500, 330), p.kinds("music", "Harp", "Loudspeaker", "Piano"), 4, yaw=180)
            else:
                desks(p, (-330, -270, 560, 270), 6, 5, desk_, chairs, books, each=2, yaw=-90)
            p.along(
                (690, -380),
                (690, 380),
                [*p.kit("bookcase", 3), *p.kit("cupboard", 2, kind="Cabinet"), *p.kit("house-plant", 2)],
                8,
                fill=True,
                count=7,
            )
            p.put(p.kit("music", 2, kind="Globe"), -680, 250 * up)
            p.light(-300, 0, 270, intensity=3600, radius=1100, colour=(255, 248, 236))
            p.light(350, 0, 270, intensity=3600, radius=1100, colour=(255, 248, 236))
    lockers = p.kit("cupboard", 4, kind="LockerRow")
    p.along((-1150, -191), (-250, -191), lockers, 2, fill=True)
    p.along((450, -191), (1350, -191), lockers, 2, fill=True)
    p.along((1350, 191), (450, 191), lockers, 2, fill=True)
    p.along((-250, 191), (-1150, 191), lockers, 2, fill=True)
    p.row((-1000, 0), (1400, 0), [*p.kit("bench", 2, back=False), *p.kit("bin", 2), *p.kit("house-plant", 2)], 9)
    p.put(p.one("service", kind="VendingMachine"), 1540, 0, yaw=90)
    p.scatter((-1550, -180, 1550, 180), [*p.kit("crate", 2, kind="CardboardBox"), *p.kit("sack", 2, kind="Basket")], 8)
    p.sun(-40, 110, intensity=2.8, sky=0.75)
    p.view("classroom", (-130, 960, 175), (-1300, 400, 90), 78)
    p.view("corridor", (-1520, 60, 165), (800, -40, 110), 70)


@scene("office-floor", "indoor", "Open-plan office floor", styles.OFFICE, slot=True)
def office_floor(p: StagedPlace) -> None:
    """Bays of desks, meeting rooms behind glass, a kitchen and a lounge."""
    p.room(
        (-2000, -1200, 2000, 1200),
        "GreyCarpet",
        wall="WhitePlaster",
        S=("Window",),
        N=("Window",),
        E=("Plain", "Window"),
    )
    must = p.kit("desk-thing", 1, kind="Monitor")
    things = (
        p.kinds("desk-thing", "Keyboard", "Laptop", "Telephone", "Mug", "PencilCup", "PaperTray", "Binders", "Notebook")
        + p.kit("desk-thing", 3, kind="Mug")
        + p.kinds("decor", "PottedPlant", "PictureFrame", "BookStack")
        + p.kit("lamp", 2, kind="DeskLamp")
    )
    desk_, chairs = (
        p.kit("desk", 3, kind="Office"),
        p.kit("chair", 3, kind="Shell") + p.kit("chair", 2, kind="Upholstered"),
    )
    for bx in (-1550, -850, -150, 550):
        for by in (-800, -250):
            for side in (-1, 1):
                desks(
                    p,
                    (bx - 160, by + side * 40, bx + 160, by + side * 40),
                    3,
                    1,
                    desk_,
                    chairs,
                    things,
                    each=5,
                    yaw=0 if side > 0 else 180,
                    must=must,
                )
            p.put(p.kit("house-plant", 4), bx + 300, by)
            p.put(p.kit("cupboard", 3, kind="FilingCabinet"), bx - 290, by, yaw=90)
    glass = [p.one("room-wall", kind=kind, length=396.0) for kind in ("Glass", "Door")]
    for x in range(-1800, 1900, 400):
        p.put(glass[1] if x in (-1400, -200, 1000) else glass[0], x, 340)
    for x in (-1200, -400, 400, 1200):
        for y in (552, 952):
            p.put(glass[0], x, y, yaw=90)
    table, meeting = p.kit("table", 3, kind="Long", width=220.0, depth=100.0), p.kit("chair", 3, kind="Metal")
    for x in (-1600, -800, 0, 800, 1600):
        with p.at(x, 770):
            if abs(x) == 1600:
                for sy in (-150, 150):
                    p.put(p.kit("sofa", 4, seats=3), 0, sy, yaw=0 if sy < 0 else 180)
                p.put(p.kit("sofa", 3, seats=1), 190, 0, yaw=90)
                p.on(p.put(p.one("table", kind="Small"), 0, 0), things[3:], 3)
                p.put(p.one("rug", width=300.0, depth=200.0), 0, 0)
                p.stock(
                    p.put(p.one("shelf", kind="Wood"), 0, 390, yaw=180),
                    p.kinds("decor", "BookStack", "Vase", "PottedPlant") + things[6:8],
                    8,
                )
                continue
            made = p.put(table, 0, 0)
            p.around(made, meeting, 8)
            p.on(made, things[:8], 6)
            p.put(p.kit("board", 2, kind="Whiteboard"), 0, 370, yaw=180)
            p.put(p.kit("house-plant", 3), 150, 320)
    units = [
        p.one("kitchen-unit", kind=kind, paint="TealPaint")
        for kind in ("Fridge", "KitchenBase", "KitchenSink", "Dishwasher", "KitchenBase", "KitchenBase")
    ]
    for item in p.along((1999, -1150), (1999, -500), units, 1):
        p.on(
            item, p.kinds("desk-thing", "CoffeeMachine", "Microwave") + p.kinds("dish", "Cup", "Plate", "FruitBowl"), 3
        )
    for y in (-950, -650, -350):
        made = p.put(p.kit("table", 2, kind="Round"), 1550, y)
        p.around(made, meeting, 4)
        p.on(made, p.kinds("dish", "Cup", "Plate", "FruitBowl"), 4)
    p.along((1300, -1199), (1900, -1199), p.kinds("service", "VendingMachine") + p.kit("desk-thing", 0), 30)
    p.along(
        (-1999, 200),
        (-1999, -1100),
        [*p.kit("cupboard", 3, kind="LockerRow"), *p.kit("bookcase", 2), *p.kit("house-plant", 2)],
        12,
        fill=True,
    )
    p.along(
        (-1900, -1199),
        (1200, -1199),
        [
            *p.kit("cupboard", 3, kind="Sideboard"),
            *p.kit("house-plant", 4),
            *p.kit("board", 1, kind="Whiteboard"),
            *p.kit("cupboard", 3, kind="FilingCabinet"),
        ],
        60,
        fill=True,
    )
    for item in list(p.items.values()):
        if item.thing.noun == "Sideboard":
            p.on(item, p.kinds("desk-thing", "Printer", "Binders", "PaperTray") + p.kinds("decor", "FlowerVase"), 3)
    p.scatter((-1900, 120, 1900, 280), [*p.kit("bin", 3), *p.kit("house-plant", 4)], 16, clear=30)
    for x in (-1500, -500, 500, 1500):
        for y in (-700, 700):
            p.light(x, y, 270, intensity=4200, radius=1400, colour=(250, 250, 255))
    p.sun(-45, 60, intensity=2.6, sky=0.8)
    p.view("bays", (-1940, 60, 165), (300, -700, 90), 78)
    p.view("meeting", (1500, 180, 170), (-200, 900, 90), 75)


@scene("machine-shop", "indoor", "Machine shop", styles.INDUSTRIAL, slot=True)
def machine_shop(p: StagedPlace) -> None:
    """Machines in rows between marked ways, workbenches, racks, a forklift, pallets."""
    p.room(
        (-1800, -1100, 1800, 1100),
        "Concrete",
        wall="RedBrick",
        high=520,
        S=("Window", "Plain", "Door", "Plain"),
        N=("Window", "Plain"),
    )
    machines = (
        p.kinds(
            "machine",
            "Lathe",
            "MillingMachine",
            "DrillPress",
            "HydraulicPress",
            "BandSaw",
            "GrindingMachine",
            "CncMachine",
            "Compressor",
            "RobotArm",
            "PackingMachine",
        )
        + p.kit("machine", 3, kind="Lathe")
        + p.kit("machine", 3, kind="MillingMachine")
    )
    for j, y in enumerate((-700, -330, 330, 700)):
        p.row((-1500, y), (900, y), machines, 8, yaw=0 if j % 2 else 180)
        p.row(
            (-1330, y + (90 if j % 2 else -90)),
            (1050, y + (90 if j % 2 else -90)),
            [*p.kit("crate", 4), *p.kit("bin", 1), *p.kit("barrel", 3), *p.kit("stool", 2)],
            12,
            jitter=20,
        )
    belt = p.one("machine", kind="ConveyorBelt")
    for i in range(8):
        item = p.put(belt, -1350 + 302 * i, 0)
        p.on(item, [*p.kit("package", 3, kind="ToolBox"), *p.kit("crate", 1, kind="AppleCrate")], 3)
    bench, tools = (
        p.one("table", kind="Long", width=200.0, depth=80.0),
        p.kinds("package", "ToolBox", "PaintTins")
        + p.kinds("desk-thing", "Binders", "Telephone", "Mug")
        + p.kit("lamp", 2, kind="DeskLamp")
        + p.kit("package", 3, kind="PaintTins"),
    )
    for x in range(-1600, 1300, 260):
        p.on(p.put(bench, x, 1040, yaw=180), tools, 5)
        p.put(p.kit("stool", 3), x, 930)
    for item in p.along((1799, -1000), (1799, 1000), p.kit("shelf", 3, kind="Metal", depth=60.0), 6, fill=True):
        p.stock(
            item,
            [
                *p.kit("package", 4, kind="PaintTins"),
                *p.kit("package", 4, kind="ToolBox"),
                *p.kit("crate", 2, kind="AppleCrate"),
                *p.kit("package", 3, kind="ShoeBoxes"),
            ],
            8,
            0.8,
        )
    for x in (1250, 1500):
        for y in range(-800, 900, 260):
            pal = p.put(p.kit("pallet", 8), x, y, yaw=90)
            p.middle(pal, p.kit("crate", 4, kind="PackingCase"))
    p.put(p.one("tractor", kind="Forklift"), 1380, -980, yaw=180)
    p.put(p.one("tractor", kind="Forklift", paint="RedPaint"), -1620, 100, yaw=90)
    p.along(
        (-1799, 900),
        (-1799, -900),
        [
            *p.kit("cupboard", 3, kind="LockerRow"),
            *p.kit("machine", 1, kind="Boiler"),
            *p.kit("machine", 1, kind="Generator"),
            *p.kit("barrel", 4, kind="GasBottle"),
        ],
        24,
        fill=True,
    )
    p.along(
        (-1700, -1099),
        (700, -1099),
        [
            *p.kit("works", 1, kind="CableDrum"),
            *p.kit("works", 2, kind="SteelBeams"),
            *p.kit("pipe", 3, kind="PipeStack"),
            *p.kit("barrel", 3, kind="OilDrum"),
        ],
        40,
        fill=True,
    )
    p.scatter(
        (-1700, -200, 1100, -120), [*p.kit("works", 1, kind="TrafficCone"), *p.kit("barrel", 3, kind="OilDrum")], 12
    )
    p.scatter(
        (-1700, -1000, 1700, 1000),
        [
            *p.kit("barrel", 3, kind="OilDrum"),
            *p.kit("crate", 3),
            *p.kit("works", 1, kind="TrafficCone"),
            *p.kit("bin", 2),
            *p.kit("works", 1, kind="Barrier"),
        ],
        60,
        clear=30,
    )
    p.beams((-1800, -1100, 1800, 1100), 520, 8, "Iron", truss=True)
    for x in (-1200, 0, 1200):
        for y in (-600, 600):
            p.light(x, y, 460, intensity=6000, radius=1700, colour=(255, 250, 238))
    p.sun(-50, -50, intensity=2.0, sky=0.65)
    p.view("line", (-1700, -150, 175), (600, 100, 90), 75)
    p.view("benches", (1150, 940, 175), (-700, 500, 80), 75)


@scene("loft", "indoor", "Loft flat", styles.DOMESTIC.but(wall=("RedBrick",)))
def loft(p: StagedPlace) -> None:
    """One large room of brick to live in: sofas, kitchen, bed behind a shelf, bath, piano."""
    p.room(
        (-500, -350, 500, 350), "Parquet", wall="RedBrick", S=("Window", "Plain", "Door"), N=("Window",), module=334.0
    )
    units = [
        p.one("kitchen-unit", kind=kind, paint="NavyPaint")
        for kind in ("Fridge", "KitchenBase", "KitchenSink", "Stove", "KitchenBase")
    ]
    for item in p.along((-120, 349), (-499, 349), units, 1):
        p.on(item, p.kinds("dish", "Teapot", "Cup", "Plate", "FruitBowl", "Toaster"), 2)
    table = p.put(p.one("table", kind="Long", width=180.0), -280, 150)
    p.around(table, p.kit("chair", 2), 6)
    p.on(table, p.kinds("dish", "Plate", "Cup", "Bottle", "FruitBowl", "WineGlass"), 7)
    p.put(p.one("rug", width=280.0, depth=200.0), -220, -150)
    p.put(p.one("sofa", seats=3), -220, -290)
    p.put(p.one("sofa", seats=1), -420, -150, yaw=-90)
    p.on(
        p.put(p.one("table", kind="Small", high=45.0, width=100.0), -220, -150),
        p.kinds("decor", "OpenBook", "Vase") + p.kinds("dish", "Cup"),
        3,
    )
    p.put(p.one("lamp", kind="FloorLamp"), -90, -300)
    p.put(p.one("lamp", kind="ArcLamp"), -455, -300, yaw=-60)
    for y in (-240, -130, 60, 170):
        p.stock(
            p.put(p.one("shelf", kind="Wood", width=100.0), 60, y, yaw=90),
            p.kinds("decor", "Vase", "BookStack", "PottedPlant", "Clock", "Figurine"),
            8,
            0.6,
        )
    p.put(p.one("cot", kind="DoubleBed"), 390, -200, yaw=0)
    for x in (280, 470):
        p.on(
            p.put(p.one("cupboard", kind="Nightstand"), x if x > 300 else 276, -318),
            [*p.kit("lamp", 1, kind="TableLamp"), *p.kinds("decor", "OpenBook")],
            2,
        )
    p.along((499, 0), (499, 200), [p.one("cupboard", kind="Wardrobe")], 5)
    p.put(p.one("music", kind="Piano"), 200, 322, yaw=180)
    p.put(p.one("stool", high=45.0), 200, 240)
    p.put(p.one("bath-thing", kind="Bathtub"), 400, 305)
    p.put(p.one("board", kind="FloorMirror"), 290, 40, yaw=90)
    p.scatter(
        (-480, -330, 480, 330),
        [*p.kit("house-plant", 3), *p.kit("sack", 1, kind="LaundryBasket"), *p.kit("animal", 1, kind="Cat")],
        6,
        clear=15,
    )
    p.beams((-500, -350, 500, 350), 300, 4, "DarkOak")
    for x, y in ((-250, 120), (-200, -180), (380, -150), (300, 200)):
        p.light(x, y, 230, intensity=2200, radius=750)
    p.sun(-38, 70, intensity=2.8, sky=0.7)
    p.view("door", (-60, -330, 165), (-320, 250, 80), 85)
    p.view("bed", (120, 330, 165), (380, -250, 60), 85)
