"""What smiths, coopers, potters and carpenters work with."""

from __future__ import annotations

import math

from catalog.kits.goods.categories import TOOLS
from catalog.kits.maker import KitMaker, family, word
from catalog.shapes.patches import hull


@family("forge")
def forge(m: KitMaker) -> None:
    """What a smith, a cooper, a potter or a carpenter works with."""
    kind = m.opt(
        "kind",
        m.pick(
            "Anvil",
            "ForgeHearth",
            "Bellows",
            "Grindstone",
            "PotterWheel",
            "Sawhorse",
            "CopperStill",
            "Kiln",
            "Cauldron",
            "BreadOven",
            "WinePress",
        ),
    )
    m.say(
        kind,
        TOOLS,
        f"{word(kind).capitalize()} of a craftsman.",
        m.pick("Old", "Heavy"),
        "Worn",
        tags="craft tool workshop",
    )
    b, wood, stone = m.b, m.mat("wood"), m.mat("stone")
    if kind == "Anvil":
        b.cylinder(wood, 26, 50, top=24, segments=12)
        b.box("Iron", (24, 18, 14), (0, 0, 50))
        b.box("Iron", (50, 16, 12), (4, 0, 64))
        b.cylinder("Iron", 7, 24, (-20, 0, 70), (90, 0, 0), top=1, segments=10, body=None)
    elif kind in ("ForgeHearth", "BreadOven", "Kiln"):
        b.box(stone, (170, 130, 85))
        if kind == "ForgeHearth":
            b.box("Ember", (90, 70, 5), (0, 10, 84), body=None)
            b.box("Cinder", (120, 90, 3), (0, 10, 83), body=None)
            b.add(
                "DarkStone",
                hull(
                    [
                        (x, y, z)
                        for x, y, z in (
                            (-85.0, -65.0, 150.0),
                            (85.0, -65.0, 150.0),
                            (85.0, 65.0, 150.0),
                            (-85.0, 65.0, 150.0),
                            (-30.0, -40.0, 250.0),
                            (30.0, -40.0, 250.0),
                            (30.0, 10.0, 250.0),
                            (-30.0, 10.0, 250.0),
                        )
                    ]
                ),
            )
            b.box("DarkStone", (60, 50, 160), (0, -15, 250), body="box")
            for x in (-80, 80):
                b.box(stone, (14, 20, 65), (x, -55, 85))
        else:
            b.ellipsoid("Clay", (170, 130, 130), (0, 0, 40), body="hull")
            b.box("Ember", (46, 8, 30), (0, 62, 90), body=None)
            b.cylinder("Clay", 14, 80, (0, -30, 150), segments=10, body=None)
    elif kind == "Bellows":
        b.box(wood, (120, 50, 6), (0, 0, 60))
        b.add(
            "BrownLeather",
            hull(
                [(-60.0, y, 66.0) for y in (-25.0, 25.0)]
                + [(60.0, y, 66.0) for y in (-8.0, 8.0)]
                + [(-60.0, y, 100.0) for y in (-25.0, 25.0)]
            ),
        )
        for x in (-50, 40):
            b.box(wood, (10, 40, 60), (x, 0, 0))
    elif kind in ("Grindstone", "PotterWheel"):
        for x in (-24, 24):
            b.box(wood, (8, 50, 60), (x, 0, 0))
        if kind == "Grindstone":
            b.cylinder("Granite", 34, 12, (-6, 0, 62), (-90, 0, 0), segments=20)
        else:
            b.box(wood, (70, 60, 6), (0, 0, 60))
            b.cylinder("Terracotta", 20, 4, (0, 0, 66), segments=16)
            b.lathe("Clay", [(0, 0), (10, 0), (14, 14), (9, 26), (11, 28)], (0, 0, 70), body=None)
    elif kind == "Sawhorse":
        for x in (-50, 50):
            for y in (-1, 1):
                b.tube(wood, [(x, y * 28, 0), (x, y * 4, 72)], 3.5)
        b.box(wood, (140, 12, 10), (0, 0, 70))
        b.body_box((110, 50, 30))
    elif kind == "CopperStill":
        b.cylinder(stone, 50, 40, segments=16)
        b.lathe("Copper", [(0, 0), (44, 0), (52, 40), (40, 80), (14, 104), (12, 130), (0, 132)], (0, 0, 40))
        b.tube("Copper", [(0, 0, 164), (40, 0, 178), (84, 0, 120), (88, 0, 60)], 5)
        b.cylinder("Oak", 26, 60, (92, 0, 0), segments=12)
    elif kind == "Cauldron":
        for k in range(3):
            b.tube("Iron", [(50 * math.cos(k * 2.1), 50 * math.sin(k * 2.1), 0), (0, 0, 120)], 2.5)
        b.lathe("Iron", [(0, 20), (26, 26), (34, 50), (28, 66), (32, 70), (26, 70)])
        b.body_box((56, 56, 30))
        b.cylinder("PaleLeaf", 26, 2, (0, 0, 62), segments=16, body=None)
        for k in range(5):
            b.cylinder("Bark", 5, 34, (0, 0, 5), (80, 72 * k, 0), segments=7, body=None)
        b.ellipsoid("Ember", (24, 24, 12), segments=8, body=None)
    else:
        b.cylinder(wood, 50, 60, (0, 0, 20), segments=16)
        for x in (-60, 60):
            b.box(wood, (14, 20, 190), (x, 0, 0))
        b.box(wood, (140, 24, 20), (0, 0, 170))
        b.cylinder("Iron", 6, 90, (0, 0, 90), segments=8, body=None)
        b.box(wood, (80, 10, 8), (0, 0, 150), body=None)
