"""Old library."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "library",
    "indoor",
    "Old library",
    styles.HISTORICAL.but(
        wall=("CreamPlaster",), wood=("Walnut", "DarkOak", "Cherry"), cloth=("GreenCloth", "BrownLeather", "RedCloth")
    ),
)
def library(p: StagedPlace) -> None:
    """Bays of bookcases around reading tables with lamps and globes."""
    p.room(
        (-1200, -800, 1200, 800),
        "Parquet",
        wall="GreenPlaster",
        base="DarkPlanks",
        high=420,
        S=("Window", "Window", "Door", "Window"),
        N=("Window", "Plain"),
    )
    cases_ = p.kit("bookcase", 6)
    p.along((1199, 799), (-1199, 799), cases_, 3, fill=True)
    p.along((-1199, 700), (-1199, -700), cases_, 3, fill=True)
    p.along((1199, -700), (1199, 700), cases_, 3, fill=True)
    for x in (-900, -560, 560, 900):
        for y in (300, -330):
            p.along((x - 2, y - 170), (x - 2, y + 170), cases_, 2, fill=True)
            p.along((x + 2, y + 170), (x + 2, y - 170), cases_, 2, fill=True)
    books = (
        p.kinds("decor", "OpenBook", "BookStack", "Scroll", "PictureFrame", "Hourglass")
        + p.kit("decor", 4, kind="BookStack")
        + p.kit("decor", 3, kind="OpenBook")
    )
    tables, chairs = p.kit("table", 2, kind="Long", width=220.0, depth=100.0), p.kit("chair", 3, kind="Upholstered")
    for y in (-430, -150, 130, 410):
        for x in (-180, 180):
            table = p.put(tables, x, y)
            p.around(table, chairs, 6)
            p.middle(table, p.kit("lamp", 2, style=styles.DOMESTIC, kind="TableLamp"))
            p.on(table, books, 6)
    for x, y in ((-400, 620), (400, 620), (-380, -640), (380, -640)):
        p.put(p.kit("music", 2, kind="Globe"), x, y)
        p.put(p.kit("sofa", 3, seats=1), x + 110, y, yaw=90 if x > 0 else -90)
        p.on(p.put(p.kit("table", 1, kind="Small"), x - 95, y), books, 2)
    p.put(p.one("counter", kind="ReceptionDesk", length=300.0), 700, -660, yaw=180)
    p.row((-500, -745), (300, -745), p.kit("display", 3, kind="TableCase"), 4)
    p.row((-1000, -640), (1000, -640), p.kinds("works", "Ladder"), 2)
    for x, y in ((-200, 0), (200, 0), (0, 560)):
        p.put(p.one("rug", width=300.0, depth=200.0), x, y)
    p.scatter(
        (-1100, -780, 1100, 700),
        [*p.kit("house-plant", 3), *p.kit("statue", 2, kind="Bust"), *p.kit("lamp", 2, kind="Candelabrum")],
        14,
        clear=25,
    )
    p.beams((-1200, -800, 1200, 800), 420, 7, "DarkOak")
    for x in (-750, 0, 750):
        for y in (-300, 300):
            p.light(x, y, 300, intensity=3200, radius=1000, colour=(255, 220, 170))
    p.sun(-38, 100, intensity=2.4, sky=0.6)
    p.view("nave", (-60, -760, 170), (30, 500, 100), 80)
    p.view("bays", (-1080, 60, 170), (900, -60, 120), 75)
