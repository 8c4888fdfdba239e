"""Country railway station."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import border, enclosure
from cases.open190.parts.land import field, forest
from cases.open190.parts.rails import rails
from cases.open190.scenes import scene
from catalog.kits import styles


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
