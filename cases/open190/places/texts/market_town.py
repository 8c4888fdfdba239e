"""Medieval market town."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.land import field, forest, ring
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("market-town", "text", "Medieval market town", styles.HISTORICAL, 130)
def market_town(p: StagedPlace) -> None:
    """Timbered houses around a cobbled market with a well, a church and a gate."""
    p.plate(130, "Grass")
    p.ground((-2600, -2200, 2600, 2200), "Cobble", tile=650, z=0.5)
    houses = p.kit("house", 8, storeys=2) + p.kit("house", 4, storeys=3)
    frontage(p, (2500, 2300), (-2500, 2300), houses, (0, 30))
    frontage(p, (-2500, -2300), (-420, -2300), houses[5:] + houses[:5], (0, 30))
    frontage(p, (420, -2300), (2500, -2300), houses[3:] + houses[:3], (0, 30))
    frontage(p, (-2700, 2200), (-2700, -2200), houses[::-1], (0, 60))
    frontage(p, (2700, -2200), (2700, 2200), houses[7:] + houses[:7], (0, 60))
    p.put(p.one("church"), -1500, 1150, yaw=180)
    p.put(p.one("gatehouse"), 0, -2650)
    market(p, (-800, -1700, 2300, -200), 7, 3, old_goods(p))
    p.put(p.one("well"), 300, 700)
    p.put(p.one("statue", kind="Figure"), 1500, 1200, yaw=180)
    ring(p, 300, 700, 420, p.kit("bench", 2, back=False), 6, face=-90)
    p.scatter((-2400, -2000, 2400, 2000), old_goods(p), 60, clear=40)
    p.scatter((-2400, -2000, 2400, 2000), p.kinds("animal", "Hen", "Dog", "Goat", "Horse"), 14, clear=40)
    p.row((-2300, -2050), (2300, -2050), p.kit("flag", 4, banner=True), 8)
    forest(p, (-6200, 3600, 6200, 6200), p.kit("tree", 5), 60, under=[*p.kit("bush", 3), *p.kit("rock", 3)], floor=60)
    for x in (-5200, 4200):
        field(p, (x - 900, -5800, x + 1300, -3400), p.random.choice(("Wheat", "Cabbage")), step=190)
    p.trail([(0, -6400), (0, -2850)], 420, "Cobble")
    p.palette(140, "house", "stall", "crate", "barrel", "fence", "tree", "animal", "sign", "cart", "shed", "forge")
