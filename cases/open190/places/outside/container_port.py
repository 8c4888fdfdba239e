"""Container port."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import border
from cases.open190.parts.rails import rails
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import container_yard
from cases.open190.scenes import scene
from catalog.kits import styles


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
