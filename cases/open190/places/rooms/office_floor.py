"""Open-plan office floor."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.halls import desks
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("office-floor", "indoor", "Open-plan office floor", styles.OFFICE, slot=True)
def office_floor(p: StagedPlace) -> None:
    """Bays of desks, meeting rooms behind glass, a kitchen and a lounge."""
    p.room(
        (-2000, -1200, 2000, 1200),
        "GreyCarpet",
        wall="WhitePlaster",
        S=("Window",),
        N=("Window",),
        E=("Plain", "Window"),
    )
    must = p.kit("desk-thing", 1, kind="Monitor")
    things = (
        p.kinds("desk-thing", "Keyboard", "Laptop", "Telephone", "Mug", "PencilCup", "PaperTray", "Binders", "Notebook")
        + p.kit("desk-thing", 3, kind="Mug")
        + p.kinds("decor", "PottedPlant", "PictureFrame", "BookStack")
        + p.kit("lamp", 2, kind="DeskLamp")
    )
    desk_, chairs = (
        p.kit("desk", 3, kind="Office"),
        p.kit("chair", 3, kind="Shell") + p.kit("chair", 2, kind="Upholstered"),
    )
    for bx in (-1550, -850, -150, 550):
        for by in (-800, -250):
            for side in (-1, 1):
                desks(
                    p,
                    (bx - 160, by + side * 40, bx + 160, by + side * 40),
                    3,
                    1,
                    desk_,
                    chairs,
                    things,
                    each=5,
                    yaw=0 if side > 0 else 180,
                    must=must,
                )
            p.put(p.kit("house-plant", 4), bx + 300, by)
            p.put(p.kit("cupboard", 3, kind="FilingCabinet"), bx - 290, by, yaw=90)
    glass = [p.one("room-wall", kind=kind, length=396.0) for kind in ("Glass", "Door")]
    for x in range(-1800, 1900, 400):
        p.put(glass[1] if x in (-1400, -200, 1000) else glass[0], x, 340)
    for x in (-1200, -400, 400, 1200):
        for y in (552, 952):
            p.put(glass[0], x, y, yaw=90)
    table, meeting = p.kit("table", 3, kind="Long", width=220.0, depth=100.0), p.kit("chair", 3, kind="Metal")
    for x in (-1600, -800, 0, 800, 1600):
        with p.at(x, 770):
            if abs(x) == 1600:
                for sy in (-150, 150):
                    p.put(p.kit("sofa", 4, seats=3), 0, sy, yaw=0 if sy < 0 else 180)
                p.put(p.kit("sofa", 3, seats=1), 190, 0, yaw=90)
                p.on(p.put(p.one("table", kind="Small"), 0, 0), things[3:], 3)
                p.put(p.one("rug", width=300.0, depth=200.0), 0, 0)
                p.stock(
                    p.put(p.one("shelf", kind="Wood"), 0, 390, yaw=180),
                    p.kinds("decor", "BookStack", "Vase", "PottedPlant") + things[6:8],
                    8,
                )
                continue
            made = p.put(table, 0, 0)
            p.around(made, meeting, 8)
            p.on(made, things[:8], 6)
            p.put(p.kit("board", 2, kind="Whiteboard"), 0, 370, yaw=180)
            p.put(p.kit("house-plant", 3), 150, 320)
    units = [
        p.one("kitchen-unit", kind=kind, paint="TealPaint")
        for kind in ("Fridge", "KitchenBase", "KitchenSink", "Dishwasher", "KitchenBase", "KitchenBase")
    ]
    for item in p.along((1999, -1150), (1999, -500), units, 1):
        p.on(
            item, p.kinds("desk-thing", "CoffeeMachine", "Microwave") + p.kinds("dish", "Cup", "Plate", "FruitBowl"), 3
        )
    for y in (-950, -650, -350):
        made = p.put(p.kit("table", 2, kind="Round"), 1550, y)
        p.around(made, meeting, 4)
        p.on(made, p.kinds("dish", "Cup", "Plate", "FruitBowl"), 4)
    p.along((1300, -1199), (1900, -1199), p.kinds("service", "VendingMachine") + p.kit("desk-thing", 0), 30)
    p.along(
        (-1999, 200),
        (-1999, -1100),
        [*p.kit("cupboard", 3, kind="LockerRow"), *p.kit("bookcase", 2), *p.kit("house-plant", 2)],
        12,
        fill=True,
    )
    p.along(
        (-1900, -1199),
        (1200, -1199),
        [
            *p.kit("cupboard", 3, kind="Sideboard"),
            *p.kit("house-plant", 4),
            *p.kit("board", 1, kind="Whiteboard"),
            *p.kit("cupboard", 3, kind="FilingCabinet"),
        ],
        60,
        fill=True,
    )
    for item in list(p.items.values()):
        if item.thing.noun == "Sideboard":
            p.on(item, p.kinds("desk-thing", "Printer", "Binders", "PaperTray") + p.kinds("decor", "FlowerVase"), 3)
    p.scatter((-1900, 120, 1900, 280), [*p.kit("bin", 3), *p.kit("house-plant", 4)], 16, clear=30)
    for x in (-1500, -500, 500, 1500):
        for y in (-700, 700):
            p.light(x, y, 270, intensity=4200, radius=1400, colour=(250, 250, 255))
    p.sun(-45, 60, intensity=2.6, sky=0.8)
    p.view("bays", (-1940, 60, 165), (300, -700, 90), 78)
    p.view("meeting", (1500, 180, 170), (-200, 900, 90), 75)
