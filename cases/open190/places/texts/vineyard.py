"""Vineyard estate."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.gardens import enclosure, garden
from cases.open190.parts.land import field, forest
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "vineyard",
    "text",
    "Vineyard estate",
    styles.HISTORICAL.but(
        wall=("OchrePlaster", "PinkPlaster", "CreamPlaster"),
        roof=("OrangeTile", "RedTile"),
        stone=("Sandstone", "Limestone"),
    ),
    200,
)
def vineyard(p: StagedPlace) -> None:
    """A villa with a formal garden on an avenue of cypresses, vines in long rows, a winery."""
    p.plate(200, "DryGrass")
    p.put(p.one("block", use="Villa", storeys=2.0, width=2200.0, depth=1200.0), 0, 3000, yaw=180)
    garden(
        p,
        (-2000, 200, 2000, 1900),
        beds=3,
        centre=p.one("fountain", radius=260.0),
        benches=p.kit("bench", 3),
        trees=p.kit("tree", 3, height=500.0),
    )
    p.trail([(0, -9800), (0, 100)], 400, "Gravel")
    for side in (-1, 1):
        p.row((side * 420, -9600), (side * 420, -100), p.kit("conifer", 3), 22)
        for y0 in (-9300, -6200, -3100):
            field(p, (side * 5400 - 4200, y0, side * 5400 + 4200, y0 + 2700), "Vine", step=300)
        p.put(p.kit("statue", 3), side * 900, 2200, yaw=180)
    p.put(p.one("hall", use="Winery", width=2000.0, depth=1100.0), -5000, 2600, yaw=180)
    p.put(p.one("hall", use="CaskHouse", width=1500.0, depth=900.0), 4800, 2700, yaw=180)
    p.ground((-6400, 300, -3200, 1800), "Gravel", tile=800, z=0.5)
    p.grid((-6100, 500, -3600, 1200), [*p.kit("barrel", 4, kind="WineCask")], 9, 4, jitter=20)
    p.row((-6200, 1650), (-3400, 1650), p.kit("cart", 4), 4)
    p.put(p.one("forge", kind="WinePress"), 3900, 1500)
    p.scatter((3300, 400, 6400, 1800), old_goods(p), 40, clear=40)
    enclosure(p, (-2600, 4300, 2600, 6500), p.kit("wall", 2, high=150.0), gate=p.one("gate"))
    p.grid((-2200, 4700, 2200, 6100), p.kit("tree", 4, height=450.0, leaf="PaleLeaf"), 8, 4, jitter=40)
    forest(p, (-9700, 7000, 9700, 9700), p.kit("tree", 5), 90)
    p.palette(
        130,
        "barrel",
        "crate",
        "statue",
        "planter",
        "tree",
        "conifer",
        "house",
        "flowers",
        "handcart",
        "column",
        "fence",
        "arbour",
    )
