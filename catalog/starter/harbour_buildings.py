"""Buildings of the harbour pack: townhouses by one rule, warehouse, lighthouse, kiosk."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from catalog.shapes import AssetSpec, Builder, Kit
from catalog.shapes.patches import Point2, prism

KIT = Kit()
STOREY_CM = 310.0


@dataclass(frozen=True)
class House:
    """A townhouse: width and storeys; wall, roof and door materials; how the roof meets the street."""

    name: str
    width: float
    storeys: int
    wall: str
    roof: str
    door: str
    top: Literal["eaves", "gable", "stepped"]
    shop: bool = False
    depth: float = 1000.0


HOUSES = (
    House("TownhouseRed", 700, 4, "PlasterRed", "RoofTile", "DoorGreen", "eaves"),
    House("TownhouseOchre", 600, 4, "PlasterOchre", "RoofTile", "DoorBlue", "gable"),
    House("TownhouseBlue", 650, 3, "PlasterBlue", "RoofSlate", "WhitePaint", "eaves", shop=True),
    House("TownhouseCream", 800, 4, "PlasterCream", "RoofSlate", "DoorRed", "eaves", shop=True),
    House("TownhouseGreen", 600, 3, "PlasterGreen", "RoofTile", "WhitePaint", "gable"),
    House("TownhouseBrick", 700, 5, "BrickRed", "RoofSlate", "DoorGreen", "stepped"),
    House("TownhouseDarkBrick", 800, 4, "BrickDark", "RoofTile", "DoorBlue", "stepped", shop=True),
    House("TownhouseNarrow", 500, 5, "PlasterRed", "RoofSlate", "DoorBlue", "gable"),
)


def window(b: Builder, width: float, height: float, at: tuple[float, float, float], yaw: float = 0.0) -> None:
    """A white framed sash window in a wall that faces +Y; ``at`` is the middle of its sill on the wall's face."""
    with b.moved(at, (0.0, yaw, 0.0)):
        b.box("WhitePaint", (width + 20, 8, height + 20), (0, 2, -10), body=None)
        b.box("Glass", (width, 4, height), (0, 6, 0), body=None)
        b.box("WhitePaint", (6, 4, height), (0, 8, 0), body=None)
        b.box("WhitePaint", (width, 4, 6), (0, 8, height * 0.6), body=None)
        b.box("Stone", (width + 36, 18, 8), (0, 4, -18), body=None)


def _windows(b: Builder, house: House, face: float, yaw: float) -> None:
    columns = max(2, round(house.width / 200))
    for storey in range(house.storeys):
        for column in range(columns):
            x = (column - (columns - 1) / 2) * house.width / columns
            if storey == 0 and (yaw == 0.0 and (house.shop or column == columns // 2)):
                continue
            side = 1 if yaw == 0.0 else -1
            window(b, 92, 165, (side * x, face, 105 + storey * STOREY_CM), yaw)


def _ground_floor(b: Builder, house: House, face: float) -> None:
    columns = max(2, round(house.width / 200))
    x = (columns // 2 - (columns - 1) / 2) * house.width / columns
    if house.shop:
        x = house.width / 2 - 110
        pane = house.width - 280
        b.box("WhitePaint", (pane + 30, 10, 215), (-95, face + 3, 35), body=None)
        b.box("Glass", (pane, 6, 185), (-95, face + 7, 50), body=None)
        b.box(house.door, (house.width - 40, 14, 50), (0, face + 6, 262), body=None)
    b.box("Stone", (140, 10, 250), (x, face + 3, 0), body=None)
    b.box(house.door, (104, 8, 215), (x, face + 7, 8), body=None)
    b.box("Glass", (90, 4, 26), (x, face + 10, 188), body=None)
    b.box("Stone", (140, 30, 8), (x, face + 15, 0), body=None)


def _roof(b: Builder, house: House, height: float) -> None:
    width, depth, half = house.width, house.depth, house.depth / 2
    if house.top == "eaves":
        b.box("WhitePaint", (width, depth + 24, 24), (0, 0, height), body=None)
        b.gable(house.roof, (depth + 40, width, 420), (0, 0, height + 24), (0, 90, 0))
        for x in (-width / 4, width / 4):
            b.box(house.wall, (130, 190, 130), (x, half - 190, height + 60), body=None)
            b.gable(house.roof, (150, 210, 60), (x, half - 190, height + 190), body=None)
            window(b, 80, 90, (x, half - 95, height + 90))
        ridge = height + 440
    else:
        b.gable(house.roof, (width, depth - 40, 460), (0, 0, height))
        steps: list[Point2] = [(-width / 2, 0), (width / 2, 0)]
        if house.top == "gable":
            outline: list[Point2] = [*steps, (width / 2, 40), (30, 500), (-30, 500), (-width / 2, 40)]
        else:
            outline = list(steps)
            for i in range(5):
                x, z = width / 2 - i * width / 11, 60 + i * 100.0
                outline += [(x, z), (x - width / 11, z)]
            outline += [(-x, z) for x, z in reversed(outline[2:])]
        for y in (half - 15, 15 - half):
            b.add(house.wall, prism(outline, 30), (0, y, height), body=None)
        for level, count in ((90, 2), (270, 1)):
            for i in range(count):
                window(b, 80, 110, ((i - (count - 1) / 2) * 190, half, height + level))
        b.box("Stone", (40, 36, 14), (0, half - 15, height + 500), body=None)
        ridge = height + 420
    for x in (-width * 0.32, width * 0.32):
        b.box("BrickRed", (70, 90, 200), (x, -half * 0.35, ridge - 160), body=None)
        b.box("Stone", (84, 104, 12), (x, -half * 0.35, ridge + 40), body=None)


def townhouse(house: House) -> AssetSpec:
    """The asset of a townhouse."""

    def build(b: Builder) -> None:
        height, face = house.storeys * STOREY_CM, house.depth / 2
        b.box(house.wall, (house.width, house.depth, height))
        b.box("Stone", (house.width, house.depth + 8, 60), body=None)
        for storey in range(1, house.storeys):
            b.box("Stone", (house.width, house.depth + 6, 10), (0, 0, storey * STOREY_CM + 20), body=None)
        _windows(b, house, face, 0.0)
        _windows(b, house, -face, 180.0)
        _ground_floor(b, house, face)
        _roof(b, house, height)

    words = "house building townhouse facade row" + (" shop" if house.shop else "")
    kind = {"eaves": "dormers", "gable": "a pointed gable", "stepped": "a stepped gable"}[house.top]
    return AssetSpec(
        house.name,
        "buildings",
        f"{house.storeys}-storey townhouse with {kind}"
        f"{' and a shop front' if house.shop else ''}, {house.width / 100:g} m wide, front to +Y",
        tuple(words.split()),
        build,
    )


KIT.assets.extend(townhouse(house) for house in HOUSES)


@KIT.asset(
    "Warehouse",
    "buildings",
    "Brick warehouse with loading doors and hoist beams, 16 x 12 m, front to +Y",
    "warehouse building storage brick harbour",
)
def warehouse(b: Builder) -> None:
    b.box("BrickDark", (1600, 1200, 720))
    b.box("StoneDark", (1600, 1208, 80), body=None)
    for x in (-400, 400):
        b.gable("RoofSlate", (820, 1230, 330), (x, 0, 720))
        for y in (585, -585):
            b.add("BrickDark", prism([(-400, 0), (400, 0), (0, 340)], 30), (x, y, 720), body=None)
        b.box("WoodDark", (300, 12, 320), (x, 602, 20), body=None)
        b.box("WoodDark", (180, 12, 210), (x, 602, 440), body=None)
        b.box("Iron", (14, 130, 16), (x, 660, 800), body=None)
    for x in (-650, -150, 150, 650):
        window(b, 110, 150, (x, 600, 140))
        window(b, 110, 150, (x, 600, 470))
        window(b, 110, 150, (x, -600, 300), 180)


@KIT.asset("Lighthouse", "buildings", "Round harbour lighthouse with red bands, 14 m high", "lighthouse tower beacon")
def lighthouse(b: Builder) -> None:
    b.cylinder("Stone", 300, 60, segments=24)
    for i in range(5):
        low, high = 230 - i * 20, 210 - i * 20
        b.cylinder("DoorRed" if i % 2 else "WhitePaint", low, 180, (0, 0, 60 + i * 180), top=high, segments=24)
    b.cylinder("Iron", 190, 16, (0, 0, 960), segments=24)
    b.cylinder("Glass", 100, 180, (0, 0, 976), segments=16)
    b.cylinder("LampGlow", 40, 120, (0, 0, 1000), body=None)
    b.cylinder("DoorRed", 130, 120, (0, 0, 1156), top=10, segments=16)
    for z in (1010, 1056):
        b.cylinder("Iron", 184, 5, (0, 0, z), segments=24, body=None)
    b.box("DoorGreen", (90, 14, 200), (0, 222, 60), body=None)
    window(b, 60, 90, (0, 196, 420))


@KIT.asset("Kiosk", "buildings", "Small wooden kiosk with a counter and an awning, front to +Y", "kiosk shop hut")
def kiosk(b: Builder) -> None:
    b.box("DoorGreen", (300, 220, 250))
    b.box("WhitePaint", (320, 240, 14), (0, 0, 250), body=None)
    b.add("RoofSlate", prism([(-165, 0), (165, 0), (0, 80)], 250), (0, 0, 264))
    b.box("Glass", (200, 6, 100), (0, 110, 110), body=None)
    b.box("Wood", (240, 40, 6), (0, 128, 100))
    b.add("Canvas", prism([(-120, 0), (120, 0), (120, 6), (-120, 6)], 100), (0, 152, 222), (0, 0, 15), body=None)
