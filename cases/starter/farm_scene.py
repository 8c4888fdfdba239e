"""The scene ``small-farm``: a yard between house and barn, a track, crop fields, an orchard, a pasture, a pond.

The land is 100 x 80 m in cells of 10 m: column ``i`` (0 to 9) along X, row ``j`` (0 to 7) along Y. Ground at z = 0.
"""

from __future__ import annotations

from cases.model import SourceScene
from cases.starter.plot import STACK_GAP_CM, Plot, asset_paths
from catalog.starter.farm import pack

SCENE_ID = "small-farm"
SPEC = pack()
PATHS = asset_paths(SPEC.content_folder, ((asset.name, asset.category) for asset in SPEC.assets))
FIELDS = [(i, j) for i in range(4) for j in (5, 6, 7)]
YARD = [(i, j) for i in (4, 5, 6) for j in (4, 5)]
POND = (5, 1)
TRACK_ROW = 3
QUARTERS = ((-250.0, -250.0), (250.0, -250.0), (-250.0, 250.0), (250.0, 250.0))


def cell(i: int, j: int) -> tuple[float, float]:
    """Centre of a cell in cm."""
    return -4500.0 + 1000 * i, -3500.0 + 1000 * j


def build() -> SourceScene:
    """The scene with its level."""
    p = Plot(SCENE_ID, PATHS, seed=23)
    _ground(p)
    _fields(p)
    _pasture(p)
    _orchard(p)
    _yard(p)
    _edges(p)
    p.daylight(-42.0, -118.0)
    return SourceScene(SCENE_ID, "outdoor", "Small farm", p.level(), ("c4s-farm",))


def _ground(p: Plot) -> None:
    for i in range(10):
        for j in range(8):
            x, y = cell(i, j)
            if (i, j) in FIELDS:
                p.add("FieldTile", x, y)
            elif (i, j) == POND:
                p.add("PondTile", x, y)
            elif (i, j) in YARD:
                for dx, dy in QUARTERS:
                    p.add("EarthGround", x + dx, y + dy)
            elif j == TRACK_ROW:
                for dx, dy in QUARTERS[2:]:
                    p.add("GravelPath", x + dx, y + dy)
                p.add("GrassTile", x, y - 250, scale=(1.0, 0.5, 1.0))
            else:
                p.add("GrassTile", x, y)


def _fields(p: Plot) -> None:
    for i, j in FIELDS:
        x, y = cell(i, j)
        crop, step = {0: ("CornRow", 110), 1: ("CabbageRow", 130), 2: ("WheatPatch", 235), 3: ("PumpkinRow", 170)}[i]
        count = int(880 / step)
        for row in range(count):
            for dx in (-220, 220):
                p.add(crop, x + dx, y + (row - (count - 1) / 2) * step)
    for x, y in ((-3900, 1500), (-2000, 2980)):
        p.add("Scarecrow", x - 500, y, yaw=p.random.uniform(-30, 30))
    for number in range(6):
        p.add("Sunflower", -950, 1200 + 420 * number, yaw=-90)


def _pasture(p: Plot) -> None:
    west, east, south, north = -4900.0, -1300.0, -3900.0, -1100.0
    count = int((east - west) / 300)
    for k in range(count):
        p.add("WoodFence", west + 150 + 300 * k, south)
        if k != 9:
            p.add("WoodFence", west + 150 + 300 * k, north, yaw=180)
        else:
            p.add("FieldGate", west + 150 + 300 * k, north)
    for k in range(9):
        y = south + 160 + 300 * k
        p.add("WoodFence", west - 20, y, yaw=90)
        p.add("WoodFence", east + 20, y, yaw=-90)
    for x, y, yaw in ((-4200, -3100, 20), (-3600, -1900, 160), (-3900, -2500, -70), (-2300, -3300, 100)):
        p.add("Cow", x, y, yaw=yaw, scale=p.random.uniform(0.95, 1.05))
    for x, y in ((-3000, -2000), (-2750, -2180), (-2600, -1900), (-3050, -2300), (-2450, -2350), (-2800, -1650)):
        p.add("Sheep", x, y, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.92, 1.08))
    p.add("Horse", -1800, -2600, yaw=140)
    p.add("Horse", -1700, -1800, yaw=-30)
    p.add("WaterTrough", -2780, -2030)
    p.add("OakTree", -4400, -1700, yaw=40)
    p.add("OakTree", -2900, -3500, yaw=120, scale=0.85)
    for x, y in ((-4600, -3600), (-3300, -3000), (-1600, -3500)):
        p.add("FieldStone", x, y, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.8, 1.6))


def _orchard(p: Plot) -> None:
    for x in range(2350, 4900, 560):
        for y in range(-3600, -1200, 560):
            p.add("AppleTree", x, y, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.88, 1.12))
    for x, y in ((2630, -2200), (3190, -1700), (3750, -2760)):
        p.add("Crate", x, y, yaw=p.random.uniform(-20, 20))
        p.add("Crate", x + 3, y - 2, 26 + STACK_GAP_CM, yaw=p.random.uniform(-20, 20))
    for x in range(2150, 4900, 310):
        p.add("StoneWall", x, -1080)
    px, py = cell(*POND)
    for dx, dy, scale in ((-560.0, 300.0, 1.0), (560.0, -250.0, 0.8), (540.0, 420.0, 0.6)):
        p.add("Boulder", px + dx, py + dy, yaw=p.random.uniform(-180, 180), scale=scale)
    for dx, dy in ((-600.0, -300.0), (-420.0, 560.0), (300.0, 600.0), (620.0, 120.0)):
        p.add("Bush", px + dx, py + dy, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.8, 1.2))


def _yard(p: Plot) -> None:
    p.add("Farmhouse", 0, 2950, yaw=180)
    for y in (2350, 2090):
        p.add("FlagstoneTile", 0, y, 0.5)
    for x in (-420, 420):
        p.add("Sunflower", x, 2420, yaw=180)
    for x in (-780, 780):
        p.add("Bush", x, 2440)
    p.add("Barn", 3400, 1500, yaw=90)
    p.add("Silo", 3000, 3000)
    p.add("Silo", 3560, 3000)
    p.add("Windmill", 4300, 3300, yaw=200)
    p.add("ToolShed", 1750, 2800, yaw=180)
    p.add("Greenhouse", -1200 + 400, 3200 + 350, yaw=90, scale=0.9)
    p.add("Well", 150, 1050, yaw=15)
    p.add("ChickenCoop", 2500 - 260, 150, yaw=0)
    for x, y in ((2470, 240), (2400, 430), (2150, 460), (1960, 280), (2010, 40), (2390, -20)):
        p.add("Hen", x, y, yaw=p.random.uniform(-180, 180))
    for x in (1650, 1950, 2250, 2550):
        p.add("WoodFence", x - 20, 700)
    for x, y in ((-600, 400), (-520, 560), (-380, 380)):
        p.add("Pig", x, y, yaw=p.random.uniform(-180, 180))
    p.add("WaterTrough", -480, 200)
    for x in (-850, -550, -250):
        p.add("WoodFence", x, 760)
        p.add("WoodFence", x, 80)
    p.add("WoodFence", -1010, 250, yaw=90)
    p.add("WoodFence", -1010, 560, yaw=90)
    p.add("WoodFence", -90, 560, yaw=-90)
    p.add("FieldGate", -90, 250, yaw=90)
    p.add("TractorRed", 1500, 1500, yaw=-165)
    p.add("TractorGreen", 900, -240, yaw=0)
    p.add("HayCart", 380, -240, yaw=0)
    p.add("Plough", 1700, 2250, yaw=30)
    for x, y, level in ((2200, 2560, 0), (2200, 2560, 1), (2200, 2625, 0), (2200, 2690, 0), (2200, 2625, 1)):
        p.add("HayBale", x, y, level * (51 + STACK_GAP_CM))
    for x, y in ((2900, -240), (3200, -230), (3500, -250)):
        p.add("RoundBale", x, y, yaw=p.random.uniform(-10, 10))
    p.add("Haystack", 4300, 400)
    p.add("Haystack", 4650, 700, scale=0.85)
    for x in (2280, 2330, 2380):
        p.add("MilkChurn", x, 1080)
    for x, y in ((1580, 2560), (1500, 2600), (560, 2500)):
        p.add("Barrel", x, y, yaw=p.random.uniform(-180, 180))
    p.add("WoodPile", 650, 3400, yaw=90)
    p.add("WoodPile", -650, 2900, yaw=-90)
    p.add("Wheelbarrow", 1150, 2250, yaw=-50)
    p.add("ToolRack", 1980, 2580, yaw=180)
    for x, y in ((1240, 2560), (1300, 2480), (1180, 2470)):
        p.add("Crate", x, y, yaw=p.random.uniform(-25, 25))


def _edges(p: Plot) -> None:
    for x in range(-4800, 4900, 800):
        p.add("Poplar", x, 3975, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.85, 1.1))
    for x in range(-4750, -1000, 310):
        p.add("Hedge", x, 850)
    for x, y in ((4600, -400), (-700, -2900), (1500, -3500), (1300, -1400), (-800, -1500)):
        p.add("OakTree", x, y - 300, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.9, 1.1))
    for x, y in ((4700, 1200), (4800, 2300), (1900, -3700), (-900, -3700)):
        p.add("Bush", x, y, scale=p.random.uniform(0.8, 1.2))
    for x, y in ((4700, -900), (-4850, -500)):
        p.add("Boulder", x, y, yaw=p.random.uniform(-180, 180), scale=p.random.uniform(0.6, 0.9))
