"""Small airfield."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import yard_goods
from cases.open190.parts.gardens import border
from cases.open190.parts.land import forest
from cases.open190.parts.streets import car_park, frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("airfield", "text", "Small airfield", styles.TRANSIT.but(wall=("WhitePaint", "Concrete")), 200)
def airfield(p: StagedPlace) -> None:
    """A runway with light aircraft, hangars, a control tower, fuel tanks and a cafe."""
    p.plate(200, "DryGrass")
    for i in range(11):
        p.put(p.one("road", length=1800.0, wide=1400.0), -9000 + 1800 * i, 3500, 0.5)
    p.ground((-7000, -2600, 7000, 1200), "Concrete", tile=1000, z=0.5)
    p.trail([(0, 1200), (0, 2800)], 700, "Asphalt")
    hangars = p.kit("hall", 5, use="Hangar", width=2000.0, depth=1300.0, high=650.0)
    frontage(p, (-6600, -2900), (2600, -2900), hangars, (150, 260))
    p.put(
        p.one("tower", round=False, spire=False, height=1500.0, radius=300.0, noun="ControlTower", stone="Concrete"),
        4300,
        -3200,
    )
    p.put(p.one("block", use="Terminal", storeys=2.0, width=1600.0), 6000, -3700)
    planes = p.kit("plane", 5)
    p.grid((-6000, -1500, 5500, 300), planes, 7, 2, yaw=90, jitter=60)
    p.put(planes, -3000, 3500)
    p.row(
        (-6500, 900),
        (6500, 900),
        [
            *p.kit("truck", 2, kind="TankerTruck"),
            *p.kit("car", 2, kind="Pickup"),
            *p.kit("works", 1, kind="TrafficCone"),
            *p.kit("tractor", 1, kind="Tractor"),
        ],
        15,
        jitter=50,
    )
    p.row((8000, -2400), (8000, 600), p.kit("tank", 3, kind="HorizontalTank"), 4)
    car_park(p, (3600, -7200, 8600, -5600), p.kit("car", 8))
    for x in range(4200, 7800, 420):
        table = p.put(p.kit("parasol-table", 3), x, -2300)
        p.around(table, p.kit("chair", 2, kind="Shell"), 3, gap=-48)
    for y in (2700, 4300):
        p.row((-9500, y), (9500, y), p.kit("bollard", 1), 40)
    p.row((-7000, 2100), (7000, 2100), [*p.kit("sign", 3), *p.kit("flag", 3)], 9)
    border(p, (-9900, -9500), (9900, -9500), p.kit("fence", 1, kind="Iron"), opening=900)
    forest(p, (-9800, 5600, 9800, 9700), p.kit("tree", 4), 90)
    p.scatter((-7000, -9000, 2800, -4800), [*p.kit("tree", 4), *p.kit("bush", 3)], 50, clear=100)
    p.scatter((-6800, -2500, 6800, 1000), yard_goods(p), 70, clear=80)
    p.palette(70, "plane", "car", "truck", "sign", "works", "crate", "barrel")
