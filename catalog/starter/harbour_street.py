"""Street furniture, market, cargo and vehicles of the harbour pack."""

from __future__ import annotations

import math

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import prism

KIT = Kit()


@KIT.asset("StreetLamp", "street", "Ornate black street lamp with a lantern, 4.2 m high", "lamp lantern light post")
def lamp(b: Builder) -> None:
    b.lathe("Iron", [(0, 0), (24, 0), (24, 12), (14, 30), (8, 60), (6, 330), (10, 340), (0, 345)], body=None)
    b.box("LampGlow", (26, 26, 44), (0, 0, 346), body=None)
    for x in (-14, 14):
        for y in (-14, 14):
            b.box("Iron", (3, 3, 46), (x, y, 345), body=None)
    b.cylinder("Iron", 26, 26, (0, 0, 391), top=4, segments=8, body=None)
    b.tube("Iron", [(-40, 0, 300), (40, 0, 300)], 2.5)
    b.body_box((20, 20, 417))


@KIT.asset("Bench", "street", "Wooden park bench with iron legs, faces +Y", "bench seat")
def bench(b: Builder) -> None:
    for y in (-18, -2, 14):
        b.box("Wood", (180, 13, 4), (0, y, 42), body=None)
    for z in (60, 76):
        b.box("Wood", (180, 4, 12), (0, -28, z), (0, 0, -8), body=None)
    for x in (-72, 72):
        b.box("Iron", (6, 46, 42), (x, -3, 0), body=None)
        b.box("Iron", (6, 5, 90), (x, -29, 0), body=None)
    b.body_box((180, 56, 46), (0, -4, 0))
    b.body_box((180, 10, 44), (0, -29, 46))


@KIT.asset("Bollard", "street", "Cast-iron mooring bollard", "bollard mooring post iron")
def bollard(b: Builder) -> None:
    b.lathe("Iron", [(0, 0), (26, 0), (26, 8), (16, 14), (15, 46), (24, 54), (24, 62), (0, 68)])


@KIT.asset("StoneBollard", "street", "Round-topped stone bollard", "bollard stone post")
def stone_bollard(b: Builder) -> None:
    b.lathe("Stone", [(0, 0), (20, 0), (17, 70), (10, 84), (0, 88)])


@KIT.asset("StreetTree", "street", "Leafy street tree with a round crown, 7 m high", "tree leafy plant")
def tree(b: Builder) -> None:
    b.cylinder("Bark", 22, 260, top=14, segments=10, body=None)
    crown = ((0, 0, 330, 360), (-90, 40, 270, 260), (80, -50, 250, 270), (30, 90, 300, 250), (-20, -90, 340, 240))
    for x, y, z, size in crown:
        b.ellipsoid("Leaves", (size, size, size * 0.85), (x, y, z - 30), segments=12, body=None)
    b.body_box((40, 40, 300))


@KIT.asset("SlimTree", "street", "Slender conical tree, 6 m high", "tree conifer plant")
def slim_tree(b: Builder) -> None:
    b.cylinder("Bark", 14, 120, segments=10, body=None)
    for z, radius in ((90, 120), (200, 100), (320, 76), (430, 50)):
        b.cylinder("Leaves", radius, 170, (0, 0, z), top=radius * 0.15, segments=12, body=None)
    b.body_box((28, 28, 200))


@KIT.asset("Planter", "street", "Stone planter with a clipped bush", "planter bush plant pot flower")
def planter(b: Builder) -> None:
    b.box("Stone", (110, 110, 60), bevel=4)
    b.box("Soil", (90, 90, 3), (0, 0, 60), body=None)
    b.ellipsoid("Leaves", (100, 100, 80), (0, 0, 52), segments=12, body=None)


@KIT.asset("RoadSign", "street", "Round no-entry sign on a pole, faces +Y", "sign road traffic")
def sign(b: Builder) -> None:
    b.cylinder("Steel", 3, 230, segments=10, body=None)
    b.cylinder("SignRed", 32, 3, (0, 4, 235), (0, 0, 90), segments=24, body=None)
    b.box("WhitePaint", (44, 2, 10), (0, 8, 230), body=None)
    b.body_box((8, 8, 260))


@KIT.asset("ParkingSign", "street", "Square blue parking sign on a pole, faces +Y", "sign parking traffic")
def parking(b: Builder) -> None:
    b.cylinder("Steel", 3, 220, segments=10, body=None)
    b.box("SignBlue", (56, 3, 56), (0, 4, 200), body=None)
    b.box("WhitePaint", (8, 2, 38), (-10, 6, 209), body=None)
    b.box("WhitePaint", (22, 2, 8), (-3, 6, 239), body=None)
    b.box("WhitePaint", (22, 2, 8), (-3, 6, 225), body=None)
    b.box("WhitePaint", (8, 2, 22), (10, 6, 225), body=None)
    b.body_box((8, 8, 256))


@KIT.asset("LitterBin", "street", "Round litter bin with a lid", "bin trash litter")
def litter_bin(b: Builder) -> None:
    b.cylinder("DoorGreen", 28, 80, top=32, segments=16)
    b.lathe("Iron", [(34, 80), (34, 86), (16, 100), (0, 102)], body=None)


@KIT.asset("CafeTable", "market", "Round cafe table", "table cafe")
def table(b: Builder) -> None:
    b.cylinder("WhitePaint", 40, 4, (0, 0, 70))
    b.cylinder("Iron", 4, 70, body=None)
    b.cylinder("Iron", 26, 4, body=None)
    b.body_box((16, 16, 70))


@KIT.asset("CafeChair", "market", "Folding cafe chair, faces +Y", "chair seat cafe")
def chair(b: Builder) -> None:
    b.box("Wood", (40, 40, 4), (0, 0, 42), body=None)
    for x in (-17, 17):
        for y in (-17, 17):
            b.box("Iron", (4, 4, 42), (x, y, 0), body=None)
        b.box("Iron", (4, 4, 44), (x, -18, 46), body=None)
    b.box("Wood", (38, 3, 22), (0, -18, 64), body=None)
    b.body_box((40, 40, 46))
    b.body_box((40, 5, 44), (0, -18, 46))


def _stall(b: Builder, canvas: str) -> None:
    b.box("Wood", (240, 110, 8), (0, 0, 78))
    b.box("WoodDark", (232, 100, 78), (0, 0, 0))
    for x in (-112, 112):
        b.box("WoodDark", (8, 8, 235), (x, -46, 0), body=None)
        b.box("WoodDark", (8, 8, 205), (x, 46, 0), body=None)
    b.add(canvas, prism([(-130, 0), (130, 0), (130, 5), (-130, 5)], 160), (0, 5, 218), (0, 0, 13), body=None)
    b.box(canvas, (260, 4, 24), (0, 82, 178), body=None)
    for i, fruit in enumerate(("FruitRed", "FruitYellow", "FruitGreen")):
        b.box("Wood", (66, 84, 14), (-76 + 76 * i, 4, 86), body=None)
        for x in (-20, 0, 20):
            for y in (-28, -8, 12, 32):
                b.ellipsoid(fruit, (19, 19, 18), (-76 + 76 * i + x, y, 96), segments=8, body=None)


@KIT.asset(
    "MarketStallRed",
    "market",
    "Market stall with fruit under a red striped awning, faces +Y",
    "market stall fruit awning",
)
def stall_red(b: Builder) -> None:
    _stall(b, "Canvas")


@KIT.asset(
    "MarketStallBlue",
    "market",
    "Market stall with fruit under a blue striped awning, faces +Y",
    "market stall fruit awning",
)
def stall_blue(b: Builder) -> None:
    _stall(b, "CanvasBlue")


@KIT.asset("Parasol", "market", "Striped parasol on a stone foot, 2.6 m high", "parasol umbrella cafe")
def parasol(b: Builder) -> None:
    b.cylinder("Stone", 28, 10)
    b.cylinder("Wood", 3, 250, (0, 0, 10), body=None)
    b.cylinder("Canvas", 140, 55, (0, 0, 205), top=3, segments=8, body=None)
    b.body_box((8, 8, 250), (0, 0, 10))


@KIT.asset("WoodenCrate", "cargo", "Wooden crate, 0.8 m", "crate box wooden cargo")
def crate(b: Builder) -> None:
    b.box("Wood", (76, 76, 76), (0, 0, 2), body=None)
    for x in (-36, 36):
        for y in (-36, 36):
            b.box("WoodDark", (8, 8, 80), (x, y, 0), body=None)
    for z in (0, 72):
        for y in (-38, 38):
            b.box("WoodDark", (80, 4, 8), (0, y, z), body=None)
        for x in (-38, 38):
            b.box("WoodDark", (4, 80, 8), (x, 0, z), body=None)
    b.body_box((80, 80, 80))


@KIT.asset("FishBox", "cargo", "Low blue fish box, 0.8 x 0.5 m", "box fish crate blue")
def fish_box(b: Builder) -> None:
    b.box("ContainerBlue", (80, 50, 3), body=None)
    for y in (-23.5, 23.5):
        b.box("ContainerBlue", (80, 3, 26), (0, y, 0), body=None)
    for x in (-38.5, 38.5):
        b.box("ContainerBlue", (3, 50, 26), (x, 0, 0), body=None)
    for i in range(5):
        b.ellipsoid("Steel", (40, 10, 8), (-14 + 7 * i, -16 + 8 * i, 14), segments=8, body=None)
    b.body_box((80, 50, 26))


@KIT.asset("Barrel", "cargo", "Oak barrel with iron hoops, 0.9 m high", "barrel cask wooden cargo")
def barrel(b: Builder) -> None:
    b.lathe("Wood", [(0, 0), (27, 0), (33, 24), (35, 45), (33, 66), (27, 90), (0, 90)])
    for z, radius in ((10, 30.5), (28, 34.5), (58, 34.8), (76, 31)):
        b.cylinder("Iron", radius, 5, (0, 0, z), body=None)


@KIT.asset("CargoContainer", "cargo", "Blue shipping container, 6 m long along X", "container cargo shipping blue")
def container(b: Builder) -> None:
    _container(b, "ContainerBlue")


@KIT.asset(
    "CargoContainerRust", "cargo", "Rust-red shipping container, 6 m long along X", "container cargo shipping red"
)
def container_rust(b: Builder) -> None:
    _container(b, "ContainerRust")


def _container(b: Builder, paint: str) -> None:
    b.box(paint, (600, 236, 250), (0, 0, 4), body=None)
    for x in range(-280, 281, 28):
        for y in (-120, 120):
            b.box(paint, (14, 4, 230), (x, y, 14), body=None)
    for z in (0, 248):
        for y in (-118, 118):
            b.box("Steel", (606, 10, 12), (0, y, z), body=None)
    for y in (-60, 60):
        b.box("Steel", (4, 5, 220), (303, y, 16), body=None)
    b.body_box((606, 244, 260))


@KIT.asset(
    "HarbourCrane",
    "cargo",
    "Yellow harbour crane with a lattice jib that reaches to +Y, 14 m high",
    "crane harbour dock lifting",
)
def crane(b: Builder) -> None:
    b.box("StoneDark", (420, 420, 40))
    for x in (-150, 150):
        for y in (-150, 150):
            b.box("CraneYellow", (34, 34, 620), (x, y, 40), body=None)
        b.tube("CraneYellow", [(x, -150, 60), (x, 150, 620)], 9)
    for y in (-150, 150):
        b.tube("CraneYellow", [(-150, y, 60), (150, y, 620)], 9)
    b.box("Steel", (380, 380, 24), (0, 0, 660))
    b.box("CraneYellow", (260, 300, 260), (0, -30, 684))
    b.box("Glass", (180, 8, 110), (0, 121, 790), body=None)
    b.box("StoneDark", (220, 120, 160), (0, -240, 700), body=None)
    length, tilt = 1100.0, math.radians(33)
    for x in (-40, 40):
        for low in (0, 70):
            end = (x * 0.4, 110 + length * math.cos(tilt), 700 + low * 0.4 + length * math.sin(tilt))
            b.tube("CraneYellow", [(x, 110, 700 + low), end], 7)
    for i in range(10):
        out, up = 110 + i * length * math.cos(tilt) / 10, 700 + i * length * math.sin(tilt) / 10
        b.box("CraneYellow", (80 - i * 5, 6, 60 - i * 3), (0, out, up + 5), (0, 0, 33), body=None)
    tip = (0.0, 110 + length * math.cos(tilt), 700 + length * math.sin(tilt))
    b.tube("Iron", [tip, (tip[0], tip[1], 560)], 2)
    b.box("Iron", (20, 20, 40), (tip[0], tip[1], 520), body=None)
    b.body_box((340, 340, 620), (0, 0, 40))


@KIT.asset("HandTruck", "cargo", "Two-wheeled hand truck, handle to -Y", "hand truck trolley cart")
def hand_truck(b: Builder) -> None:
    b.box("Steel", (50, 30, 3), (0, 14, 3), body=None)
    for x in (-22, 22):
        b.tube("SignRed", [(x, 0, 6), (x, -14, 100), (x, -30, 124)], 2.5)
        b.cylinder("Rubber", 12, 6, (x * 1.35 + 3, -6, 12), (90, 0, 0), body=None)
    for z in (30, 60, 90):
        b.tube("SignRed", [(-22, -z * 0.14, z), (22, -z * 0.14, z)], 2)
    b.body_box((66, 62, 100), (0, -2, 0))


def _wheels(b: Builder, xs: tuple[float, ...], half: float, radius: float) -> None:
    for x in xs:
        for side in (-1, 1):
            b.cylinder("Rubber", radius, 22, (x, side * half + 11, radius), (0, 0, 90), segments=16, body=None)
            b.cylinder("Steel", radius * 0.55, 24, (x, side * half + 12, radius), (0, 0, 90), segments=12, body=None)


def _car(b: Builder, paint: str) -> None:
    side = [(-200, 28), (205, 28), (210, 62), (190, 84), (100, 92), (-180, 96), (-208, 80), (-208, 40)]
    b.add(paint, prism(side, 168), body=None)
    b.add("Glass", prism([(-170, 92), (110, 90), (55, 138), (-110, 140)], 150), body=None)
    b.add(paint, prism([(-116, 136), (60, 134), (50, 146), (-105, 147)], 146), body=None)
    for y in (-60, 60):
        b.box("LampGlow", (6, 26, 14), (207, y, 62), body=None)
        b.box("SignRed", (6, 26, 12), (-208, y, 70), body=None)
    b.box("Steel", (10, 160, 12), (208, 0, 32), body=None)
    _wheels(b, (-130, 130), 76, 32)
    b.body_box((418, 176, 96))
    b.body_box((240, 150, 52), (-30, 0, 96))


@KIT.asset("CarRed", "vehicles", "Small red car, 4.2 m long, front to +X", "car vehicle red")
def car_red(b: Builder) -> None:
    _car(b, "CarRed")


@KIT.asset("CarTeal", "vehicles", "Small teal car, 4.2 m long, front to +X", "car vehicle teal")
def car_teal(b: Builder) -> None:
    _car(b, "CarTeal")


@KIT.asset("DeliveryVan", "vehicles", "White delivery van, 5.4 m long, front to +X", "van vehicle delivery white")
def van(b: Builder) -> None:
    b.add(
        "VanWhite",
        prism([(-260, 30), (262, 30), (268, 70), (250, 110), (200, 120), (150, 220), (-258, 225)], 190),
        body=None,
    )
    b.add("Glass", prism([(246, 116), (202, 124), (158, 208), (170, 208)], 170), (3, 0, 0), body=None)
    for side in (-96, 96):
        b.box("Glass", (70, 3, 60), (120, side, 130), body=None)
        b.box("SignBlue", (250, 3, 60), (-100, side, 120), body=None)
    for y in (-66, 66):
        b.box("LampGlow", (6, 26, 18), (262, y, 74), body=None)
    _wheels(b, (-160, 165), 88, 36)
    b.body_box((530, 194, 120))
    b.body_box((430, 190, 105), (-45, 0, 120))


@KIT.asset("Bicycle", "vehicles", "Upright bicycle with a front basket, front to +X", "bicycle bike")
def bicycle(b: Builder) -> None:
    for x in (-52, 52):
        ring = [(x + 33 * math.cos(a), 0.0, 34 + 33 * math.sin(a)) for a in (i * math.pi / 8 for i in range(17))]
        b.tube("Rubber", ring, 2.2, segments=6)
        for a in (0.3, 1.35, 2.4):
            dx, dz = 32 * math.cos(a), 32 * math.sin(a)
            b.tube("Steel", [(x - dx, 0, 34 - dz), (x + dx, 0, 34 + dz)], 0.5, segments=4)
    for path in (
        [(-52, 0, 34), (-14, 0, 32), (36, 0, 78), (-24, 0, 74), (-14, 0, 32)],
        [(-52, 0, 34), (-24, 0, 74)],
        [(52, 0, 34), (36, 0, 78), (32, 0, 100)],
        [(-24, 0, 74), (-28, 0, 90)],
    ):
        b.tube("CarTeal", path, 2, segments=6)
    b.tube("Iron", [(18, -28, 100), (32, 0, 102), (18, 28, 100)], 1.8, segments=6)
    b.box("Rubber", (26, 16, 6), (-30, 0, 90), body=None)
    b.box("Wood", (26, 34, 22), (56, 0, 80), body=None)
    b.body_box((166, 20, 100))
