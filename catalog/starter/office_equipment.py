"""Equipment, lamps and decoration of the office. Wall objects have their pivot at the middle of the back."""

from __future__ import annotations

import math

from catalog.shapes import Builder, Kit
from catalog.starter.furniture_parts import BOOKS, books, crown, lamp_shade, leaf, pot

KIT = Kit()


def _display(b: Builder, picture: str, width: float, height: float, low: float) -> None:
    b.box("BlackPlastic", (width, 4, height), (0, 0, low), bevel=1)
    b.panel(picture, width - 3, height - 3.5, (0, 2.1, low + 2))


@KIT.asset("Monitor", "equipment", "27 inch monitor on a stand, showing code.", "monitor screen computer display")
def _monitor(b: Builder) -> None:
    _display(b, "ScreenCode", 61, 36, 13)
    b.box("BlackPlastic", (6, 3, 26), (0, -3.5, 1), body=None)
    b.box("BlackPlastic", (26, 20, 1.5), (0, -3, 0), bevel=0.5)
    b.body_box((6, 4, 14), (0, -3, 0))


@KIT.asset(
    "WideMonitor", "equipment", "34 inch wide monitor on a stand, showing a spreadsheet.", "monitor wide screen display"
)
def _wide(b: Builder) -> None:
    _display(b, "ScreenSheet", 81, 36, 13)
    b.box("Steel", (7, 3, 26), (0, -3.5, 1), body=None)
    b.box("Steel", (32, 22, 1.5), (0, -3, 0), bevel=0.5)
    b.body_box((7, 4, 14), (0, -3, 0))


@KIT.asset("Keyboard", "equipment", "Computer keyboard, 44 x 13 cm.", "keyboard computer input")
def _keyboard(b: Builder) -> None:
    b.box("BlackPlastic", (44, 13, 1.6), bevel=0.5)
    for row in range(5):
        count = 14 if row != 4 else 7
        for key in range(count):
            width = 30.0 / count if row != 4 or key != 3 else 12.0
            x = -20.5 + 30.0 * (key + 0.5) / count
            b.box(
                "GreyPlastic",
                (min(width - 0.3, 1.85) if key != 3 or row != 4 else 6, 1.8, 0.6),
                (x, 4.4 - row * 2.2, 1.5),
                body=None,
            )
    for row in range(4):
        for key in range(4):
            b.box("GreyPlastic", (1.85, 1.8, 0.6), (12.6 + 2.3 * key, 4.4 - row * 2.2, 1.5), body=None)


@KIT.asset("Mouse", "equipment", "Computer mouse on a mat.", "mouse computer input mat")
def _mouse(b: Builder) -> None:
    b.box("BlueFabric", (22, 18, 0.3), bevel=0.1)
    b.ellipsoid("BlackPlastic", (6.2, 10.5, 4), body=None)
    b.body_box((6, 10, 3.4), (0, 0, 0.1))


@KIT.asset("Laptop", "equipment", "Open laptop, 33 x 23 cm.", "laptop computer notebook")
def _laptop(b: Builder) -> None:
    b.box("Steel", (33, 23, 1.4), bevel=0.4)
    b.box("BlackPlastic", (29, 11, 0.2), (0, -2.5, 1.35), body=None)
    b.box("GreyPlastic", (10, 6, 0.2), (0, 7.5, 1.35), body=None)
    with b.moved((0, -11.3, 1.2), (0, 0, -14)):
        b.box("Steel", (33, 0.9, 22), bevel=0.3)
        b.panel("ScreenSheet", 31, 19.5, (0, 0.5, 1.4))


@KIT.asset(
    "ComputerTower", "equipment", "Desktop computer case, 20 x 45 cm, 44 cm high.", "computer tower desktop case"
)
def _tower(b: Builder) -> None:
    b.box("BlackPlastic", (20, 45, 42), (0, 0, 2), bevel=1)
    legs_y = (-18, 18)
    for y in legs_y:
        b.box("GreyPlastic", (18, 5, 2), (0, y, 0))
    b.box("GreyPlastic", (16, 0.6, 3), (0, 22.6, 36), body=None)
    b.box("Steel", (2, 0.6, 2), (5, 22.6, 31), body=None)
    for i in range(7):
        b.box("GreyPlastic", (15, 0.4, 0.8), (0, 22.6, 7 + 2.4 * i), body=None)


@KIT.asset("DeskPhone", "equipment", "Desk telephone with a handset and keys.", "phone telephone desk")
def _phone(b: Builder) -> None:
    b.wedge("BlackPlastic", (20, 18, 7), (0, 0, 0), (0, -90, 0), body="hull")
    b.box("BlackPlastic", (5, 20, 4), (-6, 0, 5), (0, 0, 19), bevel=1.5, body=None)
    b.box("ScreenSheet", (9, 5, 0.4), (4, -5, 6.1), (0, 0, 19), body=None)
    for row in range(3):
        for key in range(3):
            b.box(
                "WhitePlastic",
                (2, 1.6, 0.6),
                (1.4 + 2.7 * key, 0.5 + row * 2.6, 4.0 - row * 0.85),
                (0, 0, 19),
                body=None,
            )


@KIT.asset(
    "OfficePrinter",
    "equipment",
    "Floor-standing copier with paper trays and a control panel, 110 cm high.",
    "printer copier machine",
)
def _printer(b: Builder) -> None:
    b.box("WhitePlastic", (60, 60, 62), (0, 0, 4), bevel=1.5)
    b.box("GreyPlastic", (56, 54, 4))
    for row in range(3):
        b.box("GreyPlastic", (54, 1.5, 14), (0, 30, 8 + 17 * row), bevel=0.5, body=None)
        b.box("BlackPlastic", (18, 1.5, 2), (0, 31, 17 + 17 * row), body=None)
    for x in (-26, 26):
        b.box("WhitePlastic", (8, 60, 18), (x, 0, 66), body="box")
    b.box("BlackPlastic", (44, 56, 1), (0, 0, 66), body=None)
    b.box("WhitePlastic", (60, 60, 14), (0, 0, 84), bevel=1.5)
    b.box("GreyPlastic", (58, 52, 10), (0, -3, 98), bevel=2)
    b.box("ScreenCode", (20, 8, 1), (18, 30, 96), (0, 0, 35), body=None)
    b.box("Paper", (21, 30, 1.5), (-2, 4, 67), body=None)


@KIT.asset(
    "WaterCooler",
    "equipment",
    "Water cooler with a blue bottle and two taps, 135 cm high.",
    "water cooler dispenser bottle",
)
def _cooler(b: Builder) -> None:
    b.box("WhitePlastic", (32, 34, 95), bevel=2)
    b.box("GreyPlastic", (22, 2, 26), (0, 16.2, 58), bevel=0.5, body=None)
    for x, material in ((-5, "BookBlue"), (5, "AccentRed")):
        b.box(material, (3, 5, 4), (x, 18.5, 76), bevel=0.6, body=None)
    b.box("GreyPlastic", (22, 8, 2), (0, 19, 58), body=None)
    b.lathe(
        "WaterBlue",
        [(0, 93), (6, 93), (7, 97), (14, 102), (14, 116), (13.4, 117), (14, 118), (14, 131), (11, 135), (0, 135)],
        smooth=False,
    )


@KIT.asset("CoffeeMachine", "equipment", "Coffee machine with a drip tray, 28 x 40 cm.", "coffee machine kitchen")
def _coffee(b: Builder) -> None:
    b.box("BlackPlastic", (28, 22, 38), (0, -9, 0), bevel=1.5)
    b.box("BlackPlastic", (28, 40, 10), (0, 0, 28), bevel=1.5)
    b.box("Steel", (26, 18, 3), (0, 10, 0), bevel=0.5)
    b.cylinder("Steel", 3, 5, (0, 8, 23), segments=12, body=None)
    b.box("ScreenCode", (12, 0.5, 5), (0, 20.1, 31), body=None)
    b.cylinder("Ceramic", 3.6, 8, (0, 9, 3), segments=14, top=4, body=None)


@KIT.asset("DeskLamp", "lighting", "Articulated desk lamp with a metal shade.", "lamp desk light")
def _desk_lamp(b: Builder) -> None:
    b.cylinder("DarkMetal", 9, 2, segments=24, top=8)
    b.tube("Steel", [(0, 0, 2), (0, -14, 26)], 0.9)
    b.tube("Steel", [(0, -14, 26), (0, 10, 42)], 0.9)
    b.ellipsoid("DarkMetal", (3.5, 3.5, 3.5), (0, -14, 24.3), segments=10, body=None)
    with b.moved((0, 14, 36), (0, 0, -20)):
        b.lathe("AccentRed", [(8, 0), (7, 4), (3, 9), (2, 12), (0, 12)], segments=18)
        b.ellipsoid("Bulb", (6, 6, 6), (0, 0, 0.5), segments=10, body=None)
    b.body_box((4, 18, 40), (0, -6, 2))


@KIT.asset("FloorLamp", "lighting", "Floor lamp with a fabric shade, 160 cm high.", "lamp floor standing light")
def _floor_lamp(b: Builder) -> None:
    b.cylinder("DarkMetal", 15, 2.5, segments=24, top=13)
    b.cylinder("Brass", 1.2, 136, (0, 0, 2.5), segments=10)
    lamp_shade(b, 21, 14, 27, (0, 0, 133))


@KIT.asset(
    "PendantLamp",
    "lighting",
    "Pendant lamp on a cable, pivot at the ceiling end, hanging 90 cm.",
    "lamp pendant ceiling light",
)
def _pendant(b: Builder) -> None:
    b.cylinder("BlackPlastic", 5, 3, (0, 0, -3), segments=16)
    b.cylinder("BlackPlastic", 0.4, 62, (0, 0, -65), segments=6, body=None)
    b.lathe("DarkMetal", [(23, -90), (20, -78), (10, -69), (3, -65), (0, -64)], segments=24)
    b.ellipsoid("Bulb", (11, 11, 11), (0, 0, -86), segments=12, body=None)


@KIT.asset(
    "CeilingLightPanel",
    "lighting",
    "Flat LED ceiling panel, 120 x 30 cm, pivot at the ceiling side.",
    "light panel ceiling led",
)
def _panel(b: Builder) -> None:
    b.box("WhitePlastic", (120, 30, 4), (0, 0, -4), bevel=0.5)
    b.box("LightPanel", (114, 24, 0.6), (0, 0, -4.5), body=None)


@KIT.asset("TallPlant", "decor", "Potted plant with large leaves, 150 cm high.", "plant potted green ficus")
def _tall_plant(b: Builder) -> None:
    pot(b, "WhitePlastic", 19, 34)
    for k, (x, y, top) in enumerate(((0, 0, 96), (4, 3, 80), (-4, 2, 70))):
        b.tube("Bark", [(x * 0.5, y * 0.5, 30), (x, y, 60), (x * 2.5, y * 2, top)], 1.5, segments=6)
        crown(b, 16, 44, 15, (x * 2.5, y * 2, top), pitch=38 - 6 * k)
    b.body_capsule(16, 90, (0, 0, 45))


@KIT.asset(
    "SnakePlant", "decor", "Sansevieria with upright leaves in a terracotta pot, 75 cm high.", "plant potted snake"
)
def _snake(b: Builder) -> None:
    pot(b, "Terracotta", 13, 22)
    for i in range(13):
        leaf(
            b,
            "LeafLight" if i % 4 == 0 else "Leaf",
            36 + 16 * (i * 5 % 4) / 3,
            7,
            (5 * math.cos(i * 2.4), 5 * math.sin(i * 2.4), 20),
            i * 137.5,
            76 + 8 * math.sin(i),
        )
    b.body_capsule(8, 55, (0, 0, 18))


@KIT.asset("DeskPlant", "decor", "Small plant in a white pot, 24 cm high.", "plant small desk succulent")
def _desk_plant(b: Builder) -> None:
    pot(b, "Ceramic", 6, 9)
    crown(b, 16, 13, 4.5, (0, 0, 9), pitch=48)


@KIT.asset("BookRow", "decor", "Row of books for a shelf, 60 cm wide.", "books row shelf")
def _book_row(b: Builder) -> None:
    books(b, 60, (0, 0, 0), 3)


@KIT.asset("BinderRow", "decor", "Row of eight ring binders, 58 cm wide.", "binders folders row shelf")
def _binders(b: Builder) -> None:
    for i in range(8):
        x = -25.2 + 7.2 * i
        b.box(("BookBlue", "GreyPlastic", "BookBlue", "AccentRed")[i % 4], (7, 26, 32), (x, 0, 0), bevel=0.3, body=None)
        b.box("Paper", (5, 0.3, 14), (x, 13.1, 13), body=None)
        b.cylinder("Steel", 1.2, 0.4, (x, 13, 6), (0, 0, 90), segments=10, body=None)
    b.body_box((57.6, 26, 32))


@KIT.asset("BookStack", "decor", "Stack of five books lying flat.", "books stack pile")
def _stack(b: Builder) -> None:
    z = 0.0
    for i in range(5):
        b.box(
            BOOKS[(i * 2) % 4],
            (22 - i * 0.8, 16 - i * 0.5, 2.6),
            (0, 0, z),
            (0, (i * 37) % 19 - 9, 0),
            bevel=0.2,
            body="box" if i in (0, 4) else None,
        )
        z += 2.6
    b.body_box((19, 14, z))


@KIT.asset("PaperTray", "decor", "Letter tray with two levels and paper.", "paper tray letter desk")
def _tray(b: Builder) -> None:
    for z in (0, 9):
        b.box("BlackPlastic", (25, 33, 1), (0, 0, z))
        b.box("Paper", (21, 29.7, 1.8), (0, 1, z + 1), body=None)
        for x in (-12, 12):
            b.box("BlackPlastic", (1, 33, 5), (x, 0, z), body=None)
    for x in (-12, 12):
        b.box("BlackPlastic", (1, 2, 10), (x, -15, 0), body=None)
    b.body_box((25, 33, 12))


@KIT.asset("PenCup", "decor", "Cup with pens and a ruler.", "pens cup desk")
def _pens(b: Builder) -> None:
    b.cylinder("DarkMetal", 4, 10, segments=16)
    for i, material in enumerate(("BookRed", "BookBlue", "AccentGreen", "BookOchre")):
        a = i * 1.6
        c, s = math.cos(a), math.sin(a)
        b.tube(material, [(c, s, 8), (2.6 * c, 2.6 * s, 16 + i)], 0.4, segments=6)


@KIT.asset("CoffeeMug", "decor", "Ceramic mug with a handle.", "mug cup coffee")
def _mug(b: Builder) -> None:
    b.lathe("Ceramic", [(0, 0), (3.8, 0), (4, 9.5), (3.6, 9.5), (3.4, 1)], smooth=False, segments=18)
    b.tube("Ceramic", [(3.8, 0, 7.8), (6.3, 0, 7), (6.3, 0, 3.2), (3.8, 0, 2.2)], 0.6, segments=6)
    b.cylinder("Soil", 3.5, 0.2, (0, 0, 7.5), segments=16, body=None)


@KIT.asset("WasteBin", "decor", "Round waste bin with crumpled paper.", "bin waste basket trash")
def _bin(b: Builder) -> None:
    b.lathe("DarkMetal", [(0, 0), (11, 0), (14, 30), (13.2, 30), (10.5, 1)], smooth=False)
    for x, y in ((-4, 2), (4, 3), (0, -5)):
        b.ellipsoid("Paper", (9, 8, 8), (x, y, 21), segments=7, body=None)


@KIT.asset("RecyclingBin", "decor", "Blue recycling bin with a swing lid, 70 cm high.", "bin recycling paper blue")
def _recycling(b: Builder) -> None:
    b.box("RecycleBlue", (38, 32, 58), bevel=2)
    b.box("RecycleBlue", (40, 34, 4), (0, 0, 58), bevel=1, body=None)
    b.gable("RecycleBlue", (38, 32, 9), (0, 0, 62), body="hull")
    b.box("WhitePlastic", (12, 0.4, 12), (0, 16.1, 30), body=None)
    b.body_box((40, 34, 4), (0, 0, 58))


@KIT.asset(
    "WallWhiteboard",
    "decor",
    "Wall whiteboard with a pen tray and drawings, 180 x 120 cm; pivot at the back.",
    "whiteboard board wall meeting",
)
def _whiteboard(b: Builder) -> None:
    b.box("Whiteboard", (180, 2, 120), (0, 1, -60))
    for z in (-60, 58):
        b.box("Steel", (180, 3, 2), (0, 1.5, z), body=None)
    for x in (-89, 89):
        b.box("Steel", (2, 3, 120), (x, 1.5, -60), body=None)
    b.box("Steel", (100, 8, 1.5), (0, 5, -61), body=None)
    for i, material in enumerate(("BookBlue", "AccentRed", "AccentGreen")):
        b.box(material, (12, 1.4, 1.4), (-20 + 18 * i, 6, -59.4), body=None)
    for i in range(4):
        b.box("BookBlue", (40 - 7 * i, 0.2, 1.2), (-50 + 2 * i, 2.1, 34 - 12 * i), body=None)
    for x, z, material in ((20, 20, "AccentRed"), (60, 20, "AccentGreen"), (40, -25, "BookBlue")):
        for dz in (0, 16):
            b.box(material, (26, 0.2, 1), (x, 2.1, z + dz), body=None)
        for dx in (-13, 13):
            b.box(material, (1, 0.2, 17), (x + dx, 2.1, z), body=None)
    b.box("BookBlue", (14, 0.2, 1), (40, 2.1, 28), body=None)


@KIT.asset(
    "PinBoard", "decor", "Cork pin board with notes, 120 x 90 cm; pivot at the back.", "pinboard cork notes wall"
)
def _pinboard(b: Builder) -> None:
    b.box("OakWood", (120, 2.5, 90), (0, 1.25, -45))
    b.box("Cork", (114, 0.4, 84), (0, 2.6, -42), body=None)
    for i in range(9):
        x, z = -42 + 21 * (i % 5) + (i * 7 % 5), 14 - 30 * (i // 5) + (i * 5 % 7)
        b.box(
            ("Paper", "BookOchre", "Paper", "LeafLight")[i % 4],
            (14, 0.3, 17),
            (x, 2.95, z - 10),
            ((i * 11) % 9 - 4, 0, 0),
            body=None,
        )


@KIT.asset("WallClock", "decor", "Round wall clock, 34 cm across; pivot at the back.", "clock wall time")
def _clock(b: Builder) -> None:
    b.cylinder("BlackPlastic", 17, 4, (0, 0, 0), (0, 0, 90), segments=32)
    b.cylinder("Whiteboard", 15.4, 0.3, (0, 4, 0), (0, 0, 90), segments=32, body=None)
    for i in range(12):
        a = i * math.pi / 6
        b.box("BlackPlastic", (1, 0.3, 3), (13 * math.sin(a), 4.5, 13 * math.cos(a) - 1.5), body=None)
    b.box("BlackPlastic", (1.4, 0.4, 9), (0, 4.8, 0), (55, 0, 0), body=None)
    b.box("BlackPlastic", (1, 0.4, 12), (0, 4.8, 0), (-20, 0, 0), body=None)


@KIT.asset(
    "FramedPoster", "decor", "Framed landscape print, 90 x 65 cm; pivot at the back.", "picture poster frame wall"
)
def _poster(b: Builder) -> None:
    b.box("BlackPlastic", (90, 3, 65), (0, 1.5, -32.5))
    b.box("Paper", (86, 0.3, 61), (0, 3.1, -30.5), body=None)
    b.panel("Painting", 70, 45, (0, 3.4, -22.5))


@KIT.asset("LoungeRug", "decor", "Striped rug, 240 x 170 cm.", "rug carpet lounge")
def _rug(b: Builder) -> None:
    b.box("RugStripes", (240, 170, 1), bevel=0.3)
