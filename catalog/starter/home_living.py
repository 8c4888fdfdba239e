"""Living room and bedroom furniture. The front faces +Y."""

from __future__ import annotations

from catalog.shapes import Builder, Kit
from catalog.starter.furniture_parts import fronts, legs

KIT = Kit()


def _upholstered(b: Builder, fabric: str, seats: int, width: float, depth: float) -> None:
    legs(b, "OakWood", (width - 10, depth - 10), 11, 5, round_=True)
    b.box(fabric, (width, depth - 2, 20), (0, 0, 11), bevel=3)
    inner = width - 30
    for i in range(seats):
        x = (i + 0.5) * inner / seats - inner / 2
        b.box(fabric, (inner / seats - 1, depth - 26, 13), (x, 11, 31), bevel=4)
        with b.moved((x, -depth / 2 + 19, 42), (0, 0, -12)):
            b.box(fabric, (inner / seats - 2, 15, 38), bevel=5)
    b.box(fabric, (width, 15, 52), (0, -depth / 2 + 7.5, 28), bevel=4)
    for x in (-1, 1):
        b.box(fabric, (15, depth - 4, 36), (x * (width - 15) / 2, 0, 26), bevel=4)


@KIT.asset("HomeSofa", "seating", "Three-seat sofa in grey fabric, 215 x 92 cm.", "sofa couch three-seat")
def _sofa(b: Builder) -> None:
    _upholstered(b, "GreyFabric", 3, 215, 92)


@KIT.asset("Armchair", "seating", "Armchair in mustard fabric, 88 x 86 cm.", "armchair chair lounge")
def _armchair(b: Builder) -> None:
    _upholstered(b, "MustardFabric", 1, 88, 86)


@KIT.asset("DiningChair", "seating", "Oak dining chair with a slatted back.", "chair dining oak")
def _chair(b: Builder) -> None:
    for x in (-19, 19):
        b.box("OakWood", (3.6, 3.6, 43), (x, 18, 0))
        b.box("OakWood", (3.6, 3.6, 88), (x, -19, 0))
    b.box("OakWood", (43, 42, 3), (0, 0, 43), bevel=0.8)
    b.box("Linen", (38, 36, 2.5), (0, 1, 46), bevel=1, body=None)
    b.box("OakWood", (36, 2.5, 9), (0, -19, 77), bevel=0.6)
    for x in (-12, -4, 4, 12):
        b.box("OakWood", (3, 1.6, 32), (x, -19, 46), body=None)


@KIT.asset("KitchenStool", "seating", "Round wooden stool, 46 cm high.", "stool kitchen round")
def _stool(b: Builder) -> None:
    b.cylinder("WalnutWood", 17, 3.5, (0, 0, 42.5), segments=24)
    for x, y in ((12, 12), (-12, 12), (-12, -12), (12, -12)):
        b.tube("WalnutWood", [(x * 1.25, y * 1.25, 0.8), (x * 0.8, y * 0.8, 43)], 1.7)
    b.body_box((30, 30, 42))


@KIT.asset("ChildChair", "seating", "Small red chair for children.", "chair child small red")
def _child(b: Builder) -> None:
    legs(b, "OakWood", (28, 26), 28, 3, round_=True)
    b.box("ToyRed", (30, 28, 2.5), (0, 0, 28), bevel=0.8)
    with b.moved((0, -13, 30.5), (0, 0, -8)):
        b.box("ToyRed", (28, 2, 24), bevel=0.8)


@KIT.asset("DiningTable", "tables", "Oak dining table, 160 x 90 cm, 75 cm high.", "table dining oak")
def _dining(b: Builder) -> None:
    b.box("OakWood", (160, 90, 3.5), (0, 0, 71.5), bevel=0.7)
    legs(b, "OakWood", (150, 80), 71.5, 7)
    for y in (-36, 36):
        b.box("OakWood", (136, 2.2, 9), (0, y, 62), body=None)
    for x in (-71, 71):
        b.box("OakWood", (2.2, 66, 9), (x, 0, 62), body=None)


@KIT.asset("CoffeeTable", "tables", "Walnut coffee table with a shelf, 110 x 60 cm, 42 cm high.", "table coffee low")
def _coffee(b: Builder) -> None:
    b.box("WalnutWood", (110, 60, 3), (0, 0, 39), bevel=0.8)
    legs(b, "DarkMetal", (102, 54), 39, 3)
    b.box("WalnutWood", (99, 50, 2), (0, 0, 13))


@KIT.asset("BedsideTable", "tables", "Bedside table with a drawer, 45 x 38 cm, 50 cm high.", "table bedside nightstand")
def _bedside(b: Builder) -> None:
    legs(b, "OakWood", (41, 34), 20, 3.5, round_=True)
    b.box("OakWood", (45, 37, 30), (0, -0.5, 20), bevel=0.6)
    fronts(b, "WhiteLaminate", "Brass", 42, 17.5, 22, 25, 1)


@KIT.asset(
    "WritingDesk", "tables", "Writing desk with two drawers, 120 x 60 cm, 75 cm high.", "desk writing home office"
)
def _desk(b: Builder) -> None:
    b.box("OakWood", (120, 60, 3), (0, 0, 72), bevel=0.5)
    legs(b, "OakWood", (114, 54), 72, 5)
    b.box("WhiteLaminate", (102, 48, 12), (0, -1, 60))
    fronts(b, "WhiteLaminate", "Brass", 102, 23, 60, 12, 1, 2)


@KIT.asset(
    "DoubleBed",
    "bedroom",
    "Double bed with headboard, striped duvet and two pillows, 170 x 212 cm.",
    "bed double pillows duvet",
)
def _bed(b: Builder) -> None:
    b.box("WalnutWood", (170, 6, 105), (0, -103, 0), bevel=1)
    b.box("WalnutWood", (168, 203, 18), (0, 1, 14), bevel=0.8)
    legs(b, "WalnutWood", (160, 200), 14, 7)
    b.box("Linen", (160, 198, 20), (0, 1, 32), bevel=4)
    b.box("Duvet", (170, 148, 12), (0, 30, 44), bevel=4)
    for x in (-39, 39):
        b.box("Linen", (66, 42, 14), (x, -72, 50), (0, 0, -8), bevel=6, body=None)
    b.body_box((150, 40, 12), (0, -72, 50))


@KIT.asset("ChildBed", "bedroom", "Single bed with a yellow and navy cover, 96 x 206 cm.", "bed single child")
def _child_bed(b: Builder) -> None:
    for y, height in ((-100, 85), (100, 55)):
        b.box("WhiteLaminate", (96, 5, height), (0, y, 0), bevel=1)
    b.box("WhiteLaminate", (94, 195, 14), (0, 0, 18))
    b.box("Linen", (90, 194, 16), (0, 0, 32), bevel=3)
    b.box("NavyFabric", (95, 140, 10), (0, 26, 41), bevel=3.5)
    b.box("MustardFabric", (95.6, 30, 10.6), (0, -30, 41), bevel=3.5, body=None)
    b.box("Linen", (60, 38, 13), (0, -74, 47), (0, 0, -8), bevel=5)


@KIT.asset("Wardrobe", "bedroom", "Wardrobe with three doors, 150 x 60 cm, 210 cm high.", "wardrobe closet doors")
def _wardrobe(b: Builder) -> None:
    b.box("OakWood", (150, 58, 202), (0, -1, 6))
    b.box("OakWood", (154, 62, 3), (0, 0, 207), bevel=0.6)
    b.box("DarkMetal", (144, 52, 6), (0, -1, 0))
    fronts(b, "WhiteLaminate", "Brass", 148, 28, 8, 198, 1, 3, upright=True)


@KIT.asset("ChestOfDrawers", "bedroom", "Chest of four drawers, 90 x 45 cm, 85 cm high.", "drawers chest dresser")
def _chest(b: Builder) -> None:
    b.box("WhiteLaminate", (90, 43, 74), (0, -1, 8), bevel=0.5)
    b.box("OakWood", (92, 46, 2.5), (0, 0, 82), bevel=0.5)
    legs(b, "OakWood", (84, 40), 8, 5)
    fronts(b, "WhiteLaminate", "Brass", 88, 20.5, 9, 72, 4)


@KIT.asset("Bookcase", "storage", "Bookcase with five boards, 80 x 28 cm, 190 cm high.", "bookcase shelf")
def _bookcase(b: Builder) -> None:
    for x in (-39, 39):
        b.box("WalnutWood", (2.2, 28, 190), (x, 0, 0))
    for z in (4, 40, 76, 112, 148, 187.5):
        b.box("WalnutWood", (75.8, 27, 2.5), (0, 0, z))
    b.box("WalnutWood", (75.8, 1, 185), (0, -13, 3))


@KIT.asset(
    "WallShelf",
    "storage",
    "Wall shelf on two brackets, 90 x 22 cm; pivot at the middle of the back.",
    "shelf wall bracket",
)
def _wall_shelf(b: Builder) -> None:
    b.box("OakWood", (90, 22, 2.5), (0, 11, -1.25))
    for x in (-32, 32):
        b.box("DarkMetal", (2.5, 1, 16), (x, 0.5, -17))
        b.box("DarkMetal", (2.5, 18, 1), (x, 9, -2.3), body=None)
        b.tube("DarkMetal", [(x, 1, -15), (x, 16, -2.5)], 0.6)


@KIT.asset(
    "MediaBench",
    "storage",
    "Low media bench with two doors and an open shelf, 160 x 42 cm, 45 cm high.",
    "media tv bench sideboard",
)
def _media(b: Builder) -> None:
    b.box("WalnutWood", (160, 42, 3), (0, 0, 42))
    b.box("WalnutWood", (160, 42, 3), (0, 0, 10))
    for x in (-78.5, -28, 28, 78.5):
        b.box("WalnutWood", (3, 40, 29), (x, -1, 13))
    b.box("WalnutWood", (154, 1, 29), (0, -20, 13))
    for x in (-53, 53):
        b.box("WhiteLaminate", (46, 1.8, 27), (x, 19.5, 14), bevel=0.3)
        b.box("Brass", (10, 1.6, 1.2), (x, 21, 34), body=None)
    b.box("BlackPlastic", (36, 24, 6), (0, 0, 13), bevel=0.6)
    legs(b, "DarkMetal", (150, 34), 10, 3)


@KIT.asset("Television", "storage", "55 inch television on two feet.", "television tv screen")
def _tv(b: Builder) -> None:
    b.box("BlackPlastic", (123, 5, 71), (0, 0, 5), bevel=1)
    b.panel("TvScreen", 120, 67.5, (0, 2.6, 7))
    for x in (-42, 42):
        b.box("DarkMetal", (3, 26, 1.5), (x, 0, 0), bevel=0.4)
        b.box("DarkMetal", (3, 4, 6), (x, 0, 0))
