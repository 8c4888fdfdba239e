"""Boats and gear of the waterside."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.vehicles.categories import BOATS
from catalog.shapes.patches import hull


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
