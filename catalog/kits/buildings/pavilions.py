"""Kiosks, pavilions and tents."""

from __future__ import annotations

from catalog.kits.facade import BUILDINGS, hip_roof
from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull


@family("kiosk")
def kiosk(m: KitMaker) -> None:
    """A kiosk with a counter and a striped canopy."""
    use = m.opt("use", m.pick("IceCreamKiosk", "NewsKiosk", "TicketBooth", "CoffeeKiosk", "SnackKiosk", "FlowerKiosk"))
    paint = m.mat("paint")
    m.say(
        use,
        BUILDINGS,
        f"{word(paint).capitalize()} {word(use)} with a serving hatch and a canopy, 2.6 m wide.",
        camel(paint),
        tags="kiosk booth stand",
    )
    m.b.box(paint, (260, 220, 100))
    m.b.box(m.mat("trim"), (280, 40, 6), (0, 118, 100), body=None)
    for x in (-122, 122):
        m.b.box(paint, (16, 220, 150), (x, 0, 100))
    m.b.box(paint, (228, 14, 150), (0, -103, 100))
    m.b.box(m.mat("trim"), (300, 260, 14), (0, 0, 250))
    m.b.box(m.mat("awning"), (270, 90, 8), (0, 150, 236), (0, 0, -18), body=None)
    m.b.box(m.mat("door"), (200, 10, 46), (0, 112, 264), body=None)
    for i in range(4):
        m.b.box(m.another("paint"), (30, 30, 34), (-80 + 50 * i, 60, 106), body=None)


@family("pavilion")
def pavilion(m: KitMaker) -> None:
    """An open roof on posts."""
    use = m.opt("use", m.pick("Pavilion", "Bandstand", "Gazebo", "Shelter"))
    wide, roof, post = m.opt("size", m.uni(400, 600, 50)), m.mat("roof"), m.mat("trim")
    m.say(
        use,
        BUILDINGS,
        f"Open {word(use)} with a {word(roof)} roof on posts, {wide / 100:.1f} m wide.",
        camel(roof),
        tags="pavilion open roof",
    )
    m.b.box(m.mat("stone"), (wide, wide, 18))
    for x in (-1, 1):
        for y in (-1, 1):
            m.b.cylinder(post, 12, 270, (x * (wide / 2 - 30), y * (wide / 2 - 30), 18), segments=10)
    hip_roof(m, wide - 20, wide - 20, 290, wide * 0.35 * m.style.steep, roof)


@family("tent")
def tent(m: KitMaker) -> None:
    """A tent: round with a peak, or a ridge tent."""
    cloth = m.mat("awning")
    round_ = m.opt("round", m.chance(0.5))
    wide = m.opt("size", m.uni(360, 620, 20))
    m.say(
        m.opt("use", "RoundTent" if round_ else "RidgeTent"),
        BUILDINGS,
        f"{'Round' if round_ else 'Ridge'} tent of {word(cloth)}, {wide / 100:.1f} m wide.",
        camel(cloth),
        tags="tent canvas camp",
    )
    if round_:
        m.b.cylinder(cloth, wide / 2, 210, segments=18)
        m.b.cylinder(m.another("awning"), wide / 2 + 25, wide * 0.4, (0, 0, 205), top=4, segments=18)
        m.b.cylinder("Oak", 4, 90, (0, 0, 200 + wide * 0.4), segments=6, body=None)
        m.b.box("BlackCloth", (90, 8, 190), (0, wide / 2 - 4, 0), body=None)
    else:
        m.b.gable(cloth, (wide * 0.7, wide, wide * 0.5))
        m.b.add(
            "BlackCloth",
            hull(
                [
                    (-50.0, wide / 2 + 2, 0.0),
                    (50.0, wide / 2 + 2, 0.0),
                    (0.0, wide / 2 + 2, wide * 0.42),
                    (0.0, wide / 2 - 2, wide * 0.42),
                ]
            ),
            body=None,
        )
