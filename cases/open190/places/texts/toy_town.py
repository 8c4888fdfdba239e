"""Toy town."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import playground
from cases.open190.parts.land import forest, ring
from cases.open190.parts.rails import rails
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("toy-town", "text", "Toy town", styles.STYLISED, 130)
def toy_town(p: StagedPlace) -> None:
    """Bright houses on a ring road with toy cars, sweet stalls, a steam train, a castle."""
    p.plate(130, "Grass")
    ring(p, 0, 0, 1900, p.kit("house", 9, storeys=1), 9, face=90, start=10)
    ring(p, 0, 0, 1050, [*p.kit("kiosk", 4), *p.kit("stall", 4)], 8, face=-90, start=22)
    p.put(p.one("fountain"), 0, 0)
    ring(p, 0, 0, 2750, p.kit("car", 8), 14, face=0)
    ring(p, 0, 0, 3150, p.kit("streetlamp", 3, kind="Globe"), 14, start=12)
    rails(
        p,
        -6300,
        6300,
        -5200,
        [p.one("train", kind="SteamLocomotive"), *p.kit("train", 3, kind="PassengerCoach")],
        start=1500,
    )
    ring(
        p,
        0,
        0,
        4300,
        [*p.kit("tower", 4, spire=True), *p.kit("house", 6, storeys=2), *p.kit("windmill", 2)],
        12,
        face=90,
    )
    playground(p, 4900, 4900)
    p.put(p.one("tent", round=True, size=620.0, use="CircusTent"), -4900, 4900, scale=1.8)
    p.scatter(
        (-6200, -4700, 6200, 6200),
        [
            *p.kit("flag", 5),
            *p.kit("planter", 6),
            *p.kit("bench", 4),
            *p.kit("animal", 5),
            *p.kit("mushroom", 3, crystal=False),
        ],
        90,
        clear=80,
        avoid=((-1300, -1300, 1300, 1300),),
    )
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 7),
        90,
        under=[*p.kit("flowers", 6), *p.kit("bush", 4)],
        floor=110,
        avoid=((-3300, -3300, 3300, 3300), (-6400, -5700, 6400, -4700)),
    )
    p.palette(
        210,
        "house",
        "car",
        "tree",
        "flag",
        "planter",
        "kiosk",
        "stall",
        "animal",
        "flowers",
        "bench",
        "play",
        "train",
        "tent",
        "tower",
        "truck",
    )
