"""Tavern common room."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("tavern", "indoor", "Tavern common room", styles.HISTORICAL.but(wall=("CreamPlaster",), window=("AmberWindow",)))
def tavern(p: StagedPlace) -> None:
    """A timbered common room: hearth, bar with casks, long tables, snug corners."""
    p.room(
        (-700, -500, 700, 500),
        "Planks",
        wall="CreamPlaster",
        base="DarkPlanks",
        high=320,
        S=("Window", "Door", "Window"),
        E=("Plain", "Window"),
        W=("Window", "Plain"),
    )
    chairs, stools = p.kit("chair", 3, kind="Ladderback") + p.kit("chair", 2, kind="Windsor"), p.kit("stool", 3)
    tables = (
        p.kit("table", 2, kind="Long")
        + p.kit("table", 2, kind="Round")
        + p.kit("table", 1, kind="Square")
        + p.kit("table", 1, kind="Trestle")
    )
    dishes = p.kinds(
        "dish", "Tankard", "Mug", "Jug", "Plate", "Bowl", "Bread", "CheeseBoard", "Goblet", "Bottle", "Pie"
    ) + p.kit("dish", 6, kind="Tankard")
    candles = p.kinds("dish", "Candlestick")
    hearth = p.put(p.one("fireplace"), 0, 462, yaw=180)
    p.on(hearth, p.kinds("decor", "Vase", "Clock", "Figurine") + candles, 5)
    p.light(0, 390, 90, intensity=5000, colour=(255, 168, 90), radius=800)
    p.along(
        (-190, 499),
        (-690, 499),
        [p.one("cupboard", kind="Cabinet"), p.one("shelf", kind="Wood"), *p.kit("crate", 3, kind="Chest")],
        14,
    )
    bar = p.one("counter", kind="BarCounter", length=200.0)
    barrels, shelf = p.kit("barrel", 4), p.one("shelf", kind="Wood", depth=44.0)
    for y in (-330, -124, 82):
        counter = p.put(bar, 440, y, yaw=90)
        p.on(counter, dishes, 5)
        p.put(p.kit("stool", 2, high=75.0), 372, y - 45)
        p.put(p.kit("stool", 2, high=75.0), 372, y + 45)
    bottles = p.kit("dish", 5, kind="Bottle") + p.kit("dish", 3, kind="Jug") + p.kit("dish", 2, kind="Goblet")
    for y in (-270, -140, 140):
        p.stock(p.put(shelf, 674, y, yaw=90), bottles, 3)
    for y in (240, 330, 420):
        p.stack(barrels, 640, y, 2)
        p.put(barrels, 550, y + 20)
    for x, y, table, n, turn in (
        (-420, -280, tables[0], 6, 0),
        (-420, 40, tables[1], 6, 0),
        (-60, -330, tables[2], 5, 0),
        (40, 40, tables[3], 5, 0),
        (-480, 300, tables[4], 4, 0),
        (180, -180, tables[2], 5, 20),
        (-130, 215, tables[5], 6, 8),
    ):
        made = p.put(table, x, y, yaw=turn)
        p.around(made, chairs if n != 6 else [*stools, *chairs], n)
        p.middle(made, candles)
        p.on(made, dishes, 9 if n == 6 else 6)
        p.light(x, y, 180, intensity=1500, radius=600)
    p.along(
        (-699, 380),
        (-699, -480),
        [
            *p.kit("pew", 1, kind="PlainBench"),
            *p.kit("barrel", 2),
            p.one("decor", kind="Basket"),
            *p.kit("sack", 3),
            p.one("music", kind="Harp"),
            *p.kit("crate", 2),
        ],
        16,
    )
    p.put(p.one("lamp", kind="Candelabrum"), 320, 440)
    p.put(p.one("lamp", kind="Candelabrum"), -640, 440)
    p.put(p.one("rug", width=260.0, depth=160.0), 0, 370)
    for x in (-260, 260):
        p.put(
            p.one("room-wall", kind="Plain", length=24.0, high=320.0, wall="DarkOak", noun="OakPost"), x, 140, slack=1
        )
    p.scatter(
        (-660, -460, 400, 420),
        [*p.kit("animal", 1, kind="Dog"), *p.kit("animal", 1, kind="Cat"), *p.kit("sack", 2), *barrels],
        6,
    )
    p.beams((-700, -500, 700, 500), 320, 5, "DarkOak")
    p.sun(-35, -60, intensity=2.0, sky=0.55, colour=(255, 232, 200))
    p.view("door", (-60, -470, 165), (100, 420, 110), 82)
    p.view("bar", (-660, 200, 165), (500, -140, 90), 75)
