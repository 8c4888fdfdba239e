"""Quiet close of houses."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.land import forest, ring
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "quiet-close",
    "text",
    "Quiet close of houses",
    styles.DOMESTIC.but(wall=("WhiteBoards", "GreenBoards", "BlueBoards", "RedBrick", "CreamPlaster")),
    130,
)
def quiet_close(p: StagedPlace) -> None:
    """A round turning place with houses in a ring, gardens, drives, a playground."""
    p.plate(130, "Grass")
    p.trail([(0, -6400), (0, -1800)], 700, "Asphalt")
    p.ground((-1500, -1800, 1500, 1200), "Asphalt", tile=1500, z=0.6)
    p.put(p.kit("tree", 1, leaf="Leaf", height=850.0), 0, -300)
    ring(p, 0, -300, 330, p.kit("planter", 4), 8)
    houses, cars = p.kit("house", 10), p.kit("car", 8)
    for k, a in enumerate(range(-30, 211, 40)):
        with p.at(0, -300, a - 90):
            p.put(houses[k], 0, 3700, yaw=180)
            p.trail([(-330, 1950), (-330, 3100)], 300, "Concrete")
            p.put(cars, -330, 2550, 0, 90)
            p.trail([(120, 1950), (120, 3150)], 140, "Flagstone")
            p.scatter((250, 2050, 700, 3000), [*p.kit("flowers", 6), *p.kit("bush", 3)], 9, clear=10)
            p.put(p.kit("hydrant", 2, kind="PostBox"), 320, 1900)
            p.scatter(
                (-700, 4500, 700, 5600),
                [*p.kit("shed", 3), *p.kit("play", 4), *p.kit("parasol-table", 3), *p.kit("tree", 3, height=500.0)],
                5,
                clear=40,
            )
    for side in (-1, 1):
        frontage(
            p,
            (side * 1100, -6300 if side > 0 else -2600),
            (side * 1100, -2600 if side > 0 else -6300),
            houses[7:],
            (250, 400),
            (250, 400),
        )
        p.row(
            (side * 500, -6000),
            (side * 500, -2200),
            [*p.kit("streetlamp", 2, kind="Arm"), *p.kit("tree", 2, height=550.0)],
            8,
        )
    ring(p, 0, -300, 1850, p.kit("streetlamp", 2, kind="Arm"), 7, start=10)
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("tree", 5),
        60,
        under=p.kit("bush", 4),
        floor=50,
        avoid=((-1200, -6400, 1200, -1500),),
    )
    p.palette(
        175,
        "house",
        "car",
        "flowers",
        "planter",
        "tree",
        "bench",
        "shed",
        "play",
        "fence",
        "bush",
        "sign",
        "bicycle",
        "animal",
    )
