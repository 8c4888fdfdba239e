"""Fairground."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import enclosure, playground
from cases.open190.parts.land import forest, ring
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("fairground", "outdoor", "Fairground", styles.STYLISED)
def fairground(p: StagedPlace) -> None:
    """Tents, stalls, rides, flags and lamps around a way of coloured paving."""
    p.ground((-4000, -3400, 4000, 3400), "Grass")
    p.trail([(0, -3400), (0, 3200)], 500, "RedPaving")
    p.trail([(-3800, 0), (3800, 0)], 500, "RedPaving", z=1.8)
    tents, kiosks, stalls = (
        p.kit("tent", 10),
        p.kit("kiosk", 6),
        p.kinds_of("stall", "ware", "Fruit", "Bread", "Flower", "Cloth", "Pottery", "Cheese"),
    )
    for side in (-1, 1):
        p.row((side * 620, -3000), (side * 620, -600), [*kiosks, *stalls], 8, yaw=0 if side > 0 else 180)
        p.row((side * 620, 600), (side * 620, 3000), [*kiosks, *stalls], 8, yaw=0 if side > 0 else 180)
        p.row((-3400, side * 620), (-900, side * 620), [*stalls, *kiosks], 7, yaw=180 if side > 0 else 0)
        p.row((900, side * 620), (3400, side * 620), [*stalls, *kiosks], 7, yaw=180 if side > 0 else 0)
    p.put(p.one("tent", round=True, size=620.0, use="CircusTent"), 2400, 2300, scale=2.2)
    p.put(p.one("windmill"), -3200, 2600, yaw=-20)
    for x, y in ((-2200, 2000), (-2000, -2000), (2200, -2000)):
        ring(p, x, y, 520, tents, 6)
        p.put(p.kit("play", 1, kind="Roundabout"), x, y)
        ring(p, x, y, 260, p.kit("play", 4, kind="SpringHorse"), 8, face=0)
    playground(p, -3000, -600 + 2000)
    p.put(p.one("fountain"), 0, 0)
    ring(p, 0, 0, 480, p.kit("bench", 3), 8, face=-90)
    lamps = p.kit("streetlamp", 4, kind="Globe")
    for side in (-1, 1):
        p.row((side * 330, -3200), (side * 330, 3200), [*lamps, *p.kit("flag", 5)], 18)
        p.row((-3700, side * 330), (3700, side * 330), [*lamps, *p.kit("flag", 5)], 18)
    p.scatter(
        (-3700, -3200, 3700, 3200),
        [
            *p.kit("service", 3, kind="Arcade"),
            *p.kit("bin", 3),
            *p.kit("bench", 3),
            *p.kit("parasol-table", 4),
            *p.kit("crate", 3),
            *p.kit("planter", 5),
            *p.kit("animal", 2, kind="Horse"),
            *p.kit("cart", 2),
        ],
        170,
        clear=60,
        avoid=((-330, -3400, 330, 3400), (-3900, -330, 3900, 330)),
    )
    forest(
        p,
        (-3950, -3350, 3950, 3350),
        p.kit("tree", 5),
        60,
        avoid=((-2900, -3400, 3300, 2900), (-4000, -500, 4000, 500)),
    )
    enclosure(p, (-3950, -3350, 3950, 3350), p.kit("fence", 2, kind="Picket"), gate=p.one("gate", width=500.0))
    for x in range(-3, 4, 2):
        p.light(0, x * 900, 420, intensity=6000, radius=1300)
    p.sun(-24, 150, intensity=3.6, colour=(255, 222, 184))
    p.view("way", (90, -3100, 175), (-60, 400, 200), 72)
    p.view("rides", (-1100, -1300, 260), (-2400, -2300, 120), 75)
