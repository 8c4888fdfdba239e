"""Business park."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.streets import car_park
from cases.open190.scenes import scene
from catalog.kits import styles


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
