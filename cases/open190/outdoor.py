"""The outdoor source scenes."""

from __future__ import annotations

from cases.open190.districts import (
    border,
    car_park,
    castle,
    container_yard,
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
)
from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "fishing-village",
    "outdoor",
    "Fishing village",
    styles.HISTORICAL.but(
        wall=("RedBoards", "WhiteBoards", "BlueBoards", "WhitePlaster", "OchrePlaster"),
        roof=("SlateTile", "RedTile", "Shingle"),
        trim=("WhitePaint",),
        paint=("RedPaint", "BluePaint", "GreenPaint", "WhitePaint", "SkyPaint"),
    ),
)
def fishing_village(p: StagedPlace) -> None:
    """Painted houses above a quay, jetties with boats, drying racks, a church on a terrace."""
    p.ground((-4500, -4500, 4500, 500), "Grass")
    p.ground((-4500, 500, 4500, 1100), "Cobble", tile=600)
    p.ground((-5500, 1800, 5500, 5800), family="water")
    p.ground((-4500, 1100, 4500, 1800), "Sand", tile=700)
    houses = p.kit("house", 8, storeys=1) + p.kit("house", 7, storeys=2)
    gear = p.kinds(
        "boat-gear", "NetHeap", "RopeCoil", "LobsterPot", "Anchor", "FishRack", "OarRack", "LifeRing", "Buoy"
    )
    crates, barrels, boats = (
        p.kit("crate", 4) + p.kinds("crate", "AppleCrate"),
        p.kit("barrel", 3),
        p.kit("boat", 4, kind="RowingBoat"),
    )
    hill = p.put(p.one("mound", width=2600.0, depth=2000.0, high=160.0), 2900, -3050)
    church = p.put(p.one("church"), 2900, -3050, 160.2) if hill else None
    p.relate("on", church, hill)
    p.scatter((2100, -3600, 3700, -2400), p.kit("tomb", 5), 26, z=160.2, clear=60)
    x = -4200.0
    for name in houses + houses[:4]:
        thing = p.thing(name)
        if x + thing.width > 4300:
            break
        p.put(name, x + thing.width / 2, 60 - thing.depth / 2 + p.uni(-60, 60), yaw=p.uni(-3, 3))
        p.put(p.kit("bench", 3), x + thing.width / 2 + 170, 160)
        x += thing.width + p.uni(120, 260)
    x = -4100.0
    for name in houses[::-1]:
        thing = p.thing(name)
        if x + thing.width > 1500:
            break
        p.put(name, x + thing.width / 2, -1550 - thing.depth / 2 + p.uni(-150, 150), yaw=p.uni(-12, 12))
        x += thing.width + p.uni(200, 420)
    p.trail([(-4400, -1150), (4400, -1150)], 260, "Gravel")
    p.trail([(0, -1150), (0, 420)], 260, "Gravel")
    jetty = p.one("jetty", length=900.0, wide=260.0, high=60.0)
    for k, jx in enumerate((-3000, -900, 1300, 3300)):
        for part in range(2):
            deck = p.put(jetty, jx, 2000 + 900 * part, yaw=90)
            p.on(deck, [*gear[:3], *crates, *barrels, gear[6]], 7)
        for side in (-1, 1):
            for part in range(3):
                p.put(
                    boats if (part + k) % 3 else p.kit("boat", 3, kind="FishingBoat"),
                    jx + side * (320 if (part + k) % 3 else 400),
                    1950 + 640 * part,
                    yaw=90 + p.uni(-5, 5),
                )
    for bx, by in ((-4300, 3800), (-1900, 4600), (600, 4200), (2500, 4900), (4300, 3900)):
        p.put(p.kit("boat", 3, kind="SailingBoat"), bx, by, yaw=p.uni(-180, 180))
    p.row((-4200, 1500), (4200, 1500), [*boats, *gear[:1], gear[4], gear[4]], 17, jitter=70, yaw=80)
    p.scatter((-4400, 1130, 4400, 1780), [*gear, *crates, *barrels], 110, clear=15)
    stalls = p.kit("stall", 3, ware="Fish") + p.kit("stall", 2)
    p.row((-1900, 620), (1700, 620), stalls, 6, jitter=20)
    p.row((-4300, 1060), (4300, 1060), p.kit("streetlamp", 2, kind="Lantern"), 14, yaw=180)
    p.row((-4150, 1010), (4150, 1010), p.kit("bollard", 2), 40)
    p.scatter(
        (-4300, 540, 4300, 960),
        [*crates, *barrels, *p.kit("handcart", 3), *p.kit("sack", 3), gear[2], gear[0]],
        90,
        clear=20,
    )
    p.put(p.one("well"), 300, -950)
    p.put(p.one("lighthouse"), 4250, 1400)
    for fx in range(-4000, 4200, 620):
        p.row((fx, -780), (fx + 300, -780), p.kit("fence", 2, kind="Picket"), 2)
    p.scatter(
        (-4400, -4400, 4400, -700),
        p.kit("conifer", 6),
        130,
        clear=80,
        scale=(0.7, 1.1),
        avoid=((-4400, -1400, 4400, -900), (1400, -4300, 4400, -1950)),
    )
    p.scatter(
        (-4400, -4400, 4400, -650),
        [*p.kit("bush", 4), *p.kit("rock", 5), *p.kit("flowers", 5)],
        170,
        clear=20,
        avoid=((-4400, -1320, 4400, -980),),
    )
    p.scatter((-2000, -700, 2000, -450), p.kit("crop", 4), 10)
    p.scatter((-4000, -900, 4000, 400), p.kinds("animal", "Hen", "Goat", "Cat", "Dog"), 24)
    p.row((-4000, -640), (4000, -640), p.kinds("log", "Firewood", "WoodPile"), 9, jitter=40)
    p.sun(-32, 140, intensity=4.2, colour=(255, 240, 220))
    p.view("quay", (-3600, 980, 170), (2500, 800, 120), 70)
    p.view("jetty", (-250, 3700, 330), (-600, -900, 150), 75)


@scene(
    "castle-yard",
    "outdoor",
    "Castle yard",
    styles.HISTORICAL.but(stone=("Limestone", "Fieldstone"), wall=("WhitePlaster", "Fieldstone", "CreamPlaster")),
)
def castle_yard(p: StagedPlace) -> None:
    """A walled yard with a keep, a smithy, stables, a market day and a practice ground."""
    p.ground((-3600, -3200, 3600, 3200), "Grass")
    p.ground((-2200, -1800, 2200, 1800), "Cobble", tile=550, z=0.5)
    castle(
        p,
        (-2700, -2300, 2700, 2300),
        towers=p.kit("tower", 2, round=True, height=1100.0, radius=280.0),
        gatehouse=p.one("gatehouse"),
        wall=p.one("castle-wall", length=700.0),
    )
    p.put(p.one("tower", round=False, spire=False, height=1700.0, radius=480.0, noun="GreatKeep"), 0, 1450, yaw=180)
    frontage(
        p,
        (-2500, 1900),
        (-2500, -1900),
        p.kit("hall", 2, use="Stable", width=900.0, depth=500.0, high=300.0)[::-1]
        + p.kit("house", 3, storeys=2, depth=550.0),
        (20, 120),
    )
    frontage(
        p,
        (2500, -1900),
        (2500, 1900),
        p.kit("house", 3, storeys=1, depth=520.0) + p.kit("house", 2, storeys=2, depth=520.0),
        (60, 160),
    )
    p.put(p.one("church"), 1450, 1250, yaw=180)
    p.put(p.one("well"), 0, -150)
    goods = p.kit("crate", 4) + p.kit("barrel", 4) + p.kit("sack", 4)
    market(p, (-1500, -1250, 300, -450), 5, 3, goods)
    for k, kind in enumerate(("ForgeHearth", "Anvil", "Bellows", "Grindstone", "Cauldron", "Kiln", "Sawhorse")):
        p.put(p.one("forge", kind=kind), 900 + 240 * (k % 4), -500 - 260 * (k // 4), yaw=180)
    p.put(p.one("pavilion", use="SmithyShelter", size=600.0), 1750, -950)
    p.row((-900, 500), (900, 500), p.kit("flag", 4, banner=True), 6)
    p.row((-700, 250), (-1700, 250), p.kit("cart", 3), 3, jitter=30)
    enclosure(p, (-1850, 520, -850, 1250), p.kit("fence", 1, kind="Rail"))
    p.scatter((-1780, 600, -920, 1180), p.kinds("animal", "Horse", "Cow", "Goat", "Sheep", "Pig"), 9, clear=50)
    p.scatter(
        (-2150, -1750, 2150, 1750),
        [*goods, *p.kit("handcart", 3), *p.kinds("log", "Firewood"), *p.kit("bench", 2, back=False)],
        130,
        clear=25,
        avoid=((-300, -2300, 300, 900),),
    )
    p.scatter((-2100, -1700, 2100, 1700), p.kinds("animal", "Hen", "Dog", "Cat", "Duck"), 26, clear=30)
    forest(
        p,
        (-3500, -3150, 3500, 3150),
        p.kit("tree", 6),
        70,
        under=[*p.kit("bush", 4), *p.kit("rock", 3), *p.kit("flowers", 4)],
        floor=110,
        avoid=((-3050, -2700, 3050, 2700), (-350, -3200, 350, -2300)),
    )
    p.trail([(0, -3200), (0, -1000)], 400, "Cobble")
    p.sun(-36, 60, colour=(255, 244, 226))
    p.view("gate", (0, -2150, 175), (-100, 1300, 350), 72)
    p.view("yard", (1750, -1500, 260), (-1300, 300, 150), 72)


@scene("town-square", "outdoor", "Town square", styles.URBAN, slot=True)
def town_square(p: StagedPlace) -> None:
    """A square with a fountain, cafes and market stalls between streets of shops."""
    p.ground((-5200, -4600, 5200, 4600), "Concrete")
    p.ground((-2400, -1800, 2400, 1800), "Paving", tile=600, z=0.8)
    shops, blocks = p.kit("shop", 12), p.kit("block", 3, storeys=4.0, width=1800.0, depth=1000.0)
    cars, lamps, trees = p.kit("car", 10), p.kit("streetlamp", 4), p.kit("tree", 4, height=650.0)
    clutter = [
        *p.kit("bench", 3, back=True),
        *p.kit("bin", 3),
        *p.kit("hydrant", 5),
        *p.kit("planter", 4),
        *p.kit("sign", 5),
        *p.kit("bicycle", 3),
        *p.kit("bike-rack", 1),
    ]
    street(p, -5200, 5200, 2500, north=shops, trees=trees, cars=cars, lamps=lamps, clutter=clutter)
    street(p, -5200, 5200, -2500, south=shops[::-1], trees=trees, cars=cars, lamps=lamps, clutter=clutter)
    frontage(p, (-3000, 1750), (-3000, -1750), shops[3:] + shops[:3], (0, 10))
    frontage(p, (3000, -1750), (3000, 1750), shops[6:] + shops[:6], (0, 10))
    frontage(p, (-4400, -1650), (-4400, 1650), blocks)
    frontage(p, (4400, 1650), (4400, -1650), blocks[::-1])
    p.put(p.one("fountain", radius=320.0), 0, 0)
    p.put(p.one("statue", kind="Rider"), 0, 1150, yaw=180)
    p.put(p.one("clock"), -600, -200)
    ring(p, 0, 0, 560, p.kit("bench", 3, back=True), 8, face=-90)
    ring(p, 0, 0, 800, [*trees, *p.kit("planter", 3)], 12, start=15)
    market(p, (-1900, -1500, -500, -400), 4, 3, [*p.kit("crate", 3), *p.kit("sack", 3)])
    for x in range(900, 2200, 300):
        for y in range(-1500, -300, 300):
            table = p.put(p.kit("parasol-table", 4), x + p.uni(-20, 20), y + p.uni(-20, 20))
            p.around(table, p.kit("chair", 3, kind="Metal"), 3, gap=-48)
    for x in (-1500, 1500):
        p.put(p.kit("kiosk", 3), x, 1300, yaw=180)
        p.row((x - 600, 800), (x + 600, 800), p.kit("planter", 4), 5)
    p.row((-2300, 1700), (2300, 1700), p.kit("bollard", 2), 34)
    p.row((-2300, -1700), (2300, -1700), p.kit("bollard", 2), 34)
    p.row((-2100, 1550), (2100, 1550), p.kit("flag", 4), 7)
    p.scatter((-2300, -1650, 2300, 1650), clutter, 70, clear=40)
    p.put(p.one("pavilion", use="Bandstand", size=600.0), 0, -1150)
    p.sun(-40, 40, colour=(255, 248, 236))
    p.view("cafe", (2250, -1650, 175), (-300, 300, 150), 72)
    p.view("fountain", (-900, 1600, 175), (300, -400, 150), 72)


@scene("container-port", "outdoor", "Container port", styles.INDUSTRIAL)
def container_port(p: StagedPlace) -> None:
    """Stacks of containers, gantry cranes, ships at the quay, warehouses, lorries, a rail siding."""
    p.ground((-7000, -4600, 7000, 1200), "Concrete")
    p.ground((-7000, 1200, 7000, 1600), "Asphalt", tile=800)
    p.ground((-8000, 1600, 8000, 5600), family="water")
    for x in range(-5600, 6000, 2800):
        p.put(p.one("crane", kind="HarbourCrane"), x, 1380, yaw=90)
    for x in (-4200, 0, 4200):
        p.put(p.kit("boat", 2, kind="Ferry") + p.kit("boat", 2, kind="Barge"), x, 2050, yaw=p.random.choice((0, 180)))
    p.row(
        (-6200, 2900),
        (6200, 3300),
        [*p.kit("boat", 2, kind="TugBoat"), *p.kit("boat", 2, kind="Barge")],
        6,
        jitter=200,
        yaw=90,
    )
    for bx in range(-6400, 6000, 2200):
        for by in (-2600, -900):
            container_yard(p, bx, by, 3, 5, 4)
    for x in (-4400, 1100):
        p.put(p.one("crane", kind="GantryCrane"), x + 560, 650, yaw=90)
    frontage(p, (-6900, -3600), (6900, -3600), p.kit("hall", 5, depth=1200.0), (200, 500))
    rails(
        p,
        -6900,
        6900,
        -3150,
        [
            *p.kit("train", 2, kind="DieselLocomotive"),
            *p.kit("train", 3, kind="FlatWagon") * 3,
            *p.kit("train", 2, kind="BoxWagon") * 2,
        ],
    )
    trucks = [
        *p.kit("truck", 5, kind="Lorry"),
        *p.kit("tractor", 2, kind="Forklift"),
        *p.kit("truck", 2, kind="TankerTruck"),
    ]
    p.row((-6500, 350), (6500, 350), trucks, 12, jitter=60)
    p.row((-6600, -1650), (6600, -1650), trucks, 12, jitter=40)
    p.row((-6800, 1565), (6800, 1565), p.kit("bollard", 2), 60)
    p.row((-6800, 1080), (6800, 1080), p.kit("streetlamp", 2, kind="Twin"), 18)
    gear = [*p.kit("pallet", 8), *p.kit("barrel", 4), *p.kit("crate", 4), *p.kit("works", 5), *p.kit("boat-gear", 4)]
    p.scatter((-6800, 700, 6800, 1040), gear, 260, clear=30)
    p.scatter((-6800, -3500, 6800, -3400), gear, 60, clear=20)
    p.scatter(
        (-6800, -3000, 6800, 600),
        [*gear, *p.kit("works", 1, kind="TrafficCone"), *p.kit("works", 1, kind="Barrier")],
        420,
        clear=60,
    )
    border(p, (-6950, -4550), (6950, -4550), p.kit("fence", 2, kind="Iron"))
    for x in (-6600, 6600):
        p.row((x, -2800), (x, 300), p.kit("tank", 4), 4, jitter=20)
    p.sun(-44, 120, colour=(255, 250, 240))
    p.view("quay", (-6700, 1150, 260), (0, 1300, 300), 70)
    p.view("stacks", (-300, 500, 400), (-4800, -1500, 200), 72)


@scene("fairground", "outdoor", "Fairground", styles.STYLISED)
def fairground(p: StagedPlace) -> None:
    """Tents, stalls, rides, flags and lamps around a way of coloured paving."""
    p.ground((-4000, -3400, 4000, 3400), "Grass")
    p.trail([(0, -3400), (0, 3200)], 500, "RedPaving")
    p.trail([(-3800, 0), (3800, 0)], 500, "RedPaving", z=1.8)
    tents, kiosks, stalls = (
        p.kit("tent", 10),
        p.kit("kiosk", 6),
        p.kinds_of("stall", "ware", "Fruit", "Bread", "Flower", "Cloth", "Pottery", "Cheese"),
    )
    for side in (-1, 1):
        p.row((side * 620, -3000), (side * 620, -600), [*kiosks, *stalls], 8, yaw=0 if side > 0 else 180)
        p.row((side * 620, 600), (side * 620, 3000), [*kiosks, *stalls], 8, yaw=0 if side > 0 else 180)
        p.row((-3400, side * 620), (-900, side * 620), [*stalls, *kiosks], 7, yaw=180 if side > 0 else 0)
        p.row((900, side * 620), (3400, side * 620), [*stalls, *kiosks], 7, yaw=180 if side > 0 else 0)
    p.put(p.one("tent", round=True, size=620.0, use="CircusTent"), 2400, 2300, scale=2.2)
    p.put(p.one("windmill"), -3200, 2600, yaw=-20)
    for x, y in ((-2200, 2000), (-2000, -2000), (2200, -2000)):
        ring(p, x, y, 520, tents, 6)
        p.put(p.kit("play", 1, kind="Roundabout"), x, y)
        ring(p, x, y, 260, p.kit("play", 4, kind="SpringHorse"), 8, face=0)
    playground(p, -3000, -600 + 2000)
    p.put(p.one("fountain"), 0, 0)
    ring(p, 0, 0, 480, p.kit("bench", 3), 8, face=-90)
    lamps = p.kit("streetlamp", 4, kind="Globe")
    for side in (-1, 1):
        p.row((side * 330, -3200), (side * 330, 3200), [*lamps, *p.kit("flag", 5)], 18)
        p.row((-3700, side * 330), (3700, side * 330), [*lamps, *p.kit("flag", 5)], 18)
    p.scatter(
        (-3700, -3200, 3700, 3200),
        [
            *p.kit("service", 3, kind="Arcade"),
            *p.kit("bin", 3),
            *p.kit("bench", 3),
            *p.kit("parasol-table", 4),
            *p.kit("crate", 3),
            *p.kit("planter", 5),
            *p.kit("animal", 2, kind="Horse"),
            *p.kit("cart", 2),
        ],
        170,
        clear=60,
        avoid=((-330, -3400, 330, 3400), (-3900, -330, 3900, 330)),
    )
    forest(
        p,
        (-3950, -3350, 3950, 3350),
        p.kit("tree", 5),
        60,
        avoid=((-2900, -3400, 3300, 2900), (-4000, -500, 4000, 500)),
    )
    enclosure(p, (-3950, -3350, 3950, 3350), p.kit("fence", 2, kind="Picket"), gate=p.one("gate", width=500.0))
    for x in range(-3, 4, 2):
        p.light(0, x * 900, 420, intensity=6000, radius=1300)
    p.sun(-24, 150, intensity=3.6, colour=(255, 222, 184))
    p.view("way", (90, -3100, 175), (-60, 400, 200), 72)
    p.view("rides", (-1100, -1300, 260), (-2400, -2300, 120), 75)


@scene(
    "rail-yard",
    "outdoor",
    "Rail yard and station",
    styles.INDUSTRIAL.but(wall=("RedBrick", "YellowBrick"), roof=("SlateTile", "DarkConcrete")),
    slot=True,
)
def rail_yard(p: StagedPlace) -> None:
    """A station with platforms and canopies beside sidings full of wagons, a shed and a water tower."""
    p.ground((-7200, -3600, 7200, 3600), "Gravel")
    p.ground((-7200, 2400, 7200, 3600), "Cobble", tile=600, z=0.4)
    kinds = ("PassengerCoach", "BoxWagon", "TankWagon", "HopperWagon", "FlatWagon")
    wagons = {kind: p.kit("train", 3, kind=kind) for kind in kinds}
    engines = [*p.kit("train", 2, kind="SteamLocomotive"), *p.kit("train", 3, kind="DieselLocomotive")]
    for i, y in enumerate((1950, 1250, 550)):
        rails(
            p,
            -7000,
            7000,
            y,
            [engines[i], *(wagons["PassengerCoach"] * 2)[: 4 + i % 2]] if i != 1 else [],
            start=600 + 900 * i,
        )
    for y in (1600, 900):
        for k in range(7):
            deck = p.put(p.one("platform", length=1000.0, wide=330.0), -3200 + 1000 * k, y)
            x = -3200 + 1000 * k
            if k % 2:
                p.put(p.one("canopy", length=900.0), x, y, 90.2, scale=(1.0, 0.6, 1.0))
            for dx, things in (
                (-330, p.kit("bench", 2)),
                (330, p.kit("bench", 2)),
                (-170, p.kit("streetlamp", 2)),
                (180, p.kit("planter", 2)),
                (440, p.kit("bin", 2)),
                (-440, p.kit("crate", 3)),
            ):
                p.relate("on", p.put(things, x + dx, y, 90.2), deck)
    for i in range(6):
        y = -150 - 520 * i
        train = [p.random.choice(wagons[p.random.choice(kinds[1:])]) for _ in range(p.random.randint(6, 11))]
        rails(p, -7000, 7000, y, [p.random.choice(engines), *train] if i % 3 else train, start=p.uni(300, 2500))
        p.put(p.kit("rail-thing", 2, kind="BufferStop"), 6960, y)
        p.row(
            (-6700, y + 240),
            (6600, y + 240),
            [*p.kit("rail-thing", 2, kind="RailSignal"), *p.kit("rail-thing", 2, kind="SwitchLever")],
            7,
            jitter=30,
        )
    p.put(p.one("block", use="Station", storeys=2.0, width=2400.0, depth=700.0), 0, 2850, yaw=180)
    frontage(p, (-1500, 2600), (-7000, 2600), p.kit("hall", 3, depth=800.0), (150, 400))
    frontage(p, (7000, 2600), (1500, 2600), [*p.kit("shop", 4), *p.kit("house", 2)], (60, 300))
    p.row((-6000, 2350), (6000, 2350), p.kit("streetlamp", 2), 16)
    p.row((1500, 2480), (6500, 2480), [*p.kit("car", 6), *p.kit("truck", 2)], 8)
    p.put(p.one("tank", kind="TankOnLegs"), -6500, 1600)
    p.put(p.one("shed", use="SignalBox"), -6000, 1600)
    p.scatter(
        (-7000, -3500, 7000, 300),
        [*p.kit("works", 6), *p.kit("barrel", 3), *p.kit("pallet", 5), *p.kit("crate", 3)],
        200,
        clear=25,
    )
    p.scatter(
        (-6900, 2120, 6900, 2330),
        [*p.kit("bicycle", 3), *p.kit("bench", 3), *p.kit("bin", 2), *p.kit("hydrant", 3), *p.kit("sign", 4)],
        60,
        clear=30,
    )
    border(p, (-7150, -3550), (7150, -3550), p.kit("fence", 2, kind="Plank"))
    forest(p, (-7100, 3250, 7100, 3560), p.kit("tree", 4), 40)
    p.sun(-34, 50, colour=(255, 240, 220))
    p.view("platform", (-3600, 1600, 265), (1500, 1450, 230), 70)
    p.view("sidings", (-6800, -400, 400), (-1500, -1500, 150), 72)


@scene(
    "campus",
    "outdoor",
    "University campus",
    styles.URBAN.but(wall=("RedBrick", "YellowBrick", "WhiteBrick", "Concrete")),
)
def campus(p: StagedPlace) -> None:
    """Halls around lawns with crossing paths, a library with columns, bicycles, a pond."""
    p.ground((-5500, -4500, 5500, 4500), "LawnStripes")
    p.put(p.one("temple", use="MainLibrary"), 0, 3200, yaw=180)
    halls = [
        *p.kit("block", 3, use="LectureHall", storeys=3.0),
        *p.kit("block", 2, use="Laboratory", storeys=4.0),
        *p.kit("block", 2, use="Dormitory", storeys=5.0),
        p.one("block", use="StudentUnion", storeys=2.0),
    ]
    frontage(p, (-4300, 3600), (-4300, -3600), halls, (300, 600))
    frontage(p, (4300, -3600), (4300, 3600), halls[3:] + halls[:3], (300, 600))
    frontage(p, (-3200, -3500), (3200, -3500), halls[5:] + halls[:2], (300, 500))
    for points in (
        [(0, -3200), (0, 2200)],
        [(-4000, 0), (4000, 0)],
        [(-3500, -2600), (3500, 2600)],
        [(-3500, 2600), (3500, -2600)],
        [(-3900, -3000), (-3900, 3000)],
        [(3900, -3000), (3900, 3000)],
    ):
        p.trail(points, 300, "Paving", z=1.0 + 0.5 * (points[0][0] != 0))
    ring(p, 0, 0, 700, p.kit("bench", 3, back=True), 12, face=-90)
    p.put(p.one("fountain", radius=300.0), 0, 0)
    p.put(p.one("statue", kind="Figure"), 0, 1900, yaw=180)
    for side in (-1, 1):
        garden(
            p,
            (side * 2300 - 900, 900, side * 2300 + 900, 2300),
            beds=2,
            benches=p.kit("bench", 2, back=True),
            trees=p.kit("tree", 3, height=560.0),
            path="Gravel",
        )
        p.row((side * 180, -3000), (side * 180, -900), [*p.kit("streetlamp", 2), *p.kit("tree", 3, height=620.0)], 9)
        p.row((side * 1500, -250), (side * 3700, -250), p.kit("bike-rack", 2), 6)
        p.row((side * 1500, -420), (side * 3700, -420), p.kit("bicycle", 5), 14, jitter=20)
        p.row(
            (side * 3700, -2800),
            (side * 3700, 2800),
            [*p.kit("streetlamp", 2), *p.kit("planter", 3), *p.kit("sign", 4)],
            14,
        )
    car_park(p, (-3300, -4450, 3300, -4200 + 350), p.kit("car", 8))
    for x in range(-900, 1000, 300):
        table = p.put(p.kit("parasol-table", 3), x, -1500 + p.uni(-60, 60))
        p.around(table, p.kit("chair", 3, kind="Metal"), 3, gap=-48)
    p.scatter(
        (-3600, -3200, 3600, 2800),
        [*p.kit("bench", 3), *p.kit("bin", 3), *p.kit("bush", 4), *p.kit("statue", 3), *p.kit("sign", 4)],
        110,
        clear=60,
    )
    forest(
        p,
        (-3700, -3200, 3700, 2700),
        p.kit("tree", 5),
        70,
        under=[*p.kit("flowers", 5), *p.kit("bush", 3)],
        floor=120,
        avoid=((-900, -900, 900, 900), (-260, -3300, 260, 2300), (-4100, -200, 4100, 200)),
    )
    p.sun(-42, 70)
    p.view("lawn", (-300, -2900, 175), (200, 1500, 250), 70)
    p.view("union", (3550, 200, 260), (-900, -900, 120), 72)


@scene(
    "forest-ruins",
    "outdoor",
    "Ruins in a forest",
    styles.FANTASY.but(stone=("MossyStone", "Limestone"), leaf=("Leaf", "DarkLeaf", "AutumnLeaf", "GoldenLeaf")),
)
def forest_ruins(p: StagedPlace) -> None:
    """A fallen temple on a terrace among old trees, a stream with a bridge, glowing crystals."""
    p.ground((-3500, -3000, 3500, 3000), "Moss")
    p.ground((-3500, -1450, 3500, -950), family="water", tile=700, z=0.6)
    p.put(p.one("bridge", length=900.0, width=320.0, stone="Limestone"), 0, -1200, yaw=90)
    p.trail([(0, -3000), (0, -1680)], 260, "Flagstone")
    p.trail([(0, -720), (0, 900)], 260, "Flagstone")
    mound = p.put(p.one("mound", of="Moss", width=2600.0, depth=1900.0, high=90.0), 0, 1900)
    p.put(p.one("stairs", width=500.0, steps=5), 0, 830, yaw=180)
    columns = [*p.kit("column", 4, broken=True), *p.kit("column", 3, broken=False)]
    walls = p.kit("ruin-wall", 6)
    for side in (-1, 1):
        for k in range(5):
            p.relate("on", p.put(columns, side * 560, 1350 + 270 * k, 90.2), mound)
    p.relate("on", p.put(p.one("statue", kind="Figure", stone="MossyStone"), 0, 2350, 90.2, 180), mound)
    p.scatter(
        (-850, 1250, 850, 2600),
        [*p.kit("rubble", 3), *p.kit("column", 2, broken=True), *p.kit("flowers", 2, kind="Ferns")],
        22,
        z=90.2,
        clear=40,
    )
    ring(p, 0, -250, 900, walls, 10, face=90, start=18)
    p.put(p.one("fountain"), -600, -250)
    p.put(p.one("tower", round=True, spire=False, height=900.0), -2300, 900)
    p.put(p.one("gatehouse"), 0, -2350)
    p.scatter(
        (-3300, -2800, 3300, 2800),
        [
            *p.kit("rubble", 4),
            *p.kit("mushroom", 3, crystal=True),
            *p.kit("mushroom", 4, crystal=False),
            *p.kinds("log", "FallenLog", "TreeStump"),
        ],
        70,
        clear=40,
        avoid=((-200, -3000, 200, 1000), (-3500, -1500, 3500, -900), (-1400, 850, 1400, 2900)),
    )
    forest(
        p,
        (-3450, -2950, 3450, 2950),
        [*p.kit("tree", 7), *p.kit("conifer", 4)],
        150,
        under=[*p.kit("bush", 4), *p.kit("flowers", 6), *p.kit("rock", 6)],
        floor=230,
        avoid=((-300, -3000, 300, 1000), (-3500, -1560, 3500, -840), (-1500, 800, 1500, 2950)),
    )
    p.scatter(
        (-3400, -1420, 3400, -980),
        p.kit("flowers", 3, kind="Reeds"),
        40,
        z=0.6,
        clear=10,
        avoid=((-250, -1500, 250, -900),),
    )
    for x, y in ((-600, 1600), (600, 2100), (0, -2350), (-900, -250)):
        p.light(x, y, 260, intensity=5000, radius=900, colour=(150, 200, 255))
    p.sun(-28, 30, intensity=3.6, colour=(255, 232, 196))
    p.view("path", (40, -2050, 180), (-40, 1500, 220), 70)
    p.view("temple", (-1250, 700, 300), (300, 2000, 200), 75)


@scene(
    "farm",
    "outdoor",
    "Great farm",
    styles.DOMESTIC.but(
        wall=("RedBoards", "WhiteBoards"), old=True, paint=("RedPaint", "GreenPaint", "BluePaint", "YellowPaint")
    ),
)
def farm(p: StagedPlace) -> None:
    """Fields of seven crops in rows around a farmyard with barns, silos, animals and machines."""
    p.ground((-9000, -7000, 9000, 7000), "Grass", tile=1500)
    p.trail([(-9000, 0), (9000, 0)], 500, "Soil")
    p.trail([(0, -7000), (0, 7000)], 500, "Soil", z=1.8)
    crops = ("Wheat", "Maize", "Cabbage", "Lettuce", "Carrot", "Pumpkin", "Strawberry", "Leek", "Vine")
    for k, (x0, y0, x1, y1) in enumerate(
        (
            (-8700, 500, -4600, 6700),
            (-8700, -6700, -4600, -500),
            (-4300, 3600, -500, 6700),
            (-4300, -6700, -500, -3200),
            (500, 3600, 4300, 6700),
            (500, -6700, 4300, -3200),
            (4600, -6700, 8700, -500),
            (4600, 500, 8700, 3400),
        )
    ):
        field(p, (x0, y0, x1, y1), crops[k], step=(66.0, 58.0, 62.0, 50.0, 47.0, 66.0, 48.0, 58.0)[k])
    for x in range(4800, 8700, 560):
        for y in range(3900, 6700, 560):
            p.relate(
                "in_grid", p.put(p.kit("tree", 3, leaf="Blossom", height=450.0), x, y, yaw=p.uni(0, 360), scale=0.7)
            )
    p.put(p.one("house", storeys=2, width=1100.0), -1500, 2300, yaw=180)
    for x, y, yaw, use in (
        (-3200, 2000, -90, "Barn"),
        (1700, 2400, 180, "Barn"),
        (3300, 1500, 90, "CowShed"),
        (1700, -1500, 0, "Granary"),
    ):
        p.put(p.one("hall", use=use, width=1400.0, depth=900.0, high=450.0), x, y, yaw=yaw)
    p.row((2900, 2900), (3900, 2900), p.kit("tank", 2, kind="GrainSilo"), 3, scale=(0.6, 0.6))
    p.put(p.one("windmill"), -3500, -1500, yaw=30)
    p.put(p.one("greenhouse"), -2000, -1400)
    p.put(p.one("greenhouse"), -2000, -2200)
    p.put(p.one("well"), -700, 1300)
    p.ground((-3000, 500, 3000, 1900), "Soil", tile=700, z=0.6)
    animals = p.kinds("animal", "Cow", "Sheep", "Horse", "Goat", "Donkey")
    for box in ((-4200, -2900, -2400, -2300), (500, -3000, 3900, -1950)):
        enclosure(p, box, p.kit("fence", 2, kind="Rail"), gate=p.one("gate"))
        p.scatter(
            (box[0] + 150, box[1] + 150, box[2] - 150, box[3] - 150),
            [*animals, *p.kit("animal", 3, kind="Sheep")],
            24,
            clear=60,
        )
    p.scatter(
        (-2800, 550, 2800, 1850),
        [
            *p.kinds("animal", "Hen", "Duck", "Pig", "Dog", "Cat"),
            *p.kit("crate", 4),
            *p.kit("barrel", 3),
            *p.kit("sack", 4),
            *p.kit("handcart", 4),
            *p.kinds("log", "Firewood", "WoodPile"),
            *p.kinds("works", "Wheelbarrow", "Ladder"),
        ],
        120,
        clear=40,
    )
    p.row(
        (-2500, 700),
        (2500, 700),
        [*p.kit("tractor", 3, kind="Tractor"), *p.kit("cart", 3), *p.kinds("car", "Pickup")],
        6,
    )
    for a, b in (
        ((-8900, 350), (-300, 350)),
        ((300, 350), (8900, 350)),
        ((-8900, -350), (-300, -350)),
        ((300, -350), (8900, -350)),
    ):
        border(p, a, b, p.kit("fence", 2, kind="Rail"))
    p.row((-8800, 6900), (8800, 6900), p.kit("conifer", 4), 46, jitter=40)
    p.row((-8800, -6900), (8800, -6900), p.kit("tree", 4), 40, jitter=40)
    p.scatter(
        (-4200, -3000, 4200, 3400),
        [*p.kit("bush", 4), *p.kit("flowers", 6), *p.kit("rock", 3)],
        200,
        clear=40,
        avoid=((-4200, -300, 4200, 300), (-300, -3100, 300, 3500)),
    )
    p.sun(-38, 55, colour=(255, 246, 226))
    p.view("yard", (-2700, 300, 200), (900, 1700, 150), 72)
    p.view("fields", (-300, 3000, 500), (-7500, 4800, 0), 72)


@scene("suburb", "outdoor", "Suburban street", styles.DOMESTIC, slot=True)
def suburb(p: StagedPlace) -> None:
    """Houses with front gardens, hedges, drives with cars, a playground at the corner."""
    p.ground((-6000, -3600, 6000, 3600), "Grass")
    houses = p.kit("house", 12)
    cars, trees = p.kit("car", 9), p.kit("tree", 5, height=600.0)
    street(
        p,
        -6000,
        6000,
        0,
        pavement="Paving",
        lamps=p.kit("streetlamp", 2, kind="Arm"),
        cars=cars,
        share=0.35,
        clutter=[*p.kinds("hydrant", "Hydrant", "PostBox", "ElectricBox"), *p.kit("bin", 3), *p.kit("bicycle", 3)],
    )
    number = 0
    hedges, fences = p.kit("hedge", 2, length=250.0, high=80.0), p.kit("fence", 3, kind="Picket", length=250.0)
    for side in (-1, 1):
        x = -5900.0
        while True:
            house = houses[number % len(houses)]
            thing = p.thing(house)
            plot = thing.width + 900
            if x + plot > 5900 or (side > 0 and x + plot > 3600):
                break
            number += 1
            with p.at(x + plot / 2, side * 660, 180 if side > 0 else 0):
                p.put(house, -150, -700 - thing.high[1])
                p.trail([(-150, -20), (-150, -690)], 140, "Flagstone")
                p.trail([(plot / 2 - 260, 0), (plot / 2 - 260, -1000)], 300, "Concrete")
                p.put(cars, plot / 2 - 260, -450, 0, 90)
                for k in range(int((plot - 700) // 251)):
                    fx = -plot / 2 + 140 + 251 * k
                    if abs(fx + 150) > 190:
                        p.put(hedges if number % 2 else fences, fx, -30)
                p.scatter(
                    (-plot / 2 + 80, -620, plot / 2 - 480, -110),
                    [*p.kit("flowers", 6), *p.kit("bush", 4), *p.kinds("works", "Wheelbarrow")],
                    12,
                    clear=15,
                )
                p.put(trees, -plot / 2 + 220, -420, yaw=p.uni(0, 360), scale=0.7)
                p.scatter(
                    (-plot / 2 + 100, -2700, plot / 2 - 150, -1750),
                    [
                        *p.kit("shed", 4),
                        *trees,
                        *p.kinds("play", "Swing", "Sandbox", "PlayHouse"),
                        *p.kit("parasol-table", 2),
                        *p.kinds("log", "Firewood"),
                        *p.kit("bush", 4),
                    ],
                    8,
                    clear=60,
                )
                border(p, (-plot / 2, -2850), (-plot / 2, -1100), p.kit("fence", 2, kind="Plank", length=290.0))
            x += plot
    playground(p, 4900, 1600)
    p.put(p.one("bus-shelter"), 3900, 560, yaw=180)
    forest(p, (-5900, 3000, 5900, 3550), trees, 40)
    p.row((-5800, -3500), (5800, -3500), p.kit("conifer", 4), 30, jitter=60)
    p.sun(-40, 65, colour=(255, 248, 234))
    p.view("street", (-4200, 430, 170), (1500, -100, 160), 70)
    p.view("gardens", (900, -560, 300), (-1500, -1500, 120), 74)
