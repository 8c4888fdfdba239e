"""Wizard village."""

from __future__ import annotations

import math

from cases.open190.layout import StagedPlace
from cases.open190.parts.land import forest, ring
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("wizard-village", "text", "Wizard village", styles.FANTASY, 130)
def wizard_village(p: StagedPlace) -> None:
    """Crooked towers and violet roofs among giant mushrooms, crystals and lantern stalls."""
    p.plate(130, "Grass")
    p.put(p.one("tower", round=True, spire=True, height=1700.0), 0, 2600, yaw=180)
    ring(p, 0, -400, 2300, p.kit("house", 8), 10, face=90, start=18)
    ring(p, 0, -400, 4300, [*p.kit("tower", 4, spire=True), *p.kit("house", 5)], 13, face=90)
    p.ground((-1200, -1600, 1200, 800), "Cobble", tile=600, z=0.5)
    p.put(p.one("fountain"), 0, -400)
    ring(p, 0, -400, 620, p.kinds_of("stall", "ware", "Spice", "Book", "Flower", "Fruit", "Pottery"), 7, face=-90)
    ring(p, 0, -400, 1050, p.kit("streetlamp", 3, kind="Lantern"), 10)
    for yaw in range(0, 360, 72):
        p.trail(
            [(0, -400), (5200 * math.cos(math.radians(yaw)), -400 + 5200 * math.sin(math.radians(yaw)))],
            240,
            "Flagstone",
            z=1.2,
        )
    p.scatter(
        (-6200, -6200, 6200, 6200),
        [*p.kit("mushroom", 6, crystal=False), *p.kit("mushroom", 3, crystal=True)],
        80,
        clear=90,
        avoid=((-1300, -1700, 1300, 900),),
    )
    p.scatter(
        (-1100, -1500, 1100, 700),
        [*p.kinds("forge", "Cauldron"), *p.kit("crate", 3), *p.kit("barrel", 3), *p.kit("flag", 4)],
        24,
        clear=40,
    )
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 6),
        110,
        under=[*p.kit("bush", 3), *p.kit("flowers", 5), *p.kit("rock", 3)],
        floor=120,
        avoid=((-2900, -3300, 2900, 2500),),
    )
    p.palette(
        125,
        "house",
        "tower",
        "mushroom",
        "tree",
        "stall",
        "flag",
        "crate",
        "barrel",
        "statue",
        "rock",
        "tent",
        "flowers",
    )
