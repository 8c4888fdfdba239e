"""School with four classrooms."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.halls import desks
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "school",
    "indoor",
    "School with four classrooms",
    styles.DOMESTIC.but(
        wall=("CreamPlaster", "GreenPlaster", "BluePlaster"),
        wood=("Birch", "Pine", "Oak"),
        paint=("RedPaint", "BluePaint", "GreenPaint", "YellowPaint", "OrangePaint"),
    ),
)
def school(p: StagedPlace) -> None:
    """Classrooms on both sides of a corridor with lockers, an art room and a music room."""
    p.room(
        (-1600, -1000, 1600, 1000),
        "LinoTiles",
        wall="CreamPlaster",
        S=("Window",),
        N=("Window",),
        W=("Plain", "Plain", "Door", "Plain", "Plain"),
    )
    for side in (-1, 1):
        for i in range(8):
            kind = "Door" if i % 4 == 3 else "Plain"
            p.put(
                p.one("room-wall", kind=kind, length=398.0, wall="CreamPlaster"),
                -1400 + 400 * i,
                side * 200,
                yaw=0 if side > 0 else 180,
            )
        p.put(p.one("room-wall", kind="Plain", length=784.0, wall="CreamPlaster"), 0, side * 602, yaw=90)
    books = (
        p.kit("desk-thing", 4, kind="Notebook")
        + p.kit("desk-thing", 3, kind="PencilCup")
        + p.kit("decor", 3, kind="BookStack")
        + p.kit("decor", 2, kind="OpenBook")
    )
    desk_, chairs = p.kit("desk", 3, kind="School"), p.kit("chair", 3, kind="Shell") + p.kit("chair", 2, kind="Metal")
    for x, y, up in ((-800, 600, 1), (800, 600, 1), (-800, -600, -1), (800, -600, -1)):
        with p.at(x, y):
            p.put(p.kit("board", 2, kind="Blackboard"), -690, 40 * up, yaw=-90)
            teacher = p.put(p.one("desk", kind="Writing"), -540, -120 * up, yaw=-90)
            p.on(teacher, [*books, *p.kinds("desk-thing", "Laptop", "Mug"), *p.kinds("decor", "PottedPlant")], 4)
            p.put(chairs, -610, -120 * up, yaw=-90)
            if (x, y) == (800, -600):
                p.grid((-250, -250, 600, 250), p.kit("music", 3, kind="Easel"), 5, 3, jitter=18, yaw=90)
                p.grid((-250, -150, 600, 330), p.kit("stool", 3), 5, 3, jitter=10)
            elif (x, y) == (800, 600):
                p.put(p.one("music", kind="GrandPiano"), 560, 180, yaw=90)
                p.put(p.one("music", kind="DrumKit"), 560, -220, yaw=90)
                p.grid((-250, -220, 300, 220), p.kit("music", 2, kind="MusicStand"), 5, 4, yaw=90)
                p.grid((-180, -220, 370, 220), chairs, 5, 4, yaw=90)
                p.row((-250, 330), (500, 330), p.kinds("music", "Harp", "Loudspeaker", "Piano"), 4, yaw=180)
            else:
                desks(p, (-330, -270, 560, 270), 6, 5, desk_, chairs, books, each=2, yaw=-90)
            p.along(
                (690, -380),
                (690, 380),
                [*p.kit("bookcase", 3), *p.kit("cupboard", 2, kind="Cabinet"), *p.kit("house-plant", 2)],
                8,
                fill=True,
                count=7,
            )
            p.put(p.kit("music", 2, kind="Globe"), -680, 250 * up)
            p.light(-300, 0, 270, intensity=3600, radius=1100, colour=(255, 248, 236))
            p.light(350, 0, 270, intensity=3600, radius=1100, colour=(255, 248, 236))
    lockers = p.kit("cupboard", 4, kind="LockerRow")
    p.along((-1150, -191), (-250, -191), lockers, 2, fill=True)
    p.along((450, -191), (1350, -191), lockers, 2, fill=True)
    p.along((1350, 191), (450, 191), lockers, 2, fill=True)
    p.along((-250, 191), (-1150, 191), lockers, 2, fill=True)
    p.row((-1000, 0), (1400, 0), [*p.kit("bench", 2, back=False), *p.kit("bin", 2), *p.kit("house-plant", 2)], 9)
    p.put(p.one("service", kind="VendingMachine"), 1540, 0, yaw=90)
    p.scatter((-1550, -180, 1550, 180), [*p.kit("crate", 2, kind="CardboardBox"), *p.kit("sack", 2, kind="Basket")], 8)
    p.sun(-40, 110, intensity=2.8, sky=0.75)
    p.view("classroom", (-130, 960, 175), (-1300, 400, 90), 78)
    p.view("corridor", (-1520, 60, 165), (800, -40, 110), 70)
