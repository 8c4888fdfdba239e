"""Cars, trucks and bicycles."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.vehicles.categories import VEHICLES
from catalog.kits.vehicles.wheels import tyres
from catalog.shapes.patches import prism


@family("car")
def car(m: KitMaker) -> None:
    """A car: saloon, hatchback, estate, van, pickup or taxi."""
    kind = m.opt("kind", m.pick("Saloon", "Hatchback", "Estate", "Van", "Pickup", "Taxi", "Police"))
    paint = {"Taxi": "YellowPaint", "Police": "WhitePaint"}.get(kind) or m.mat("paint")
    length = {"Hatchback": 390, "Van": 500, "Pickup": 500}.get(kind, 450)
    m.say(
        f"{kind}Car"
        if kind not in ("Van", "Pickup", "Taxi")
        else {"Van": "DeliveryVan", "Pickup": "PickupTruck", "Taxi": "TaxiCab"}[kind],
        VEHICLES,
        f"{word(paint).capitalize()} {kind.lower()}, {length / 100:.1f} m long, nose to +X.",
        camel(paint),
        tags="car vehicle auto",
    )
    x, w = length / 2, 170.0
    high = 190 if kind == "Van" else 66
    body = (
        [(-x, 30), (-x, high + 16), (-x + 10, high + 24), (x * 0.5, high + 24), (x * 0.96, 70), (x, 60), (x, 30)]
        if kind == "Van"
        else [(-x, 28), (-x, 72), (-x + 8, 84), (x * 0.94, 78), (x, 64), (x, 28)]
    )
    m.b.add(paint, prism(body, w))
    if kind == "Van":
        m.b.add(
            "WindowGlass", prism([(x * 0.52, 204), (x * 0.9, 100), (x * 0.93, 104), (x * 0.56, 208)], w - 24), body=None
        )
        for side in (-1, 1):
            m.b.box("WindowGlass", (80, 4, 60), (x * 0.42, side * w / 2, 120), body=None)
            m.b.box(m.another("paint"), (220, 4, 34), (-x * 0.35, side * w / 2, 110), body=None)
    else:
        a, c = {
            "Saloon": (-0.55, 0.22),
            "Taxi": (-0.55, 0.22),
            "Police": (-0.55, 0.22),
            "Hatchback": (-0.92, 0.22),
            "Estate": (-0.95, 0.2),
            "Pickup": (-0.08, 0.32),
        }[kind]
        cabin = [(x * a - 14, 78), (x * a + 26, 140), (x * c, 140), (x * c + 66, 78)]
        m.b.add("WindowGlass", prism(cabin, w - 16))
        m.b.add(
            paint, prism([(x * a + 18, 136), (x * a + 30, 144), (x * c, 144), (x * c + 12, 136)], w - 12), body=None
        )
        for px in (x * a + 40 if kind != "Pickup" else x * a + 20, (x * a + x * c) / 2, x * c - 4):
            m.b.box(paint, (9, w - 13, 60), (px, 0, 80), body=None)
        if kind == "Pickup":
            for side in (-1, 1):
                m.b.box(paint, (x * 0.86, 8, 30), (-x * 0.56, side * (w / 2 - 6), 80), body=None)
        if kind == "Taxi":
            m.b.box("WhiteGlow", (20, 50, 14), (-20, 0, 143), body=None)
        if kind == "Police":
            m.b.box("BluePaint", (300, w + 1, 18), (0, 0, 50), body=None)
            for s, g in ((-1, "RedGlow"), (1, "NeonBlue")):
                m.b.box(g, (16, 40, 10), (-20, s * 24, 143), body=None)
    for side in (-1, 1):
        m.b.box("WhiteGlow", (4, 28, 14), (x, side * 58, 50), body=None)
        m.b.box("RedGlow", (4, 28, 12), (-x, side * 58, 54), body=None)
    m.b.box("BlackPaint", (length + 6, w - 20, 14), (0, 0, 24), body=None)
    tyres(m, (-x * 0.6, x * 0.62), w / 2 - 8, 32)


@family("truck")
def truck(m: KitMaker) -> None:
    """A lorry, a bus, a fire engine or a tanker."""
    kind = m.opt("kind", m.pick("Lorry", "CityBus", "TankerTruck", "DumpTruck", "RescueTruck", "Ambulance"))
    paint = {"RescueTruck": "RedPaint", "Ambulance": "WhitePaint"}.get(kind) or m.mat("paint")
    length = {"CityBus": 1150, "Ambulance": 600}.get(kind, 850)
    m.say(
        kind,
        VEHICLES,
        f"{word(paint).capitalize()} {word(kind)}, {length / 100:.1f} m long, nose to +X.",
        camel(paint),
        tags="truck vehicle large",
    )
    x, w = length / 2, 240.0
    if kind == "CityBus":
        m.b.box(paint, (length, w, 270), (0, 0, 35), bevel=12)
        m.b.box("WindowGlass", (length - 60, w + 3, 95), (0, 0, 150), body=None)
        m.b.box("WindowGlass", (10, w - 30, 130), (x - 3, 0, 130), body=None)
        m.b.box("TimetableScreen", (6, 140, 26), (x, 0, 268), body=None)
        for px in range(int(-x) + 60, int(x) - 40, 160):
            m.b.box(paint, (12, w + 6, 95), (px, 0, 150), body=None)
    else:
        m.b.box(paint, (190, w - 10, 210), (x - 95, 0, 50), bevel=10)
        m.b.box("WindowGlass", (8, w - 40, 80), (x - 2, 0, 160), body=None)
        for s in (-1, 1):
            m.b.box("WindowGlass", (90, 4, 66), (x - 80, s * (w / 2 - 5), 165), body=None)
        m.b.box("Iron", (length, 90, 30), (0, 0, 50), body=None)
        rest, mid = length - 210, -x + (length - 210) / 2
        if kind == "Lorry":
            m.b.box(m.another("cloth"), (rest, w, 240), (mid, 0, 85), bevel=4)
        elif kind == "TankerTruck":
            m.b.cylinder("SilverPaint", 110, rest, (mid - rest / 2, 0, 195), (-90, 0, 0), segments=20)
            m.b.box(m.another("paint"), (rest * 0.6, w - 14, 30), (mid, 0, 190), body=None)
        elif kind == "DumpTruck":
            m.b.box("Iron", (rest, w, 20), (mid, 0, 85))
            for s in (-1, 1):
                m.b.box(paint, (rest, 10, 110), (mid, s * (w / 2 - 5), 100))
            m.b.ellipsoid("Gravel", (rest - 30, w - 40, 160), (mid, 0, 90), body="hull")
        else:
            m.b.box(paint, (rest, w, 210), (mid, 0, 70), bevel=4)
            m.b.box("WhitePaint" if kind == "RescueTruck" else "RedPaint", (rest, w + 2, 30), (mid, 0, 130), body=None)
            if kind == "RescueTruck":
                for s in (-30, 30):
                    m.b.box("SilverPaint", (rest + 60, 8, 10), (mid, s, 290), body=None)
                for i in range(12):
                    m.b.box("SilverPaint", (6, 60, 8), (mid - rest / 2 + 20 + i * rest / 12, 0, 291), body=None)
        for s in (-1, 1):
            m.b.box(
                "NeonBlue" if kind in ("RescueTruck", "Ambulance") else "BlackPaint",
                (30, 40, 16),
                (x - 90, s * 60, 260),
                body=None,
            )
    m.b.box("BlackPaint", (length - 40, w - 40, 30), (0, 0, 30), body=None)
    tyres(m, (-x * 0.7, -x * 0.45, x * 0.66) if length > 700 else (-x * 0.6, x * 0.6), w / 2 - 12, 48, 28)


@family("bicycle")
def bicycle(m: KitMaker) -> None:
    """A bicycle that stands."""
    paint = m.mat("paint")
    m.say(
        m.pick("Bicycle", "CargoBicycle", "CityBicycle"),
        VEHICLES,
        f"{word(paint).capitalize()} bicycle, 1.8 m long.",
        camel(paint),
        tags="bicycle bike vehicle",
    )
    for x in (-52, 52):
        points = [(x + 32 * math.cos(a), 0.0, 34 + 32 * math.sin(a)) for a in [k * math.pi / 8 for k in range(17)]]
        m.b.tube("Rubber", points, 2, segments=6)
        for k in range(4):
            m.b.box("SilverPaint", (62, 0.8, 0.8), (x, 0, 34), (45 * k, 0, 0), body=None)
    for a, c in (
        ((-52, 34), (-14, 80)),
        ((-14, 80), (0, 34)),
        ((-14, 74), (40, 78)),
        ((0, 34), (40, 74)),
        ((-52, 34), (0, 34)),
        ((52, 34), (38, 96)),
    ):
        m.b.tube(paint, [(a[0], 0, a[1]), (c[0], 0, c[1])], 1.8, segments=6)
    m.b.box("BlackPaint", (26, 14, 5), (-16, 0, 84), body=None)
    m.b.tube("SilverPaint", [(40, -26, 100), (38, 0, 98), (40, 26, 100)], 1.4)
    m.b.body_box((160, 16, 90))
