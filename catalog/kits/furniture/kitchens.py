"""Counters and units of kitchens."""

from __future__ import annotations

from catalog.kits.furniture.frames import KITCHEN, TABLES
from catalog.kits.maker import KitMaker, camel, family, word


@family("counter")
def counter(m: KitMaker) -> None:
    """A counter: of a bar, a shop, a reception."""
    kind, wood = m.opt("kind", m.pick("BarCounter", "ShopCounter", "ReceptionDesk", "ServingCounter")), m.mat("wood")
    long_, top = m.opt("length", 200.0), m.opt("top", m.pick("Worktop", m.mat("wood"), "Marble"))
    m.say(
        kind,
        TABLES,
        f"{word(kind).capitalize()} of {word(wood)} with a {word(top)} top, {long_ / 100:.0f} m long, 1.05 m high.",
        camel(wood),
        tags="counter bar shop desk",
    )
    m.b.box(wood, (long_, 50, 101))
    m.b.box(top, (long_ + 6, 64, 4), (0, 3, 101), bevel=0.8)
    for i in range(int(long_ // 50)):
        m.b.box(
            m.mat("trim"), (40, 2, 74), (-long_ / 2 + 25 + i * long_ / int(long_ // 50), 26, 14), bevel=0.4, body=None
        )
    m.b.tube("Brass", [(-long_ / 2, 36, 16), (long_ / 2, 36, 16)], 2)
    m.top(105, long_ - 10, 46, y=3, room=100)


@family("kitchen-unit")
def kitchen_unit(m: KitMaker) -> None:
    """A unit of a kitchen: base, sink, stove, fridge, wall oven."""
    kind = m.opt("kind", m.pick("KitchenBase", "KitchenSink", "Stove", "Fridge", "Dishwasher"))
    paint, top = m.mat("paint"), m.opt("top", "Worktop")
    h, w = (185.0, 65.0) if kind == "Fridge" else (90.0, 70.0)
    m.say(
        kind,
        KITCHEN,
        f"{word(paint).capitalize()} {word(kind)} unit, {w:.0f} cm wide.",
        camel(paint),
        tags="kitchen unit appliance",
    )
    b = m.b
    body = "WhitePaint" if kind in ("Fridge", "Stove", "Dishwasher") else paint
    b.box(body, (w, 58, h - 4), (0, 0, 0))
    if kind == "Fridge":
        for z, hh in ((4, 110), (118, 62)):
            b.box("SilverPaint", (w - 2, 3, hh), (0, 29, z), bevel=0.6, body=None)
            b.box("Steel", (2, 4, 30), (-w / 2 + 8, 32, z + 30), body=None)
        b.box(body, (w, 58, 4), (0, 0, h - 4))
        return
    b.box(top, (w, 62, 4), (0, 1, h - 4))
    if kind == "Stove":
        b.box("BlackPaint", (w - 4, 56, 1), (0, 0, h), body=None)
        for x in (-16, 16):
            for y in (-14, 14):
                b.cylinder("Iron", 8, 1.5, (x, y, h), segments=14, body=None)
        b.box("BlackPaint", (w - 14, 2, 44), (0, 30, 18), body=None)
        for i in range(4):
            b.cylinder("SilverPaint", 2, 3, (-18 + 12 * i, 29, 76), (0, 0, 90), segments=8, body=None)
    elif kind == "KitchenSink":
        b.box("Steel", (48, 38, 1), (0, 2, h), body=None)
        b.box("GreyPaint", (42, 32, 1.2), (0, 2, h), body=None)
        b.tube("Steel", [(0, -20, h), (0, -20, h + 24), (0, -4, h + 24), (0, -4, h + 16)], 1.4)
    else:
        for z in (6, 46) if kind == "KitchenBase" else (6,):
            b.box(
                paint if kind == "KitchenBase" else "SilverPaint",
                (w - 2, 2.4, 38 if kind == "KitchenBase" else 76),
                (0, 29, z),
                bevel=0.3,
                body=None,
            )
            b.box("Steel", (16, 2, 2), (0, 31, z + 30), body=None)
        m.top(h, w - 8, 46, room=60)
