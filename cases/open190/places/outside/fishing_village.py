"""Fishing village."""

from __future__ import annotations

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
