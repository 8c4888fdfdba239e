"""Text scenes of today and of toys: urban, transit, industrial, domestic, office and stylised places."""

from __future__ import annotations

from cases.open190.districts import (
    border,
    car_park,
    enclosure,
    field,
    forest,
    frontage,
    garden,
    market,
    playground,
    rails,
    ring,
    street,
    waterfront,
)
from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


def furniture(p: StagedPlace) -> list[str]:
    """What stands on pavements."""
    return [
        *p.kit("bench", 2, back=True),
        *p.kit("bin", 2),
        *p.kit("hydrant", 4),
        *p.kit("planter", 3),
        *p.kit("sign", 4),
        *p.kit("bicycle", 2),
    ]


def yard_goods(p: StagedPlace) -> list[str]:
    """What stands about in works yards."""
    return [*p.kit("pallet", 5), *p.kit("barrel", 3), *p.kit("crate", 3), *p.kit("works", 5), *p.kit("bin", 1)]


@scene("city-crossing", "text", "City crossing", styles.URBAN, 130)
def city_crossing(p: StagedPlace) -> None:
    """Two avenues that cross between tall blocks, shops, traffic lights, buses and taxis."""
    p.plate(130, "Concrete")
    blocks = p.kit("block", 7)
    cars = [*p.kit("car", 7), *p.kit("car", 2, kind="Taxi"), *p.kit("truck", 2, kind="CityBus")]
    lamps, trees = p.kit("streetlamp", 3), p.kit("tree", 3, height=600.0)
    street(
        p,
        -6400,
        -700,
        0,
        north=p.kit("shop", 6),
        south=blocks,
        cars=cars,
        lamps=lamps,
        trees=trees,
        clutter=furniture(p),
        wide=900,
    )
    street(
        p,
        700,
        6400,
        0,
        north=blocks[2:] + blocks[:2],
        south=p.kit("shop", 8)[2:],
        cars=cars,
        lamps=lamps,
        trees=trees,
        clutter=furniture(p),
        wide=900,
    )
    with p.at(0, 0, 90):
        street(p, -6400, -700, 0, cars=cars, lamps=lamps, trees=trees, clutter=furniture(p), wide=900)
        street(p, 700, 6400, 0, cars=cars, lamps=lamps, trees=trees, clutter=furniture(p), wide=900)
    p.ground((-700, -700, 700, 700), "Asphalt", tile=700, z=0.7)
    zebra = p.one("road", length=300.0, wide=900.0, mark="zebra")
    for yaw in (0, 90, 180, 270):
        with p.at(0, 0, yaw):
            p.put(zebra, 560, 0, 1.2)
            p.put(p.kit("traffic-light", 2), 760, 560, yaw=90)
    p.put(p.one("statue"), 620 + 250, 1000)
    p.row((-6000, 5900), (6000, 5900), blocks, 5, yaw=180)
    p.palette(
        120, "car", "shop", "block", "sign", "planter", "bench", "streetlamp", "truck", "kiosk", "hydrant", "tree"
    )


@scene("park-lake", "text", "City park with a lake", styles.URBAN, 200)
def park_lake(p: StagedPlace) -> None:
    """A lake with rowing boats, lawns, winding paths, a bandstand, a playground, kiosks."""
    p.plate(200, "Grass")
    p.ground((-4500, 500, 4500, 5500), family="water", z=0.6)
    p.trail([(-9800, -1500), (-5200, -400), (-5200, 6200), (5200, 6200), (5200, -400), (9800, -1500)], 300, "Gravel")
    p.trail([(-5200, -300), (5200, -300)], 300, "Gravel", z=1.8)
    p.trail([(0, -9800), (0, -300)], 300, "Gravel", z=2.0)
    p.put(p.one("jetty", length=900.0, wide=260.0, high=60.0), -1500, 980, yaw=90)
    p.scatter(
        (-4000, 1000, 4000, 5000),
        [*p.kit("boat", 4, kind="RowingBoat"), *p.kit("boat", 2, kind="SailingBoat")],
        16,
        clear=120,
    )
    p.put(p.one("pavilion", use="Bandstand", size=600.0), 0, -3600)
    ring(p, 0, -3600, 900, p.kit("bench", 3, back=True), 14, face=-270)
    playground(p, 5500, -5000)
    garden(
        p,
        (-7600, -7000, -3200, -3400),
        beds=4,
        centre=p.one("fountain"),
        benches=p.kit("bench", 3),
        trees=p.kit("tree", 4),
    )
    for x in (-2600, 2600):
        p.put(p.kit("kiosk", 3), x, -900, yaw=0)
        for k in range(5):
            table = p.put(p.kit("parasol-table", 3), x - 700 + 350 * k, -1400 + p.uni(-50, 50))
            p.around(table, p.kit("chair", 2, kind="Metal"), 3, gap=-48)
    p.row((-5000, -560), (5000, -560), [*p.kit("streetlamp", 2), *p.kit("bench", 3, back=True), *p.kit("bin", 2)], 30)
    p.row((-5500, -100), (-5500, 6000), [*p.kit("streetlamp", 2), *p.kit("bench", 2, back=True)], 13, yaw=180)
    p.scatter((-4700, 350, 4700, 480), p.kit("flowers", 3, kind="Reeds"), 40, clear=5)
    p.row((-3000, -7900), (3000, -7900), p.kit("statue", 5), 7)
    p.scatter(
        (-9000, -9000, 9000, 9000),
        [*p.kinds("animal", "Duck", "Dog"), *p.kit("bicycle", 3), *p.kit("flowers", 5), *p.kit("rock", 3)],
        70,
        clear=60,
        avoid=((-4600, 400, 4600, 5600),),
    )
    forest(
        p,
        (-9800, -9800, 9800, 9800),
        [*p.kit("tree", 7), *p.kit("conifer", 3)],
        260,
        under=p.kit("bush", 5),
        floor=140,
        avoid=(
            (-5700, -2000, 5700, 6600),
            (-1400, -9800, 1400, -2400),
            (-7900, -7300, -2900, -3100),
            (4500, -6000, 6500, -4000),
        ),
    )
    p.palette(
        135,
        "tree",
        "flowers",
        "bench",
        "boat",
        "statue",
        "planter",
        "bush",
        "streetlamp",
        "kiosk",
        "sign",
        "play",
        "animal",
    )


@scene(
    "tram-street",
    "text",
    "Shopping street with trams",
    styles.TRANSIT.but(wall=("CreamPlaster", "RedBrick", "PinkPlaster", "YellowBrick"), roof=("SlateTile", "RedTile")),
    130,
)
def tram_street(p: StagedPlace) -> None:
    """A long street of shops with tram tracks, stops with shelters, planters and cafe tables."""
    p.plate(130, "Paving")
    shops = p.kit("shop", 14)
    frontage(p, (6300, 1500), (-6300, 1500), shops, (0, 12))
    frontage(p, (-6300, -1500), (6300, -1500), shops[7:] + shops[:7], (0, 12))
    for y, kinds in ((-260, 2), (260, 2)):
        rails(p, -6400, 6400, y, p.kit("train", kinds, kind="Tram"), start=1800 if y > 0 else 6500, gap=60)
    for x in (-3500, 0, 3500):
        p.put(p.one("bus-shelter", noun="TramShelter"), x, 660, yaw=180)
        p.put(p.one("bus-shelter", noun="TramShelter"), x + 900, -660)
        p.put(p.kit("board", 2, kind="TimetableBoard"), x + 380, 640, yaw=180)
    for side in (-1, 1):
        p.row(
            (-6000, side * 950),
            (6000, side * 950),
            [*p.kit("tree", 3, height=560.0), *p.kit("streetlamp", 2), *p.kit("planter", 3)],
            21,
        )
        for x in range(-5600, 5700, 900):
            table = p.put(p.kit("parasol-table", 4), x + p.uni(-60, 60), side * 1210)
            p.around(table, p.kit("chair", 3, kind="Metal"), 3, gap=-48)
        p.scatter((-6200, side * 800 - 60, 6200, side * 800 + 60), furniture(p), 44, clear=40)
    frontage(p, (6300, 3300), (-6300, 3300), p.kit("block", 4, storeys=5.0), (100, 300))
    frontage(p, (-6300, -3300), (6300, -3300), p.kit("block", 4, storeys=5.0)[::-1], (100, 300))
    p.palette(100, "shop", "bench", "planter", "sign", "bicycle", "streetlamp", "kiosk", "hydrant", "stall")


@scene("bus-terminal", "text", "Bus terminal", styles.TRANSIT, 130)
def bus_terminal(p: StagedPlace) -> None:
    """Bays with buses under canopies, shelters, kiosks, ticket machines, a car park."""
    p.plate(130, "Asphalt")
    p.put(p.one("block", use="TerminalBuilding", storeys=2.0, width=2400.0, depth=1000.0), 0, 4300, yaw=180)
    p.ground((-3000, 2900, 3000, 3750), "Paving", tile=600, z=0.8)
    p.row(
        (-1800, 3500),
        (1800, 3500),
        [*p.kit("service", 3, kind="TicketMachine"), *p.kit("service", 2, kind="VendingMachine"), *p.kit("kiosk", 2)],
        9,
        yaw=180,
    )
    for k, y in enumerate((-1800, -400, 1000, 2200)):
        p.ground((-3500, y - 160, 3500, y + 160), "Paving", tile=320, z=0.8)
        for x in range(-3000, 3001, 1000):
            p.put(p.one("canopy", length=980.0), x, y, scale=(1.0, 0.55, 1.0))
        p.row(
            (-3200, y),
            (3200, y),
            [
                *p.kit("pew", 2, kind="WaitingBench"),
                *p.kit("bin", 2),
                *p.kit("board", 2, kind="TimetableBoard"),
                *p.kit("planter", 2),
            ],
            14,
            jitter=12,
        )
        if k < 3:
            p.row((-2500, y + 620), (2500, y + 620), p.kit("truck", 5, kind="CityBus"), 4, jitter=40)
    car_park(p, (-6200, -6100, 6200, -3000), p.kit("car", 9), share=0.65)
    p.row(
        (-6200, -2700), (6200, -2700), [*p.kit("tree", 3, height=560.0), *p.kit("streetlamp", 2), *p.kit("sign", 4)], 22
    )
    for side in (-1, 1):
        p.row((side * 5600, -1800), (side * 5600, 5600), p.kit("shop", 6), 8, yaw=0 if side > 0 else 180)
        p.row(
            (side * 4300, -2000),
            (side * 4300, 5000),
            [*p.kit("streetlamp", 2), *p.kit("car", 3, kind="Taxi"), *p.kit("bollard", 1)],
            12,
        )
    p.scatter(
        (-3000, 2950, 3000, 3300),
        [*p.kit("bench", 2), *p.kit("bicycle", 3), *p.kit("bike-rack", 1), *p.kit("planter", 2)],
        24,
        clear=30,
    )
    p.palette(85, "car", "truck", "sign", "bench", "planter", "bin", "streetlamp", "service")


@scene(
    "country-station",
    "text",
    "Country railway station",
    styles.TRANSIT.but(
        wall=("RedBrick", "YellowBrick"), roof=("SlateTile", "BrownTile"), old=True, trim=("WhitePaint", "GreenPaint")
    ),
    200,
)
def country_station(p: StagedPlace) -> None:
    """A steam train at a small platform, a brick station, a level crossing, meadows and a village lane."""
    p.plate(200, "Grass")
    rails(
        p,
        -9900,
        9900,
        0,
        [p.one("train", kind="SteamLocomotive"), *p.kit("train", 3, kind="PassengerCoach")],
        start=6500,
    )
    rails(
        p,
        -9900,
        9900,
        480,
        [*p.kit("train", 2, kind="BoxWagon"), *p.kit("train", 2, kind="FlatWagon"), p.one("train", kind="TankWagon")],
        start=2200,
    )
    for k in range(5):
        x = -2000 + 1000 * k
        deck = p.put(p.one("platform", length=1000.0, wide=460.0, of="Paving"), x, -400)
        for dx, things in (
            (-350, p.kit("bench", 2)),
            (-120, p.kit("planter", 2)),
            (120, p.kit("streetlamp", 2)),
            (330, [*p.kit("crate", 3, kind="Trunk"), *p.kit("barrel", 1, kind="MilkChurn")]),
        ):
            p.relate("on", p.put(things, x + dx, -420, 90.2), deck)
    p.put(p.one("house", storeys=2, width=1150.0, noun="StationHouse"), 0, -1300, yaw=0)
    p.put(p.one("shed", use="SignalBox"), 3600, -500)
    p.put(p.one("tank", kind="TankOnLegs", noun="WaterTower"), -3300, -700)
    p.trail([(5000, -9800), (5000, -300)], 500, "Soil")
    p.trail([(5000, 800), (5000, 9800)], 500, "Soil")
    for y in (-330, 800):
        p.put(p.one("rail-thing", kind="LevelCrossingBarrier"), 4650, y)
    p.row(
        (-8000, 900),
        (8000, 900),
        [*p.kit("rail-thing", 2, kind="RailSignal"), *p.kit("rail-thing", 1, kind="SwitchLever")],
        9,
        jitter=40,
    )
    for y in range(-8800, -2200, 1500):
        p.put(p.kit("house", 6), 6300, y, yaw=90)
        p.put(p.kit("house", 6), 3700, y, yaw=-90)
    p.trail([(0, -2000), (4800, -2000)], 350, "Gravel")
    p.row((500, -1800), (4000, -1800), [*p.kit("cart", 3), *p.kit("bicycle", 3)], 7)
    for box, kind in (((-9600, -8800, -4200, -4800), "Wheat"), ((-9600, 2600, -3800, 6600), "Cabbage")):
        field(p, box, kind, step=300)
    enclosure(p, (-2800, 2200, 3800, 6400), p.kit("fence", 2, kind="Rail"), gate=p.one("gate"))
    p.scatter((-2500, 2500, 3500, 6100), p.kinds("animal", "Cow", "Sheep", "Horse"), 18, clear=100)
    for a, b in (((-9800, -300), (-2700, -300)), ((-9800, 1250), (9800, 1250))):
        border(p, a, b, p.kit("fence", 1, kind="Plank"), opening=400)
    forest(
        p,
        (-9800, 1500, 9800, 9800),
        p.kit("tree", 5),
        110,
        under=p.kit("bush", 3),
        floor=60,
        avoid=((-9800, 1300, 4200, 6900), (4600, 1000, 5400, 9900)),
    )
    forest(p, (-4000, -9800, 3200, -2500), p.kit("tree", 4), 40)
    p.palette(
        145,
        "train",
        "house",
        "bench",
        "crate",
        "fence",
        "tree",
        "animal",
        "cart",
        "rail-thing",
        "sign",
        "planter",
        "shed",
    )


@scene("airfield", "text", "Small airfield", styles.TRANSIT.but(wall=("WhitePaint", "Concrete")), 200)
def airfield(p: StagedPlace) -> None:
    """A runway with light aircraft, hangars, a control tower, fuel tanks and a cafe."""
    p.plate(200, "DryGrass")
    for i in range(11):
        p.put(p.one("road", length=1800.0, wide=1400.0), -9000 + 1800 * i, 3500, 0.5)
    p.ground((-7000, -2600, 7000, 1200), "Concrete", tile=1000, z=0.5)
    p.trail([(0, 1200), (0, 2800)], 700, "Asphalt")
    hangars = p.kit("hall", 5, use="Hangar", width=2000.0, depth=1300.0, high=650.0)
    frontage(p, (-6600, -2900), (2600, -2900), hangars, (150, 260))
    p.put(
        p.one("tower", round=False, spire=False, height=1500.0, radius=300.0, noun="ControlTower", stone="Concrete"),
        4300,
        -3200,
    )
    p.put(p.one("block", use="Terminal", storeys=2.0, width=1600.0), 6000, -3700)
    planes = p.kit("plane", 5)
    p.grid((-6000, -1500, 5500, 300), planes, 7, 2, yaw=90, jitter=60)
    p.put(planes, -3000, 3500)
    p.row(
        (-6500, 900),
        (6500, 900),
        [
            *p.kit("truck", 2, kind="TankerTruck"),
            *p.kit("car", 2, kind="Pickup"),
            *p.kit("works", 1, kind="TrafficCone"),
            *p.kit("tractor", 1, kind="Tractor"),
        ],
        15,
        jitter=50,
    )
    p.row((8000, -2400), (8000, 600), p.kit("tank", 3, kind="HorizontalTank"), 4)
    car_park(p, (3600, -7200, 8600, -5600), p.kit("car", 8))
    for x in range(4200, 7800, 420):
        table = p.put(p.kit("parasol-table", 3), x, -2300)
        p.around(table, p.kit("chair", 2, kind="Shell"), 3, gap=-48)
    for y in (2700, 4300):
        p.row((-9500, y), (9500, y), p.kit("bollard", 1), 40)
    p.row((-7000, 2100), (7000, 2100), [*p.kit("sign", 3), *p.kit("flag", 3)], 9)
    border(p, (-9900, -9500), (9900, -9500), p.kit("fence", 1, kind="Iron"), opening=900)
    forest(p, (-9800, 5600, 9800, 9700), p.kit("tree", 4), 90)
    p.scatter((-7000, -9000, 2800, -4800), [*p.kit("tree", 4), *p.kit("bush", 3)], 50, clear=100)
    p.scatter((-6800, -2500, 6800, 1000), yard_goods(p), 70, clear=80)
    p.palette(70, "plane", "car", "truck", "sign", "works", "crate", "barrel")


@scene("brickworks", "text", "Brickworks", styles.INDUSTRIAL, 130)
def brickworks(p: StagedPlace) -> None:
    """Kilns and tall chimneys, stacks of bricks, clay heaps, a narrow railway."""
    p.plate(130, "Cinder")
    frontage(p, (-5800, 3000), (5800, 3000), p.kit("hall", 4, wall="RedBrick"), (100, 300))
    p.row((-4500, 5600), (4500, 5600), p.kit("tank", 2, kind="FactoryChimney"), 4)
    for k in range(5):
        p.put(p.kit("forge", 3, kind="Kiln"), -3600 + 700 * k, 1900, scale=2.0)
    rails(
        p,
        -6300,
        6300,
        -400,
        [
            p.one("train", kind="SteamLocomotive"),
            *p.kit("train", 3, kind="HopperWagon"),
            *p.kit("train", 2, kind="FlatWagon"),
        ],
        start=900,
    )
    p.grid(
        (-5600, -3400, -600, -1300),
        [*p.kit("works", 1, kind="BrickStack"), *p.kit("pallet", 2, load="Bricks")],
        18,
        8,
        jitter=12,
    )
    p.grid((900, -3300, 5600, -1500), p.kinds("works", "SandHeap", "GravelHeap"), 7, 3, jitter=60)
    p.row(
        (-5800, 900),
        (5800, 900),
        [*p.kit("truck", 3, kind="DumpTruck"), *p.kit("tractor", 3), *p.kit("truck", 2, kind="Lorry")],
        11,
        jitter=40,
    )
    p.row((-5000, -5000), (5000, -5000), p.kit("house", 5, storeys=2, wall="RedBrick"), 7)
    border(p, (-6300, -6200), (6300, -6200), p.kit("wall", 2, stone="RedBrick"), opening=700)
    p.scatter((-6000, -4200, 6000, 1500), [*yard_goods(p), *p.kinds("works", "Wheelbarrow")], 120, clear=50)
    p.palette(65, "works", "pallet", "barrel", "hall", "truck", "machine", "pipe")


@scene(
    "refinery",
    "text",
    "Oil refinery",
    styles.INDUSTRIAL.but(paint=("WhitePaint", "SilverPaint", "GreyPaint", "GreenPaint", "YellowPaint")),
    200,
)
def refinery(p: StagedPlace) -> None:
    """Fields of tanks with pipe racks between, columns, cooling towers, tank wagons, a jetty."""
    p.plate(200, "Gravel")
    p.grid((-8600, -8200, -2200, -2600), p.kit("tank", 6, kind="StorageTank"), 7, 6)
    p.grid((2600, -8000, 8600, -4600), p.kit("tank", 4, kind="HorizontalTank"), 6, 6)
    for y in (-1200, 2400):
        for x in range(-8800, 8800, 520):
            p.put(p.kit("pipe", 3, kind="PipeRack"), x, y)
    for y in range(-700, 2200, 640):
        for x in range(-8200, -2400, 420):
            p.put(
                [
                    *p.kit("pipe", 4, kind="PipeValve"),
                    *p.kit("pipe", 3, kind="PipeBend"),
                    *p.kit("machine", 2, kind="WaterPump"),
                    *p.kit("machine", 2, kind="Compressor"),
                ],
                x,
                y,
            )
    p.row((-1200, 600), (5200, 600), p.kit("tank", 4, kind="GasHolder"), 7)
    p.row((6600, 200), (6600, 1400), p.kit("tank", 2, kind="FactoryChimney"), 2)
    p.row((-4500, 5200), (4500, 5200), p.kit("tank", 2, kind="CoolingTower"), 4)
    rails(
        p,
        -9800,
        9800,
        3400,
        [*p.kit("train", 1, kind="DieselLocomotive"), *p.kit("train", 3, kind="TankWagon") * 3],
        start=3500,
    )
    p.trail([(-9800, -2100), (9800, -2100)], 600, "Asphalt")
    p.row(
        (-8800, -2100),
        (8800, -2100),
        [*p.kit("truck", 3, kind="TankerTruck"), *p.kit("car", 2, kind="Pickup")],
        12,
        jitter=60,
    )
    p.row((-8000, 8400), (8000, 8400), p.kit("hall", 5, depth=1000.0), 7, yaw=180)
    border(p, (-9900, -9700), (9900, -9700), p.kit("fence", 2, kind="Iron"), opening=800)
    p.row((-9600, 4400), (9600, 4400), p.kit("streetlamp", 2, kind="Twin"), 20)
    p.scatter((-9500, -9300, 9500, 8000), yard_goods(p), 160, clear=80)
    p.palette(75, "tank", "pipe", "machine", "barrel", "truck", "works", "container")


@scene("building-site", "text", "Building site", styles.INDUSTRIAL.but(wall=("Concrete", "RedBrick")), 130)
def building_site(p: StagedPlace) -> None:
    """Half-built walls in scaffolds under tower cranes, diggers, heaps, site huts, a hoarding."""
    p.plate(130, "Soil")
    for x, y in ((-2600, 2600), (2700, -1900)):
        p.put(p.kit("crane", 2, kind="TowerCrane"), x, y)
    wall = p.kit("wall", 2, stone="Concrete", high=190.0)
    for bx, by in ((-3900, -300), (600, 1200)):
        enclosure(p, (bx, by, bx + 2900, by + 2200), wall)
        p.row((bx + 300, by - 120), (bx + 1100, by - 120), p.kit("works", 1, kind="Scaffold"), 3)
        p.row((bx + 1800, by - 120), (bx + 2600, by - 120), p.kit("works", 1, kind="Scaffold"), 3)
        p.grid((bx + 450, by + 450, bx + 2450, by + 1750), p.kit("pillar", 2, kind="Square", of="Concrete"), 6, 4)
    p.row((-5500, -2600), (1500, -2600), p.kit("tractor", 6), 6, yaw=30, jitter=60)
    p.grid((-5600, -5200, -1200, -3800), p.kinds("works", "SandHeap", "GravelHeap"), 6, 2, jitter=60)
    p.grid(
        (-600, -5300, 3400, -3600),
        [*p.kinds("works", "PlankStack", "SteelBeams", "BrickStack", "CableDrum"), *p.kit("pallet", 4)],
        9,
        5,
        jitter=20,
    )
    p.row((4600, -5200), (4600, 600), p.kit("container", 4, long=False), 7, yaw=-90)
    p.row((5700, -5000), (5700, 1000), [*p.kit("works", 1, kind="PortableToilet"), *p.kit("shed", 3, use="SiteHut")], 8)
    p.row(
        (-5600, 5200),
        (5600, 5200),
        [*p.kit("truck", 2, kind="DumpTruck"), *p.kit("truck", 2, kind="Lorry"), *p.kit("car", 3)],
        9,
        jitter=40,
    )
    for a, b in (
        ((-6300, -6200), (6300, -6200)),
        ((6300, -6200), (6300, 6200)),
        ((6300, 6200), (-6300, 6200)),
        ((-6300, 6200), (-6300, -6200)),
    ):
        border(p, a, b, p.kit("fence", 2, kind="Plank"), opening=800 if a[1] > 0 and b[1] > 0 else 0)
    p.scatter(
        (-5900, -5900, 5900, 5900),
        [*yard_goods(p), *p.kinds("works", "TrafficCone", "CementMixer", "Wheelbarrow", "Barrier", "Ladder")],
        160,
        clear=60,
    )
    p.palette(90, "works", "tractor", "pallet", "barrel", "container", "truck", "sign", "pipe")


@scene(
    "sawmill",
    "text",
    "Sawmill in the woods",
    styles.INDUSTRIAL.but(wall=("Planks", "RedBoards", "GreyPlanks"), old=True),
    130,
)
def sawmill(p: StagedPlace) -> None:
    """Stacks of logs and planks, a saw shed, a mill pond, carts, a forest around."""
    p.plate(130, "Grass")
    p.ground((-2600, -2600, 3600, 2200), "Soil", tile=700, z=0.5)
    p.put(p.one("hall", use="SawMill", width=2200.0, depth=1100.0, high=450.0), 0, 3000, yaw=180)
    p.put(p.one("hall", use="DryingShed", width=1800.0, depth=900.0, high=380.0), -4000, 900, yaw=-90)
    p.ground((-6200, -4600, -3000, -1600), family="water", tile=800, z=0.6)
    p.grid((-2200, -2300, 300, -400), p.kinds("log", "WoodPile"), 6, 6, jitter=15)
    p.grid((1300, -2300, 3300, -300), p.kinds("works", "PlankStack"), 4, 7, jitter=15)
    p.grid(
        (-2000, 500, 200, 1700), [*p.kit("pallet", 2, load="Timber"), *p.kinds("works", "PlankStack")], 5, 4, jitter=15
    )
    p.row(
        (900, 800),
        (3200, 800),
        p.kinds("machine", "BandSaw", "ConveyorBelt") + p.kinds("forge", "Sawhorse", "Grindstone"),
        8,
    )
    p.row(
        (800, 1800),
        (3300, 1800),
        [*p.kit("cart", 4), *p.kit("truck", 1, kind="Lorry"), *p.kit("tractor", 1, kind="Tractor")],
        5,
    )
    p.scatter(
        (-2500, -2500, 3500, 2100),
        [
            *p.kinds("log", "Firewood", "TreeStump"),
            *p.kit("barrel", 2),
            *p.kit("crate", 2),
            *p.kinds("works", "Ladder", "Wheelbarrow"),
        ],
        60,
        clear=40,
    )
    p.row((4300, -2200), (4300, 2400), p.kit("house", 4, storeys=1), 4, yaw=0)
    p.scatter(
        (-6200, -6200, 6200, 6200),
        p.kinds("log", "TreeStump", "FallenLog"),
        70,
        clear=60,
        avoid=((-5200, -4700, 5400, 4200),),
    )
    p.put(p.one("crane", kind="TreadwheelCrane"), 700, -900)
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("conifer", 7),
        240,
        under=[*p.kit("rock", 4), *p.kit("flowers", 2, kind="Ferns")],
        floor=80,
        avoid=((-5400, -4800, 5600, 4300),),
    )
    p.trail([(0, -6400), (0, -2700)], 420, "Soil")
    p.palette(55, "log", "conifer", "works", "cart", "rock", "shed")


@scene(
    "power-station", "text", "Power station", styles.INDUSTRIAL.but(wall=("Concrete", "GreyPaint", "DarkBrick")), 200
)
def power_station(p: StagedPlace) -> None:
    """Cooling towers and chimneys, turbine halls, a coal yard with a train, transformers, a canal."""
    p.plate(200, "Gravel")
    p.grid((-7500, 5200, -1500, 7800), p.kit("tank", 2, kind="CoolingTower"), 3, 2)
    p.row((3200, 7000), (7800, 7000), p.kit("tank", 2, kind="FactoryChimney"), 3)
    p.row(
        (800, 4300),
        (7600, 4300),
        p.kit("hall", 3, use="TurbineHall", width=2100.0, depth=1300.0, high=700.0),
        3,
        yaw=180,
    )
    for y in (900, 1500, 2100):
        p.row(
            (-8500, y),
            (-1500, y),
            [*p.kit("hydrant", 2, kind="ElectricBox"), *p.kit("machine", 3, kind="Generator")],
            20,
        )
    for k in range(5):
        p.grid((700 + 1500 * k, 800, 1700 + 1500 * k, 2000), p.kit("machine", 3, kind="Generator"), 3, 4)
    for y in (-1500, -2100):
        rails(
            p,
            -9800,
            9800,
            y,
            [*p.kit("train", 1, kind="DieselLocomotive"), *p.kit("train", 4, kind="HopperWagon") * 2],
            start=1200 if y < -2000 else 5200,
        )
    p.grid((-8600, -6200, 3000, -3200), p.kinds("works", "GravelHeap"), 16, 6, jitter=80)
    p.row(
        (4600, -5800),
        (8800, -3200),
        p.kit("tractor", 2, kind="Bulldozer") + p.kit("tractor", 2, kind="Excavator"),
        5,
        jitter=60,
    )
    p.ground((-9900, -9600, 9900, -7600), family="water", z=0.6)
    p.row((-7000, -8600), (7000, -8600), p.kit("boat", 3, kind="Barge"), 5, jitter=100)
    for x in range(-8600, 8700, 540):
        p.put(p.kit("pipe", 2, kind="PipeRack"), x, 0)
    p.row((-9000, -700), (9000, -700), p.kit("streetlamp", 2, kind="Arm"), 20)
    border(p, (-9900, 9700), (9900, 9700), p.kit("fence", 2, kind="Iron"), opening=900)
    car_park(p, (-900, 7600, 2600, 9000), p.kit("car", 7))
    p.scatter((-9000, -7000, 9000, 9000), yard_goods(p), 130, clear=90)
    p.palette(48, "tank", "machine", "works", "pipe")


@scene("allotments", "text", "Allotment gardens", styles.DOMESTIC, 130)
def allotments(p: StagedPlace) -> None:
    """Plots with beds, sheds, greenhouses, water butts, scarecrow flags, hedges and a green path."""
    p.plate(130, "Grass")
    p.trail([(-6300, 0), (6300, 0)], 300, "Gravel")
    p.trail([(0, -6300), (0, 6300)], 300, "Gravel", z=1.8)
    crops = ("Cabbage", "Lettuce", "Carrot", "Strawberry", "Leek", "Pumpkin", "Maize")
    fences, hedges = p.kit("fence", 3, kind="Picket", length=250.0), p.kit("hedge", 2, length=250.0, high=80.0)
    for i in range(6):
        for j in range(4):
            x, y = (-5200 + 2000 * i) + (250 if i > 2 else -50), -4700 + 3000 * j + (200 if j > 1 else -100)
            with p.at(x, y, 0 if j % 2 else 180):
                enclosure(p, (-870, -1200, 870, 1200), fences if (i + j) % 2 else hedges)
                p.put(p.kit("shed", 6), -520, 820, yaw=180)
                p.put([*p.kit("greenhouse", 2)], 380, 800, scale=0.7) if (i + j) % 3 == 0 else p.put(
                    p.kit("arbour", 2), 420, 800
                )
                for k in range(5):
                    p.put(p.one("bed", length=420.0, wide=130.0), -420, -950 + 280 * k, 1.0)
                    p.put(p.one("crop", kind=crops[(i + k + j) % 7]), -420, -950 + 280 * k)
                for k in range(4):
                    p.put(p.kit("flowers", 7), 250 + 170 * (k % 3), -900 + 300 * k)
                p.put(p.kit("barrel", 2, style=styles.HISTORICAL, kind="RainButt"), -760, 560)
                p.scatter(
                    (100, -1000, 780, 500),
                    [
                        *p.kinds("works", "Wheelbarrow"),
                        *p.kit("bench", 3),
                        *p.kit("sack", 2),
                        *p.kit("planter", 3),
                        *p.kit("parasol-table", 2),
                        *p.kit("tree", 3, height=450.0),
                    ],
                    5,
                    clear=30,
                )
    p.row((-6000, 260), (6000, 260), [*p.kit("bench", 2), *p.kit("bicycle", 3), *p.kit("bin", 2)], 14)
    p.put(p.one("pavilion"), 5900, 5900)
    p.palette(
        155,
        "shed",
        "flowers",
        "crop",
        "planter",
        "bench",
        "bush",
        "tree",
        "fence",
        "works",
        "animal",
        "bicycle",
        "barrel",
    )


@scene(
    "quiet-close",
    "text",
    "Quiet close of houses",
    styles.DOMESTIC.but(wall=("WhiteBoards", "GreenBoards", "BlueBoards", "RedBrick", "CreamPlaster")),
    130,
)
def quiet_close(p: StagedPlace) -> None:
    """A round turning place with houses in a ring, gardens, drives, a playground."""
    p.plate(130, "Grass")
    p.trail([(0, -6400), (0, -1800)], 700, "Asphalt")
    p.ground((-1500, -1800, 1500, 1200), "Asphalt", tile=1500, z=0.6)
    p.put(p.kit("tree", 1, leaf="Leaf", height=850.0), 0, -300)
    ring(p, 0, -300, 330, p.kit("planter", 4), 8)
    houses, cars = p.kit("house", 10), p.kit("car", 8)
    for k, a in enumerate(range(-30, 211, 40)):
        with p.at(0, -300, a - 90):
            p.put(houses[k], 0, 3700, yaw=180)
            p.trail([(-330, 1950), (-330, 3100)], 300, "Concrete")
            p.put(cars, -330, 2550, 0, 90)
            p.trail([(120, 1950), (120, 3150)], 140, "Flagstone")
            p.scatter((250, 2050, 700, 3000), [*p.kit("flowers", 6), *p.kit("bush", 3)], 9, clear=10)
            p.put(p.kit("hydrant", 2, kind="PostBox"), 320, 1900)
            p.scatter(
                (-700, 4500, 700, 5600),
                [*p.kit("shed", 3), *p.kit("play", 4), *p.kit("parasol-table", 3), *p.kit("tree", 3, height=500.0)],
                5,
                clear=40,
            )
    for side in (-1, 1):
        frontage(
            p,
            (side * 1100, -6300 if side > 0 else -2600),
            (side * 1100, -2600 if side > 0 else -6300),
            houses[7:],
            (250, 400),
            (250, 400),
        )
        p.row(
            (side * 500, -6000),
            (side * 500, -2200),
            [*p.kit("streetlamp", 2, kind="Arm"), *p.kit("tree", 2, height=550.0)],
            8,
        )
    ring(p, 0, -300, 1850, p.kit("streetlamp", 2, kind="Arm"), 7, start=10)
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 5),
        60,
        under=p.kit("bush", 4),
        floor=50,
        avoid=((-1200, -6400, 1200, -1500),),
    )
    p.palette(
        175,
        "house",
        "car",
        "flowers",
        "planter",
        "tree",
        "bench",
        "shed",
        "play",
        "fence",
        "bush",
        "sign",
        "bicycle",
        "animal",
    )


@scene(
    "camping",
    "text",
    "Camping ground by a lake",
    styles.DOMESTIC.but(
        awning=("BlueStripes", "GreenStripes", "OrangeCloth", "TealCloth", "RedStripes"),
        wall=("PalePlanks", "GreenBoards"),
    ),
    200,
)
def camping(p: StagedPlace) -> None:
    """Tents, vans and tables under trees by a lake with a jetty and boats, a wash house, a fire ring."""
    p.plate(200, "Grass")
    waterfront(
        p,
        -9800,
        9800,
        5500,
        deep=4300,
        boats=p.kit("boat", 4, kind="RowingBoat")
        + p.kit("boat", 2, kind="SailingBoat")
        + p.kit("boat", 2, kind="MotorBoat"),
        jetties=3,
    )
    p.ground((-9800, 4700, 9800, 5500), "Sand", tile=800, z=0.5)
    p.trail([(-9800, 0), (9800, 0)], 350, "Gravel")
    p.trail([(0, -9800), (0, 4700)], 350, "Gravel", z=1.8)
    for x in range(-8800, 8900, 1600):
        for y in (-7800, -5400, -3000, 1500, 3300):
            if abs(x) < 500:
                continue
            with p.at(x + p.uni(-150, 150), y + p.uni(-150, 150), p.random.choice((0, 90, 180, -90))):
                p.put(p.kit("tent", 8), 0, 0)
                p.put([*p.kit("car", 6), *p.kit("car", 2, kind="Van")], 620, 0, 0, 90)
                table = p.put(p.kit("table", 3, kind="Trestle"), -100, 620)
                p.around(table, p.kit("chair", 3), 4)
                p.on(table, p.kinds("dish", "Cup", "Plate", "Bottle", "FruitBowl"), 3)
    ring(p, 3200, -1200, 420, p.kinds("log", "FallenLog"), 5, face=0)
    p.put(p.one("forge", kind="Cauldron"), 3200, -1200)
    p.put(p.one("house", storeys=1, noun="WashHouse"), -3200, -1400, yaw=180)
    p.put(p.one("kiosk"), 1200, 700, yaw=180)
    playground(p, -6500, -1400)
    p.row(
        (-9000, 5000),
        (9000, 5000),
        [*p.kit("parasol-table", 3), *p.kinds("boat-gear", "LifeRing"), *p.kit("bench", 2)],
        18,
    )
    p.row(
        (-9500, 260),
        (9500, 260),
        [*p.kit("streetlamp", 2), *p.kit("bin", 2), *p.kit("sign", 3), *p.kit("bicycle", 3)],
        26,
    )
    forest(
        p,
        (-9800, -9800, 9800, 4600),
        [*p.kit("tree", 5), *p.kit("conifer", 4)],
        150,
        under=[*p.kit("bush", 3), *p.kit("flowers", 4), *p.kit("rock", 3)],
        floor=120,
        avoid=((-9900, -350, 9900, 350), (-350, -9900, 350, 4700)),
    )
    p.palette(110, "tent", "car", "boat", "tree", "chair", "bicycle", "sign", "bench", "flowers", "animal")


@scene(
    "school-grounds",
    "text",
    "School grounds",
    styles.OFFICE.but(
        wall=("RedBrick", "YellowBrick", "WhiteBrick"), paint=("RedPaint", "YellowPaint", "BluePaint", "LimePaint")
    ),
    130,
)
def school_grounds(p: StagedPlace) -> None:
    """A school with a yard, a playground, a sports field, a garden, bicycles and buses."""
    p.plate(130, "Grass")
    p.put(p.one("block", use="School", storeys=3.0, width=2400.0, depth=1100.0), -1500, 2600, yaw=180)
    p.put(p.one("block", use="School", storeys=2.0, width=1500.0, depth=1000.0, noun="SportsHall"), 1700, 2700, yaw=180)
    p.ground((-3000, -400, 3000, 1800), "Asphalt", tile=800, z=0.5)
    playground(p, -4700, 600)
    p.ground((1000, -5800, 6000, -1600), "LawnStripes", tile=1000, z=0.5)
    for x in (1150, 5850):
        p.put(p.one("play", kind="ClimbingFrame", noun="GoalFrame"), x, -3700, yaw=90)
    p.row((1200, -1450), (5800, -1450), p.kit("bench", 3), 10, yaw=180)
    garden(
        p,
        (-5600, -5600, -1800, -2400),
        beds=4,
        centre=p.one("well"),
        benches=p.kit("bench", 2),
        trees=p.kit("tree", 3, height=500.0),
    )
    p.row((-2800, 1500), (-400, 1500), p.kit("bike-rack", 1), 7)
    p.row((-2800, 1280), (-400, 1280), p.kit("bicycle", 5), 12, jitter=15)
    p.grid((200, 0, 2600, 1300), p.kit("table", 3, kind="Square"), 5, 3, jitter=30)
    p.scatter(
        (-2800, -300, 2800, 1100),
        [
            *p.kit("bench", 3),
            *p.kit("bin", 3),
            *p.kit("planter", 5),
            *p.kit("play", 2, kind="SpringHorse"),
            *p.kit("flag", 3),
        ],
        40,
        clear=60,
    )
    p.put(p.one("greenhouse"), -600, -4600)
    p.trail([(0, -6400), (0, -450)], 350, "Paving")
    p.row((-4800, 5200), (4800, 5200), [*p.kit("truck", 2, kind="CityBus"), *p.kit("car", 6)], 7)
    p.put(p.one("bus-shelter"), 0, 4700, yaw=0)
    for a, b in (((-6300, -6200), (6300, -6200)), ((6300, -6200), (6300, 4400)), ((-6300, 4400), (-6300, -6200))):
        border(p, a, b, p.kit("fence", 2, kind="Iron"), opening=450 if a[1] == b[1] else 0)
    forest(
        p,
        (-6200, -6100, 6200, 4200),
        p.kit("tree", 5),
        60,
        under=p.kit("bush", 4),
        floor=40,
        avoid=(
            (-3200, -600, 3200, 3400),
            (900, -5900, 6100, -1300),
            (-5700, -5700, -1700, -300),
            (-400, -6400, 400, 0),
        ),
    )
    p.palette(
        185,
        "play",
        "bench",
        "bicycle",
        "planter",
        "tree",
        "flowers",
        "sign",
        "car",
        "bush",
        "chair",
        "table",
        "streetlamp",
        "statue",
    )


@scene("business-park", "text", "Business park", styles.OFFICE, 200)
def business_park(p: StagedPlace) -> None:
    """Glass and brick offices around a pond, car parks, plazas with tables, sculpture, a bus stop."""
    p.plate(200, "LawnStripes")
    blocks = [*p.kit("block", 7, use="OfficeBlock"), p.one("block", use="Hotel", storeys=7.0)]
    for k, (x, y, yaw) in enumerate(
        (
            (-6000, 5200, 180),
            (0, 6200, 180),
            (6000, 5200, 180),
            (-7600, -800, -90),
            (7600, -800, 90),
            (-5000, -6600, 0),
            (5200, -6600, 0),
        )
    ):
        p.put(blocks[k], x, y, yaw=yaw)
        with p.at(x, y, yaw):
            p.row((-700, 1150), (700, 1150), [*p.kit("planter", 3), *p.kit("bench", 2), *p.kit("flag", 3)], 6)
    p.ground((-2500, -1800, 2500, 1800), family="water", z=0.6)
    for points in (
        [(-3000, -2300), (3000, -2300), (3000, 2300), (-3000, 2300), (-3000, -2300)],
        [(0, -9800), (0, -2300)],
        [(0, 2300), (0, 5300)],
        [(-6800, -800), (-3000, -800)],
        [(3000, -800), (6800, -800)],
    ):
        p.trail(points, 350, "Paving", z=1.0 + 0.4 * len(points) % 2)
    p.row(
        (-2700, 2650),
        (2700, 2650),
        [*p.kit("bench", 3), *p.kit("streetlamp", 3), *p.kit("tree", 3, height=560.0)],
        15,
        yaw=180,
    )
    p.row(
        (-2700, -2650),
        (2700, -2650),
        [*p.kit("bench", 3), *p.kit("streetlamp", 3), *p.kit("tree", 3, height=560.0)],
        15,
    )
    p.row((-2300, -1950), (2300, -1950), p.kit("flowers", 2, kind="Reeds"), 14, jitter=20)
    p.put(p.one("statue", kind="Obelisk", stone="Granite"), 3900, 2900)
    for x in range(-1600, 1700, 400):
        table = p.put(p.kit("parasol-table", 4), x, 3300)
        p.around(table, p.kit("chair", 3, kind="Shell"), 4, gap=-48)
    for box in (
        (-9600, 1200, -4200, 3400),
        (4200, 1200, 9600, 3400),
        (-9600, -4800, -4000, -3000),
        (4000, -4800, 9600, -3000),
    ):
        car_park(p, box, p.kit("car", 9), share=0.6)
    p.row((-9000, -9000), (9000, -9000), [*p.kit("tree", 4, height=650.0), *p.kit("streetlamp", 3)], 30)
    p.put(p.one("bus-shelter"), 900, -8700)
    p.scatter(
        (-9500, -9500, 9500, 9500),
        [*p.kit("tree", 5), *p.kit("bush", 5), *p.kit("sign", 4), *p.kit("bicycle", 3)],
        150,
        clear=120,
        avoid=((-3400, -3000, 3400, 3800), (-400, -9900, 400, 6000)),
    )
    p.palette(
        165,
        "car",
        "planter",
        "bench",
        "tree",
        "sign",
        "block",
        "statue",
        "streetlamp",
        "bush",
        "flag",
        "bicycle",
        "chair",
    )


@scene("toy-town", "text", "Toy town", styles.STYLISED, 130)
def toy_town(p: StagedPlace) -> None:
    """Bright houses on a ring road with toy cars, sweet stalls, a steam train, a castle."""
    p.plate(130, "Grass")
    ring(p, 0, 0, 1900, p.kit("house", 9, storeys=1), 9, face=90, start=10)
    ring(p, 0, 0, 1050, [*p.kit("kiosk", 4), *p.kit("stall", 4)], 8, face=-90, start=22)
    p.put(p.one("fountain"), 0, 0)
    ring(p, 0, 0, 2750, p.kit("car", 8), 14, face=0)
    ring(p, 0, 0, 3150, p.kit("streetlamp", 3, kind="Globe"), 14, start=12)
    rails(
        p,
        -6300,
        6300,
        -5200,
        [p.one("train", kind="SteamLocomotive"), *p.kit("train", 3, kind="PassengerCoach")],
        start=1500,
    )
    ring(
        p,
        0,
        0,
        4300,
        [*p.kit("tower", 4, spire=True), *p.kit("house", 6, storeys=2), *p.kit("windmill", 2)],
        12,
        face=90,
    )
    playground(p, 4900, 4900)
    p.put(p.one("tent", round=True, size=620.0, use="CircusTent"), -4900, 4900, scale=1.8)
    p.scatter(
        (-6200, -4700, 6200, 6200),
        [
            *p.kit("flag", 5),
            *p.kit("planter", 6),
            *p.kit("bench", 4),
            *p.kit("animal", 5),
            *p.kit("mushroom", 3, crystal=False),
        ],
        90,
        clear=80,
        avoid=((-1300, -1300, 1300, 1300),),
    )
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 7),
        90,
        under=[*p.kit("flowers", 6), *p.kit("bush", 4)],
        floor=110,
        avoid=((-3300, -3300, 3300, 3300), (-6400, -5700, 6400, -4700)),
    )
    p.palette(
        210,
        "house",
        "car",
        "tree",
        "flag",
        "planter",
        "kiosk",
        "stall",
        "animal",
        "flowers",
        "bench",
        "play",
        "train",
        "tent",
        "tower",
        "truck",
    )


@scene(
    "winter-village",
    "text",
    "Snowed-in mountain village",
    styles.STYLISED.but(
        wall=("Planks", "DarkPlanks", "WhitePlaster", "RedBoards"),
        roof=("Snow",),
        leaf=("Snow",),
        window=("AmberWindow",),
        awning=("RedStripes", "GreenStripes"),
        old=True,
        ornate=True,
    ),
    130,
)
def winter_village(p: StagedPlace) -> None:
    """Log houses under snow around a market with a great fir, sledges of wood, fir woods and hills."""
    p.plate(130, "Snow")
    frontage(p, (4800, 2600), (-4800, 2600), p.kit("house", 7), (150, 350))
    frontage(p, (-4800, -2600), (4800, -2600), p.kit("house", 7)[::-1], (150, 350))
    p.ground((-2400, -1500, 2400, 1500), "Cobble", tile=600, z=0.5)
    firs = p.kit("conifer", 7)
    p.put(firs[0], 0, 0, scale=1.5)
    ring(p, 0, 0, 520, p.kit("bench", 3), 7, face=-90)
    market(p, (-2300, -1400, -700, 1400), 4, 3, [*p.kit("crate", 3), *p.kit("sack", 3)])
    market(p, (700, -1400, 2300, 1400), 4, 3, [*p.kit("crate", 3), *p.kit("barrel", 3)])
    p.put(p.one("church"), 0, 4600, yaw=180)
    p.row(
        (-4500, 2150),
        (4500, 2150),
        [*p.kit("streetlamp", 2, kind="Lantern"), *p.kinds("log", "WoodPile", "Firewood")],
        15,
    )
    p.row(
        (-4500, -2150),
        (4500, -2150),
        [*p.kit("streetlamp", 2, kind="Lantern"), *p.kit("cart", 3), *p.kit("handcart", 3)],
        15,
    )
    p.put(p.one("well"), 3400, 600)
    p.scatter(
        (-4600, -2000, 4600, 2000),
        [
            *p.kinds("animal", "Dog", "Horse", "Goat"),
            *p.kit("barrel", 3),
            *p.kit("crate", 3),
            *p.kit("flag", 3, banner=True),
        ],
        36,
        clear=50,
        avoid=((-2500, -1600, 2500, 1600),),
    )
    for x, y in ((-4600, 5400), (4700, 5300)):
        p.put(p.one("hill", of="Snow", width=2400.0, high=900.0), x, y)
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        firs,
        170,
        under=p.kit("rock", 5),
        floor=50,
        avoid=((-5400, -3800, 5400, 3700), (-900, 3600, 900, 6400)),
    )
    p.palette(50, "conifer", "house", "crate")
