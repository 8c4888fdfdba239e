"""The flat: 12 x 8 m with a living and dining room with kitchen, a hall, a bathroom, a bedroom and a child's room.

It has no ceiling, so that pictures from above show the rooms.
"""

from __future__ import annotations

from c4s.records.level import Level
from cases.starter.level_builder import LevelBuilder, wall_run
from catalog.starter import home

SCENE_ID = "starter-flat"
FLOOR = 2.0
"""Top of the floor tiles (cm)."""


def flat_level() -> Level:
    """The flat, about 145 actors."""
    level = LevelBuilder(SCENE_ID, [home.pack()], FLOOR)
    for name, rooms in (
        ("Building", _building),
        ("Kitchen", _kitchen),
        ("Living", _living),
        ("Bedroom", _bedroom),
        ("ChildRoom", _child_room),
        ("Bathroom", _bathroom),
        ("Hall", _hall),
    ):
        with level.folder(name):
            rooms(level)
    with level.folder("Lighting"):
        level.daylight(yaw=-40)
        for x, y in ((-400, 80), (-200, -270), (400, 200), (400, -200), (100, 300), (100, -150)):
            level.point_light(x, y, 235, intensity=2200)
    return level.level()


def _building(level: LevelBuilder) -> None:
    level.floor = 0.0
    for x in range(-500, 600, 200):
        for y in range(-300, 400, 200):
            if y == 300 and x in (-500, -300, 100):
                level.place("FloorBath200" if x == 100 else "FloorKitchen200", x, y)
            else:
                level.place("FloorParquet200", x, y)
    wall_run(
        level,
        ["HomeWallWindow300", "HomeWallWindow300", "HomeWallDoorway200", "HomeWall100", "HomeWallWindow300"],
        (-600, -406),
        0,
    )
    wall_run(level, ["HomeWall300", "HomeWall300", "HomeWallWindow300", "HomeWall300"], (600, 406), 180)
    wall_run(level, ["HomeWall300", "HomeWall100", "HomeWall100", "HomeWallWindow300"], (606, -400), 90)
    wall_run(level, ["HomeWall100", "HomeWall100", "SageWall300", "HomeWallWindow300"], (-606, 400), -90)
    for x in (-606, 606):
        for y in (-406, 406):
            level.place("HomeWall100", x, y, scale=(0.12, 1.0, 1.0))
    level.floor = FLOOR
    wall_run(level, ["HomeWall300", "HomeWallDoorway200", "HomeWall300"], (0, -400), 90)
    wall_run(
        level,
        ["HomeWall100", "HomeWall100", "HomeWallDoorway200", "HomeWallDoorway200", "HomeWall100", "HomeWall100"],
        (200, -400),
        90,
    )
    with level.at(100, 200):
        level.place("HomeWallDoorway200", 0, 0, scale=(0.94, 1.0, 1.0))
    with level.at(206, 0):
        level.place("HomeWall300", 150, 0)
        level.place("HomeWall100", 347, 0, scale=(0.94, 1.0, 1.0))
    level.place("HomeDoor", 100, -406)
    level.place("HomeDoor", 100, 200, scale=(0.92, 1.0, 1.0))
    level.place("HomeDoor", 254, -146)
    level.place("HomeDoor", 254, 146)


def _kitchen(level: LevelBuilder) -> None:
    for asset, x, y in (
        ("Fridge", -569, 367),
        ("KitchenCounter", -508, 369),
        ("KitchenSink", -438, 369),
        ("KitchenStove", -368, 369),
        ("KitchenCounter", -308, 369),
    ):
        level.place(asset, x, y, yaw=180)
    for x in (-498, -308):
        level.place("WallCabinet", x, 400, 180, yaw=180)
    level.place("Kettle", -520, 375, 90, yaw=150)
    level.place("PlateStack", -305, 378, 90)
    level.place("CookingPot", -383, 384, 90.3, yaw=20)
    with level.at(-400, 90):
        level.place("DiningTable", 0, 0)
        for x in (-40, 40):
            level.place("DiningChair", x, 58, yaw=180)
            level.place("DiningChair", x, -58)
        level.place("FruitBowl", -10, 4, 75)
        level.place("FlowerVase", 48, -8, 75)
    level.place("KitchenStool", -225, 350)
    level.place("HillsPicture", -6, 250, 150, yaw=90)
    level.place("WindowPlant", -20, 382)


def _living(level: LevelBuilder) -> None:
    level.place("PersianRug", -195, -270, yaw=90)
    level.place("HomeSofa", -330, -270, yaw=-90)
    level.place("CoffeeTable", -195, -270, 1.1, yaw=90)
    level.place("OpenBook", -190, -292, 43.2, yaw=70)
    level.place("TallVase", -200, -240, 43.2)
    level.place("Armchair", -195, -105, yaw=180)
    level.place("ArcFloorLamp", -350, -215, yaw=-90)
    level.place("MediaBench", -29, -270, yaw=90)
    level.place("Television", -29, -270, 45, yaw=90)
    level.place("PalmPlant", -520, -330)
    for y in (-60, 22):
        level.place("FilledBookcase", -585, y, yaw=-90)
    level.place("DeskGlobe", -585, 22, 190)
    for x in (-565, -335, -265, -80):
        level.place("Curtain", x, -387)
    level.place("HillsPicture", -600, 130, 158, yaw=-90)
    level.place("DuskPicture", -6, -190, 175, yaw=90)


def _bedroom(level: LevelBuilder) -> None:
    level.place("DoubleBed", 420, 293, yaw=180)
    for x in (306, 534):
        level.place("BedsideSet", x, 378, yaw=180)
    level.place("Wardrobe", 238, 305, yaw=-90)
    level.place("BlueRug", 420, 118)
    level.place("ChestOfDrawers", 470, 31)
    level.place("WallMirror", 470, 6, 145)
    level.place("FlowerVase", 445, 28, 84.5)
    level.place("TableLamp", 500, 28, 84.5)
    level.place("HillsPicture", 420, 400, 165, yaw=180)
    for y in (135, 365):
        level.place("Curtain", 587, y, yaw=90)


def _child_room(level: LevelBuilder) -> None:
    level.place("ChildBed", 551, -110, yaw=180)
    level.place("WritingDesk", 440, -368)
    level.place("DiningChair", 436, -318, yaw=172)
    level.place("DeskGlobe", 398, -372, 75)
    level.place("TableLamp", 486, -374, 75)
    level.place("OpenBook", 440, -356, 75, yaw=4)
    level.place("FilledBookcase", 220, -300, yaw=-90)
    level.place("BlueRug", 380, -210)
    level.place("ToyTrain", 385, -230, 1.1, yaw=24)
    level.place("ToyBlocks", 330, -180, 1.1, yaw=-12)
    level.place("TeddyBear", 425, -175, 1.1, yaw=150)
    level.place("ChildChair", 350, -70, yaw=165)
    level.place("CushionSquare", 410, -70, yaw=20)
    level.place("DuskPicture", 380, -6, 150, yaw=180)
    for x in (335, 552):
        level.place("Curtain", x, -387)


def _bathroom(level: LevelBuilder) -> None:
    level.place("Bathtub", 100, 361, yaw=180)
    level.place("Toilet", 42, 276, yaw=-90)
    level.place("Washbasin", 168, 268, yaw=90)
    level.place("WallMirror", 194, 268, 155, yaw=90)
    level.place("TowelRail", 6, 276, 165, yaw=-90)
    level.place("LaundryBasket", 31, 230)
    level.place("BathMat", 118, 296, yaw=90)


def _hall(level: LevelBuilder) -> None:
    level.place("ChestOfDrawers", 30, -260, yaw=-90)
    level.place("FlowerVase", 30, -238, 84.5)
    level.place("WallMirror", 6, -260, 150, yaw=-90)
    level.place("BathMat", 100, -355)
    level.place("PalmPlant", 52, 130)
    level.place("DuskPicture", 194, -270, 150, yaw=90)
