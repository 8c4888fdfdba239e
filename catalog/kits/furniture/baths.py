"""Bathrooms and fireplaces."""

from __future__ import annotations

from catalog.kits.furniture.frames import BATH, legs
from catalog.kits.maker import KitMaker, camel, family, word


@family("bath-thing")
def bath_thing(m: KitMaker) -> None:
    """Bath, toilet, basin, shower, urinal row."""
    kind = m.opt("kind", m.pick("Bathtub", "Toilet", "Washbasin", "ShowerCabin", "TowelShelf"))
    m.say(
        kind,
        BATH,
        f"White {word(kind)} of a bathroom.",
        m.pick("White", "Porcelain"),
        "Modern",
        tags="bathroom sanitary",
    )
    b = m.b
    if kind == "Bathtub":
        b.box("Porcelain", (170, 76, 56), bevel=8)
        b.box("WhitePaint", (150, 58, 1), (0, 0, 56), body=None)
        b.box("SkyPaint", (140, 50, 1.5), (0, 0, 56), body=None)
        b.tube("Steel", [(-70, -30, 56), (-70, -30, 76), (-54, -24, 74)], 2)
    elif kind == "Toilet":
        b.lathe("Porcelain", [(0, 0), (13, 0), (14, 20), (20, 38), (0, 38)], (0, 6, 0), squash=1.35)
        b.box("Porcelain", (40, 18, 40), (0, -26, 36), bevel=3)
        b.cylinder("WhitePaint", 20, 4, (0, 6, 38), segments=16, squash=1.3)
    elif kind == "Washbasin":
        b.cylinder("Porcelain", 9, 76, top=11, segments=12)
        b.lathe("Porcelain", [(0, 0), (14, 0), (30, 14), (30, 18), (24, 18), (0, 8)], (0, 4, 70))
        b.tube("Steel", [(0, -16, 86), (0, -16, 102), (0, -4, 100)], 1.5)
    elif kind == "ShowerCabin":
        b.box("Porcelain", (90, 90, 12))
        for x, y, s in ((0, 44, (90, 2, 190)), (44, 0, (2, 90, 190)), (-44, 0, (2, 90, 190)), (0, -44, (90, 2, 190))):
            b.box("Glass", s, (x, y, 12))
        b.tube("Steel", [(0, -40, 12), (0, -40, 200), (0, -10, 206)], 1.5)
    else:
        legs(m, "Steel", 60, 34, 110, 3)
        for z in (20, 60, 106):
            b.box("WhitePaint", (60, 34, 2), (0, 0, z))
        for z in (22, 62):
            b.box("TealCloth", (40, 26, 14), (0, 0, z), bevel=4, body=None)


@family("fireplace")
def fireplace(m: KitMaker) -> None:
    """A fireplace with a chimney breast."""
    stone = m.mat("stone")
    m.say(
        "Fireplace",
        "decor",
        f"{word(stone).capitalize()} hearth with glowing logs and a mantel shelf.",
        camel(stone),
        tags="fireplace hearth chimney",
    )
    b = m.b
    for x in (-75, 75):
        b.box(stone, (40, 50, 120), (x, 0, 0))
    b.box(stone, (190, 50, 40), (0, 0, 120))
    b.box(m.mat("wood"), (210, 62, 8), (0, 4, 160))
    b.box(stone, (150, 40, 130), (0, -5, 168), body="box")
    b.box("DarkStone", (112, 6, 120), (0, -22, 0))
    b.box("DarkStone", (112, 44, 6), body=None)
    for i in range(4):
        b.cylinder("Bark", 6, 70, (-35, -8 + 5 * i, 12 + 5 * (i % 2)), (-90, 8 * i - 12, 0), segments=8, body=None)
    b.ellipsoid("Ember", (50, 26, 20), (0, 0, 8), segments=10, body=None)
