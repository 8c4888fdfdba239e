"""Mountain monastery."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.gardens import cemetery, enclosure, garden
from cases.open190.parts.land import field, forest
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "mountain-monastery",
    "text",
    "Mountain monastery",
    styles.HISTORICAL.but(
        wall=("WhitePlaster", "Limestone", "Sandstone"), roof=("BrownTile", "RedTile"), stone=("Limestone", "Sandstone")
    ),
    130,
)
def monastery(p: StagedPlace) -> None:
    """A cloister with a herb garden, a church on a terrace, vines, graves, a bell tower."""
    p.plate(130, "DryGrass")
    mound = p.put(p.one("mound", of="DryGrass", width=3400.0, depth=2600.0, high=150.0), 0, 3300)
    p.relate("on", p.put(p.one("church"), 0, 3300, 150.2, 180), mound)
    p.scatter((-1200, 2400, 1200, 2700), p.kit("bench", 2), 5, z=150.2, clear=40)
    p.put(p.one("stairs", width=500.0, steps=9), 0, 1780, yaw=180)
    enclosure(
        p, (-2800, -2200, 2800, 1500), p.kit("wall", 2, stone="Limestone", high=180.0), gate=p.one("gate", width=360.0)
    )
    halls = p.kit("house", 4, storeys=2, depth=600.0)
    frontage(p, (-2700, 1400), (-2700, -1800), halls, (20, 60))
    frontage(p, (2700, -1800), (2700, 1400), halls[::-1], (20, 60))
    columns = p.kit("column", 2, broken=False, height=380.0)
    for x in range(-1500, 1501, 300):
        for y in (-1300, 1100):
            p.put(columns, x, y)
    for y in range(-1000, 1000, 300):
        for x in (-1500, 1500):
            p.put(columns, x, y)
    garden(
        p,
        (-1250, -1050, 1250, 850),
        beds=3,
        centre=p.one("well"),
        hedge=False,
        benches=p.kit("bench", 2),
        trees=p.kit("tree", 2, height=480.0),
    )
    p.put(p.one("tower", round=False, spire=True, height=1400.0), -2100, 2300, yaw=180)
    cemetery(p, (1900, 2200, 3200, 3400), 5, 4)
    field(p, (-5800, -5600, -3200, -2600), "Vine", step=200)
    field(p, (3200, -5600, 5800, -2600), "Vine", step=200)
    p.row((-2600, 1650), (2600, 1650), p.kit("conifer", 3), 9)
    p.scatter((-2500, -2100, 2500, 1350), [*old_goods(p), *p.kit("planter", 3)], 30, clear=60)
    forest(
        p,
        (-6200, 1800, 6200, 6200),
        p.kit("conifer", 5),
        90,
        under=p.kit("rock", 6),
        floor=40,
        avoid=((-2600, 1500, 3400, 4800),),
    )
    p.trail([(0, -6400), (0, -2300)], 300, "Gravel")
    p.put(p.one("hill", of="Rock"), -4300, 5300)
    p.palette(110, "column", "statue", "tomb", "flowers", "tree", "bench", "fence", "planter", "barrel", "house")
