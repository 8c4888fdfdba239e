"""Bus terminal."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.streets import car_park
from cases.open190.scenes import scene
from catalog.kits import styles


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
