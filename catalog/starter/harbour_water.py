"""Boats and the gear of the water in the harbour pack."""

from __future__ import annotations

from catalog.shapes import Builder, Kit
from catalog.shapes.patches import hull

KIT = Kit()


def _hull(b: Builder, paint: str, length: float, beam: float, depth: float, inner: str = "Wood") -> None:
    """A boat's hull, bow to +X, keel at z = 0, with a sheer strake, a deck line and a hollow."""
    x, y = length / 2, beam / 2
    keel = [(-x * 0.9, 0.0, 0.0), (x * 0.55, 0.0, 0.0)]
    chine = [(a * x, s * c * y, depth * 0.3) for a, c in ((-0.95, 0.7), (0.4, 0.75)) for s in (-1, 1)]
    rim = (
        [(-x, s * y * 0.75, depth) for s in (-1, 1)]
        + [(0.0, s * y, depth) for s in (-1, 1)]
        + [(x * 0.6, s * y * 0.72, depth) for s in (-1, 1)]
        + [(x, 0.0, depth + 8)]
    )
    b.add(paint, hull([*keel, *chine, *rim]))
    inset = [(px * 0.93, py * 0.88, depth + dz) for px, py, _ in rim for dz in (2.0, 9.0)]
    strake = [(px * 1.01, py * 1.03, depth + dz) for px, py, _ in rim for dz in (-6.0, 8.0)]
    b.add("WhitePaint", hull(strake), body=None)
    b.add(inner, hull(inset), body=None)


@KIT.asset(
    "RowingBoat",
    "boats",
    "Wooden rowing boat with two benches, 3.6 m, bow to +X, keel at the pivot",
    "boat rowing dinghy wooden",
)
def rowing(b: Builder) -> None:
    _hull(b, "BoatRed", 360, 140, 60, "WoodDark")
    for x in (-80, 30):
        b.box("Wood", (30, 118, 5), (x, 0, 68), body=None)
    for y in (-30, 30):
        b.tube("Wood", [(-120, y, 76), (100, y * 1.5, 76)], 2.5)


@KIT.asset(
    "FishingBoat",
    "boats",
    "Blue fishing boat with a wheelhouse and mast, 8 m, bow to +X, keel at the pivot",
    "boat fishing trawler ship",
)
def fishing(b: Builder) -> None:
    _hull(b, "BoatBlue", 800, 290, 150)
    b.box("WhitePaint", (200, 170, 190), (-150, 0, 155))
    b.box("BoatBlue", (220, 190, 12), (-150, 0, 345), body=None)
    b.box("Glass", (6, 140, 60), (-48, 0, 260), body=None)
    for y in (-87, 87):
        b.box("Glass", (130, 4, 55), (-150, y, 262), body=None)
    b.cylinder("Wood", 8, 420, (90, 0, 155), segments=10, body=None)
    b.tube("Wood", [(90, 0, 260), (-60, 0, 400)], 5)
    b.tube("Iron", [(90, 0, 570), (390, 0, 165)], 1.2)
    b.tube("Iron", [(90, 0, 570), (-390, 0, 160)], 1.2)
    b.box("Net", (150, 140, 30), (220, 0, 158), body=None)
    b.ellipsoid("BuoyOrange", (40, 40, 44), (-330, 60, 158), body=None)


@KIT.asset(
    "SailingBoat",
    "boats",
    "White sailing boat with furled sail, 7 m, bow to +X, keel at the pivot",
    "boat sailing yacht sail",
)
def sailing(b: Builder) -> None:
    _hull(b, "WhitePaint", 700, 220, 110)
    b.box("WhitePaint", (260, 130, 50), (0, 0, 112), bevel=8)
    for y in (-66, 66):
        b.box("Glass", (180, 3, 18), (0, y, 132), body=None)
    b.cylinder("Steel", 6, 800, (60, 0, 150), segments=10, body=None)
    b.tube("Steel", [(60, 0, 230), (-270, 0, 225)], 4)
    b.tube("WhitePaint", [(50, 0, 240), (-100, 0, 246), (-260, 0, 238)], 12)
    b.tube("Iron", [(60, 0, 945), (345, 0, 122)], 1)
    b.tube("Iron", [(60, 0, 945), (-345, 0, 118)], 1)
    b.body_box((12, 12, 800), (60, 0, 150))


@KIT.asset("Buoy", "boats", "Orange navigation buoy, base at the pivot", "buoy float marker orange")
def buoy(b: Builder) -> None:
    b.lathe("BuoyOrange", [(0, 0), (40, 10), (55, 40), (50, 60), (18, 75), (12, 150), (0, 155)])
    b.box("WhitePaint", (26, 26, 10), (0, 0, 110), body=None)


@KIT.asset("NetPile", "boats", "Heap of green fishing net with floats", "net fishing heap")
def net(b: Builder) -> None:
    b.lathe("Net", [(0, 0), (85, 0), (70, 26), (38, 48), (0, 58)], squash=0.75)
    for x, y in ((-50, 20), (20, -44), (48, 26), (-10, 50)):
        b.ellipsoid("BuoyOrange", (18, 18, 18), (x, y, 24), segments=8, body=None)


@KIT.asset("RopeCoil", "boats", "Coiled mooring rope", "rope coil mooring")
def rope(b: Builder) -> None:
    for i in range(4):
        b.lathe("Rope", [(22, 6 * i), (34 - i, 6 * i), (34 - i, 6 * i + 6), (22, 6 * i + 6)], body=None, smooth=False)
    b.body_box((60, 60, 24))


@KIT.asset("LobsterPot", "boats", "Half-round lobster pot", "lobster pot trap cage")
def pot(b: Builder) -> None:
    b.box("WoodDark", (80, 50, 5))
    arc = [(25.0, 5.0), (22, 22), (12, 34), (0, 38), (-12, 34), (-22, 22), (-25, 5)]
    for x in (-38, -13, 13, 38):
        b.tube("Wood", [(x, y, z) for y, z in arc], 1.6, segments=6)
    b.add("Net", hull([(x, y * 0.94, z * 0.96) for x in (-38.0, 38.0) for y, z in arc]))


@KIT.asset("Anchor", "boats", "Old iron anchor lying on its side, shank along X", "anchor iron")
def anchor(b: Builder) -> None:
    b.tube("Iron", [(-70, 0, 7), (70, 0, 7)], 6)
    b.tube("Iron", [(44, -48, 7), (66, -22, 7), (70, 0, 7), (66, 22, 7), (44, 48, 7)], 6)
    b.tube("Iron", [(-56, -34, 7), (-56, 34, 7)], 4)
    b.body_box((150, 100, 13))
