"""River town of the elves."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import garden
from cases.open190.parts.land import forest
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "elf-river",
    "text",
    "River town of the elves",
    styles.FANTASY.but(
        wall=("WhitePlaster", "GreenPlaster", "TealPlaster"),
        roof=("GreenTile", "BlueTile"),
        leaf=("GoldenLeaf", "Leaf", "Blossom"),
        stone=("Limestone", "Marble"),
    ),
    200,
)
def elf_river(p: StagedPlace) -> None:
    """White houses with green spires on both banks, bridges, gardens and slender boats."""
    p.plate(200, "Grass")
    p.ground((-9900, -900, 9900, 900), family="water", tile=1000, z=0.6)
    for x in (-6000, 0, 6000):
        p.put(p.one("bridge", length=2000.0, width=400.0, stone="Limestone"), x, 0, yaw=90)
    houses = p.kit("house", 9)
    for side in (-1, 1):
        p.ground(
            (-9800, side * 1000 - (500 if side < 0 else 0), 9800, side * 1000 + (500 if side > 0 else 0)),
            "Paving",
            tile=500,
            z=0.5,
        )
        frontage(
            p,
            (9500, 2000) if side > 0 else (-9500, -2000),
            (-9500, 2000) if side > 0 else (9500, -2000),
            [*houses, *p.kit("tower", 3, spire=True)],
            (150, 400),
        )
        p.row(
            (-9500, side * 1080),
            (9500, side * 1080),
            [*p.kit("streetlamp", 2, kind="Lantern"), *p.kit("planter", 3)],
            24,
        )
        for x in (-7000, -2400, 2400, 7000):
            garden(
                p,
                (x - 1100, side * 5200 - 1000, x + 1100, side * 5200 + 1000),
                beds=2,
                centre=p.kit("fountain", 2)[side > 0],
                benches=p.kit("bench", 3),
                trees=p.kit("tree", 4),
            )
    p.row(
        (-8800, -450),
        (8800, 500),
        p.kit("boat", 3, kind="RowingBoat") + p.kit("boat", 3, kind="SailingBoat"),
        14,
        jitter=150,
    )
    p.put(p.one("temple", use="Shrine"), 0, 8000, yaw=180)
    p.row((-1500, 6700), (1500, 6700), p.kit("statue", 5), 6, yaw=180)
    forest(
        p,
        (-9800, -9800, 9800, 9800),
        p.kit("tree", 7),
        170,
        under=[*p.kit("flowers", 5), *p.kit("bush", 4)],
        floor=120,
        avoid=(
            (-9900, -3600, 9900, 3600),
            (-1500, 6400, 1500, 9500),
            (-8300, 4000, 8300, 6400),
            (-8300, -6400, 8300, -4000),
        ),
    )
    p.palette(
        160,
        "house",
        "tower",
        "tree",
        "boat",
        "statue",
        "fountain",
        "flowers",
        "bench",
        "planter",
        "flag",
        "mushroom",
        "stall",
    )
