"""Vehicles on wheels and rails, boats, and aircraft. Noses point to +X unless told otherwise."""

from __future__ import annotations

import math

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull, prism

VEHICLES, BOATS, RAIL = "vehicles", "boats", "railway"


def tyres(m: KitMaker, wheels: tuple[float, ...], half: float, radius: float, thick: float = 20.0) -> None:
    """Pairs of wheels at places along X."""
    for x in wheels:
        m.b.body_box((radius, 2 * half, radius), (x, 0, 0))
        for side in (-1, 1):
            m.b.cylinder(
                "Rubber", radius, thick, (x, side * half - thick / 2, radius), (0, 0, 90), segments=16, body=None
            )
            m.b.cylinder(
                "SilverPaint",
                radius * 0.5,
                thick + 2,
                (x, side * half - thick / 2 - 1, radius),
                (0, 0, 90),
                segments=10,
                body=None,
            )


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


@family("tractor")
def tractor(m: KitMaker) -> None:
    """A tractor, a digger, a forklift or a roller."""
    kind = m.opt("kind", m.pick("Tractor", "Excavator", "Forklift", "RoadRoller", "Bulldozer"))
    paint = m.opt("paint", m.pick("YellowPaint", "OrangePaint", "RedPaint", "GreenPaint"))
    m.say(
        kind,
        VEHICLES,
        f"{word(paint).capitalize()} {word(kind)}, nose to +X.",
        camel(paint),
        tags="vehicle machine work",
    )
    b = m.b
    if kind == "Tractor":
        b.box(paint, (180, 80, 60), (50, 0, 70), bevel=6)
        b.box("BlackPaint", (4, 60, 44), (141, 0, 78), body=None)
        b.box(paint, (110, 110, 40), (-70, 0, 80))
        for s in (-1, 1):
            for x in (-115, -25):
                b.box("Iron", (6, 6, 100), (x, s * 48, 120), body=None)
            b.cylinder("Rubber", 70, 36, (-80, s * 84 - 18, 70), (0, 0, 90), segments=18)
            b.cylinder("YellowPaint", 36, 38, (-80, s * 84 - 19, 70), (0, 0, 90), segments=12, body=None)
            b.cylinder("Rubber", 40, 26, (105, s * 66 - 13, 40), (0, 0, 90), segments=16)
        b.box(paint, (120, 116, 8), (-70, 0, 218))
        b.box("WindowGlass", (86, 92, 92), (-70, 0, 124), body=None)
        b.cylinder("Iron", 5, 90, (80, 26, 130), segments=8, body=None)
    elif kind == "Forklift":
        b.box(paint, (170, 100, 70), (-20, 0, 24), bevel=5)
        b.box("BlackPaint", (50, 60, 10), (-20, 0, 94), body=None)
        for s in (-1, 1):
            for x in (-90, 50):
                b.box("Iron", (6, 6, 120), (x, s * 44, 90), body=None)
            b.box("Iron", (12, 8, 230), (84, s * 34, 10))
            b.box("Iron", (110, 12, 5), (140, s * 26, 6))
        b.box(paint, (150, 100, 6), (-20, 0, 210))
        b.box("Iron", (8, 80, 60), (92, 0, 8), body=None)
        tyres(m, (-70, 40), 50, 26, 22)
    elif kind == "RoadRoller":
        b.cylinder("Iron", 65, 170, (110, -85, 65), (0, 0, 90), segments=24)
        b.cylinder("Iron", 65, 170, (-120, -85, 65), (0, 0, 90), segments=24)
        b.box(paint, (210, 120, 70), (0, 0, 90), bevel=6)
        b.box(paint, (130, 130, 8), (-10, 0, 262))
        for x in (-66, 46):
            for s in (-1, 1):
                b.box("Iron", (6, 6, 105), (x, s * 56, 158), body=None)
    else:
        for s in (-1, 1):
            b.box("Rubber", (260, 50, 70), (0, s * 85, 0), bevel=24)
        b.box(paint, (220, 150, 80), (-10, 0, 72), bevel=8)
        b.box("WindowGlass", (90, 100, 100), (-10, 20, 150), body="box")
        b.box(paint, (100, 110, 8), (-10, 20, 250), body=None)
        if kind == "Excavator":
            b.box(paint, (240, 30, 34), (170, -40, 190), (38, 0, 0))
            b.box(paint, (200, 24, 28), (310, -40, 200), (-52, 0, 0))
            b.box("Iron", (80, 70, 60), (350, -40, 60), (20, 0, 0))
        else:
            b.box("Iron", (24, 240, 100), (190, 0, 8), (8, 0, 0))
            for s in (-1, 1):
                b.box(paint, (90, 14, 16), (140, s * 70, 40), body=None)


@family("cart")
def wagon(m: KitMaker) -> None:
    """A four-wheeled wagon, a coach or a covered wagon."""
    from catalog.kits.outdoors import wheel

    kind, wood = m.opt("kind", m.pick("HayWagon", "CoveredWagon", "Coach", "BarrelWagon")), m.mat("wood")
    m.say(
        kind,
        VEHICLES,
        f"{word(wood).capitalize()} {word(kind)} on four wheels, pole to +X.",
        camel(wood),
        tags="wagon cart vehicle wood",
    )
    m.b.box(wood, (300, 140, 14), (0, 0, 70))
    for x in (-100, 100):
        for y in (-86, 86):
            wheel(m, m.mat("trim"), 55, (x, y, 58), 90)
    m.b.body_box((300, 176, 70))
    m.b.box(wood, (170, 10, 10), (230, 0, 66), body=None)
    if kind == "Coach":
        m.b.box(m.mat("paint"), (190, 140, 150), (-10, 0, 92), bevel=10)
        for s in (-1, 1):
            m.b.box("WindowGlass", (60, 4, 50), (-10, s * 70, 170), body=None)
        m.b.box("Gold", (200, 150, 6), (-10, 0, 240), body=None)
    else:
        for s in (-1, 1):
            m.b.box(wood, (300, 6, 44), (0, s * 68, 84))
        if kind == "CoveredWagon":
            points = [
                (x, 74 * math.cos(a), 120 + 110 * math.sin(a))
                for x in (-145.0, 145.0)
                for a in [k * math.pi / 8 for k in range(9)]
            ]
            m.b.add("WhiteSail", hull(points))
        elif kind == "HayWagon":
            m.b.ellipsoid("Hay", (290, 140, 150), (0, 0, 66))
        else:
            for i in range(4):
                m.b.lathe("Oak", [(0, 0), (26, 0), (32, 40), (26, 80), (0, 80)], (-105 + 70 * i, 0, 84), segments=12)


@family("train")
def train(m: KitMaker) -> None:
    """A railway vehicle on its wheels (rails at z = 0 + 16 cm)."""
    kind = m.opt(
        "kind",
        m.pick(
            "PassengerCoach",
            "DieselLocomotive",
            "SteamLocomotive",
            "BoxWagon",
            "FlatWagon",
            "TankWagon",
            "HopperWagon",
            "MetroCar",
            "Tram",
        ),
    )
    paint = m.mat("paint")
    length = {"SteamLocomotive": 900, "BoxWagon": 900, "FlatWagon": 900, "TankWagon": 900, "HopperWagon": 900}.get(
        kind, 1400
    )
    m.say(
        kind,
        RAIL,
        f"{word(paint).capitalize()} {word(kind)}, {length / 100:.0f} m long along X.",
        camel(paint),
        tags="train railway vehicle",
    )
    b, x = m.b, length / 2
    for px in (-x * 0.68, -x * 0.5, x * 0.5, x * 0.68):
        for s in (-1, 1):
            b.cylinder("Iron", 42, 12, (px, s * 74 - 6, 42), (0, 0, 90), segments=16, body=None)
    b.box("Iron", (length - 30, 180, 34), (0, 0, 66))
    b.body_box((length - 100, 150, 66))
    if kind in ("PassengerCoach", "MetroCar", "Tram", "DieselLocomotive"):
        b.box(paint, (length, 280, 260), (0, 0, 95), bevel=14)
        if kind == "DieselLocomotive":
            for s in (-1, 1):
                b.box("HazardStripes", (length - 100, 3, 24), (0, s * 141, 110), body=None)
                for i in range(6):
                    b.box("BlackPaint", (90, 3, 80), (-x + 250 + i * 170, s * 141, 200), body=None)
        else:
            b.box("WindowGlass", (length - 140, 284, 90), (0, 0, 210), body=None)
            n = int(length // 200)
            for i in range(n + 1):
                b.box(paint, (26, 287, 92), (-x + 70 + i * (length - 140) / n, 0, 209), body=None)
            b.box(m.another("paint"), (length + 1, 283, 22), (0, 0, 170), body=None)
            if kind != "PassengerCoach":
                for share in (-0.6, 0.6):
                    b.box("SilverPaint", (130, 286, 200), (x * share, 0, 105), body=None)
                    b.box("WindowGlass", (90, 288, 90), (x * share, 0, 205), body=None)
        for s in (-1, 1):
            b.box("WindowGlass", (4, 200, 80), (s * x, 0, 230), body=None)
            for y in (-90, 90):
                b.box("WhiteGlow", (5, 26, 18), (s * x, y, 130), body=None)
        b.box("GreyPaint", (length - 60, 220, 14), (0, 0, 354), body=None)
        if kind == "Tram":
            b.tube("Iron", [(-60, 0, 366), (0, 0, 420), (60, 0, 366)], 3)
    elif kind == "SteamLocomotive":
        b.cylinder(paint, 85, 560, (-100, 0, 190), (-90, 0, 0), segments=20)
        b.cylinder("BlackPaint", 87, 30, (440, 0, 190), (-90, 0, 0), segments=20, body=None)
        b.cylinder("BlackPaint", 26, 100, (370, 0, 265), top=34, segments=14)
        for px in (120, 240):
            b.ellipsoid("Brass", (60, 60, 60), (px, 0, 255), segments=12, body=None)
        b.box(paint, (230, 250, 240), (-260, 0, 100))
        b.box("BlackPaint", (280, 280, 14), (-260, 0, 340))
        b.box("WindowGlass", (80, 254, 70), (-250, 0, 240), body=None)
        for s in (-1, 1):
            b.tube("RedPaint", [(-300, s * 86, 42), (310, s * 86, 42)], 6)
        b.cylinder("WarmGlow", 18, 12, (450, 0, 285), (-90, 0, 0), segments=12, body=None)
    elif kind == "TankWagon":
        b.cylinder(paint, 120, length - 60, (-x + 30, 0, 225), (-90, 0, 0), segments=22)
        b.cylinder("Iron", 34, 30, (0, 0, 340), segments=14, body=None)
        b.body_box((length - 100, 120, 20), (0, 0, 100))
    elif kind == "FlatWagon":
        b.box("Planks", (length, 260, 10), (0, 0, 100))
        m.top(110, length - 60, 230)
        for px in range(int(-x) + 60, int(x), 220):
            for s in (-1, 1):
                b.box("Iron", (8, 8, 50), (px, s * 132, 100), body=None)
    elif kind == "HopperWagon":
        for s in (-1, 1):
            b.box(paint, (length - 20, 14, 140), (0, s * 125, 100))
            b.box(paint, (14, 260, 140), (s * (x - 20), 0, 100))
        b.box("Cinder", (length - 60, 240, 110), (0, 0, 100), body="box")
        for i in range(4):
            b.cylinder("Cinder", 110, 60, (-x + 150 + i * (length - 300) / 3, 0, 205), top=8, segments=12, body=None)
    else:
        b.box(paint, (length - 20, 270, 240), (0, 0, 100))
        b.box("GreyPaint", (length, 280, 14), (0, 0, 340), body=None)
        for s in (-1, 1):
            b.box(m.another("paint"), (210, 6, 200), (0, s * 136, 112), body=None)
            for i in range(6):
                b.box("Iron", (8, 5, 230), (-x + 40 + i * (length - 80) / 5, s * 136, 104), body=None)


@family("track", flat=True)
def track(m: KitMaker) -> None:
    """A length of railway track along X: ballast, sleepers, rails."""
    length = m.opt("length", 1000.0)
    m.say(
        "TrackGround",
        RAIL,
        f"Railway track on gravel, {length / 100:.0f} m long along X.",
        "Gravel",
        tags="track rail ground railway",
    )
    m.b.box("Gravel", (length, 320, 4), (0, 0, -4))
    for i in range(int(length // 65)):
        m.b.box("DarkPlanks", (24, 250, 3), (-length / 2 + (i + 0.5) * length / int(length // 65), 0, 0), body=None)
    for y in (-72, 72):
        m.b.box("Rust", (length, 6, 4), (0, y, 0.5), body=None)


@family("platform")
def platform(m: KitMaker) -> None:
    """A length of station platform along X: things stand on it at 90 cm."""
    length, wide, of = m.opt("length", 1000.0), m.opt("wide", 500.0), m.opt("of", "Paving")
    m.say(
        "StationPlatform",
        RAIL,
        f"Station platform of {word(of)} with a yellow edge, {length / 100:.0f} m long, 0.9 m high.",
        camel(of),
        tags="platform station railway",
    )
    m.b.box("Concrete", (length, wide, 84))
    m.b.box(of, (length, wide, 6), (0, 0, 84), body="box")
    for s in (-1, 1):
        m.b.box("YellowPaint", (length, 16, 0.5), (0, s * (wide / 2 - 55), 89.6), body=None)
    m.top(90, length - 40, wide - 130)


@family("rail-thing")
def rail_thing(m: KitMaker) -> None:
    """A buffer stop, a signal, a barrier or a water crane of a railway."""
    kind = m.opt("kind", m.pick("BufferStop", "RailSignal", "LevelCrossingBarrier", "SwitchLever"))
    m.say(
        kind, RAIL, f"{word(kind).capitalize()} of a railway.", m.pick("Red", "White", "Yellow"), tags="railway signal"
    )
    b = m.b
    if kind == "BufferStop":
        for s in (-72, 72):
            b.box("Iron", (14, 14, 110), (0, s, 0))
            b.tube("Iron", [(0, s, 100), (-110, s, 4)], 7)
        b.box("HazardStripes", (20, 230, 40), (6, 0, 80))
        b.body_box((110, 160, 40), (-50, 0, 0))
    elif kind == "RailSignal":
        b.cylinder("Iron", 9, 420, segments=10)
        b.box("BlackPaint", (36, 16, 90), (0, 10, 330))
        for i, glow in enumerate(("RedGlow", "GreenGlow")):
            b.cylinder(glow, 11, 3, (0, 18, 350 + 42 * i), (0, 0, 90), segments=14, body=None)
        b.tube("Iron", [(-20, -20, 0), (-20, -20, 320)], 2)
    elif kind == "SwitchLever":
        b.box("Iron", (60, 30, 12))
        b.tube("RedPaint", [(0, 0, 10), (26, 0, 90)], 3)
        b.cylinder("Iron", 18, 14, (-14, 0, 12), segments=12)
    else:
        b.box("Iron", (40, 50, 110))
        for i in range(6):
            b.box("RedPaint" if i % 2 else "WhitePaint", (66, 8, 12), (40 + 66 * i, 0, 100), body=None)
        b.body_box((390, 10, 12), (215, 0, 100))


def boat_hull(m: KitMaker, paint: str, length: float, beam: float, depth: float) -> None:
    """A boat's hull, bow to +X, keel at z = 0, hollow under a deck line."""
    x, y = length / 2, beam / 2
    keel = [(-x * 0.9, 0.0, 0.0), (x * 0.55, 0.0, 0.0)]
    chine = [(a * x, s * c * y, depth * 0.3) for a, c in ((-0.95, 0.7), (0.4, 0.75)) for s in (-1, 1)]
    rim = (
        [(-x, s * y * 0.75, depth) for s in (-1, 1)]
        + [(0.0, s * y, depth) for s in (-1, 1)]
        + [(x * 0.6, s * y * 0.72, depth) for s in (-1, 1)]
        + [(x, 0.0, depth + 8)]
    )
    m.b.add(paint, hull([*keel, *chine, *rim]))
    m.b.add(
        m.mat("trim"), hull([(px * 1.01, py * 1.03, depth + dz) for px, py, _ in rim for dz in (-6.0, 8.0)]), body=None
    )
    m.b.add("Planks", hull([(px * 0.93, py * 0.88, depth + dz) for px, py, _ in rim for dz in (2.0, 9.0)]), body=None)


@family("boat")
def boat(m: KitMaker) -> None:
    """A boat: rowing, fishing, sailing, barge, motor boat, gondola, ferry, longship."""
    kinds = ("RowingBoat", "FishingBoat", "SailingBoat", "Barge", "MotorBoat", "Ferry", "Longship", "TugBoat")
    kind = m.opt("kind", m.pick(*(k for k in kinds if not m.style.old or k not in ("MotorBoat", "Ferry", "TugBoat"))))
    paint = m.mat("paint")
    length, beam, depth = {
        "RowingBoat": (360, 140, 60),
        "FishingBoat": (800, 290, 150),
        "SailingBoat": (700, 220, 110),
        "Barge": (1500, 420, 130),
        "MotorBoat": (550, 210, 100),
        "Ferry": (1800, 560, 240),
        "Longship": (1400, 320, 120),
        "TugBoat": (1000, 380, 190),
    }[kind]
    m.say(
        kind,
        BOATS,
        f"{word(paint).capitalize()} {word(kind)}, {length / 100:.1f} m long, bow to +X, keel at the pivot.",
        camel(paint),
        tags="boat ship vessel",
    )
    boat_hull(m, paint, length, beam, depth)
    b = m.b
    if kind == "RowingBoat":
        for x in (-80, 30):
            b.box("Oak", (30, 118, 5), (x, 0, 68), body=None)
        for y in (-30, 30):
            b.tube("Oak", [(-120, y, 76), (100, y * 1.5, 76)], 2.5)
    elif kind in ("SailingBoat", "Longship"):
        high = length * 1.05 if kind == "SailingBoat" else length * 0.6
        b.cylinder("Oak", 8, high, (40, 0, depth), segments=10, body=None)
        b.body_box((16, 16, high), (40, 0, depth))
        if kind == "SailingBoat":
            b.add(
                "WhiteSail",
                hull(
                    [(30.0, y, z) for y in (-1.5, 1.5) for z in (depth + 90.0, depth + high * 0.95)]
                    + [(-length * 0.42, y, depth + 95.0) for y in (-1.5, 1.5)]
                ),
                body=None,
            )
            b.add(
                "WhiteSail",
                hull(
                    [(50.0, y, z) for y in (-1.2, 1.2) for z in (depth + 60.0, depth + high * 0.8)]
                    + [(length * 0.46, y, depth + 40.0) for y in (-1.2, 1.2)]
                ),
                body=None,
            )
            b.box(m.mat("trim"), (220, 120, 40), (-60, 0, depth), bevel=8)
        else:
            b.box("Oak", (8, 420, 8), (44, 0, depth + high * 0.86), body=None)
            b.box(m.mat("awning"), (4, 400, high * 0.5), (48, 0, depth + high * 0.36), body=None)
            for i in range(8):
                for s in (-1, 1):
                    b.cylinder(
                        m.another("paint"),
                        30,
                        5,
                        (-380 + 100 * i, s * 150 - 2, depth - 4),
                        (0, 0, 90),
                        segments=12,
                        body=None,
                    )
            b.tube(
                "Oak",
                [(length / 2 - 10, 0, depth), (length / 2 + 40, 0, depth + 130), (length / 2 + 10, 0, depth + 170)],
                10,
            )
    elif kind == "Barge":
        b.box("Cinder", (length * 0.5, beam * 0.7, 60), (60, 0, depth), bevel=20)
        b.box(m.another("paint"), (260, beam * 0.6, 150), (-length * 0.36, 0, depth))
        b.box("WindowGlass", (264, beam * 0.6 + 4, 50), (-length * 0.36, 0, depth + 70), body=None)
        b.box("WhitePaint", (300, beam * 0.68, 10), (-length * 0.36, 0, depth + 150), body=None)
    else:
        k = length / 800
        tiers = 3 if kind == "Ferry" else 1
        for t in range(tiers):
            size = (
                length * (0.6 - 0.12 * t) if kind == "Ferry" else 200 * k,
                beam * (0.8 - 0.1 * t) if kind == "Ferry" else 170 * k,
                150 if kind == "Ferry" else 170 * k,
            )
            at = -length * 0.06 if kind == "Ferry" else -length * 0.18
            z = depth + t * size[2]
            b.box("WhitePaint", size, (at, 0, z))
            b.box("WindowGlass", (size[0] + 4, size[1] - 30, size[2] * 0.34), (at, 0, z + size[2] * 0.48), body=None)
            b.box("WindowGlass", (size[0] - 40, size[1] + 4, size[2] * 0.34), (at, 0, z + size[2] * 0.48), body=None)
            b.box(paint, (size[0] + 20, size[1] + 20, 10), (at, 0, z + size[2]), body=None)
        if kind in ("Ferry", "TugBoat"):
            b.cylinder(
                m.another("paint"),
                50,
                200,
                (-length * 0.2, 0, depth + (460 if kind == "Ferry" else 200)),
                top=44,
                segments=14,
            )
        if kind == "FishingBoat":
            b.cylinder("Oak", 8, 420, (90, 0, depth), segments=10, body=None)
            b.tube("Oak", [(90, 0, depth + 110), (-60, 0, depth + 250)], 5)
            b.box("Net", (150, 140, 30), (220, 0, depth + 8), body=None)
            b.ellipsoid("OrangePaint", (40, 40, 44), (-330, 60, depth + 8), body=None)


@family("jetty")
def jetty(m: KitMaker) -> None:
    """A jetty of planks along X on piles, or a quay."""
    length, wide, high = m.opt("length", 800.0), m.opt("wide", 300.0), m.opt("high", 60.0)
    wood = m.opt("wood", m.pick("Planks", "GreyPlanks", "DarkPlanks"))
    m.say(
        "PlankJetty",
        BOATS,
        f"Jetty of {word(wood)} on piles, {length / 100:.0f} m long, deck at {high / 100:.1f} m.",
        camel(wood),
        tags="jetty pier dock",
    )
    m.b.box(wood, (length, wide, 12), (0, 0, high - 12))
    for i in range(int(length // 200) + 1):
        for s in (-1, 1):
            m.b.cylinder(
                "Bark",
                13,
                high,
                (-length / 2 + 15 + i * (length - 30) / int(length // 200), s * (wide / 2 - 14), 0),
                segments=9,
                body=None,
            )
    for s in (-1, 1):
        m.b.body_box((length, 26, high - 12), (0, s * (wide / 2 - 14), 0))
    m.top(high, length - 60, wide - 80)


@family("quay")
def quay(m: KitMaker) -> None:
    """A quay block: things stand on it."""
    length, wide, high, stone = (
        m.opt("length", 1000.0),
        m.opt("wide", 1000.0),
        m.opt("high", 100.0),
        m.opt("stone", m.mat("stone")),
    )
    m.say(
        "QuayBlock",
        BOATS,
        f"Quay of {word(stone)}, {length / 100:.0f} x {wide / 100:.0f} m, {high / 100:.1f} m high.",
        camel(stone),
        tags="quay harbour stone wall",
    )
    m.b.box(stone, (length, wide, high - 12))
    m.b.box(m.opt("paving", "Cobble"), (length, wide, 12), (0, 0, high - 12))
    m.top(high, length, wide)


@family("boat-gear")
def boat_gear(m: KitMaker) -> None:
    """Gear of the waterside."""
    kind = m.opt(
        "kind",
        m.pick("NetHeap", "RopeCoil", "LobsterPot", "Anchor", "Buoy", "LifeRing", "FishRack", "OarRack", "MooringPost"),
    )
    m.say(
        kind,
        BOATS,
        f"{word(kind).capitalize()} of a harbour.",
        m.pick("", "Old"),
        m.pick("Grey", "Large"),
        tags="harbour fishing gear",
    )
    b = m.b
    if kind == "NetHeap":
        b.lathe("Net", [(0, 0), (85, 0), (70, 26), (38, 48), (0, 58)], squash=0.75)
        for x, y in ((-50, 20), (20, -44), (48, 26)):
            b.ellipsoid("OrangePaint", (18, 18, 18), (x, y, 24), segments=8, body=None)
    elif kind == "RopeCoil":
        for i in range(4):
            b.lathe(
                "Rope", [(22, 6 * i), (34 - i, 6 * i), (34 - i, 6 * i + 6), (22, 6 * i + 6)], body=None, smooth=False
            )
        b.body_box((60, 60, 24))
    elif kind == "LobsterPot":
        b.box("DarkPlanks", (80, 50, 5))
        arc = [(25.0, 5.0), (22, 22), (12, 34), (0, 38), (-12, 34), (-22, 22), (-25, 5)]
        for x in (-38, -13, 13, 38):
            b.tube("Oak", [(x, y, z) for y, z in arc], 1.6, segments=6)
        b.add("Net", hull([(x, y * 0.94, z * 0.96) for x in (-38.0, 38.0) for y, z in arc]))
    elif kind == "Anchor":
        b.tube("Iron", [(-70, 0, 7), (70, 0, 7)], 6)
        b.tube("Iron", [(44, -48, 7), (66, -22, 7), (70, 0, 7), (66, 22, 7), (44, 48, 7)], 6)
        b.tube("Iron", [(-56, -34, 7), (-56, 34, 7)], 4)
        b.body_box((150, 100, 13))
    elif kind == "Buoy":
        b.lathe("OrangePaint", [(0, 0), (40, 10), (55, 40), (50, 60), (18, 75), (12, 150), (0, 155)])
    elif kind == "LifeRing":
        b.box("WhitePaint", (8, 8, 130))
        b.lathe(
            "RedPaint",
            [(22, 0), (34, 0), (34, 10), (22, 10), (22, 0)],
            (0, 4, 122),
            (0, 0, 90),
            body=None,
            smooth=False,
        )
        b.body_box((60, 16, 60), (0, 6, 92))
    elif kind == "FishRack":
        for x in (-120, 120):
            b.tube("GreyWood", [(x, -50, 0), (x, 0, 170), (x, 50, 0)], 4)
        b.tube("GreyWood", [(-130, 0, 168), (130, 0, 168)], 4)
        for i in range(11):
            b.ellipsoid("SilverPaint", (5, 12, 34), (-100 + 20 * i, 0, 128), segments=7, body=None)
        b.body_box((260, 100, 165))
    elif kind == "OarRack":
        b.box("Oak", (120, 10, 90))
        for i in range(5):
            b.tube("Pine", [(-48 + 24 * i, 16, 0), (-48 + 24 * i, 8, 220)], 2.5)
        b.body_box((110, 24, 160), (0, 10, 0))
    else:
        b.cylinder("Bark", 16, 110, segments=10)
        b.cylinder("Rope", 18, 16, (0, 0, 76), segments=10, body=None)


@family("plane")
def plane(m: KitMaker) -> None:
    """A small aeroplane."""
    paint = m.mat("paint")
    m.say(
        "LightAircraft",
        VEHICLES,
        f"{word(paint).capitalize()} light aircraft with one propeller, wings 10 m wide, nose to +X.",
        camel(paint),
        tags="aircraft plane vehicle",
    )
    m.b.lathe("WhitePaint", [(0, 0), (50, 40), (62, 160), (56, 380), (20, 700), (0, 720)], (340, 0, 120), (90, 0, 0))
    m.b.box(paint, (130, 1000, 14), (90, 0, 170))
    m.b.box(paint, (80, 330, 10), (-320, 0, 130))
    m.b.box(paint, (90, 8, 130), (-330, 0, 130), (0, 0, 0))
    m.b.box("WindowGlass", (110, 90, 50), (140, 0, 150), body=None)
    m.b.box("BlackPaint", (6, 190, 16), (345, 0, 112), body=None)
    for x, y in ((220, 0), (60, 90), (60, -90)):
        m.b.cylinder("Rubber", 20, 12, (x, y - 6, 20), (0, 0, 90), segments=14)
        m.b.tube("Iron", [(x, y, 20), (x, y * 0.5, 90)], 3)
