"""Building site."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import yard_goods
from cases.open190.parts.gardens import border, enclosure
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("building-site", "text", "Building site", styles.INDUSTRIAL.but(wall=("Concrete", "RedBrick")), 130)
def building_site(p: StagedPlace) -> None:
    """Half-built walls in scaffolds under tower cranes, diggers, heaps, site huts, a hoarding."""
    p.plate(130, "Soil")
    for x, y in ((-2600, 2600), (2700, -1900)):
        p.put(p.kit("crane", 2, kind="TowerCrane"), x, y)
    wall = p.kit("wall", 2, stone="Concrete", high=190.0)
    for bx, by in ((-3900, -300), (600, 1200)):
        enclosure(p, (bx, by, bx + 2900, by + 2200), wall)
        p.row((bx + 300, by - 120), (bx + 1100, by - 120), p.kit("works", 1, kind="Scaffold"), 3)
        p.row((bx + 1800, by - 120), (bx + 2600, by - 120), p.kit("works", 1, kind="Scaffold"), 3)
        p.grid((bx + 450, by + 450, bx + 2450, by + 1750), p.kit("pillar", 2, kind="Square", of="Concrete"), 6, 4)
    p.row((-5500, -2600), (1500, -2600), p.kit("tractor", 6), 6, yaw=30, jitter=60)
    p.grid((-5600, -5200, -1200, -3800), p.kinds("works", "SandHeap", "GravelHeap"), 6, 2, jitter=60)
    p.grid(
        (-600, -5300, 3400, -3600),
        [*p.kinds("works", "PlankStack", "SteelBeams", "BrickStack", "CableDrum"), *p.kit("pallet", 4)],
        9,
        5,
        jitter=20,
    )
    p.row((4600, -5200), (4600, 600), p.kit("container", 4, long=False), 7, yaw=-90)
    p.row((5700, -5000), (5700, 1000), [*p.kit("works", 1, kind="PortableToilet"), *p.kit("shed", 3, use="SiteHut")], 8)
    p.row(
        (-5600, 5200),
        (5600, 5200),
        [*p.kit("truck", 2, kind="DumpTruck"), *p.kit("truck", 2, kind="Lorry"), *p.kit("car", 3)],
        9,
        jitter=40,
    )
    for a, b in (
        ((-6300, -6200), (6300, -6200)),
        ((6300, -6200), (6300, 6200)),
        ((6300, 6200), (-6300, 6200)),
        ((-6300, 6200), (-6300, -6200)),
    ):
        border(p, a, b, p.kit("fence", 2, kind="Plank"), opening=800 if a[1] > 0 and b[1] > 0 else 0)
    p.scatter(
        (-5900, -5900, 5900, 5900),
        [*yard_goods(p), *p.kinds("works", "TrafficCone", "CementMixer", "Wheelbarrow", "Barrier", "Ladder")],
        160,
        clear=60,
    )
    p.palette(90, "works", "tractor", "pallet", "barrel", "container", "truck", "sign", "pipe")
