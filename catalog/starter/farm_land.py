"""Ground, plants and rocks of the farm pack."""

from __future__ import annotations

import math

import numpy as np

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import hull
from catalog.starter.ground import slab

KIT = Kit()


@KIT.asset("GrassTile", "ground", "Meadow, 10 x 10 m, top at the pivot", "ground floor grass meadow field tile")
def grass(b: Builder) -> None:
    slab(b, "Grass", 1000, 1000)


@KIT.asset(
    "FieldTile",
    "ground",
    "Ploughed field with furrows along X, 10 x 10 m, top at the pivot",
    "ground floor soil field ploughed tile",
)
def field(b: Builder) -> None:
    slab(b, "Soil", 1000, 1000)


@KIT.asset("GravelPath", "ground", "Gravel path, 5 x 5 m, top at the pivot", "ground floor gravel path track tile")
def gravel(b: Builder) -> None:
    slab(b, "Gravel", 500, 500)


@KIT.asset(
    "EarthGround", "ground", "Trodden earth of a yard, 5 x 5 m, top at the pivot", "ground floor earth yard tile"
)
def earth(b: Builder) -> None:
    slab(b, "Earth", 500, 500)


@KIT.asset("FlagstoneTile", "ground", "Flagstones, 2.5 x 2.5 m, top at the pivot", "ground floor stone paving tile")
def flagstone(b: Builder) -> None:
    slab(b, "Flagstone", 250, 250)


@KIT.asset(
    "PondTile",
    "ground",
    "Pond of still water with an earth bank, 10 x 10 m, top at the pivot",
    "pond water ground tile",
)
def pond(b: Builder) -> None:
    b.box("Grass", (1000, 1000, 8), (0, 0, -10))
    b.cylinder("Earth", 470, 3, (0, 0, -2.5), segments=28, squash=0.9, body=None)
    b.cylinder("Water", 440, 3, (0, 0, -1), segments=28, squash=0.9, body=None)


def _crown(b: Builder, material: str, balls: tuple[tuple[float, float, float, float], ...]) -> None:
    for x, y, z, size in balls:
        b.ellipsoid(material, (size, size, size * 0.85), (x, y, z), segments=12, body=None)


@KIT.asset("OakTree", "plants", "Broad oak, 8 m high", "tree oak plant leafy")
def oak(b: Builder) -> None:
    b.cylinder("Bark", 38, 300, top=24, segments=10, body=None)
    _crown(
        b,
        "Leaves",
        ((0, 0, 380, 480), (-160, 60, 300, 360), (150, -80, 280, 380), (60, 160, 330, 340), (-50, -160, 350, 330)),
    )
    b.body_box((64, 64, 320))


@KIT.asset("AppleTree", "plants", "Small apple tree with fruit, 4 m high", "tree apple fruit orchard plant")
def apple(b: Builder) -> None:
    b.cylinder("Bark", 16, 160, top=11, segments=10, body=None)
    balls = ((0, 0, 180, 250), (-70, 30, 140, 180), (70, -20, 150, 190), (10, 70, 160, 170))
    _crown(b, "LeavesLight", balls)
    for i in range(14):
        angle, level = i * 2.4, 190 + (i % 5) * 32
        reach = 118 - abs(level - 240) * 0.45
        place = (reach * math.cos(angle), reach * math.sin(angle), level)
        b.ellipsoid("CombRed", (13, 13, 13), place, segments=8, body=None)
    b.body_box((30, 30, 170))


@KIT.asset("Poplar", "plants", "Slender poplar, 10 m high", "tree poplar plant")
def poplar(b: Builder) -> None:
    b.cylinder("Bark", 18, 200, top=14, segments=10, body=None)
    b.lathe("Leaves", [(0, 110), (70, 170), (110, 330), (100, 560), (60, 800), (0, 1000)], segments=14, body=None)
    b.body_box((36, 36, 300))


@KIT.asset("Bush", "plants", "Round bush, 1.2 m high", "bush shrub plant hedge")
def bush(b: Builder) -> None:
    _crown(b, "Leaves", ((0, 0, 0, 130), (-45, 15, 0, 95), (40, -20, 0, 100), (10, 45, 0, 85)))
    b.body_box((110, 110, 90))


@KIT.asset("Hedge", "plants", "Clipped hedge, 3 m long along X, 1.2 m high", "hedge bush plant fence")
def hedge(b: Builder) -> None:
    b.box("Leaves", (300, 80, 120), bevel=12)


def _row(b: Builder, count: int, step: float) -> list[float]:
    return [(i - (count - 1) / 2) * step for i in range(count)]


@KIT.asset("CabbageRow", "plants", "Row of eight cabbages, 4 m long along X", "crop cabbage row vegetable plant")
def cabbage(b: Builder) -> None:
    for x in _row(b, 8, 50):
        b.ellipsoid("Crop", (40, 40, 28), (x, 0, 0), segments=10, body=None)
        b.ellipsoid("LeavesLight", (24, 24, 26), (x, 0, 8), segments=8, body=None)
    b.body_box((390, 38, 28))


@KIT.asset("CornRow", "plants", "Row of maize, 4 m long along X, 2 m high", "crop corn maize row plant")
def corn(b: Builder) -> None:
    for i, x in enumerate(_row(b, 9, 46)):
        b.cylinder("Crop", 3, 195, (x, 0, 0), segments=6, top=1.5, body=None)
        for k in range(4):
            yaw, z = 90 * k + 37 * i, 50 + 34 * k
            with b.moved((x, 0, z), (0, yaw, 0)):
                b.quad("Crop", [(0, -5, 0), (0, 5, 0), (48, 2, 18), (48, -2, 18)], fit=False)
        b.ellipsoid("Wheat", (9, 9, 26), (x, 0, 120 + (i % 3) * 14), segments=8, body=None)
    b.body_box((390, 20, 190))


@KIT.asset("WheatPatch", "plants", "Patch of ripe wheat, 4 x 2 m, 0.9 m high", "crop wheat grain field plant")
def wheat(b: Builder) -> None:
    b.box("Wheat", (400, 200, 66), body=None)
    rng = np.random.default_rng(4)
    for x in range(-190, 191, 20):
        for y in range(-90, 91, 20):
            dx, dy, top = rng.uniform(-6, 6), rng.uniform(-6, 6), rng.uniform(22, 34)
            b.cylinder("Wheat", 7, float(top), (x + float(dx), y + float(dy), 64), top=1.5, segments=5, body=None)
    b.body_box((400, 200, 66))


@KIT.asset("PumpkinRow", "plants", "Row of six pumpkins on the ground, 4 m long along X", "crop pumpkin row vegetable")
def pumpkins(b: Builder) -> None:
    for i, x in enumerate(_row(b, 6, 70)):
        size = 42 + (i * 7) % 15
        b.ellipsoid("Pumpkin", (size, size, size * 0.72), (x, (i % 2) * 16 - 8, 0), segments=12, body=None)
        b.cylinder("Bark", 3, 10, (x, (i % 2) * 16 - 8, size * 0.7), segments=6, body=None)
    b.body_box((400, 60, 36))


@KIT.asset("Sunflower", "plants", "Clump of sunflowers, 1.8 m high, heads to +Y", "sunflower flower plant")
def sunflower(b: Builder) -> None:
    for x, y, z in ((-22, 0, 165), (4, 14, 178), (26, -8, 150)):
        b.cylinder("Crop", 2.5, z, (x, y, 0), segments=6, body=None)
        b.cylinder("HubYellow", 19, 3, (x, y + 3, z), (0, 0, 80), segments=14, body=None)
        b.cylinder("HideBrown", 10, 5, (x, y + 3, z), (0, 0, 80), segments=12, body=None)
    b.body_box((50, 30, 150))


def _boulder(b: Builder, size: tuple[float, float, float], seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(26, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    points = points * np.array(size) / 2 * rng.uniform(0.82, 1.0, (26, 1)) + [0, 0, size[2] * 0.36]
    points[:, 2] = np.maximum(points[:, 2], 0)
    b.add("Rock", hull(points))


@KIT.asset("Boulder", "rocks", "Grey boulder, 1.6 m", "rock boulder stone")
def boulder(b: Builder) -> None:
    _boulder(b, (160, 130, 120), 5)


@KIT.asset("FieldStone", "rocks", "Small field stone, 0.5 m", "rock stone small")
def fieldstone(b: Builder) -> None:
    _boulder(b, (55, 45, 38), 8)
