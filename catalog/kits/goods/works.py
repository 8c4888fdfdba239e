"""Things of building sites."""

from __future__ import annotations

from catalog.kits.goods.categories import TOOLS
from catalog.kits.maker import KitMaker, family, word
from catalog.shapes.patches import hull


@family("works")
def works(m: KitMaker) -> None:
    """Things of a building site."""
    kind = m.opt(
        "kind",
        m.pick(
            "TrafficCone",
            "SandHeap",
            "GravelHeap",
            "Scaffold",
            "CementMixer",
            "BrickStack",
            "PlankStack",
            "Barrier",
            "Wheelbarrow",
            "Ladder",
            "CableDrum",
            "PortableToilet",
            "SteelBeams",
        ),
    )
    m.say(
        kind,
        TOOLS,
        f"{word(kind).capitalize()} of a building site.",
        m.pick("", "Yard"),
        m.pick("Orange", "Grey"),
        tags="building site construction",
    )
    b = m.b
    if kind == "TrafficCone":
        b.box("BlackPaint", (36, 36, 4))
        b.cylinder("OrangePaint", 14, 60, (0, 0, 4), top=3, segments=14)
        b.cylinder("WhitePaint", 10.6, 10, (0, 0, 26), top=8.7, segments=14, body=None)
    elif kind.endswith("Heap"):
        b.lathe(
            "Sand" if kind == "SandHeap" else "Gravel", [(0, 0), (170, 0), (120, 50), (50, 100), (0, 116)], squash=0.8
        )
    elif kind == "Scaffold":
        for x in (-120, 0, 120):
            for y in (-45, 45):
                b.cylinder("Steel", 3, 400, (x, y, 0), segments=8)
        for z in (195, 390):
            b.box("Planks", (250, 90, 5), (0, 0, z))
            for y in (-45, 45):
                b.tube("Steel", [(-125, y, z - 50), (125, y, z - 50)], 2.5)
        b.tube("Steel", [(-120, 45, 0), (0, 45, 195)], 2.5)
        b.tube("Steel", [(120, 45, 195), (0, 45, 390)], 2.5)
    elif kind == "CementMixer":
        b.lathe("OrangePaint", [(0, 0), (30, 4), (40, 40), (24, 80), (20, 80)], (0, -10, 70), (0, 0, 50))
        for x in (-40, 40):
            b.tube("Iron", [(x, -40, 0), (x * 0.8, 0, 90), (x, 40, 0)], 4)
            b.cylinder("Rubber", 20, 8, (x * 1.2 - 4, -40, 20), (-90, 0, 0), segments=14, body=None)
        b.body_box((100, 100, 90))
    elif kind == "BrickStack":
        for layer in range(5):
            b.box("RedBrick", (100 - 4 * (layer % 2), 60 - 3 * (layer % 2), 13.5), (0, 0, 14 * layer), body=None)
        b.body_box((100, 60, 69.5))
        m.top(69.5, 80, 46)
    elif kind in ("PlankStack", "SteelBeams"):
        of = "Pine" if kind == "PlankStack" else "Rust"
        for x in (-130, 130):
            b.box("DarkOak", (12, 90, 10), (x, 0, 0))
        for layer in range(4):
            for i in range(4):
                b.box(of, (380 - 10 * ((layer + i) % 3), 19, 9), (0, -33 + 22 * i, 10 + 10 * layer), body=None)
        b.body_box((380, 88, 40), (0, 0, 10))
        m.top(50, 300, 60)
    elif kind == "Barrier":
        for x in (-80, 80):
            b.box("WhitePaint", (8, 50, 8), (x, 0, 0))
            b.box("WhitePaint", (8, 8, 100), (x, 0, 0))
        for i in range(6):
            b.box("RedPaint" if i % 2 else "WhitePaint", (32, 5, 24), (-80 + 32 * i, 4, 74), body=None)
        b.body_box((180, 10, 26), (0, 2, 74))
    elif kind == "Wheelbarrow":
        b.add(
            "GreenPaint",
            hull(
                [
                    (x, y, z)
                    for x, y, z in (
                        (-30.0, -22.0, 30.0),
                        (-30.0, 22.0, 30.0),
                        (20.0, -16.0, 30.0),
                        (20.0, 16.0, 30.0),
                        (-44.0, -32.0, 62.0),
                        (-44.0, 32.0, 62.0),
                        (48.0, -28.0, 62.0),
                        (48.0, 28.0, 62.0),
                    )
                ]
            ),
        )
        b.cylinder("Rubber", 18, 8, (52, -4, 18), (0, 0, 90), segments=14)
        for y in (-22, 22):
            b.tube("Pine", [(52, y * 0.2, 18), (-30, y, 30), (-90, y * 1.2, 56)], 2.2)
            b.box("Iron", (4, 4, 30), (-28, y, 0))
        b.ellipsoid("Soil", (80, 52, 20), (0, 0, 52), body=None)
    elif kind == "Ladder":
        for y in (-22, 22):
            b.tube("Pine", [(0, y, 0), (0, y, 300)], 2.5)
        for i in range(9):
            b.tube("Pine", [(0, -22, 30 + 30 * i), (0, 22, 30 + 30 * i)], 1.6)
        for y in (-22, 22):
            b.tube("Pine", [(-80, y, 0), (0, y, 290)], 2.2)
        b.body_box((84, 48, 40), (-38, 0, 0))
        b.body_box((10, 48, 300))
    elif kind == "CableDrum":
        for y in (-46, 38):
            b.cylinder("Pine", 70, 8, (0, y, 70), (0, 0, 90), segments=22)
        b.cylinder("BlackPaint", 48, 80, (0, -40, 70), (0, 0, 90), segments=20)
    else:
        b.box("TealPaint", (110, 110, 220), bevel=4)
        b.box("WhitePaint", (120, 120, 14), (0, 0, 218), bevel=6)
        b.box("SkyPaint", (80, 4, 190), (0, 55, 14), body=None)
