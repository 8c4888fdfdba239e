"""The open-plan office: 18 x 12 m, five clusters of four desks, a glazed meeting room, a lounge, a reception.

It has no ceiling, so that pictures from above show the rooms.
"""

from __future__ import annotations

from c4s.records.level import Level
from cases.starter.level_builder import LevelBuilder, wall_run
from catalog.starter import office

SCENE_ID = "starter-office"
FLOOR = 2.0
"""Top of the floor tiles (cm)."""
DESK_TOP = 74.0
CLUSTERS = ((-80, -420), (320, -420), (720, -420), (-80, -50), (320, -50))


def office_level() -> Level:
    """The office, about 340 actors."""
    level = LevelBuilder(SCENE_ID, [office.pack()], FLOOR)
    with level.folder("Building"):
        _building(level)
    with level.folder("Desks"):
        for number, (x, y) in enumerate(CLUSTERS):
            with level.at(x, y):
                _cluster(level, number)
    with level.folder("MeetingRoom"):
        _meeting_room(level)
    with level.folder("Lounge"):
        _lounge(level)
    with level.folder("Reception"):
        _reception(level)
    with level.folder("Storage"):
        _storage(level)
    with level.folder("Lighting"):
        level.daylight(yaw=35)
        for x, y in ((-80, -235), (320, -235), (720, -235), (600, 400), (-650, 400), (-600, -350)):
            level.point_light(x, y, 240)
    return level.level()


def _building(level: LevelBuilder) -> None:
    level.floor = 0.0
    for column in range(9):
        for row in range(6):
            tile = "FloorPlanks200" if column >= 6 and row >= 4 else "FloorCarpet200"
            level.place(tile, -800 + 200 * column, -500 + 200 * row)
    wall_run(
        level,
        ["OfficeWall100"] * 2 + ["OfficeWallDoorway200"] + ["OfficeWall100"] * 2 + ["OfficeWallWindow300"] * 4,
        (-900, -606),
        0,
    )
    wall_run(
        level,
        [
            "OfficeWall300",
            "OfficeWall300",
            "OfficeWallWindow300",
            "OfficeWallWindow300",
            "BrickWall300",
            "BrickWall300",
        ],
        (900, 606),
        180,
    )
    wall_run(level, ["OfficeWall300", "OfficeWallWindow300", "OfficeWall300", "OfficeWall300"], (906, -600), 90)
    wall_run(level, ["BrickWall300", "OfficeWall300", "OfficeWallWindow300", "OfficeWall300"], (-906, 600), -90)
    for x in (-906, 906):
        for y in (-606, 606):
            level.place("OfficeWall100", x, y, scale=(0.12, 1.0, 1.0))
    level.floor = FLOOR
    level.place("OfficeDoor", -600, -606)
    for x in (120, 520):
        level.place("OfficeColumn", x, 145)


def _cluster(level: LevelBuilder, number: int) -> None:
    for x in (-82, 82):
        level.place("DeskPartition", x, 0)
    for seat, (x, y, yaw) in enumerate(((-82, 44, 0), (82, 44, 0), (-82, -44, 180), (82, -44, 180))):
        with level.at(x, y, yaw):
            _workplace(level, 4 * number + seat)


def _workplace(level: LevelBuilder, number: int) -> None:
    """A desk whose user sits on the +Y side; every place holds a little different things."""
    level.place("OfficeDesk", 0, 0)
    level.place("TaskChair", 4 - 3 * (number % 4), 72 + 5 * (number % 3), yaw=180 + (-14, 8, 25, -6, 0)[number % 5])
    if number % 3:
        level.place("Monitor", 0, -16, DESK_TOP)
    else:
        level.place("WideMonitor", 0, -14, DESK_TOP)
    if number % 5 == 4:
        level.place("Laptop", -2, 16, DESK_TOP, yaw=180)
    else:
        level.place("Keyboard", 0, 16, DESK_TOP, yaw=180)
    level.place("Mouse", -38, 16, DESK_TOP, yaw=180)
    if number % 2:
        level.place("DrawerPedestal", 48, 0)
    else:
        level.place("ComputerTower", 60, -4)
    extras = (
        ("DeskPhone", 52, -10),
        ("PaperTray", 58, -12),
        ("DeskPlant", 64, -24),
        ("DeskLamp", -60, -20),
        ("BookStack", -66, 14),
        ("CoffeeMug", 46, 18),
        ("PenCup", -46, -28),
    )
    for step in (0, 3):
        name, x, y = extras[(2 * number + step) % 7]
        level.place(name, x, y, DESK_TOP)


def _meeting_room(level: LevelBuilder) -> None:
    for x in (400, 700):
        level.place("GlassPartition200", x, 200)
    level.place("OfficeWall100", 850, 200)
    for y in (303, 503):
        level.place("GlassPartition200", 297, y, yaw=90, scale=(0.97, 1.0, 1.0))
    with level.at(600, 400):
        level.place("MeetingTable", 0, 0)
        for x in (-75, 0, 75):
            level.place("ConferenceChair", x, 92, yaw=180)
            level.place("ConferenceChair", x, -92)
        level.place("ConferenceChair", -158, 0, yaw=-90)
        level.place("Laptop", -60, 22, 74.6)
        level.place("CoffeeMug", 10, -30, 74.6)
        level.place("CoffeeMug", 70, 28, 74.6, yaw=60)
        level.place("BookStack", 30, 6, 74.6)
        level.place("DeskPlant", -12, 10, 74.6)
    level.place("WallWhiteboard", 900, 400, 150, yaw=90)
    level.place("TallPlant", 850, 545)
    level.place("WallClock", 600, 600, 215, yaw=180)
    level.place("LowCabinet", 390, 574, yaw=180)


def _lounge(level: LevelBuilder) -> None:
    with level.at(-700, 420):
        level.place("LoungeRug", 0, 0)
        level.place("OfficeSofa", 0, 130, yaw=180)
        level.place("OfficeSofa", -145, 0, yaw=-90)
        level.place("SideTable", 5, 10, 1)
        level.place("BookStack", 18, 14, 42)
        level.place("CoffeeMug", -16, 2, 42)
        level.place("FloorLamp", -140, 128)
        level.place("TallPlant", 115, 130)
    level.place("FramedPoster", -700, 600, 165, yaw=180)
    level.place("LowCabinet", -330, 572, yaw=180)
    level.place("CoffeeMachine", -360, 572, 75, yaw=180)
    for x in (-310, -298, -286):
        level.place("CoffeeMug", x, 568, 75, yaw=x)
    level.place("WaterCooler", -235, 576, yaw=180)
    level.place("RecyclingBin", -180, 580, yaw=180)
    level.place("RoundTable", -380, 380)
    for x, y, yaw in ((-380, 452, 180), (-308, 380, 90), (-380, 308, 0)):
        level.place("VisitorChair", x, y, yaw=yaw)
    level.place("DeskPlant", -376, 386, 74)
    with level.at(-60, 470):
        level.place("RoundTable", 0, 0)
        for x, y, yaw in ((-70, 0, -90), (70, 0, 90)):
            level.place("BarStool", x, y, yaw=yaw)


def _reception(level: LevelBuilder) -> None:
    with level.at(-620, -250):
        level.place("ReceptionCounter", 0, 0, yaw=180)
        level.place("TaskChair", 6, 72)
        with level.at(0, 150, 180):
            level.place("OfficeDesk", 0, 0)
            level.place("Monitor", 0, -16, DESK_TOP)
            level.place("Keyboard", 0, 16, DESK_TOP, yaw=180)
            level.place("DeskPhone", 52, -10, DESK_TOP)
        level.place("DeskPlant", 85, -32, 112)
    for y in (-520, -455, -390):
        level.place("VisitorChair", -872, y, yaw=-90)
    level.place("TallPlant", -850, -300)
    level.place("CoatStand", -420, -560)
    level.place("WallClock", -900, -150, 205, yaw=-90)
    level.place("FramedPoster", -900, -455, 165, yaw=-90)


def _storage(level: LevelBuilder) -> None:
    """Printer corner and shelves in the east, lockers in the west."""
    for y in (-80, -32, 16):
        level.place("FilingCabinet", 866, y, yaw=90)
    level.place("OfficePrinter", 864, 90, yaw=90)
    level.place("RecyclingBin", 880, 150, yaw=90)
    level.place("StandingDesk", 640, -60)
    level.place("WideMonitor", 640, -76, 108)
    level.place("Keyboard", 640, -46, 108, yaw=180)
    for x in (640, 735):
        level.place("ShelfWithBooks", x, 176, yaw=180)
    level.place("SnakePlant", 812, 165)
    for y in (-20, 72):
        level.place("StaffLockers", -876, y, yaw=-90)
    level.place("PinBoard", -900, -70, 160, yaw=-90)
    for x, y in ((-265, -390), (505, -390), (505, -20)):
        level.place("WasteBin", x, y)
