"""What lies on desks today."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.small.categories import DESK


@family("desk-thing")
def desk_thing(m: KitMaker) -> None:
    """What lies on desks today."""
    kind = m.opt(
        "kind",
        m.pick(
            "Monitor",
            "Laptop",
            "Keyboard",
            "Telephone",
            "PaperTray",
            "Mug",
            "PencilCup",
            "Printer",
            "Binders",
            "Notebook",
            "Microwave",
            "CoffeeMachine",
            "CashRegister",
        ),
    )
    paint = m.mat("paint")
    m.say(
        {"Mug": "CoffeeMug"}.get(kind, kind),
        DESK,
        f"{word(paint).capitalize()} {word(kind)} for a desk.",
        camel(paint),
        tags="desk office computer small",
    )
    b = m.b
    if kind == "Monitor":
        b.box("BlackPlastic", (22, 18, 1.5))
        b.box("BlackPlastic", (4, 3, 16), (0, -3, 1), body=None)
        b.box("BlackPlastic", (56, 3.4, 34), (0, 0, 12), bevel=0.6)
        b.panel("Screen", 53, 30, (0, 1.9, 14))
    elif kind == "Laptop":
        b.box("GreyPlastic", (34, 24, 2))
        b.box("BlackPlastic", (28, 10, 0.4), (0, -2, 2), body=None)
        with b.moved((0, -11, 2), (0, 0, 14)):
            b.box("GreyPlastic", (34, 1, 22), body="box")
            b.panel("Screen", 31, 19, (0, 0.7, 1.5))
    elif kind == "Keyboard":
        b.box(paint, (44, 14, 2), bevel=0.4)
        for i in range(4):
            b.box("GreyPlastic", (41, 2.4, 0.5), (0, -4.6 + 3.1 * i, 2), body=None)
    elif kind == "Telephone":
        b.box(paint, (20, 20, 5), bevel=1)
        b.box(paint, (5, 22, 4), (-6, 0, 5), bevel=1, body=None)
    elif kind == "PaperTray":
        for z in (0, 8, 16):
            b.box(paint, (24, 33, 1), (0, 0, z), body=None)
            b.box("Paper", (21, 30, 2), (0, 0, z + 1), body=None)
        b.body_box((24, 33, 19))
    elif kind in ("Mug", "PencilCup"):
        b.cylinder(paint, 4.4, 10, segments=14)
        if kind == "PencilCup":
            for i in range(5):
                b.tube(m.another("paint"), [(i - 2, 0, 4), (2 * (i - 2), 1, 18)], 0.5)
    elif kind == "Printer":
        b.box("WhitePlastic", (44, 38, 24), bevel=2)
        b.box("Paper", (22, 20, 1), (0, 16, 14), body=None)
        b.box("BlackPlastic", (30, 2, 6), (0, 19, 8), body=None)
    elif kind == "Binders":
        for i in range(5):
            b.box(m.another("paint"), (7, 26, 31), (-15 + 7.6 * i, 0, 0), body=None)
        b.body_box((38, 26, 31))
    elif kind == "Notebook":
        b.box(paint, (16, 22, 1.6))
        b.tube("BlackPaint", [(10, -6, 1.2), (11, 8, 1.2)], 0.5)
    elif kind == "Microwave":
        b.box("BlackPlastic", (50, 36, 28), bevel=1)
        b.box("WindowGlass", (30, 1, 18), (-6, 18, 5), body=None)
    elif kind == "CoffeeMachine":
        b.box(paint, (26, 32, 38), bevel=2)
        b.box("BlackPaint", (16, 2, 18), (0, 16, 6), body=None)
        b.cylinder("Glass", 5, 10, (0, 18, 2), segments=10, body=None)
    else:
        b.box("GreyPlastic", (36, 38, 12), bevel=1)
        b.box("GreyPlastic", (32, 10, 18), (0, -8, 12), (0, 0, -20), body=None)
        b.box("Screen", (22, 2, 12), (0, 0, 16), (0, 0, -20), body=None)
        b.body_box((34, 24, 30))
