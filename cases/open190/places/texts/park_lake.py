"""City park with a lake."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import garden, playground
from cases.open190.parts.land import forest, ring
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("park-lake", "text", "City park with a lake", styles.URBAN, 200)
def park_lake(p: StagedPlace) -> None:
    """A lake with rowing boats, lawns, winding paths, a bandstand, a playground, kiosks."""
    p.plate(200, "Grass")
    p.ground((-4500, 500, 4500, 5500), family="water", z=0.6)
    p.trail([(-9800, -1500), (-5200, -400), (-5200, 6200), (5200, 6200), (5200, -400), (9800, -1500)], 300, "Gravel")
    p.trail([(-5200, -300), (5200, -300)], 300, "Gravel", z=1.8)
    p.trail([(0, -9800), (0, -300)], 300, "Gravel", z=2.0)
    p.put(p.one("jetty", length=900.0, wide=260.0, high=60.0), -1500, 980, yaw=90)
    p.scatter(
        (-4000, 1000, 4000, 5000),
        [*p.kit("boat", 4, kind="RowingBoat"), *p.kit("boat", 2, kind="SailingBoat")],
        16,
        clear=120,
    )
    p.put(p.one("pavilion", use="Bandstand", size=600.0), 0, -3600)
    ring(p, 0, -3600, 900, p.kit("bench", 3, back=True), 14, face=-270)
    playground(p, 5500, -5000)
    garden(
        p,
        (-7600, -7000, -3200, -3400),
        beds=4,
        centre=p.one("fountain"),
        benches=p.kit("bench", 3),
        trees=p.kit("tree", 4),
    )
    for x in (-2600, 2600):
        p.put(p.kit("kiosk", 3), x, -900, yaw=0)
        for k in range(5):
            table = p.put(p.kit("parasol-table", 3), x - 700 + 350 * k, -1400 + p.uni(-50, 50))
            p.around(table, p.kit("chair", 2, kind="Metal"), 3, gap=-48)
    p.row((-5000, -560), (5000, -560), [*p.kit("streetlamp", 2), *p.kit("bench", 3, back=True), *p.kit("bin", 2)], 30)
    p.row((-5500, -100), (-5500, 6000), [*p.kit("streetlamp", 2), *p.kit("bench", 2, back=True)], 13, yaw=180)
    p.scatter((-4700, 350, 4700, 480), p.kit("flowers", 3, kind="Reeds"), 40, clear=5)
    p.row((-3000, -7900), (3000, -7900), p.kit("statue", 5), 7)
    p.scatter(
        (-9000, -9000, 9000, 9000),
        [*p.kinds("animal", "Duck", "Dog"), *p.kit("bicycle", 3), *p.kit("flowers", 5), *p.kit("rock", 3)],
        70,
        clear=60,
        avoid=((-4600, 400, 4600, 5600),),
    )
    forest(
        p,
        (-9800, -9800, 9800, 9800),
        [*p.kit("tree", 7), *p.kit("conifer", 3)],
        260,
        under=p.kit("bush", 5),
        floor=140,
        avoid=(
            (-5700, -2000, 5700, 6600),
            (-1400, -9800, 1400, -2400),
            (-7900, -7300, -2900, -3100),
            (4500, -6000, 6500, -4000),
        ),
    )
    p.palette(
        135,
        "tree",
        "flowers",
        "bench",
        "boat",
        "statue",
        "planter",
        "bush",
        "streetlamp",
        "kiosk",
        "sign",
        "play",
        "animal",
    )
