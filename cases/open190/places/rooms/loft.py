"""Loft flat."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("loft", "indoor", "Loft flat", styles.DOMESTIC.but(wall=("RedBrick",)))
def loft(p: StagedPlace) -> None:
    """One large room of brick to live in: sofas, kitchen, bed behind a shelf, bath, piano."""
    p.room(
        (-500, -350, 500, 350), "Parquet", wall="RedBrick", S=("Window", "Plain", "Door"), N=("Window",), module=334.0
    )
    units = [
        p.one("kitchen-unit", kind=kind, paint="NavyPaint")
        for kind in ("Fridge", "KitchenBase", "KitchenSink", "Stove", "KitchenBase")
    ]
    for item in p.along((-120, 349), (-499, 349), units, 1):
        p.on(item, p.kinds("dish", "Teapot", "Cup", "Plate", "FruitBowl", "Toaster"), 2)
    table = p.put(p.one("table", kind="Long", width=180.0), -280, 150)
    p.around(table, p.kit("chair", 2), 6)
    p.on(table, p.kinds("dish", "Plate", "Cup", "Bottle", "FruitBowl", "WineGlass"), 7)
    p.put(p.one("rug", width=280.0, depth=200.0), -220, -150)
    p.put(p.one("sofa", seats=3), -220, -290)
    p.put(p.one("sofa", seats=1), -420, -150, yaw=-90)
    p.on(
        p.put(p.one("table", kind="Small", high=45.0, width=100.0), -220, -150),
        p.kinds("decor", "OpenBook", "Vase") + p.kinds("dish", "Cup"),
        3,
    )
    p.put(p.one("lamp", kind="FloorLamp"), -90, -300)
    p.put(p.one("lamp", kind="ArcLamp"), -455, -300, yaw=-60)
    for y in (-240, -130, 60, 170):
        p.stock(
            p.put(p.one("shelf", kind="Wood", width=100.0), 60, y, yaw=90),
            p.kinds("decor", "Vase", "BookStack", "PottedPlant", "Clock", "Figurine"),
            8,
            0.6,
        )
    p.put(p.one("cot", kind="DoubleBed"), 390, -200, yaw=0)
    for x in (280, 470):
        p.on(
            p.put(p.one("cupboard", kind="Nightstand"), x if x > 300 else 276, -318),
            [*p.kit("lamp", 1, kind="TableLamp"), *p.kinds("decor", "OpenBook")],
            2,
        )
    p.along((499, 0), (499, 200), [p.one("cupboard", kind="Wardrobe")], 5)
    p.put(p.one("music", kind="Piano"), 200, 322, yaw=180)
    p.put(p.one("stool", high=45.0), 200, 240)
    p.put(p.one("bath-thing", kind="Bathtub"), 400, 305)
    p.put(p.one("board", kind="FloorMirror"), 290, 40, yaw=90)
    p.scatter(
        (-480, -330, 480, 330),
        [*p.kit("house-plant", 3), *p.kit("sack", 1, kind="LaundryBasket"), *p.kit("animal", 1, kind="Cat")],
        6,
        clear=15,
    )
    p.beams((-500, -350, 500, 350), 300, 4, "DarkOak")
    for x, y in ((-250, 120), (-200, -180), (380, -150), (300, 200)):
        p.light(x, y, 230, intensity=2200, radius=750)
    p.sun(-38, 70, intensity=2.8, sky=0.7)
    p.view("door", (-60, -330, 165), (-320, 250, 80), 85)
    p.view("bed", (120, 330, 165), (380, -250, 60), 85)
