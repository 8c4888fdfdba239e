"""Goods of shop shelves: tins, boxes, bottles, jars, rolls."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word


@family("package")
def package(m: KitMaker) -> None:
    """Goods of a shop shelf: tins, boxes, bottles, jars, rolls in a row."""
    kind, paint = (
        m.opt(
            "kind",
            m.pick(
                "CerealBoxes",
                "SoupTins",
                "SodaBottles",
                "JamJars",
                "PaintTins",
                "TeaBoxes",
                "Detergent",
                "ShoeBoxes",
                "Potions" if m.style.name == "fantasy" else "SpiceJars",
                "ToolBox",
            ),
        ),
        m.mat("paint"),
    )
    m.say(
        kind,
        "goods",
        f"{word(kind).capitalize()} in {word(paint)} for a shelf.",
        camel(paint),
        tags="goods package shop",
    )
    b = m.b
    w, d, h, n = {
        "CerealBoxes": (9, 20, 26, 4),
        "SoupTins": (9, 9, 11, 4),
        "SodaBottles": (8, 8, 26, 4),
        "JamJars": (8, 8, 11, 4),
        "PaintTins": (16, 16, 18, 2),
        "TeaBoxes": (12, 9, 9, 3),
        "Detergent": (14, 9, 24, 3),
        "ShoeBoxes": (34, 20, 12, 1),
        "Potions": (8, 8, 14, 4),
        "SpiceJars": (7, 7, 9, 5),
        "ToolBox": (40, 20, 16, 1),
    }[kind]
    for i in range(n):
        x = (i - (n - 1) / 2) * (w + 0.6)
        if kind in ("CerealBoxes", "TeaBoxes", "Detergent", "ShoeBoxes", "ToolBox"):
            b.box(paint, (w, d, h), (x, 0, 0), body=None)
            b.box("WhitePaint", (w * 0.7, 0.6, h * 0.4), (x, d / 2, h * 0.35), body=None)
            if kind == "ShoeBoxes":
                b.box("WhitePaint", (w - 1, d - 1, h), (x, 0, h), body=None)
            if kind == "ToolBox":
                b.box("BlackPaint", (16, 3, 4), (x, 0, h), body=None)
        elif kind in ("SodaBottles", "Potions"):
            r = w / 2
            b.lathe(
                paint if kind == "SodaBottles" else m.pick("CrystalBlue", "CrystalViolet", "NeonGreen"),
                [(0, 0), (r, 0), (r, h * 0.55), (r * 0.35, h * 0.8), (r * 0.35, h), (0, h)],
                (x, 0, 0),
                segments=12,
                body=None,
            )
            b.cylinder("WhitePaint", r * 1.02, h * 0.2, (x, 0, h * 0.2), segments=12, body=None)
        else:
            b.cylinder(paint, w / 2, h, (x, 0, 0), segments=12, body=None)
            b.cylinder(
                "WhitePaint" if kind != "PaintTins" else "SilverPaint",
                w / 2 + 0.2,
                h * 0.4,
                (x, 0, h * 0.3),
                segments=12,
                body=None,
            )
    b.body_box((n * (w + 0.6), d, h * (2 if kind == "ShoeBoxes" else 1)))
