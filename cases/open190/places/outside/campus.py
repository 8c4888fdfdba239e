"""University campus."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import garden
from cases.open190.parts.land import forest, ring
from cases.open190.parts.streets import car_park, frontage
from cases.open190.scenes import scene
from catalog.kits import styles


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
