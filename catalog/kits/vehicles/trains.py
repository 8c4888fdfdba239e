"""Railway vehicles."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.vehicles.categories import RAIL


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
