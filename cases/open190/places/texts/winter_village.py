"""Snowed-in mountain village."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.land import forest, ring
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "winter-village",
    "text",
    "Snowed-in mountain village",
    styles.STYLISED.but(
        wall=("Planks", "DarkPlanks", "WhitePlaster", "RedBoards"),
        roof=("Snow",),
        leaf=("Snow",),
        window=("AmberWindow",),
        awning=("RedStripes", "GreenStripes"),
        old=True,
        ornate=True,
    ),
    130,
)
def winter_village(p: StagedPlace) -> None:
    """Log houses under snow around a market with a great fir, sledges of wood, fir woods and hills."""
    p.plate(130, "Snow")
    frontage(p, (4800, 2600), (-4800, 2600), p.kit("house", 7), (150, 350))
    frontage(p, (-4800, -2600), (4800, -2600), p.kit("house", 7)[::-1], (150, 350))
    p.ground((-2400, -1500, 2400, 1500), "Cobble", tile=600, z=0.5)
    firs = p.kit("conifer", 7)
    p.put(firs[0], 0, 0, scale=1.5)
    ring(p, 0, 0, 520, p.kit("bench", 3), 7, face=-90)
    market(p, (-2300, -1400, -700, 1400), 4, 3, [*p.kit("crate", 3), *p.kit("sack", 3)])
    market(p, (700, -1400, 2300, 1400), 4, 3, [*p.kit("crate", 3), *p.kit("barrel", 3)])
    p.put(p.one("church"), 0, 4600, yaw=180)
    p.row(
        (-4500, 2150),
        (4500, 2150),
        [*p.kit("streetlamp", 2, kind="Lantern"), *p.kinds("log", "WoodPile", "Firewood")],
        15,
    )
    p.row(
        (-4500, -2150),
        (4500, -2150),
        [*p.kit("streetlamp", 2, kind="Lantern"), *p.kit("cart", 3), *p.kit("handcart", 3)],
        15,
    )
    p.put(p.one("well"), 3400, 600)
    p.scatter(
        (-4600, -2000, 4600, 2000),
        [
            *p.kinds("animal", "Dog", "Horse", "Goat"),
            *p.kit("barrel", 3),
            *p.kit("crate", 3),
            *p.kit("flag", 3, banner=True),
        ],
        36,
        clear=50,
        avoid=((-2500, -1600, 2500, 1600),),
    )
    for x, y in ((-4600, 5400), (4700, 5300)):
        p.put(p.one("hill", of="Snow", width=2400.0, high=900.0), x, y)
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        firs,
        170,
        under=p.kit("rock", 5),
        floor=50,
        avoid=((-5400, -3800, 5400, 3700), (-900, 3600, 900, 6400)),
    )
    p.palette(50, "conifer", "house", "crate")
