"""Rail yard and station."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import border
from cases.open190.parts.land import forest
from cases.open190.parts.rails import rails
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


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
