"""Cemetery with a chapel."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import cemetery, enclosure
from cases.open190.parts.land import forest
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "cemetery-hill",
    "text",
    "Cemetery with a chapel",
    styles.HISTORICAL.but(leaf=("AutumnLeaf", "GoldenLeaf", "DarkLeaf"), stone=("Granite", "MossyStone", "DarkStone")),
    130,
)
def cemetery_hill(p: StagedPlace) -> None:
    """Graves in rows inside a wall, a chapel, tombs, statues, autumn trees, an iron gate."""
    p.plate(130, "Grass")
    enclosure(p, (-5200, -4600, 5200, 4600), p.kit("wall", 2, high=140.0), gate=p.one("gate", width=400.0))
    p.trail([(0, -6400), (0, 2200)], 300, "Gravel")
    p.trail([(-5000, -400), (5000, -400)], 300, "Gravel", z=1.8)
    p.put(p.one("church"), 0, 3300, yaw=180)
    for side in (-1, 1):
        cemetery(p, (side * 2700 - 2100, -4100, side * 2700 + 2100, -1000), 9, 7)
        cemetery(p, (side * 3200 - 1600, 300, side * 3200 + 1600, 3900), 7, 8)
        p.row(
            (side * 330, -4300), (side * 330, 1800), [*p.kit("conifer", 2), *p.kit("streetlamp", 2, kind="Lantern")], 10
        )
        p.row((side * 600, -250), (side * 4800, -250), p.kit("bench", 3), 5, yaw=180)
    p.row((-4800, 4300), (4800, 4300), p.kit("statue", 5), 9, yaw=180)
    p.put(p.one("statue", kind="Obelisk"), 800, 900)
    p.put(p.one("shed", use="GraveDiggerHut"), -4700, -4100)
    p.scatter(
        (-5000, -4400, 5000, 4400),
        [*p.kit("tree", 5), *p.kit("bush", 3), *p.kit("flowers", 4), *p.kit("planter", 2)],
        90,
        clear=40,
        avoid=((-300, -4600, 300, 2400), (-5000, -650, 5000, -150)),
    )
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 5),
        90,
        avoid=((-5500, -4900, 5500, 4900), (-400, -6400, 400, -4000)),
    )
    p.palette(60, "tomb", "statue", "tree", "bench", "planter", "column", "flowers")
