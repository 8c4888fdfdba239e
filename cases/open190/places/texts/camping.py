"""Camping ground by a lake."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import playground
from cases.open190.parts.land import forest, ring
from cases.open190.parts.water import waterfront
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "camping",
    "text",
    "Camping ground by a lake",
    styles.DOMESTIC.but(
        awning=("BlueStripes", "GreenStripes", "OrangeCloth", "TealCloth", "RedStripes"),
        wall=("PalePlanks", "GreenBoards"),
    ),
    200,
)
def camping(p: StagedPlace) -> None:
    """Tents, vans and tables under trees by a lake with a jetty and boats, a wash house, a fire ring."""
    p.plate(200, "Grass")
    waterfront(
        p,
        -9800,
        9800,
        5500,
        deep=4300,
        boats=p.kit("boat", 4, kind="RowingBoat")
        + p.kit("boat", 2, kind="SailingBoat")
        + p.kit("boat", 2, kind="MotorBoat"),
        jetties=3,
    )
    p.ground((-9800, 4700, 9800, 5500), "Sand", tile=800, z=0.5)
    p.trail([(-9800, 0), (9800, 0)], 350, "Gravel")
    p.trail([(0, -9800), (0, 4700)], 350, "Gravel", z=1.8)
    for x in range(-8800, 8900, 1600):
        for y in (-7800, -5400, -3000, 1500, 3300):
            if abs(x) < 500:
                continue
            with p.at(x + p.uni(-150, 150), y + p.uni(-150, 150), p.random.choice((0, 90, 180, -90))):
                p.put(p.kit("tent", 8), 0, 0)
                p.put([*p.kit("car", 6), *p.kit("car", 2, kind="Van")], 620, 0, 0, 90)
                table = p.put(p.kit("table", 3, kind="Trestle"), -100, 620)
                p.around(table, p.kit("chair", 3), 4)
                p.on(table, p.kinds("dish", "Cup", "Plate", "Bottle", "FruitBowl"), 3)
    ring(p, 3200, -1200, 420, p.kinds("log", "FallenLog"), 5, face=0)
    p.put(p.one("forge", kind="Cauldron"), 3200, -1200)
    p.put(p.one("house", storeys=1, noun="WashHouse"), -3200, -1400, yaw=180)
    p.put(p.one("kiosk"), 1200, 700, yaw=180)
    playground(p, -6500, -1400)
    p.row(
        (-9000, 5000),
        (9000, 5000),
        [*p.kit("parasol-table", 3), *p.kinds("boat-gear", "LifeRing"), *p.kit("bench", 2)],
        18,
    )
    p.row(
        (-9500, 260),
        (9500, 260),
        [*p.kit("streetlamp", 2), *p.kit("bin", 2), *p.kit("sign", 3), *p.kit("bicycle", 3)],
        26,
    )
    forest(
        p,
        (-9800, -9800, 9800, 4600),
        [*p.kit("tree", 5), *p.kit("conifer", 4)],
        150,
        under=[*p.kit("bush", 3), *p.kit("flowers", 4), *p.kit("rock", 3)],
        floor=120,
        avoid=((-9900, -350, 9900, 350), (-350, -9900, 350, 4700)),
    )
    p.palette(110, "tent", "car", "boat", "tree", "chair", "bicycle", "sign", "bench", "flowers", "animal")
