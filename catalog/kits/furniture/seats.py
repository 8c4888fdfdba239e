"""Chairs, stools, sofas and pews."""

from __future__ import annotations

from catalog.kits.furniture.frames import SEATS, legs
from catalog.kits.maker import KitMaker, camel, family, word


@family("chair")
def chair(m: KitMaker) -> None:
    """A chair."""
    kind = m.opt(
        "kind",
        m.pick("Ladderback", "Slatted", "Upholstered", "Windsor")
        if m.style.old
        else m.pick("Dining", "Shell", "Upholstered", "Metal", "Slatted"),
    )
    wood, cloth, metal = m.mat("wood"), m.mat("cloth"), m.mat("metal")
    b = m.b
    if kind in ("Shell", "Metal"):
        paint = m.mat("paint")
        m.say(
            f"{kind}Chair",
            SEATS,
            f"{word(paint).capitalize()} {kind.lower()} chair on {word(metal)} legs.",
            camel(paint),
            tags="chair seat",
        )
        for x in (-19, 19):
            for y in (-19, 19):
                b.tube(metal, [(x * 1.1, y * 1.1, 0), (x * 0.8, y * 0.8, 43)], 1.5)
        b.box(paint, (44, 42, 4), (0, 0, 43), bevel=1.5)
        b.box(paint, (42, 3, 34), (0, -21, 50), (0, 0, -8), bevel=1)
        b.body_box((40, 40, 43))
        return
    m.say(
        f"{kind}Chair",
        SEATS,
        f"{kind} chair of {word(wood)}{' with ' + word(cloth) + ' cushion' if kind == 'Upholstered' else ''}.",
        camel(cloth if kind == "Upholstered" else wood),
        camel(wood),
        tags="chair seat",
    )
    for x in (-19, 19):
        b.box(wood, (3.8, 3.8, 44), (x, 18, 0))
        b.box(wood, (3.8, 3.8, 94), (x, -19, 0))
    b.box(wood, (43, 42, 3), (0, 0, 43), bevel=0.8)
    if kind == "Upholstered":
        b.box(cloth, (40, 38, 5), (0, 0, 46), bevel=2)
        b.box(cloth, (36, 4, 34), (0, -19, 56), bevel=1.5)
    elif kind == "Ladderback":
        for z in (56, 69, 82):
            b.box(wood, (36, 2, 7), (0, -19, z), body=None)
    elif kind == "Windsor":
        for x in range(-15, 16, 5):
            b.cylinder(wood, 0.8, 46, (x, -19, 46), segments=5, body=None)
        b.box(wood, (42, 4, 5), (0, -19, 90), body=None)
    else:
        b.box(wood, (36, 2.4, 9), (0, -19, 83), body=None)
        for x in (-12, -4, 4, 12):
            b.box(wood, (3, 1.6, 38), (x, -19, 46), body=None)
    b.body_box((38, 4, 46), (0, -19, 46))


@family("stool")
def stool(m: KitMaker) -> None:
    """A stool, low or of a bar."""
    high, wood = m.opt("high", m.pick(45.0, 45.0, 75.0)), m.mat("wood")
    pad = m.chance(0.4)
    m.say(
        "BarStool" if high > 60 else "Stool",
        SEATS,
        f"Round {word(wood)} stool, {high:.0f} cm high.",
        camel(m.mat("cloth") if pad else wood),
        camel(wood),
        tags="stool seat",
    )
    m.b.cylinder(m.mat("cloth") if pad else wood, 17, 4, (0, 0, high - 4), segments=16)
    for x, y in ((12, 12), (-12, 12), (-12, -12), (12, -12)):
        m.b.tube(m.mat("metal") if pad else wood, [(x * 1.2, y * 1.2, 0), (x * 0.8, y * 0.8, high - 3)], 1.7)
    m.b.body_box((30, 30, high - 4))


@family("sofa")
def sofa(m: KitMaker) -> None:
    """A sofa or an armchair."""
    seats, cloth = m.opt("seats", m.pick(1, 2, 3)), m.mat("cloth")
    m.say(
        {1: "Armchair", 2: "TwoSeatSofa", 3: "Sofa"}[seats],
        SEATS,
        f"{word(cloth).capitalize()} {'armchair' if seats == 1 else 'sofa'} for {seats}.",
        camel(cloth),
        "Deep",
        tags="sofa couch armchair seat",
    )
    inner = 62 * seats
    width, depth = inner + 30, 86.0
    legs(m, m.mat("wood"), width - 10, depth - 10, 11, 5, round_=True)
    m.b.box(cloth, (width, depth, 20), (0, 0, 11), bevel=3)
    for i in range(seats):
        x = (i + 0.5) * 62 - inner / 2
        m.b.box(cloth, (60, 58, 14), (x, 12, 31), bevel=4)
        m.b.box(
            m.another("cloth") if i == 0 and m.style.ornate else cloth,
            (58, 14, 40),
            (x, -22, 44),
            (0, 0, -10),
            bevel=4,
            body=None,
        )
    m.b.box(cloth, (width, 16, 54), (0, -depth / 2 + 8, 31), bevel=4)
    for x in (-1, 1):
        m.b.box(cloth, (15, depth - 4, 34), (x * (width - 15) / 2, 0, 28), bevel=4)


@family("pew")
def pew(m: KitMaker) -> None:
    """A long bench: a pew, a waiting bench, a school bench, a plain bench."""
    kind, wood, long_ = m.opt("kind", m.pick("Pew", "PlainBench")), m.mat("wood"), m.opt("length", 240.0)
    m.say(
        kind,
        SEATS,
        f"{word(wood if kind != 'WaitingBench' else m.mat('metal')).capitalize()} {word(kind)}, "
        f"{long_ / 100:.1f} m long.",
        camel(wood if kind != "WaitingBench" else m.mat("cloth")),
        tags="bench pew seat",
    )
    b = m.b
    if kind == "Pew":
        for x in (-1, 1):
            b.box(wood, (5, 56, 60), (x * (long_ / 2 - 2.5), 4, 0))
            b.box(wood, (5, 8, 96), (x * (long_ / 2 - 2.5), -22, 0), body=None)
        b.box(wood, (long_ - 10, 40, 4), (0, 4, 42))
        b.box(wood, (long_, 4, 50), (0, -20, 44), (0, 0, -6), body="box")
        b.box(wood, (long_ - 10, 3, 40), (0, -18, 2), body=None)
    elif kind == "WaitingBench":
        b.box(m.mat("metal"), (long_, 8, 8), (0, 0, 30))
        n = int(long_ // 58)
        for i in range(n):
            px = (i - (n - 1) / 2) * long_ / n
            b.box(m.mat("cloth"), (50, 46, 6), (px, 2, 40), bevel=2)
            b.box(m.mat("cloth"), (50, 5, 40), (px, -22, 48), (0, 0, -8), bevel=2)
        for side in (-0.4, 0.4):
            b.box(m.mat("metal"), (6, 50, 30), (side * long_, 0, 0))
    else:
        b.box(wood, (long_, 34, 5), (0, 0, 41))
        for x in (-1, 1):
            b.box(wood, (6, 30, 41), (x * (long_ / 2 - 22), 0, 0))
        b.body_box((long_ - 60, 6, 41))
    if kind == "PlainBench":
        m.top(46, long_ - 20, 24)
