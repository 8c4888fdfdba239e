"""Brickworks."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import yard_goods
from cases.open190.parts.gardens import border
from cases.open190.parts.rails import rails
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("brickworks", "text", "Brickworks", styles.INDUSTRIAL, 130)
def brickworks(p: StagedPlace) -> None:
    """Kilns and tall chimneys, stacks of bricks, clay heaps, a narrow railway."""
    p.plate(130, "Cinder")
    frontage(p, (-5800, 3000), (5800, 3000), p.kit("hall", 4, wall="RedBrick"), (100, 300))
    p.row((-4500, 5600), (4500, 5600), p.kit("tank", 2, kind="FactoryChimney"), 4)
    for k in range(5):
        p.put(p.kit("forge", 3, kind="Kiln"), -3600 + 700 * k, 1900, scale=2.0)
    rails(
        p,
        -6300,
        6300,
        -400,
        [
            p.one("train", kind="SteamLocomotive"),
            *p.kit("train", 3, kind="HopperWagon"),
            *p.kit("train", 2, kind="FlatWagon"),
        ],
        start=900,
    )
    p.grid(
        (-5600, -3400, -600, -1300),
        [*p.kit("works", 1, kind="BrickStack"), *p.kit("pallet", 2, load="Bricks")],
        18,
        8,
        jitter=12,
    )
    p.grid((900, -3300, 5600, -1500), p.kinds("works", "SandHeap", "GravelHeap"), 7, 3, jitter=60)
    p.row(
        (-5800, 900),
        (5800, 900),
        [*p.kit("truck", 3, kind="DumpTruck"), *p.kit("tractor", 3), *p.kit("truck", 2, kind="Lorry")],
        11,
        jitter=40,
    )
    p.row((-5000, -5000), (5000, -5000), p.kit("house", 5, storeys=2, wall="RedBrick"), 7)
    border(p, (-6300, -6200), (6300, -6200), p.kit("wall", 2, stone="RedBrick"), opening=700)
    p.scatter((-6000, -4200, 6000, 1500), [*yard_goods(p), *p.kinds("works", "Wheelbarrow")], 120, clear=50)
    p.palette(65, "works", "pallet", "barrel", "hall", "truck", "machine", "pipe")
