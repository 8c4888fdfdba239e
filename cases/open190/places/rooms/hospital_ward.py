"""Hospital ward."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "hospital-ward",
    "indoor",
    "Hospital ward",
    styles.OFFICE.but(
        wall=("WhitePlaster",),
        cloth=("TealCloth", "BlueCloth", "Linen", "GreenCloth"),
        paint=("WhitePaint", "TealPaint", "SkyPaint", "GreyPaint"),
    ),
)
def hospital_ward(p: StagedPlace) -> None:
    """Bays of beds with screens, a nurses' station, a corridor with trolleys, a bathroom."""
    p.room(
        (-1600, -800, 1600, 800),
        "LinoTiles",
        wall="WhitePlaster",
        base="GreenTiles",
        S=("Window", "Window", "Plain"),
        N=("Window", "Plain", "Window"),
        W=("Plain", "Door"),
    )
    beds, screens = p.kit("cot", 3, kind="HospitalBed"), p.kit("care", 3, kind="BedScreen")
    stands, monitors, trolleys = (
        p.kit("care", 1, kind="DripStand"),
        p.kit("care", 2, kind="PatientMonitor"),
        p.kit("care", 3, kind="MedicineTrolley"),
    )
    nightstand, small = (
        p.kit("cupboard", 2, kind="Nightstand"),
        p.kinds("decor", "FlowerVase", "OpenBook", "Clock", "Radio") + p.kinds("dish", "Cup", "Bottle", "FruitBowl"),
    )
    for i in range(10):
        x = -1420 + 300 * i
        if i == 9:
            continue
        for side in (-1, 1):
            with p.at(x, side * 690, 180 if side > 0 else 0):
                p.put(beds, 0, 0)
                p.on(p.put(nightstand, 84, -78), small, 3)
                p.put(stands, -72, -60)
                p.put(monitors, -84, -10, yaw=-90) if i % 2 else p.put(p.kit("stool", 2), -84, 20)
                p.put(screens, 144, 20, yaw=90)
                p.put(p.kit("chair", 3, kind="Metal"), 84, 30, yaw=90)
    station = p.one("counter", kind="ReceptionDesk", length=200.0)
    things = p.kinds("desk-thing", "Monitor", "Telephone", "Binders", "PaperTray", "Mug", "Keyboard")
    for x in (-220, 0, 220):
        p.on(p.put(station, x, 110), things, 4)
        p.on(p.put(p.kit("desk", 1, kind="Office"), x, -90, yaw=180), things, 5)
        p.put(p.kit("chair", 2, kind="Shell"), x, 10, yaw=180)
    p.row((-1300, 0), (-500, 0), [*trolleys, *p.kit("care", 2, kind="Wheelchair")], 8, yaw=90)
    p.row(
        (500, 0),
        (1200, 0),
        [*trolleys, *p.kit("care", 2, kind="Wheelchair"), *p.kit("cot", 1, kind="HospitalBed")],
        5,
        yaw=0,
    )
    p.along((1340, 799), (1340, 300), p.kit("cupboard", 2, kind="Cabinet"), 5, fill=True)
    p.along(
        (1599, -700),
        (1599, 700),
        [
            *p.kit("cupboard", 2, kind="LockerRow"),
            *p.kit("shelf", 1, kind="Metal"),
            *p.kit("bath-thing", 2, kind="Washbasin"),
        ],
        22,
        fill=True,
    )
    p.scatter(
        (-1550, -420, 1550, 420),
        [*p.kit("bin", 2), *p.kit("house-plant", 3), *p.kit("sack", 1, kind="LaundryBasket"), *stands, *trolleys],
        26,
        clear=40,
    )
    for x in (-1200, -400, 400, 1200):
        p.light(x, 0, 270, intensity=3800, radius=1300, colour=(244, 250, 255))
    p.sun(-42, -60, intensity=2.6, sky=0.8)
    p.view("ward", (-1560, -60, 165), (600, 60, 80), 75)
    p.view("beds", (300, 330, 165), (-700, -700, 70), 75)
