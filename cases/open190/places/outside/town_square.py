"""Town square."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.land import ring
from cases.open190.parts.streets import frontage, street
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("town-square", "outdoor", "Town square", styles.URBAN, slot=True)
def town_square(p: StagedPlace) -> None:
    """A square with a fountain, cafes and market stalls between streets of shops."""
    p.ground((-5200, -4600, 5200, 4600), "Concrete")
    p.ground((-2400, -1800, 2400, 1800), "Paving", tile=600, z=0.8)
    shops, blocks = p.kit("shop", 12), p.kit("block", 3, storeys=4.0, width=1800.0, depth=1000.0)
    cars, lamps, trees = p.kit("car", 10), p.kit("streetlamp", 4), p.kit("tree", 4, height=650.0)
    clutter = [
        *p.kit("bench", 3, back=True),
        *p.kit("bin", 3),
        *p.kit("hydrant", 5),
        *p.kit("planter", 4),
        *p.kit("sign", 5),
        *p.kit("bicycle", 3),
        *p.kit("bike-rack", 1),
    ]
    street(p, -5200, 5200, 2500, north=shops, trees=trees, cars=cars, lamps=lamps, clutter=clutter)
    street(p, -5200, 5200, -2500, south=shops[::-1], trees=trees, cars=cars, lamps=lamps, clutter=clutter)
    frontage(p, (-3000, 1750), (-3000, -1750), shops[3:] + shops[:3], (0, 10))
    frontage(p, (3000, -1750), (3000, 1750), shops[6:] + shops[:6], (0, 10))
    frontage(p, (-4400, -1650), (-4400, 1650), blocks)
    frontage(p, (4400, 1650), (4400, -1650), blocks[::-1])
    p.put(p.one("fountain", radius=320.0), 0, 0)
    p.put(p.one("statue", kind="Rider"), 0, 1150, yaw=180)
    p.put(p.one("clock"), -600, -200)
    ring(p, 0, 0, 560, p.kit("bench", 3, back=True), 8, face=-90)
    ring(p, 0, 0, 800, [*trees, *p.kit("planter", 3)], 12, start=15)
    market(p, (-1900, -1500, -500, -400), 4, 3, [*p.kit("crate", 3), *p.kit("sack", 3)])
    for x in range(900, 2200, 300):
        for y in range(-1500, -300, 300):
            table = p.put(p.kit("parasol-table", 4), x + p.uni(-20, 20), y + p.uni(-20, 20))
            p.around(table, p.kit("chair", 3, kind="Metal"), 3, gap=-48)
    for x in (-1500, 1500):
        p.put(p.kit("kiosk", 3), x, 1300, yaw=180)
        p.row((x - 600, 800), (x + 600, 800), p.kit("planter", 4), 5)
    p.row((-2300, 1700), (2300, 1700), p.kit("bollard", 2), 34)
    p.row((-2300, -1700), (2300, -1700), p.kit("bollard", 2), 34)
    p.row((-2100, 1550), (2100, 1550), p.kit("flag", 4), 7)
    p.scatter((-2300, -1650, 2300, 1650), clutter, 70, clear=40)
    p.put(p.one("pavilion", use="Bandstand", size=600.0), 0, -1150)
    p.sun(-40, 40, colour=(255, 248, 236))
    p.view("cafe", (2250, -1650, 175), (-300, 300, 150), 72)
    p.view("fountain", (-900, 1600, 175), (300, -400, 150), 72)
