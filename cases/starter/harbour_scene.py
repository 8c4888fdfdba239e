"""The scene ``harbour-street``: a quay with a promenade, a street of townhouses, a canal with two bridges, boats.

X runs along the waterfront, the water lies at +Y. The quay's edge is y = 0, the ground is at z = 0, the water at -120.
"""

from __future__ import annotations

from cases.model import SourceScene
from cases.starter.plot import STACK_GAP_CM, Plot, asset_paths
from catalog.starter.harbour import pack

SCENE_ID = "harbour-street"
WATER_CM = -120.0
SPEC = pack()
PATHS = asset_paths(SPEC.content_folder, ((asset.name, asset.category) for asset in SPEC.assets))
WEST, EAST = range(-8000, 1600, 400), range(2400, 8000, 400)
"""Left ends of the 4 m columns on both sides of the canal (x 1600 to 2400)."""
HOUSE_WIDTHS = {
    "TownhouseRed": 700,
    "TownhouseOchre": 600,
    "TownhouseBlue": 650,
    "TownhouseCream": 800,
    "TownhouseGreen": 600,
    "TownhouseBrick": 700,
    "TownhouseDarkBrick": 800,
    "TownhouseNarrow": 500,
}
WEST_ROW = ("Red", "Ochre", "Blue", "Cream", "Green", "", "Brick", "DarkBrick", "Narrow", "Red", "Blue")
EAST_ROW = ("Ochre", "Brick", "Cream", "", "Narrow", "DarkBrick", "Green", "Red")
LANE_CM = 450.0


def build() -> SourceScene:
    """The scene with its level."""
    p = Plot(SCENE_ID, PATHS, seed=11)
    _ground(p)
    _water(p)
    _canal(p)
    _houses(p)
    _promenade(p)
    _street(p)
    _market(p)
    _cargo(p)
    _boats(p)
    _mole(p)
    p.daylight(-46.0, -62.0)
    return SourceScene(SCENE_ID, "outdoor", "Harbour street", p.level(), ("c4s-harbour",))


def _ground(p: Plot) -> None:
    columns = [x + 200.0 for x in (*WEST, *EAST)]
    for x in columns:
        p.add("QuayWall", x, -30)
    p.grid("CobbleTile", columns, (-260, -660))
    for x in (*range(-8000, 1600, 800), *range(2400, 8000, 800)):
        p.add("CrossingTile" if x in (-4800, 800, 4800) else "RoadTile", x + 400, -1260)
    p.grid("PavingTile", columns, (-1860,))
    p.grid("CobbleTile", columns, (-2260, -2660, -3060, -3460))


def _water(p: Plot) -> None:
    p.grid("WaterTile", range(-7600, 8000, 800), range(400, 3600, 800), WATER_CM)
    for y in (-400, -1200, -2000, -2800):
        p.add("WaterTile", 2000, y, WATER_CM, scale=(0.85, 1.0, 1.0))
    p.add("WaterTile", 2000, -3400, WATER_CM, scale=(0.85, 0.5, 1.0))


def _canal(p: Plot) -> None:
    for y in range(-200, -3600, -400):
        p.add("QuayWall", 1630, y, yaw=-90)
        p.add("QuayWall", 2370, y, yaw=90)
    for x in (1830, 2170):
        p.add("QuayWall", x, -3630, scale=(0.85, 1.0, 1.0))
    p.add("StoneBridge", 2000, -1260, scale=(0.85, 1.0, 1.0))
    p.add("StoneBridge", 2000, -460, scale=(0.85, 0.5, 1.0))
    for y in (-1860, -2260, -2660, -3060, -3460):
        p.add("IronRailing", 1620, y, yaw=90)
        p.add("IronRailing", 2380, y, yaw=90)
    for y in (-1905, -2705, -3300):
        p.add("RowingBoat", 2000 + p.random.uniform(-150, 150), y, WATER_CM - 25, yaw=90 + p.random.uniform(-6, 6))


def _row(p: Plot, names: tuple[str, ...], start: float) -> None:
    x = start
    for name in names:
        if not name:
            p.add("SlimTree", x + LANE_CM / 2, -2500, scale=0.8)
            p.add("LitterBin", x + 80, -2140)
            x += LANE_CM
            continue
        width = HOUSE_WIDTHS[f"Townhouse{name}"]
        p.add(f"Townhouse{name}", x + width / 2, -2560)
        x += width


def _houses(p: Plot) -> None:
    p.add("Warehouse", -7000, -2660)
    _row(p, WEST_ROW, -5900)
    _row(p, EAST_ROW, 2560)
    for x in range(-5600, 7800, 900):
        if not 1200 < x < 2700:
            p.add("SlimTree", x, -3480, scale=p.random.uniform(0.8, 1.2), yaw=p.random.uniform(-180, 180))


def _promenade(p: Plot) -> None:
    for x in range(-7800, 8000, 600):
        if not 1500 < x < 2500:
            p.add("Bollard", x, -100)
    for number, x in enumerate(range(-4700, 7800, 800)):
        if 1300 < x < 2700:
            continue
        if number % 2:
            p.add("StreetLamp", x, -790)
        else:
            p.add("StreetTree", x, -770, scale=p.random.uniform(0.9, 1.15), yaw=p.random.uniform(-180, 180))
            p.add("Bench", x + 250, -770)
            if number % 4:
                p.add("LitterBin", x + 400, -770)
    p.add("Kiosk", 3300, -560)
    for x in (3800, 4250, 4700):
        p.add("CafeTable", x, -400)
        p.add("Parasol", x + 110, -400)
        for dx, dy, yaw in ((-75, 0, -90), (0, -78, 0), (0, 78, 180)):
            p.add("CafeChair", x + dx, -400 + dy, yaw=yaw)
    p.add("Anchor", 5600, -450, yaw=25)
    for x in (6100, 6220, 6340):
        p.add("StoneBollard", x, -830)


def _street(p: Plot) -> None:
    for x in range(-7700, 8000, 1600):
        if not 1300 < x < 2700:
            p.add("StreetLamp", x, -1700)
            p.add("Planter", x + 800, -1745)
    for x in (-5400, -3300, -700, 3400, 5200, 7300):
        p.add("Bench", x, -1990)
    for x, yaw in ((-4900, 4), (-4840, 0), (-2200, -3), (900, 0), (2900, 5), (4400, -2), (4460, 3), (6500, 0)):
        p.add("Bicycle", x, -1965, yaw=90 + yaw)
    for x in (-5000, 700, 4600):
        p.add("RoadSign", x, -1690)
    for x in (-6200, -2600, 6900):
        p.add("ParkingSign", x, -1690)
    for x in (-4300, 1200, 5600):
        p.add("LitterBin", x, -1700)
    for name, x, lane in (
        ("CarRed", -6100, 0),
        ("CarTeal", -3900, 0),
        ("DeliveryVan", -2500, 0),
        ("CarTeal", 200, 1),
        ("CarRed", 3000, 0),
        ("CarTeal", 4100, 1),
        ("DeliveryVan", 6600, 0),
        ("CarRed", 7300, 1),
    ):
        p.add(name, x, -980 if lane else -1530, yaw=180 if lane else 0)
    p.add("DeliveryVan", -6700, -1535, yaw=0)
    for x in (-3350, 1420, 6250):
        for dx in (-120, 0, 120):
            p.add("StoneBollard", x + dx, -1690)


def _market(p: Plot) -> None:
    for number, x in enumerate(range(-3600, -1000, 420)):
        p.add("MarketStallBlue" if number % 2 else "MarketStallRed", x, -420, yaw=180)
        _stack(p, "WoodenCrate", x + 60, -290, 1 + number % 2, p.random.uniform(-8, 8), 0.7)
        p.add("FishBox", x - 70, -290, yaw=p.random.uniform(-10, 10))


def _stack(p: Plot, asset: str, x: float, y: float, count: int, yaw: float = 0.0, scale: float = 1.0) -> None:
    height = {
        "WoodenCrate": 80.0,
        "FishBox": 26.0,
        "CargoContainer": 260.0,
        "CargoContainerRust": 260.0,
        "LobsterPot": 40.0,
    }[asset] * scale
    for level in range(count):
        p.add(asset, x, y, level * (height + STACK_GAP_CM), yaw=yaw + level * 2.5, scale=scale)


def _cargo(p: Plot) -> None:
    p.add("HarbourCrane", -6800, -380)
    _stack(p, "CargoContainer", -7600, -330, 2)
    p.add("CargoContainerRust", -7600, -660)
    _stack(p, "CargoContainerRust", -5900, -640, 1)
    p.add("CargoContainer", -5900, -340)
    for x, y, count in (
        (-5400, -300, 2),
        (-5300, -300, 1),
        (-5390, -400, 1),
        (-5200, -640, 3),
        (-5090, -640, 1),
        (-7150, -720, 2),
        (-7040, -720, 1),
        (-6500, -1960, 2),
        (-6390, -1960, 1),
    ):
        _stack(p, "WoodenCrate", x, y, count, p.random.uniform(-6, 6))
    for x, y in (
        (-4900, -300),
        (-4820, -310),
        (-4860, -380),
        (-6450, -720),
        (-6370, -700),
        (-7900, -1950),
        (-7820, -1960),
        (-5700, -1980),
        (-5620, -1975),
        (5900, -300),
        (5980, -320),
    ):
        p.add("Barrel", x, y, yaw=p.random.uniform(-180, 180))
    p.add("HandTruck", -5500, -520, yaw=35)
    p.add("HandTruck", -6600, -1830, yaw=-60)
    for x, count in ((-300, 3), (-200, 2), (-95, 4), (500, 2), (2900, 3), (5100, 2), (6700, 3)):
        _stack(p, "FishBox", x, -250, count, p.random.uniform(-5, 5))
    for x in (100, 900, 4900, 6400, 7300):
        p.add("NetPile", x, -310, yaw=p.random.uniform(-180, 180))
    for x, count in ((250, 1), (690, 2), (5300, 2), (7000, 1)):
        _stack(p, "LobsterPot", x, -250, count)
    for x in (-7400, -4500, -1000, 1100, 2700, 5750, 7700):
        p.add("RopeCoil", x, -160, yaw=p.random.uniform(-180, 180))


def _boats(p: Plot) -> None:
    for row in range(5):
        p.add("JettyPlanks", -800, 200 + 400 * row, yaw=90)
    p.add("QuayStairs", 1200, 0.5)
    draft = {"FishingBoat": 60.0, "SailingBoat": 40.0, "RowingBoat": 25.0}
    boats = (
        ("FishingBoat", -4200, 210, 0),
        ("FishingBoat", -2700, 215, 180),
        ("FishingBoat", 5000, 210, 0),
        ("FishingBoat", -5400, 2200, -25),
        ("SailingBoat", -560, 900, 90),
        ("SailingBoat", -1060, 1300, -90),
        ("SailingBoat", 3400, 190, 0),
        ("SailingBoat", 2600, 1900, 40),
        ("RowingBoat", -560, 300, 90),
        ("RowingBoat", -1040, 500, 90),
        ("RowingBoat", 400, 130, 0),
        ("RowingBoat", 2700, 140, 180),
    )
    for name, x, y, yaw in boats:
        p.add(name, x, y, WATER_CM - draft[name], yaw=yaw)
    for x, y in ((-6900, 1400), (-3600, 2600), (-1700, 2900), (600, 1500), (1900, 2700), (4400, 1600), (5900, 2300)):
        p.add("Buoy", x, y, WATER_CM - 35, yaw=p.random.uniform(-180, 180))


def _mole(p: Plot) -> None:
    for y in (200, 600, 1000, 1400):
        p.add("QuayWall", 7030, y, yaw=90)
        p.add("QuayWall", 7770, y, yaw=-90)
        for x in (7230, 7570):
            p.add("CobbleTile", x, y, scale=(0.85, 1.0, 1.0))
    for x in (7200, 7600):
        p.add("QuayWall", x, 1630)
    p.add("Lighthouse", 7400, 1250)
    for y in (150, 550):
        p.add("Bollard", 7120, y)
        p.add("Bollard", 7680, y)
