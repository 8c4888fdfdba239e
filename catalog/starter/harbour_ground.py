"""Ground, quays and bridges of the harbour pack."""

from __future__ import annotations

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import prism
from catalog.starter.ground import slab

KIT = Kit()


@KIT.asset("CobbleTile", "ground", "Cobbled ground, 4 x 4 m, top at the pivot", "ground floor cobblestone street tile")
def cobble(b: Builder) -> None:
    slab(b, "Cobble", 400, 400)


@KIT.asset("PavingTile", "ground", "Pale stone paving, 4 x 4 m, top at the pivot", "ground floor pavement tile")
def paving(b: Builder) -> None:
    slab(b, "Paving", 400, 400)


@KIT.asset(
    "RoadTile",
    "ground",
    "Asphalt road with a dashed centre line along X, 8 x 8 m, top at the pivot",
    "ground floor road street asphalt tile",
)
def road(b: Builder) -> None:
    slab(b, "Asphalt", 800, 800)
    for x in (-200, 200):
        b.box("WhitePaint", (200, 14, 0.6), (x, 0, -0.3), body=None)
    for y in (-385, 385):
        b.box("WhitePaint", (800, 10, 0.6), (0, y, -0.3), body=None)


@KIT.asset(
    "CrossingTile",
    "ground",
    "Asphalt road with a zebra crossing, 8 x 8 m, top at the pivot",
    "ground floor road zebra crossing tile",
)
def crossing(b: Builder) -> None:
    slab(b, "Asphalt", 800, 800)
    for y in range(-350, 351, 100):
        b.box("WhitePaint", (300, 50, 0.6), (0, y, -0.3), body=None)


@KIT.asset("WaterTile", "ground", "Rippling harbour water, 8 x 8 m, surface at the pivot", "water sea canal tile")
def water(b: Builder) -> None:
    b.box("Water", (800, 800, 6), (0, 0, -6), body=None)


@KIT.asset(
    "QuayWall",
    "waterfront",
    "Stone quay wall with a coping, 4 m long, top at the pivot, faces +Y",
    "quay wall stone edge canal embankment",
)
def quay(b: Builder) -> None:
    b.box("StoneDark", (400, 50, 200), (0, -5, -220))
    b.box("Stone", (400, 60, 20), (0, 0, -20))
    for x in (-150, 150):
        b.box("WoodDark", (24, 10, 150), (x, 25, -200), body=None)


@KIT.asset(
    "StoneBridge",
    "waterfront",
    "Gently arched stone bridge, 8 m span along X, 8 m wide, ends level with z = 0",
    "bridge stone arch canal crossing",
)
def bridge(b: Builder) -> None:
    top = [(-400, 0), (-200, 30), (0, 40), (200, 30), (400, 0)]
    under = [(400, -160), (300, -90), (150, -45), (0, -35), (-150, -45), (-300, -90), (-400, -160)]
    b.add("Stone", prism([*top, *under], 800), body=None)
    for left, right, low in ((-400, -200, -60), (-200, 0, -45), (0, 200, -45), (200, 400, -60)):
        ends = dict(top)
        b.add("Cobble", prism([(left, ends[left] + 1), (right, ends[right] + 1), (right, low), (left, low)], 740))
    for side in (-385, 385):
        for x in range(-350, 351, 100):
            height = 30 * (1 - (x / 400) ** 2)
            b.box("Iron", (8, 8, 110), (x, side, height - 5), body=None)
        for rise in (50, 100):
            b.tube("Iron", [(x, side, 38 * (1 - (x / 400) ** 2) + rise) for x in range(-380, 381, 95)], 4)
        b.body_box((760, 12, 130), (0, side, 0))


@KIT.asset(
    "JettyPlanks",
    "waterfront",
    "Timber jetty on piles, 4 m long along X, 3 m wide, deck at the pivot",
    "jetty pier wooden dock planks",
)
def jetty(b: Builder) -> None:
    b.box("Wood", (400, 300, 14), (0, 0, -14))
    for y in (-110, 0, 110):
        b.box("WoodDark", (400, 20, 18), (0, y, -32), body=None)
    for x in (-150, 150):
        for y in (-120, 120):
            b.cylinder("WoodDark", 15, 220, (x, y, -252), segments=10)


@KIT.asset("IronRailing", "waterfront", "Iron railing, 4 m long along X, 1.1 m high", "railing fence iron canal edge")
def railing(b: Builder) -> None:
    for x in range(-190, 191, 95):
        b.box("Iron", (7, 7, 110), (x, 0, 0), body=None)
    for z in (40, 75, 106):
        b.tube("Iron", [(-198, 0, z), (198, 0, z)], 3)
    b.body_box((396, 8, 110))


@KIT.asset(
    "QuayStairs",
    "waterfront",
    "Stone steps down to the water, 3 m wide, top at the pivot, descend to +Y",
    "stairs steps quay stone",
)
def stairs(b: Builder) -> None:
    for step in range(6):
        b.box("Stone", (300, 35, 220 - 22 * step), (0, 17.5 + 35 * step, -220))
