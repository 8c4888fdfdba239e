"""Buildings of the farm pack."""

from __future__ import annotations

from itertools import pairwise

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import prism

KIT = Kit()


def _window(b: Builder, width: float, height: float, at: tuple[float, float, float], yaw: float = 0.0) -> None:
    with b.moved(at, (0.0, yaw, 0.0)):
        b.box("WhitePaint", (width + 16, 8, height + 16), (0, 2, -8), body=None)
        b.box("Glass", (width, 4, height), (0, 5, 0), body=None)
        b.box("WhitePaint", (5, 4, height), (0, 7, 0), body=None)
        b.box("WhitePaint", (width, 4, 5), (0, 7, height / 2), body=None)


def _slopes(b: Builder, material: str, points: list[tuple[float, float]], length: float, thick: float = 10) -> None:
    """Roof skins over a gable wall: ``points`` (x, z) from eaves to ridge of the right half, ridge along Y."""
    for sign in (-1, 1):
        for (x0, z0), (x1, z1) in pairwise(points):
            outline = [(sign * x0, z0), (sign * x1, z1), (sign * x1, z1 + thick), (sign * x0, z0 + thick)]
            b.add(material, prism(outline, length), body=None)


@KIT.asset(
    "Barn",
    "buildings",
    "Red gambrel barn with double doors and a hay loft, 12 x 16 m, front to +Y",
    "barn building farm red",
)
def barn(b: Builder) -> None:
    outline = [(-600, 0), (600, 0), (600, 450), (420, 750), (0, 920), (-420, 750), (-600, 450)]
    b.add("BarnRed", prism(outline, 1600))
    b.box("Stone", (1206, 1606, 40), body=None)
    _slopes(b, "RoofTin", [(640, 395), (424, 752), (0, 926)], 1680, 14)
    for y in (802, -802):
        b.box("WhitePaint", (420, 8, 400), (0, y, 10), body=None)
        for x in (-98, 98):
            b.box("BarnRed", (184, 12, 372), (x, y, 14), body=None)
            for tilt in (-27, 27):
                b.box("WhitePaint", (14, 16, 410), (x + (95 if tilt > 0 else -95), y, 14), (-tilt, 0, 0), body=None)
        b.box("WhitePaint", (180, 8, 150), (0, y, 540), body=None)
        b.box("BarnRed", (152, 14, 126), (0, y, 552), body=None)
        for x in (-598, 598):
            b.box("WhitePaint", (18, 10, 440), (x, y, 0), body=None)
    for y in (-500, 0, 500):
        _window(b, 90, 90, (602, y, 200), -90)
        _window(b, 90, 90, (-602, y, 200), 90)


@KIT.asset(
    "Farmhouse",
    "buildings",
    "Two-storey farmhouse with a porch and a tiled roof, 11 x 8 m, front to +Y",
    "house farmhouse building home",
)
def farmhouse(b: Builder) -> None:
    b.box("Plaster", (1100, 800, 560))
    b.box("Stone", (1108, 808, 60), body=None)
    b.gable("RoofTile", (900, 1180, 330), (0, 0, 560), (0, 90, 0))
    for x in (-548, 548):
        b.add("Plaster", prism([(-400, 0), (400, 0), (0, 290)], 12), (x, 0, 560), (0, 90, 0), body=None)
    b.box("Brick", (90, 90, 300), (-330, -60, 700))
    for z in (110, 370):
        for x in (-400, -190, 190, 400):
            _window(b, 95, 125, (x, 400, z))
            _window(b, 95, 125, (x, -400, z), 180)
        for y in (-180, 180):
            _window(b, 90, 120, (552, y, z), -90)
            _window(b, 90, 120, (-552, y, z), 90)
    _window(b, 95, 125, (0, 400, 370))
    b.box("DoorGreen", (110, 10, 215), (0, 402, 20), body=None)
    b.box("Stone", (320, 180, 20), (0, 490, 0))
    for x in (-140, 140):
        b.box("WhitePaint", (16, 16, 250), (x, 560, 20))
    b.add("RoofTile", prism([(-180, 0), (180, 0), (0, 90)], 190), (0, 490, 270))


@KIT.asset("Silo", "buildings", "Steel grain silo with a domed roof, 11 m high", "silo grain tower steel")
def silo(b: Builder) -> None:
    b.cylinder("Stone", 240, 40, segments=28)
    b.cylinder("Steel", 225, 860, (0, 0, 40), segments=28)
    for z in range(120, 860, 105):
        b.cylinder("RoofTin", 229, 10, (0, 0, z), segments=28, body=None)
    b.lathe("Steel", [(232, 900), (190, 1000), (110, 1070), (0, 1100)], segments=28)
    for x in (-22, 22):
        b.tube("Iron", [(x, 238, 60), (x, 238, 930)], 3)
    for z in range(90, 930, 42):
        b.tube("Iron", [(-22, 238, z), (22, 238, z)], 2, segments=5)


@KIT.asset(
    "Windmill", "buildings", "Stone tower windmill with four sails, 12 m high, sails to +Y", "windmill mill tower sails"
)
def windmill(b: Builder) -> None:
    b.cylinder("Stone", 330, 820, top=230, segments=20)
    b.lathe("Thatch", [(262, 820), (240, 930), (120, 1040), (0, 1070)], segments=20)
    b.box("DoorGreen", (110, 40, 210), (0, 312, 0), body=None)
    for z, y in ((330, 288), (590, 256)):
        _window(b, 70, 100, (0, y, z))
    b.tube("Wood", [(0, 200, 880), (0, 320, 880)], 18)
    for k in range(4):
        angle = 90 * k + 20
        with b.moved((0, 318, 880), (-angle, 0, 0)):
            b.box("Wood", (14, 10, 560), body=None)
            b.box("WhitePaint", (110, 3, 430), (62, 0, 110), body=None)
            for z in range(110, 541, 54):
                b.box("Wood", (124, 6, 6), (60, 2, z), body=None)
    b.body_box((30, 30, 1120), (0, 318, 320), (0, 0, 0))


@KIT.asset(
    "ChickenCoop",
    "buildings",
    "Wooden hen house on legs with a ramp, 2.4 x 1.8 m, ramp to +Y",
    "chicken coop hen house",
)
def coop(b: Builder) -> None:
    for x in (-105, 105):
        for y in (-75, 75):
            b.box("Wood", (12, 12, 60), (x, y, 0), body=None)
    b.box("PlankGrey", (240, 180, 130), (0, 0, 55))
    b.gable("RoofTile", (220, 264, 70), (0, 0, 185), (0, 90, 0))
    b.box("HideDark", (40, 4, 46), (-50, 90, 62), body=None)
    _window(b, 60, 45, (50, 90, 105))
    b.add("Wood", prism([(90, 56), (90, 61), (205, 4), (205, 0)], 40), (-50, 0, 0), (0, 90, 0), body=None)
    b.body_box((240, 180, 55))


@KIT.asset("ToolShed", "buildings", "Grey plank shed with a mono-pitch roof, 4 x 3 m, door to +Y", "shed hut tools")
def shed(b: Builder) -> None:
    b.add("PlankGrey", prism([(-200, 0), (200, 0), (200, 220), (-200, 290)], 300))
    b.add("RoofTin", prism([(-225, 294), (225, 216), (225, 226), (-225, 304)], 350), body=None)
    b.box("Wood", (100, 8, 195), (60, 152, 5), body=None)
    _window(b, 70, 60, (-90, 150, 110))


@KIT.asset(
    "Greenhouse",
    "buildings",
    "Small glass greenhouse on a brick base, 3 x 5 m, ridge along Y",
    "greenhouse glass building",
)
def greenhouse(b: Builder) -> None:
    b.box("Brick", (300, 500, 60))
    b.box("Glass", (290, 490, 130), (0, 0, 60))
    b.gable("Glass", (290, 490, 90), (0, 0, 190))
    for y in range(-245, 246, 98):
        for x in (-147, 147):
            b.box("WhitePaint", (6, 6, 130), (x, y, 60), body=None)
        for side in (-1, 1):
            b.tube("WhitePaint", [(side * 147, y, 190), (0, y, 281)], 3, segments=5)
    b.box("WhitePaint", (6, 494, 6), (0, 0, 280), body=None)


@KIT.asset("Well", "buildings", "Round stone well with a roof and a bucket", "well water stone bucket")
def well(b: Builder) -> None:
    b.lathe("Stone", [(70, 0), (95, 0), (95, 85), (70, 85), (70, 50), (0, 50)], smooth=False, segments=20)
    b.cylinder("Water", 70, 2, (0, 0, 51), body=None)
    for x in (-82, 82):
        b.box("Wood", (14, 14, 160), (x, 0, 80), body=None)
    b.tube("Wood", [(-82, 0, 190), (82, 0, 190)], 9)
    b.gable("RoofTile", (170, 230, 80), (0, 0, 235), (0, 90, 0))
    b.tube("HideBrown", [(0, 0, 190), (0, 0, 150)], 1.5)
    b.cylinder("Steel", 14, 28, (0, 0, 122), top=17, body=None)
