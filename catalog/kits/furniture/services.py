"""Machines of public rooms: vending, tickets, lockers, checkout, gates, freezers."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull


@family("service")
def service(m: KitMaker) -> None:
    """Machines of public rooms: vending, tickets, lockers, checkout, gates, freezers."""
    kind = m.opt(
        "kind",
        m.pick(
            "VendingMachine",
            "TicketMachine",
            "Checkout",
            "TicketGate",
            "ChestFreezer",
            "FridgeDisplay",
            "PhotoBooth",
            "CashMachine",
            "ShoppingCart",
            "Arcade",
            "Jukebox",
        ),
    )
    paint = m.mat("paint")
    m.say(
        {"Arcade": "ArcadeCabinet"}.get(kind, kind),
        "equipment",
        f"{word(paint).capitalize()} {word(kind)}.",
        camel(paint),
        tags="machine shop public",
    )
    b = m.b
    if kind in ("VendingMachine", "FridgeDisplay"):
        b.box(paint, (95, 75, 185), bevel=2)
        b.box("BlackPaint", (64, 3, 130), (-10, 37, 40), body=None)
        for row in range(5):
            for i in range(5):
                b.box(m.another("paint"), (8, 3, 16), (-34 + 12 * i, 39, 46 + 25 * row), body=None)
        b.box("WhiteGlow", (88, 2, 12), (0, 38, 170), body=None)
    elif kind in ("TicketMachine", "CashMachine"):
        b.box(paint, (70, 50, 170), bevel=2)
        b.box("TimetableScreen", (44, 3, 30), (0, 25, 110), body=None)
        b.box("BlackPaint", (50, 3, 14), (0, 25, 60), body=None)
        b.box("WhiteGlow", (66, 2, 12), (0, 25, 154), body=None)
    elif kind == "Checkout":
        b.box(paint, (240, 60, 80), (0, 0, 0))
        b.box("Rubber", (150, 50, 3), (-40, 0, 80), body=None)
        b.box("GreyPaint", (60, 50, 12), (80, 0, 80))
        b.box("Screen", (30, 4, 24), (80, -10, 104), body=None)
        b.box("Iron", (4, 4, 26), (80, -14, 90), body=None)
        b.cylinder("Iron", 2, 150, (-110, -26, 80), segments=6, body=None)
        b.box("YellowPaint", (24, 6, 24), (-110, -26, 206), body=None)
    elif kind == "TicketGate":
        b.box("SilverPaint", (160, 26, 100), bevel=4)
        b.box("BluePaint", (40, 27, 3), (50, 0, 100), body=None)
        b.box("GreenGlow", (8, 28, 8), (72, 0, 84), body=None)
        b.box("RedPaint", (6, 40, 40), (0, 28, 50), body=None)
    elif kind == "ChestFreezer":
        b.box("WhitePaint", (180, 80, 80), bevel=3)
        b.box("Glass", (170, 70, 4), (0, 0, 80))
        for i in range(12):
            b.box(m.another("paint"), (22, 16, 8), (-70 + 28 * (i % 6), -16 + 32 * (i // 6), 73), body=None)
    elif kind == "ShoppingCart":
        for x in (-40, 40):
            for y in (-22, 22):
                b.cylinder("BlackPaint", 5, 4, (x, y - 2, 5), (0, 0, 90), segments=8, body=None)
        b.box("Steel", (90, 48, 3), (0, 0, 20), body=None)
        b.add(
            "SilverPaint",
            hull(
                [
                    (x, y, z)
                    for x, y, z in (
                        (-36.0, -20.0, 50.0),
                        (-36.0, 20.0, 50.0),
                        (36.0, -16.0, 50.0),
                        (36.0, 16.0, 50.0),
                        (-46.0, -27.0, 96.0),
                        (-46.0, 27.0, 96.0),
                        (46.0, -22.0, 90.0),
                        (46.0, 22.0, 90.0),
                    )
                ]
            ),
        )
        b.tube("RedPaint", [(-56, -24, 100), (-56, 24, 100)], 2)
        b.body_box((84, 44, 50))
    elif kind == "Jukebox":
        b.box(paint, (80, 55, 120), bevel=6)
        b.cylinder("NeonPink", 40, 52, (0, -26, 118), (0, 0, 90), segments=24, body="hull")
        b.cylinder("YellowPaint", 32, 54, (0, -26, 118), (0, 0, 90), segments=24, body=None)
        b.box("NeonBlue", (64, 2, 40), (0, 28, 60), body=None)
    elif kind == "Arcade":
        b.add(
            paint,
            hull(
                [
                    (x, y, z)
                    for x in (-35.0, 35.0)
                    for y, z in (
                        (-40.0, 0.0),
                        (40.0, 0.0),
                        (40.0, 95.0),
                        (10.0, 110.0),
                        (0.0, 150.0),
                        (30.0, 180.0),
                        (-40.0, 180.0),
                    )
                ]
            ),
        )
        b.box("Screen", (54, 2, 40), (0, 26, 112), (0, 0, 14), body=None)
        b.box("NeonPink", (60, 2, 16), (0, 34, 160), body=None)
    else:
        b.box(paint, (150, 80, 195), bevel=3)
        b.box("BlackCloth", (60, 3, 120), (-30, 40, 60), body=None)
        b.box("WhiteGlow", (50, 2, 30), (40, 40, 150), body=None)
