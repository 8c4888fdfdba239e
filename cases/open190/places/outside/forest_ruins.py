"""Ruins in a forest."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.land import forest, ring
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "forest-ruins",
    "outdoor",
    "Ruins in a forest",
    styles.FANTASY.but(stone=("MossyStone", "Limestone"), leaf=("Leaf", "DarkLeaf", "AutumnLeaf", "GoldenLeaf")),
    slot=True,
)
def forest_ruins(p: StagedPlace) -> None:
    """A fallen temple on a terrace among old trees, a stream with a bridge, glowing crystals."""
    p.ground((-3500, -3000, 3500, 3000), "Moss")
    p.ground((-3500, -1450, 3500, -950), family="water", tile=700, z=0.6)
    p.put(p.one("bridge", length=900.0, width=320.0, stone="Limestone"), 0, -1200, yaw=90)
    p.trail([(0, -3000), (0, -1680)], 260, "Flagstone")
    p.trail([(0, -720), (0, 900)], 260, "Flagstone")
    mound = p.put(p.one("mound", of="Moss", width=2600.0, depth=1900.0, high=90.0), 0, 1900)
    p.put(p.one("stairs", width=500.0, steps=5), 0, 830, yaw=180)
    columns = [*p.kit("column", 4, broken=True), *p.kit("column", 3, broken=False)]
    walls = p.kit("ruin-wall", 6)
    for side in (-1, 1):
        for k in range(5):
            p.relate("on", p.put(columns, side * 560, 1350 + 270 * k, 90.2), mound)
    p.relate("on", p.put(p.one("statue", kind="Figure", stone="MossyStone"), 0, 2350, 90.2, 180), mound)
    p.scatter(
        (-850, 1250, 850, 2600),
        [*p.kit("rubble", 3), *p.kit("column", 2, broken=True), *p.kit("flowers", 2, kind="Ferns")],
        22,
        z=90.2,
        clear=40,
    )
    ring(p, 0, -250, 900, walls, 10, face=90, start=18)
    p.put(p.one("fountain"), -600, -250)
    p.put(p.one("tower", round=True, spire=False, height=900.0), -2300, 900)
    p.put(p.one("gatehouse"), 0, -2350)
    p.scatter(
        (-3300, -2800, 3300, 2800),
        [
            *p.kit("rubble", 4),
            *p.kit("mushroom", 3, crystal=True),
            *p.kit("mushroom", 4, crystal=False),
            *p.kinds("log", "FallenLog", "TreeStump"),
        ],
        70,
        clear=40,
        avoid=((-200, -3000, 200, 1000), (-3500, -1500, 3500, -900), (-1400, 850, 1400, 2900)),
    )
    forest(
        p,
        (-3450, -2950, 3450, 2950),
        [*p.kit("tree", 7), *p.kit("conifer", 4)],
        150,
        under=[*p.kit("bush", 4), *p.kit("flowers", 6), *p.kit("rock", 6)],
        floor=230,
        avoid=((-300, -3000, 300, 1000), (-3500, -1560, 3500, -840), (-1500, 800, 1500, 2950)),
    )
    p.scatter(
        (-3400, -1420, 3400, -980),
        p.kit("flowers", 3, kind="Reeds"),
        40,
        z=0.6,
        clear=10,
        avoid=((-250, -1500, 250, -900),),
    )
    for x, y in ((-600, 1600), (600, 2100), (0, -2350), (-900, -250)):
        p.light(x, y, 260, intensity=5000, radius=900, colour=(150, 200, 255))
    p.sun(-28, 30, intensity=3.6, colour=(255, 232, 196))
    p.view("path", (40, -2050, 180), (-40, 1500, 220), 70)
    p.view("temple", (-1250, 700, 300), (300, 2000, 200), 75)
