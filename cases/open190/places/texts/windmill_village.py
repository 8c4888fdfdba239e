"""Windmill village."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.land import field
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "windmill-village",
    "text",
    "Windmill village",
    styles.HISTORICAL.but(wall=("RedBrick", "WhiteBoards", "GreenBoards"), trim=("WhitePaint",), old=False),
    200,
)
def windmill_village(p: StagedPlace) -> None:
    """Mills along a canal, fields of tulips in coloured rows, brick houses, a bridge."""
    p.plate(200, "Grass")
    p.ground((-9900, -600, 9900, 200), family="water", tile=800, z=0.6)
    mills = p.kit("windmill", 3)
    for x in range(-8000, 8001, 3200):
        p.put(mills, x, 900, yaw=p.uni(-30, 30) + 180)
    for x in (-4800, 0, 4800):
        p.put(p.one("bridge", length=1000.0, width=320.0), x, -200, yaw=90)
    houses = p.kit("house", 9)
    frontage(p, (-7000, -2300), (7000, -2300), houses, (200, 500))
    p.trail([(-9800, -1150), (9800, -1150)], 300, "RedPaving")
    for k, x0 in enumerate((-9000, -4600, 600, 5000)):
        for strip in range(8):
            kind = ("Tulip", "YellowTulip", "PinkTulip", "Lavender")[(k + strip) % 4]
            y0 = 2200 + 820 * strip
            field(p, (x0, y0, x0 + 3900, y0 + 800), kind, soil="DarkSoil", step=180)
    p.row((-9500, -850), (9500, -850), p.kit("tree", 3, height=600.0), 26, scale=(0.6, 0.8))
    p.row((-9000, -1450), (9000, -1450), p.kit("streetlamp", 2), 14)
    for x in (-6400, -2500, 2600, 6500):
        p.put(p.kit("boat", 3, kind="Barge") + p.kit("boat", 2, kind="RowingBoat"), x, -200)
    market(p, (-1500, -5000, 1500, -4200), 6, 2, old_goods(p))
    p.put(p.one("church"), 0, -6500, yaw=0)
    p.scatter(
        (-9000, -9500, 9000, -3500),
        [*p.kinds("animal", "Cow", "Sheep", "Horse"), *p.kit("tree", 3), *p.kit("bush", 3)],
        130,
        clear=150,
        avoid=((-1800, -7600, 1800, -3900),),
    )
    p.scatter(
        (-9000, -1650, 9000, -1250), [*p.kit("bicycle", 4), *p.kit("bench", 3), *p.kit("planter", 4)], 50, clear=60
    )
    p.palette(150, "house", "windmill", "flowers", "boat", "bicycle", "animal", "fence", "tree", "shed", "crop", "sign")
