"""Shopping street with trams."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import pavement_goods
from cases.open190.parts.rails import rails
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "tram-street",
    "text",
    "Shopping street with trams",
    styles.TRANSIT.but(wall=("CreamPlaster", "RedBrick", "PinkPlaster", "YellowBrick"), roof=("SlateTile", "RedTile")),
    130,
)
def tram_street(p: StagedPlace) -> None:
    """A long street of shops with tram tracks, stops with shelters, planters and cafe tables."""
    p.plate(130, "Paving")
    shops = p.kit("shop", 14)
    frontage(p, (6300, 1500), (-6300, 1500), shops, (0, 12))
    frontage(p, (-6300, -1500), (6300, -1500), shops[7:] + shops[:7], (0, 12))
    for y, kinds in ((-260, 2), (260, 2)):
        rails(p, -6400, 6400, y, p.kit("train", kinds, kind="Tram"), start=1800 if y > 0 else 6500, gap=60)
    for x in (-3500, 0, 3500):
        p.put(p.one("bus-shelter", noun="TramShelter"), x, 660, yaw=180)
        p.put(p.one("bus-shelter", noun="TramShelter"), x + 900, -660)
        p.put(p.kit("board", 2, kind="TimetableBoard"), x + 380, 640, yaw=180)
    for side in (-1, 1):
        p.row(
            (-6000, side * 950),
            (6000, side * 950),
            [*p.kit("tree", 3, height=560.0), *p.kit("streetlamp", 2), *p.kit("planter", 3)],
            21,
        )
        for x in range(-5600, 5700, 900):
            table = p.put(p.kit("parasol-table", 4), x + p.uni(-60, 60), side * 1210)
            p.around(table, p.kit("chair", 3, kind="Metal"), 3, gap=-48)
        p.scatter((-6200, side * 800 - 60, 6200, side * 800 + 60), pavement_goods(p), 44, clear=40)
    frontage(p, (6300, 3300), (-6300, 3300), p.kit("block", 4, storeys=5.0), (100, 300))
    frontage(p, (-6300, -3300), (6300, -3300), p.kit("block", 4, storeys=5.0)[::-1], (100, 300))
    p.palette(100, "shop", "bench", "planter", "sign", "bicycle", "streetlamp", "kiosk", "hydrant", "stall")
