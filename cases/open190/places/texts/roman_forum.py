"""Roman forum."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "roman-forum",
    "text",
    "Roman forum",
    styles.HISTORICAL.but(
        wall=("Sandstone", "CreamPlaster"),
        roof=("OrangeTile", "RedTile"),
        stone=("Limestone", "Marble", "Sandstone"),
        awning=("RedCloth", "YellowStripes"),
    ),
    130,
)
def roman_forum(p: StagedPlace) -> None:
    """Temples and colonnades around a paved forum with statues, stalls and an obelisk."""
    p.plate(130, "DryGrass")
    p.ground((-3600, -2800, 3600, 2800), "Flagstone", tile=700, z=0.5)
    for x, y, yaw in ((0, 3900, 180), (-4700, 900, -90), (4700, 900, 90)):
        p.put(p.kit("temple", 3, use="Temple"), x, y, yaw=yaw)
    whole = p.kit("column", 3, broken=False, height=460.0)
    for side in (-1, 1):
        p.row((side * 3300, -2600), (side * 3300, 2600), whole, 14)
        p.row((side * 2900, -2600), (side * 2900, 2600), whole, 14)
    p.row((-2600, -2650), (2600, -2650), whole, 13)
    p.put(p.one("statue", kind="Obelisk"), 0, 0)
    p.put(p.one("fountain"), -1500, 1200)
    p.put(p.one("fountain"), 1500, 1200)
    p.row((-2200, 2500), (2200, 2500), p.kit("statue", 6), 9, yaw=180)
    market(p, (-2200, -1900, 2200, -500), 7, 3, [*p.kit("sack", 3), *p.kit("crate", 3)])
    p.row((-2400, 700), (2400, 700), [*p.kit("bench", 2, back=False), *p.kit("planter", 3)], 10)
    frontage(p, (-6000, -4600), (6000, -4600), p.kit("house", 7), (60, 200))
    p.put(p.one("ruin-wall", length=700.0), -5400, -1600, yaw=80)
    p.scatter(
        (-3300, -2500, 3300, 2400),
        [*p.kit("crate", 2), *p.kit("sack", 3), *p.kit("handcart", 2), *p.kinds("animal", "Dog", "Donkey")],
        35,
        clear=60,
    )
    p.scatter(
        (-6200, -4300, -3900, 6000),
        [*p.kit("conifer", 3), *p.kit("column", 4, broken=True), *p.kit("rubble", 3), *p.kit("bush", 3)],
        50,
        clear=60,
    )
    p.scatter(
        (3900, -4300, 6200, 6000),
        [*p.kit("conifer", 3), *p.kit("column", 4, broken=True), *p.kit("rubble", 3), *p.kit("bush", 3)],
        50,
        clear=60,
    )
    p.palette(100, "column", "statue", "temple", "stall", "rubble", "conifer", "planter", "ruin-wall", "bench", "house")
