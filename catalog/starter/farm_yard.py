"""Yard gear, vehicles and animals of the farm pack."""

from __future__ import annotations

import math

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import prism

KIT = Kit()


@KIT.asset("WoodFence", "yard", "Post-and-rail fence, 3 m long along X", "fence wooden rail")
def fence(b: Builder) -> None:
    for x in (-144, 0, 144):
        b.box("Wood", (12, 12, 125), (x, 0, 0), body=None)
    for z in (35, 72, 106):
        b.box("Wood", (298, 5, 12), (0, 7, z), body=None)
    b.body_box((298, 16, 120), (0, 2, 0))


@KIT.asset("FieldGate", "yard", "Five-barred field gate, 3 m wide along X", "gate fence wooden field")
def gate(b: Builder) -> None:
    for x in (-143, 143):
        b.box("Wood", (14, 14, 140), (x, 0, 0), body=None)
    for z in (20, 42, 66, 90, 114):
        b.box("WhitePaint", (268, 5, 9), (0, 0, z), body=None)
    for x in (-128, 0, 128):
        b.box("WhitePaint", (10, 7, 104), (x, 0, 20), body=None)
    b.tube("WhitePaint", [(-128, 4, 24), (128, 4, 118)], 4, segments=6)
    b.body_box((298, 14, 125))


@KIT.asset("StoneWall", "yard", "Dry stone wall, 3 m long along X, 1 m high", "wall stone dry fence")
def wall(b: Builder) -> None:
    b.add("Stone", prism([(-25, 0), (25, 0), (18, 95), (-18, 95)], 300), (0, 0, 0), (0, 90, 0))


@KIT.asset("HayBale", "yard", "Rectangular hay bale, 1.2 x 0.6 x 0.5 m", "hay bale straw")
def bale(b: Builder) -> None:
    b.box("Hay", (120, 60, 50), bevel=3)
    for x in (-32, 32):
        b.box("Wood", (2, 61, 51), (x, 0, 0), body=None)


@KIT.asset("RoundBale", "yard", "Round hay bale, 1.4 m, axis along X", "hay bale round straw")
def round_bale(b: Builder) -> None:
    b.cylinder("Hay", 70, 130, (-65, 0, 70), (-90, 0, 0), segments=22)


@KIT.asset("Haystack", "yard", "Conical haystack, 3 m high", "hay stack straw")
def haystack(b: Builder) -> None:
    b.lathe("Hay", [(0, 0), (130, 0), (145, 80), (110, 190), (50, 280), (0, 310)], segments=18)


@KIT.asset("WaterTrough", "yard", "Wooden water trough, 2 m long along X", "trough water wooden")
def trough(b: Builder) -> None:
    b.box("Wood", (200, 70, 8), (0, 0, 10), body=None)
    for y in (-32, 32):
        b.box("Wood", (200, 6, 48), (0, y, 10), body=None)
    for x in (-97, 97):
        b.box("Wood", (6, 70, 48), (x, 0, 10), body=None)
    for x in (-80, 80):
        b.box("Wood", (14, 80, 12), (x, 0, 0), body=None)
    b.box("Water", (188, 58, 30), (0, 0, 18), body=None)
    b.body_box((200, 80, 58))


@KIT.asset("MilkChurn", "yard", "Steel milk churn, 0.7 m high", "churn milk can steel")
def churn(b: Builder) -> None:
    b.lathe("Steel", [(0, 0), (19, 0), (19, 44), (11, 56), (11, 62), (15, 64), (15, 70), (0, 72)])


@KIT.asset("Barrel", "yard", "Wooden rain barrel, 0.9 m high", "barrel wooden rain")
def barrel(b: Builder) -> None:
    b.lathe("Wood", [(0, 0), (27, 0), (33, 24), (35, 45), (33, 66), (27, 90), (0, 90)])
    for z, radius in ((10, 30.5), (28, 34.5), (58, 34.8), (76, 31)):
        b.cylinder("Iron", radius, 5, (0, 0, z), body=None)


@KIT.asset("Crate", "yard", "Slatted apple crate, 0.6 x 0.4 m", "crate box apple wooden")
def crate(b: Builder) -> None:
    b.box("Wood", (60, 40, 3), body=None)
    for z in (4, 16):
        for y in (-19, 19):
            b.box("Wood", (60, 2, 9), (0, y, z), body=None)
        for x in (-29, 29):
            b.box("Wood", (2, 40, 9), (x, 0, z), body=None)
    for x in (-20, -7, 7, 20):
        for y in (-11, 0, 11):
            b.ellipsoid("CombRed", (11, 11, 11), (x, y, 13), segments=8, body=None)
    b.body_box((60, 40, 26))


@KIT.asset("WoodPile", "yard", "Stacked firewood, 2 m long along X", "wood pile logs firewood")
def wood_pile(b: Builder) -> None:
    for row in range(4):
        for i in range(9 - row % 2):
            x = (i - (8 - row % 2) / 2) * 22
            b.cylinder("Bark", 11, 56, (x, 28, 11 + 19 * row), (0, 0, 90), segments=9, body=None)
            b.cylinder("Wood", 9, 57, (x, 28.5, 11 + 19 * row), (0, 0, 90), segments=9, body=None)
    b.body_box((200, 58, 78))


@KIT.asset("Scarecrow", "yard", "Scarecrow in a blue coat, arms along X, faces +Y", "scarecrow figure field")
def scarecrow(b: Builder) -> None:
    b.box("Wood", (7, 7, 175), body=None)
    b.box("Wood", (150, 6, 6), (0, 0, 128), body=None)
    b.box("Cloth", (46, 22, 62), (0, 0, 78), body=None)
    b.box("Cloth", (120, 16, 18), (0, 0, 122), body=None)
    b.ellipsoid("Hay", (26, 26, 30), (0, 0, 146), segments=10, body=None)
    b.cylinder("Thatch", 26, 4, (0, 0, 170), body=None)
    b.cylinder("Thatch", 14, 18, (0, 0, 173), top=10, body=None)
    b.body_box((46, 22, 185))


@KIT.asset("Wheelbarrow", "yard", "Wheelbarrow, wheel to +X", "wheelbarrow barrow tool")
def wheelbarrow(b: Builder) -> None:
    b.add("TractorGreen", prism([(-42, 30), (36, 30), (52, 58), (-52, 58)], 58), body=None)
    b.add("Earth", prism([(-46, 52), (48, 52), (0, 74)], 46), body=None)
    b.cylinder("Rubber", 18, 9, (58, 4.5, 18), (0, 0, 90), body=None)
    for y in (-26, 26):
        b.tube("Wood", [(58, y * 0.4, 20), (-20, y, 34), (-90, y * 1.1, 56)], 2.5)
        b.tube("Iron", [(-32, y, 32), (-36, y, 0)], 2)
    b.body_box((150, 60, 64), (-14, 0, 0))


@KIT.asset("ToolRack", "yard", "Rack with a rake, a spade and a fork, faces +Y", "tools rack rake spade fork")
def tool_rack(b: Builder) -> None:
    for x in (-70, 70):
        b.box("Wood", (8, 8, 140), (x, -8, 0), body=None)
        b.box("Wood", (8, 50, 8), (x, 0, 0), body=None)
    for z in (60, 120):
        b.box("Wood", (148, 6, 10), (0, -4, z), body=None)
    for x in (-40, 0, 40):
        b.cylinder("Wood", 2, 150, (x, 3, 22), segments=8, body=None)
    b.box("Iron", (34, 4, 6), (-40, 4, 16), body=None)
    for x in (-55, -47, -40, -33, -25):
        b.box("Iron", (2, 3, 16), (x, 5, 2), body=None)
    b.box("Steel", (20, 3, 30), (0, 4, 2), body=None)
    for x in (32, 40, 48):
        b.box("Iron", (2, 3, 32), (x, 4, 2), body=None)
    b.body_box((156, 50, 150))


def _wheel(b: Builder, x: float, y: float, radius: float, width: float) -> None:
    b.cylinder("Rubber", radius, width, (x, y + width / 2, radius), (0, 0, 90), segments=20, body=None)
    hub = (x, y + width / 2 + 2, radius)
    b.cylinder("HubYellow", radius * 0.55, width + 4, hub, (0, 0, 90), segments=14, body=None)


def _tractor(b: Builder, paint: str) -> None:
    b.box(paint, (170, 62, 70), (70, 0, 70), bevel=6, body=None)
    b.box("Iron", (6, 50, 50), (156, 0, 78), body=None)
    b.box(paint, (130, 80, 50), (-70, 0, 66), body=None)
    for x in (-20, -120):
        for y in (-62, 62):
            b.box(paint, (7, 7, 110), (x, y, 110), body=None)
    for side in (-1, 1):
        b.box(paint, (110, 44, 8), (-72, side * 74, 146), body=None)
    b.box(paint, (140, 150, 8), (-70, 0, 220), body=None)
    b.box("Glass", (3, 118, 80), (-20, 0, 136), body=None)
    b.box("Rubber", (44, 46, 10), (-88, 0, 116), body=None)
    b.box("Rubber", (10, 46, 36), (-112, 0, 122), body=None)
    b.cylinder("Iron", 4, 80, (60, 20, 138), segments=8, body=None)
    for side in (-1, 1):
        _wheel(b, -72, side * 76, 72, 36)
        _wheel(b, 110, side * 62, 44, 24)
    b.body_box((340, 190, 140), (10, 0, 0))
    b.body_box((140, 150, 88), (-70, 0, 140))


@KIT.asset("TractorRed", "vehicles", "Red tractor with a roof, 3.4 m, front to +X", "tractor vehicle red")
def tractor_red(b: Builder) -> None:
    _tractor(b, "TractorRed")


@KIT.asset("TractorGreen", "vehicles", "Green tractor with a roof, 3.4 m, front to +X", "tractor vehicle green")
def tractor_green(b: Builder) -> None:
    _tractor(b, "TractorGreen")


@KIT.asset("HayCart", "vehicles", "Two-wheeled wooden cart with a drawbar to +X", "cart wagon wooden trailer")
def cart(b: Builder) -> None:
    b.box("Wood", (240, 130, 10), (0, 0, 66), body=None)
    for y in (-62, 62):
        b.box("Wood", (240, 6, 12), (0, y, 96), body=None)
        for x in (-114, -40, 40, 114):
            b.box("Wood", (7, 7, 40), (x, y, 72), body=None)
        ring = [(55 * math.cos(a), y * 1.18, 58 + 55 * math.sin(a)) for a in (i * math.pi / 10 for i in range(21))]
        b.tube("Iron", ring, 3, segments=6)
        for k in range(5):
            dx, dz = 53 * math.cos(k * math.pi / 5), 53 * math.sin(k * math.pi / 5)
            b.tube("Wood", [(-dx, y * 1.18, 58 - dz), (dx, y * 1.18, 58 + dz)], 2.2, segments=5)
    b.tube("Wood", [(110, 0, 66), (290, 0, 8)], 5)
    b.box("Iron", (8, 150, 8), (0, 0, 54), body=None)
    b.body_box((240, 150, 112))


@KIT.asset("Plough", "vehicles", "Three-share plough, hitch to +X", "plough implement field")
def plough(b: Builder) -> None:
    b.tube("TractorRed", [(130, 0, 60), (40, 0, 62), (-120, -50, 60)], 7)
    for i in range(3):
        x, y = 40 - 70 * i, -24.0 * i
        b.tube("TractorRed", [(x, y, 62), (x - 8, y, 24)], 5)
        b.add("Steel", prism([(-34, 0), (30, 0), (14, 30), (-20, 40)], 12), (x - 4, y, 0), (0, 25, 0), body=None)
    b.cylinder("Rubber", 24, 8, (-110, -38, 24), (0, 0, 90), body=None)
    b.body_box((260, 90, 66), (5, -20, 0))


def _beast(
    b: Builder,
    hide: str,
    length: float,
    height: float,
    girth: float,
    neck: float,
    *,
    head: float = 1.0,
    dark: str = "HideDark",
) -> None:
    """A four-legged animal, head to +X: ``height`` at the back, ``neck`` rise of the head above it (cm)."""
    leg = height - girth * 0.8
    for x in (-length * 0.36, length * 0.34):
        for y in (-girth * 0.28, girth * 0.28):
            b.cylinder(hide, girth * 0.09, leg + girth * 0.2, (x, y, 0), top=girth * 0.13, segments=8, body=None)
            b.cylinder(dark, girth * 0.1, girth * 0.1, (x, y, 0), segments=8, body=None)
    b.ellipsoid(hide, (length, girth * 0.82, girth), (0, 0, height - girth), segments=14, body=None)
    top = (length * 0.62, 0.0, height + neck)
    b.tube(hide, [(length * 0.34, 0, height - girth * 0.35), top], girth * 0.26)
    size = girth * 0.36 * head
    b.ellipsoid(
        hide,
        (size * 2.1, size, size * 1.1),
        (top[0] + size * 0.5, 0, top[2] - size * 0.75),
        (20, 0, 0),
        segments=10,
        body=None,
    )
    for y in (-1, 1):
        ear = (top[0] + size * 0.1, y * size * 0.6, top[2] + size * 0.1)
        b.ellipsoid(dark, (size * 0.25, size * 0.5, size * 0.2), ear, segments=8, body=None)
    b.tube(dark, [(-length * 0.48, 0, height - girth * 0.25), (-length * 0.56, 0, height - girth * 0.9)], girth * 0.04)
    b.body_box((length * 1.3, girth * 0.8, height), (length * 0.08, 0, 0))


@KIT.asset("Cow", "animals", "Black-and-white cow, head to +X", "cow cattle animal")
def cow(b: Builder) -> None:
    _beast(b, "Hide", 190, 145, 84, -6, head=1.2)
    for x, y, z, size in ((-40, 30, 84, 60), (36, -30, 92, 52), (-30, -31, 100, 46), (50, 28, 80, 36)):
        b.ellipsoid("HideDark", (size, 14, size * 0.7), (x, y, z), segments=10, body=None)
    b.ellipsoid("PigPink", (34, 26, 18), (-44, 0, 56), segments=10, body=None)
    for y in (-9, 9):
        b.tube("Wool", [(118, y, 142), (116, y * 2.2, 156)], 2)


@KIT.asset("Horse", "animals", "Brown horse, head to +X", "horse animal")
def horse(b: Builder) -> None:
    _beast(b, "HideBrown", 200, 160, 78, 34)
    b.tube("HideDark", [(66, 0, 160), (120, 0, 208)], 9)


@KIT.asset("Sheep", "animals", "Woolly sheep, head to +X", "sheep animal")
def sheep(b: Builder) -> None:
    _beast(b, "HideDark", 96, 78, 40, 2)
    b.ellipsoid("Wool", (108, 56, 56), (-4, 0, 28), segments=12, body=None)
    b.ellipsoid("Wool", (26, 24, 22), (50, 0, 70), segments=10, body=None)


@KIT.asset("Pig", "animals", "Pink pig, snout to +X", "pig animal")
def pig(b: Builder) -> None:
    _beast(b, "PigPink", 120, 72, 56, -14, head=1.1, dark="HideBrown")


@KIT.asset("Hen", "animals", "White hen, beak to +X", "hen chicken animal")
def hen(b: Builder) -> None:
    for y in (-5, 5):
        b.tube("Beak", [(0, y, 12), (0, y, 2)], 1)
        b.box("Beak", (9, 4, 1.5), (2, y, 0), body=None)
    b.ellipsoid("FeatherWhite", (34, 20, 22), (0, 0, 9), (-8, 0, 0), segments=10, body=None)
    b.tube("FeatherWhite", [(11, 0, 24), (16, 0, 36)], 5)
    b.ellipsoid("FeatherWhite", (11, 10, 11), (16, 0, 32), segments=8, body=None)
    b.box("CombRed", (9, 2, 5), (16, 0, 41), body=None)
    b.cylinder("Beak", 2, 6, (21, 0, 37), (-90, 0, 0), top=0.3, segments=6, body=None)
    b.add("FeatherWhite", prism([(-26, 30), (-10, 20), (-10, 26)], 10), body=None)
    b.body_box((40, 20, 42))
