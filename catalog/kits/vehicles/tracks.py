"""Tracks, platforms, signals."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.vehicles.categories import RAIL


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
