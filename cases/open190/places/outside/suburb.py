"""Suburban street."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import border, playground
from cases.open190.parts.land import forest
from cases.open190.parts.streets import street
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("suburb", "outdoor", "Suburban street", styles.DOMESTIC, slot=True)
def suburb(p: StagedPlace) -> None:
    """Houses with front gardens, hedges, drives with cars, a playground at the corner."""
    p.ground((-6000, -3600, 6000, 3600), "Grass")
    houses = p.kit("house", 12)
    cars, trees = p.kit("car", 9), p.kit("tree", 5, height=600.0)
    street(
        p,
        -6000,
        6000,
        0,
        pavement="Paving",
        lamps=p.kit("streetlamp", 2, kind="Arm"),
        cars=cars,
        share=0.35,
        clutter=[*p.kinds("hydrant", "Hydrant", "PostBox", "ElectricBox"), *p.kit("bin", 3), *p.kit("bicycle", 3)],
    )
    number = 0
    hedges, fences = p.kit("hedge", 2, length=250.0, high=80.0), p.kit("fence", 3, kind="Picket", length=250.0)
    for side in (-1, 1):
        x = -5900.0
        while True:
            house = houses[number % len(houses)]
            thing = p.thing(house)
            plot = thing.width + 900
            if x + plot > 5900 or (side > 0 and x + plot > 3600):
                break
            number += 1
            with p.at(x + plot / 2, side * 660, 180 if side > 0 else 0):
                p.put(house, -150, -700 - thing.high[1])
                p.trail([(-150, -20), (-150, -690)], 140, "Flagstone")
                p.trail([(plot / 2 - 260, 0), (plot / 2 - 260, -1000)], 300, "Concrete")
                p.put(cars, plot / 2 - 260, -450, 0, 90)
                for k in range(int((plot - 700) // 251)):
                    fx = -plot / 2 + 140 + 251 * k
                    if abs(fx + 150) > 190:
                        p.put(hedges if number % 2 else fences, fx, -30)
                p.scatter(
                    (-plot / 2 + 80, -620, plot / 2 - 480, -110),
                    [*p.kit("flowers", 6), *p.kit("bush", 4), *p.kinds("works", "Wheelbarrow")],
                    12,
                    clear=15,
                )
                p.put(trees, -plot / 2 + 220, -420, yaw=p.uni(0, 360), scale=0.7)
                p.scatter(
                    (-plot / 2 + 100, -2700, plot / 2 - 150, -1750),
                    [
                        *p.kit("shed", 4),
                        *trees,
                        *p.kinds("play", "Swing", "Sandbox", "PlayHouse"),
                        *p.kit("parasol-table", 2),
                        *p.kinds("log", "Firewood"),
                        *p.kit("bush", 4),
                    ],
                    8,
                    clear=60,
                )
                border(p, (-plot / 2, -2850), (-plot / 2, -1100), p.kit("fence", 2, kind="Plank", length=290.0))
            x += plot
    playground(p, 4900, 1600)
    p.put(p.one("bus-shelter"), 3900, 560, yaw=180)
    forest(p, (-5900, 3000, 5900, 3550), trees, 40)
    p.row((-5800, -3500), (5800, -3500), p.kit("conifer", 4), 30, jitter=60)
    p.sun(-40, 65, colour=(255, 248, 234))
    p.view("street", (-4200, 430, 170), (1500, -100, 160), 70)
    p.view("gardens", (900, -560, 300), (-1500, -1500, 120), 74)
