"""Power station."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import yard_goods
from cases.open190.parts.gardens import border
from cases.open190.parts.rails import rails
from cases.open190.parts.streets import car_park
from cases.open190.scenes import scene
from catalog.kits import styles


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
