"""Lamps, textiles, plants, books, toys and small things of the flat."""

from __future__ import annotations

import math

from catalog.shapes import Builder, Kit
from catalog.starter.furniture_parts import books, crown, knob_ring, lamp_shade, pot

KIT = Kit()


@KIT.asset(
    "TableLamp", "lighting", "Table lamp with a ceramic foot and a fabric shade, 45 cm high.", "lamp table bedside"
)
def _table_lamp(b: Builder) -> None:
    b.lathe("VaseBlue", [(0, 0), (7, 0), (8, 3), (9, 9), (6, 17), (2, 21), (2, 25), (0, 25)])
    lamp_shade(b, 14, 10, 20, (0, 0, 25))


@KIT.asset("ArcFloorLamp", "lighting", "Arc floor lamp with a brass dome, 190 cm high.", "lamp floor arc reading")
def _arc_lamp(b: Builder) -> None:
    b.cylinder("DarkMetal", 18, 5, (0, -45, 0), segments=24)
    arc = [math.pi * 0.75 * i / 16 for i in range(17)]
    b.tube("Brass", [(0, -45 + 94.5 * (1 - math.cos(a)) / 2, 5 + 180 * math.sin(a)) for a in arc], 1.2)
    b.body_box((4, 10, 150), (0, -42, 5))
    b.lathe("Brass", [(16, 113), (14, 121), (8, 128), (2, 131), (0, 131)], (0, 36, 0))
    b.ellipsoid("Bulb", (9, 9, 9), (0, 36, 115), segments=12, body=None)


@KIT.asset(
    "CeilingLamp", "lighting", "Ceiling lamp, a globe on a short rod; pivot at the ceiling.", "lamp ceiling globe"
)
def _ceiling(b: Builder) -> None:
    b.cylinder("Brass", 6, 3, (0, 0, -3), segments=18)
    b.cylinder("Brass", 0.8, 22, (0, 0, -25), segments=8, body=None)
    b.ellipsoid("Bulb", (30, 30, 30), (0, 0, -54), body="sphere")


@KIT.asset("PersianRug", "decor", "Red patterned rug, 230 x 160 cm.", "rug carpet red")
def _rug(b: Builder) -> None:
    b.box("BookRed", (230, 160, 1), bevel=0.3)
    b.quad("PersianRug", [(-115, 80, 1.05), (115, 80, 1.05), (115, -80, 1.05), (-115, -80, 1.05)])


@KIT.asset("BlueRug", "decor", "Blue patterned rug, 170 x 120 cm.", "rug carpet blue")
def _blue_rug(b: Builder) -> None:
    b.box("BookBlue", (170, 120, 1), bevel=0.3)
    b.quad("BlueRug", [(-85, 60, 1.05), (85, 60, 1.05), (85, -60, 1.05), (-85, -60, 1.05)])


@KIT.asset(
    "Curtain",
    "decor",
    "Curtain panel in folds, 70 cm wide, 240 cm long, standing on the floor.",
    "curtain drapes window",
)
def _curtain(b: Builder) -> None:
    count = 36
    front = [(-35 + 70 * i / count, 3 * math.sin(i * math.pi / 3)) for i in range(count + 1)]
    b.extrude(
        "CurtainFabric", [(x, y - 0.5) for x, y in front] + [(x, y + 0.5) for x, y in reversed(front)], 239, body="box"
    )
    b.tube("Brass", [(-40, 0, 241), (40, 0, 241)], 1.2)


@KIT.asset(
    "HillsPicture", "decor", "Framed picture of green hills, 80 x 60 cm; pivot at the back.", "picture painting wall"
)
def _picture(b: Builder) -> None:
    b.box("OakWood", (80, 3, 60), (0, 1.5, -30), bevel=0.5)
    b.panel("Painting", 70, 50, (0, 3.2, -25))


@KIT.asset("DuskPicture", "decor", "Framed evening landscape, 50 x 70 cm; pivot at the back.", "picture painting wall")
def _dusk(b: Builder) -> None:
    b.box("DarkMetal", (50, 3, 70), (0, 1.5, -35), bevel=0.5)
    b.box("Paper", (45, 0.3, 65), (0, 3.1, -32.5), body=None)
    b.panel("PaintingDusk", 36, 50, (0, 3.4, -25))


@KIT.asset("TallVase", "decor", "Slim blue vase, 34 cm high.", "vase blue")
def _vase(b: Builder) -> None:
    b.lathe(
        "VaseBlue",
        [(0, 0), (6, 0), (9, 8), (9.5, 14), (6, 24), (3.4, 30), (4.6, 34), (3.8, 34), (2.6, 30)],
        segments=24,
    )


@KIT.asset("FlowerVase", "decor", "White vase with a bunch of pink flowers.", "vase flowers bunch")
def _flowers(b: Builder) -> None:
    b.lathe("Ceramic", [(0, 0), (5, 0), (7, 6), (6, 14), (4.5, 18), (5.5, 20), (4.6, 20), (4, 18)])
    for i in range(9):
        a, reach = i * 2.4, 4 + 5 * (i % 3) / 2
        x, y, z = reach * math.cos(a), reach * math.sin(a), 32 + 5 * math.sin(i * 1.9)
        b.tube("Leaf", [(0.3 * x, 0.3 * y, 17), (x, y, z)], 0.35, segments=5)
        b.ellipsoid("FlowerPink" if i % 3 else "ToyYellow", (6, 6, 4.6), (x, y, z - 2), segments=8, body=None)
    crown(b, 8, 11, 4, (0, 0, 18), pitch=50)


@KIT.asset("PalmPlant", "decor", "Large potted palm, about 150 cm high.", "plant palm potted")
def _palm(b: Builder) -> None:
    pot(b, "Terracotta", 20, 36)
    b.tube("Bark", [(0, 0, 32), (2, 1, 60), (0, 3, 92)], 3.4)
    crown(b, 22, 62, 12, (0, 3, 90), pitch=34)
    b.body_capsule(12, 75, (0, 0, 40))


@KIT.asset("WindowPlant", "decor", "Small plant in a terracotta pot.", "plant small potted")
def _window_plant(b: Builder) -> None:
    pot(b, "Terracotta", 7, 11)
    crown(b, 18, 16, 5.5, (0, 0, 11), pitch=46)


@KIT.asset("BookRowShort", "decor", "Row of books, 50 cm wide.", "books row shelf")
def _book_row(b: Builder) -> None:
    books(b, 50, (0, 0, 0), 5, 25)


@KIT.asset("OpenBook", "decor", "Open book lying face up.", "book open")
def _open_book(b: Builder) -> None:
    b.box("BookRed", (30, 21, 0.5))
    for x in (-1, 1):
        b.box("Paper", (14, 19.5, 1.4), (x * 7.2, 0, 0.5), (-4 * x, 0, 0), bevel=0.3, body=None)
    b.body_box((28, 19, 2))


@KIT.asset("DeskGlobe", "decor", "Globe on a brass stand, 38 cm high.", "globe world map")
def _globe(b: Builder) -> None:
    b.cylinder("WalnutWood", 9, 2.5, segments=24, top=7.5)
    b.cylinder("Brass", 1, 5, (0, 0, 2.5), segments=10, body=None)
    with b.moved((0, 0, 8), (0, 0, 0)):
        b.ellipsoid("GlobeSea", (26, 26, 26), (0, 0, 1), segments=28, body="sphere")
        for x, y, z, s in ((9, 7, 19, 9), (-10, 6, 12, 10), (3, -11.5, 15, 8), (2, 11.5, 9, 8), (-6, -8, 20, 8)):
            b.ellipsoid("LeafLight", (s, s, s * 0.9), (x * 0.9, y * 0.9, z - s / 2), segments=10, body=None)
        with b.moved((0, 0, 14), (90, 0, 0)):
            knob_ring(b, "Brass", 14, 0.7, (0, 0, 0), segments=28)
    b.body_box((4, 4, 6), (0, 0, 2.5))


@KIT.asset("TeddyBear", "decor", "Sitting teddy bear, 34 cm high.", "toy teddy bear")
def _teddy(b: Builder) -> None:
    b.ellipsoid("TeddyFur", (17, 15, 19), (0, 0, 0))
    b.ellipsoid("TeddyFur", (14, 13, 13), (0, 0.5, 17.5))
    for x in (-1, 1):
        b.ellipsoid("TeddyFur", (6, 4, 6), (x * 5.5, 0, 27.5), segments=10, body=None)
        b.ellipsoid("TeddyFur", (7, 14, 7), (x * 6, 10, 0), segments=10)
        b.ellipsoid("TeddyFur", (5.5, 6, 12), (x * 9.5, 3, 7), segments=10, body=None)
        b.ellipsoid("BlackPlastic", (1.6, 1.4, 1.6), (x * 2.8, 6.6, 24.6), segments=8, body=None)
    b.ellipsoid("Linen", (6, 4, 5), (0, 6, 19.5), segments=10, body=None)
    b.ellipsoid("BlackPlastic", (2, 1.4, 1.5), (0, 8, 22.4), segments=8, body=None)


@KIT.asset("ToyBlocks", "decor", "Tower of coloured toy blocks.", "toy blocks tower")
def _blocks(b: Builder) -> None:
    for i, (x, y, z, yaw) in enumerate(((-7, 0, 0, 8), (7, 1, 0, -5), (0, 12, 0, 30), (0, 0, 10, 12), (1, 1, 20, -18))):
        b.box(("ToyRed", "ToyBlue", "ToyYellow")[i % 3], (10, 10, 10), (x, y, z), (0, yaw, 0), bevel=0.6)
    b.gable("ToyRed", (10, 10, 7), (1, 1, 30), (0, -18, 0))


@KIT.asset("ToyTrain", "decor", "Wooden toy train with two wagons, 60 cm long.", "toy train wooden")
def _train(b: Builder) -> None:
    for i, material in enumerate(("ToyRed", "ToyBlue", "ToyYellow")):
        x = 21 - 21 * i
        b.box("OakWood", (17, 9, 3), (x, 0, 3.2), bevel=0.4)
        if i:
            b.box(material, (15, 8, 6), (x, 0, 6.2), bevel=0.6)
        else:
            b.cylinder(material, 3.6, 10, (x - 3, 0, 9.8), (-90, 0, 0), segments=16)
            b.box(material, (6, 8.6, 12), (x - 5, 0, 6.2), bevel=0.5)
            b.cylinder("BlackPlastic", 1.2, 4, (x + 4, 0, 12.6), segments=12, top=1.8, body=None)
        for dx in (-5, 5):
            for y in (-4.6, 3.4):
                b.cylinder("WalnutWood", 2.6, 1.2, (x + dx, y, 2.6), (0, 0, 90), segments=14, body=None)
        if i < 2:
            b.box("DarkMetal", (5, 1.4, 1), (x - 10.5, 0, 4), body=None)
    b.body_box((58, 8, 3))


@KIT.asset("CushionSquare", "decor", "Square mustard cushion.", "cushion pillow")
def _cushion(b: Builder) -> None:
    b.box("MustardFabric", (42, 42, 13), bevel=6)
