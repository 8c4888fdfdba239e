"""Animals."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.nature.categories import ANIMALS


@family("animal")
def animal(m: KitMaker) -> None:
    """A farm animal or a pet, standing."""
    kind = m.opt("kind", m.pick("Cow", "Sheep", "Horse", "Pig", "Goat", "Dog", "Hen", "Duck", "Donkey", "Cat"))
    long_, tall, coat = {
        "Cow": (170, 130, "CreamPaint"),
        "Sheep": (90, 75, "Linen"),
        "Horse": (180, 150, "Walnut"),
        "Pig": (110, 65, "PinkPaint"),
        "Goat": (85, 75, "GreyPaint"),
        "Dog": (65, 55, "Fur"),
        "Hen": (34, 34, "Fur"),
        "Duck": (34, 30, "WhitePaint"),
        "Donkey": (130, 110, "GreyPaint"),
        "Cat": (40, 30, "BlackPaint"),
    }[kind]
    coat = m.opt("coat", m.pick(coat, coat, "BrownPaint", "WhitePaint"))
    m.say(
        kind,
        ANIMALS,
        f"{word(coat).capitalize()} {kind.lower()}, {long_ / 100:.1f} m long, head to +Y.",
        camel(coat),
        tags="animal farm",
    )
    bird = kind in ("Hen", "Duck")
    leg = tall * (0.3 if bird else 0.45)
    for x in (-1, 1):
        for y in (0,) if bird else (-1, 1):
            m.b.cylinder(
                "OrangePaint" if bird else coat,
                max(1.5, long_ * 0.04),
                leg + 4,
                (x * long_ * 0.11, y * long_ * 0.3, 0),
                segments=7,
                body=None,
            )
    m.b.ellipsoid(coat, (long_ * 0.42, long_ * 0.86, tall * 0.52), (0, 0, leg), segments=12, body=None)
    neck = long_ * (0.42 if not bird else 0.3)
    head_z = tall * (0.78 if kind not in ("Pig",) else 0.5)
    m.b.tube(coat, [(0, neck * 0.8, leg + tall * 0.3), (0, neck * 1.15, head_z + tall * 0.08)], long_ * 0.08)
    m.b.ellipsoid(coat, (long_ * 0.2, long_ * 0.34, tall * 0.2), (0, neck * 1.3, head_z), segments=10, body=None)
    if bird:
        m.b.cylinder("OrangePaint", 2.5, 6, (0, neck * 1.65, head_z + 4), (0, 0, -90), top=0.5, segments=6, body=None)
        m.b.ellipsoid("RedPaint", (3, 7, 7), (0, neck * 1.3, head_z + tall * 0.18), segments=6, body=None)
    else:
        for x in (-1, 1):
            m.b.ellipsoid(
                coat,
                (long_ * 0.07, long_ * 0.05, tall * 0.14),
                (x * long_ * 0.08, neck * 1.15, head_z + tall * 0.15),
                segments=6,
                body=None,
            )
        m.b.tube(coat, [(0, -long_ * 0.42, leg + tall * 0.36), (0, -long_ * 0.5, leg + tall * 0.06)], long_ * 0.02)
        if kind in ("Cow",):
            for x in (-1, 1):
                m.b.ellipsoid("BlackPaint", (10, 60, 44), (x * long_ * 0.19, 8, leg + 12), segments=8, body=None)
    m.b.body_box((long_ * 0.4, long_ * 0.86, tall * 0.9))
