"""Kitchen and bathroom of the flat. Fronts face +Y; backs stand against a wall."""

from __future__ import annotations

import math

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import extrude
from catalog.starter.furniture_parts import fronts

KIT = Kit()


def _counter(b: Builder, width: float, *, top: bool = True) -> None:
    b.box("GreyLaminate", (width, 50, 10), (0, -5, 0))
    b.box("CabinetSage", (width, 58, 76), (0, -1, 10))
    if top:
        b.box("Worktop", (width, 62, 4), (0, 0, 86), bevel=0.4)


@KIT.asset(
    "KitchenCounter",
    "kitchen",
    "Base cabinet with three drawers and a worktop, 60 x 62 cm, 90 cm high.",
    "kitchen counter cabinet drawers",
)
def _drawers(b: Builder) -> None:
    _counter(b, 60)
    fronts(b, "CabinetSage", "Brass", 60, 28, 11, 74, 3)


@KIT.asset(
    "KitchenSink",
    "kitchen",
    "Sink cabinet with a steel basin and a tap, 80 x 62 cm, 90 cm high.",
    "kitchen sink basin tap",
)
def _sink(b: Builder) -> None:
    _counter(b, 80, top=False)
    fronts(b, "CabinetSage", "Brass", 80, 28, 11, 74, 1, 2, upright=True)
    for x in (-33.0, 33.0):
        b.box("Worktop", (14, 62, 4), (x, 0, 86))
    for y, depth in ((-25.5, 11), (25, 12)):
        b.box("Worktop", (52, depth, 4), (0, y, 86))
    b.box("Steel", (52, 39.5, 0.6), (0, -0.5, 86.1))
    for x in (-25.4, 25.4):
        b.box("Steel", (1.4, 41, 4.6), (x, -0.5, 86), body=None)
    for y in (-20.4, 19.4):
        b.box("Steel", (52, 1.4, 4.6), (0, y, 86), body=None)
    b.cylinder("DarkMetal", 2.6, 0.4, (0, 0, 86.6), segments=14, body=None)
    b.tube("Steel", [(0, -25, 90), (0, -25, 112), (0, -21, 117), (0, -13, 118), (0, -8, 114), (0, -7, 110)], 1.3)
    b.tube("Steel", [(0, -25, 95), (9, -25, 98)], 0.9, segments=6)


@KIT.asset(
    "KitchenStove",
    "kitchen",
    "Stove with four rings, oven window and knobs, 60 x 62 cm, 90 cm high.",
    "stove oven cooker kitchen",
)
def _stove(b: Builder) -> None:
    b.box("WhitePlastic", (60, 60, 88), (0, -1, 0), bevel=0.5)
    b.box("BlackPlastic", (60, 60, 2), (0, -1, 88), bevel=0.3)
    for x, y, r in ((-15, -16, 8), (15, -16, 10), (-15, 12, 10), (15, 12, 8)):
        b.cylinder("GreyPlastic", r, 0.3, (x, y, 89.9), segments=24, body=None)
        b.cylinder("BlackPlastic", r - 2, 0.35, (x, y, 89.9), segments=24, body=None)
    b.box("DarkMetal", (52, 1, 42), (0, 29.4, 22), bevel=0.4, body=None)
    b.box("Glass", (44, 0.6, 26), (0, 30, 28), body=None)
    b.box("Steel", (46, 2.4, 2), (0, 31, 66), body=None)
    for i in range(5):
        b.cylinder("DarkMetal", 2, 2.6, (-22 + 11 * i, 29, 78), (0, 0, 90), segments=14, body=None)


@KIT.asset("Fridge", "kitchen", "Fridge with a freezer door below, 60 x 65 cm, 185 cm high.", "fridge refrigerator")
def _fridge(b: Builder) -> None:
    b.box("Steel", (60, 58, 182), (0, -3, 3), bevel=1)
    b.box("BlackPlastic", (56, 52, 3), (0, -3, 0))
    for z, height in ((5, 62), (68, 116)):
        b.box("WhitePlastic", (59, 5, height), (0, 28.5, z), bevel=1.4, body=None)
        b.box("Steel", (2, 3, 30), (-24, 32, z + (26 if z < 50 else 16)), bevel=0.6, body=None)
    b.body_box((59, 5, 180), (0, 28.5, 5))


@KIT.asset(
    "WallCabinet",
    "kitchen",
    "Kitchen wall cabinet with two doors, 80 x 35 cm, 70 cm high; pivot at the back.",
    "kitchen cabinet wall cupboard",
)
def _wall_cabinet(b: Builder) -> None:
    b.box("CabinetSage", (80, 33, 70), (0, 16.5, -35))
    fronts(b, "CabinetSage", "Brass", 80, 33, -35, 70, 1, 2, upright=True)


@KIT.asset("Kettle", "kitchen", "Steel kettle with a black handle.", "kettle kitchen")
def _kettle(b: Builder) -> None:
    b.lathe("Steel", [(0, 0), (8.5, 0), (9, 4), (7, 16), (5.5, 19), (0, 20)])
    b.ellipsoid("BlackPlastic", (2.6, 2.6, 2.6), (0, 0, 19.6), segments=10, body=None)
    b.tube("BlackPlastic", [(-7, 0, 16), (-12.5, 0, 18), (-13.5, 0, 11), (-9.5, 0, 5)], 1.1)
    b.tube("Steel", [(7, 0, 11), (11.5, 0, 16)], 1.4)


@KIT.asset("CookingPot", "kitchen", "Cooking pot with a lid.", "pot cooking kitchen")
def _pot(b: Builder) -> None:
    b.cylinder("Steel", 11, 13, segments=24)
    b.lathe("Steel", [(11.4, 13), (8, 15), (0, 16)], body=None)
    b.cylinder("BlackPlastic", 1.6, 2.6, (0, 0, 15.6), segments=12, body=None)
    for x in (-1, 1):
        b.tube("BlackPlastic", [(x * 10.5, -4, 10), (x * 14, -3, 10.4), (x * 14, 3, 10.4), (x * 10.5, 4, 10)], 0.8)


@KIT.asset("FruitBowl", "kitchen", "Ceramic bowl with oranges and apples.", "bowl fruit")
def _fruit(b: Builder) -> None:
    b.lathe("Ceramic", [(0, 0), (6, 0), (6.5, 1), (11, 4), (14, 9), (13.3, 9), (10, 4.6), (0, 2)], segments=24)
    for i in range(5):
        a = i * 2 * math.pi / 5
        b.ellipsoid(
            "FruitOrange" if i % 2 else "FruitGreen",
            (7.6, 7.6, 7.4),
            (6 * math.cos(a), 6 * math.sin(a), 4.4),
            segments=12,
            body=None,
        )
    b.ellipsoid("FruitOrange", (7.8, 7.8, 7.6), (0, 0, 9.2), segments=12, body=None)


@KIT.asset("PlateStack", "kitchen", "Stack of plates with two bowls on top.", "plates dishes kitchen")
def _plates(b: Builder) -> None:
    for i in range(4):
        b.lathe(
            "Ceramic",
            [(0, 0), (8, 0), (13, 2), (13, 2.5), (8, 0.8), (0, 0.8)],
            (0, 0, i * 1.2),
            segments=24,
            smooth=False,
            body=None,
        )
    for i in range(2):
        b.lathe("VaseBlue", [(0, 0), (4, 0), (8, 5), (7.6, 5), (4, 0.6)], (0, 0, 4.6 + i * 2), segments=20, body=None)
    b.body_box((20, 20, 6))


def _oval(width: float, depth: float, power: float = 0.5) -> list[tuple[float, float]]:
    return [
        (
            width / 2 * math.copysign(abs(math.cos(a)) ** power, math.cos(a)),
            depth / 2 * math.copysign(abs(math.sin(a)) ** power, math.sin(a)),
        )
        for a in [2 * math.pi * i / 40 for i in range(40)]
    ]


@KIT.asset(
    "Bathtub", "bathroom", "Bathtub with a panel, tap and some water, 170 x 75 cm, 58 cm high.", "bathtub bath tub"
)
def _bathtub(b: Builder) -> None:
    from shapely import Polygon

    rim = Polygon([(-85, -37.5), (85, -37.5), (85, 37.5), (-85, 37.5)], [_oval(156, 62, 0.45)[::-1]])
    b.add("Ceramic", extrude(rim, 58), body=None)
    b.box("Ceramic", (168, 73, 12), (0, 0, 1))
    b.box("BathLiquid", (154, 60, 0.5), (0, 0, 34), body=None)
    b.tube("Steel", [(-72, -33, 58), (-72, -33, 70), (-70, -26, 73), (-68, -18, 69)], 1.5)
    for x in (-82, -62):
        b.cylinder("Steel", 2.4, 4, (x, -34, 58), segments=12, body=None)
    for y in (-1, 1):
        b.body_box((170, 7, 58), (0, y * 34, 0))
    for x in (-1, 1):
        b.body_box((8, 61, 58), (x * 81, 0, 0))


@KIT.asset("Toilet", "bathroom", "Toilet with cistern and seat, 38 x 66 cm.", "toilet wc")
def _toilet(b: Builder) -> None:
    b.extrude("Ceramic", [(x, y * 1.0) for x, y in _oval(24, 40, 0.7)], 30, (0, 4, 0))
    b.lathe("Ceramic", [(11, 18), (17, 32), (18.5, 39), (0, 39)], (0, 8, 0), squash=1.3, smooth=False)
    b.extrude("WhitePlastic", _oval(38, 49, 0.8), 3, (0, 9, 39))
    b.box("Ceramic", (38, 17, 38), (0, -24.5, 39), bevel=2)
    b.box("Ceramic", (40, 18.5, 3), (0, -24.5, 77), bevel=1)
    b.box("Ceramic", (26, 20, 40), (0, -22, 0))
    b.cylinder("Steel", 2.2, 1, (0, -24, 80), segments=14, body=None)


@KIT.asset(
    "Washbasin",
    "bathroom",
    "Washbasin on a vanity cabinet with a tap, 70 x 48 cm, 87 cm high.",
    "washbasin sink vanity bathroom",
)
def _washbasin(b: Builder) -> None:
    b.box("WhiteLaminate", (66, 43, 52), (0, -1.5, 22))
    fronts(b, "OakWood", "Steel", 66, 20, 22, 52, 1, 2, upright=True)
    for x in (-28, 28):
        b.box("Steel", (4, 34, 22), (x, -2, 0))
    from shapely import Polygon

    rim = Polygon([(-35, -24), (35, -24), (35, 24), (-35, 24)], [_oval(50, 30, 0.7)[::-1]])
    b.add("Ceramic", extrude(rim, 13), (0, 0, 74), body="box")
    b.box("Ceramic", (54, 36, 1), (0, 0, 74.5), body=None)
    b.tube("Steel", [(0, -20, 87), (0, -20, 99), (0, -16, 102), (0, -7, 100)], 1.4)
    b.box("Steel", (1.6, 8, 1.6), (0, -20, 102.5), (0, 0, -20), body=None)


@KIT.asset("WallMirror", "bathroom", "Mirror with an oak frame, 60 x 85 cm; pivot at the back.", "mirror wall")
def _mirror(b: Builder) -> None:
    b.box("OakWood", (60, 3, 85), (0, 1.5, -42.5), bevel=0.6)
    b.box("MirrorGlass", (53, 0.6, 78), (0, 3.1, -39), body=None)


@KIT.asset("TowelRail", "bathroom", "Towel rail with two towels, 60 cm wide; pivot at the back.", "towel rail bathroom")
def _towels(b: Builder) -> None:
    for x in (-28, 28):
        b.cylinder("Steel", 1.6, 8, (x, 0, 0), (0, 0, 90), segments=12, body=None)
    b.tube("Steel", [(-30, 7.5, 0), (30, 7.5, 0)], 1.0)
    for x, fabric in ((-14, "NavyFabric"), (14, "Linen")):
        b.box(fabric, (24, 4.4, 52), (x, 7.5, -51), bevel=1.6, body=None)
    b.body_box((54, 5, 52), (0, 7.5, -51))
    b.body_box((60, 8, 3), (0, 4, -1.5))


@KIT.asset("LaundryBasket", "bathroom", "Round laundry basket with a lid, 55 cm high.", "basket laundry")
def _basket(b: Builder) -> None:
    b.lathe("OakWood", [(0, 0), (17, 0), (21, 50), (0, 50)], smooth=False)
    for z in (8, 18, 28, 38):
        b.lathe("WalnutWood", [(17.4 + z * 0.08, z), (17.5 + z * 0.08, z + 2.5)], body=None)
    b.lathe("Linen", [(22, 50), (20, 53), (0, 55)], smooth=False, body=None)


@KIT.asset("BathMat", "bathroom", "Soft bath mat, 80 x 50 cm.", "mat bath rug")
def _mat(b: Builder) -> None:
    b.box("NavyFabric", (80, 50, 1.5), bevel=0.6)
    b.box("Linen", (68, 38, 0.4), (0, 0, 1.3), body=None)
