"""Oil refinery."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import yard_goods
from cases.open190.parts.gardens import border
from cases.open190.parts.rails import rails
from cases.open190.scenes import scene
from catalog.kits import styles


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
