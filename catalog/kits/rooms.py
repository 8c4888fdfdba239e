"""Walls, floors, doors and windows of rooms, and columns, stairs and stages. Wall modules run along X."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word

ROOM = "architecture"
THICK = 14.0


@family("floor", flat=True)
def floor(m: KitMaker) -> None:
    """A square floor piece, upper face at the pivot."""
    of, side = m.opt("of", "Parquet"), m.opt("side", 400.0)
    m.say(
        f"{of}Floor",
        ROOM,
        f"Floor piece of {word(of)}, {side / 100:.0f} x {side / 100:.0f} m, upper face at the pivot.",
        tags="floor tile ground",
    )
    m.b.box(of, (side, side, 4), (0, 0, -4))


@family("room-wall")
def room_wall(m: KitMaker) -> None:
    """A wall module: plain, with a window, a doorway, a picture, panelling or an arch."""
    kind, length, high = m.opt("kind", "Plain"), m.opt("length", 400.0), m.opt("high", 300.0)
    wall, trim, base = m.opt("wall", m.mat("wall")), m.mat("trim"), m.opt("base", "")
    m.say(
        {
            "Plain": "RoomWall",
            "Window": "WindowWall",
            "Door": "DoorwayWall",
            "Glass": "GlassPartition",
            "Arch": "ArchWall",
            "Shopfront": "ShopfrontWall",
        }[kind]
        + ("" if length == 400 else f"{length / 100:.0f}m"),
        ROOM,
        f"Wall module of {word(wall)} ({kind.lower()}), {length / 100:.0f} m long, {high / 100:.1f} m high.",
        camel(wall),
        tags="wall room module",
    )
    b = m.b
    if kind == "Plain":
        b.box(wall, (length, THICK, high))
    elif kind == "Glass":
        b.box(trim, (length, THICK, 12))
        b.box("Glass", (length, 3, high - 24), (0, 0, 12))
        b.box(trim, (length, THICK, 12), (0, 0, high - 12))
        for i in range(int(length // 100) + 1):
            b.box(trim, (6, THICK, high), (-length / 2 + 3 + i * (length - 6) / int(length // 100), 0, 0), body=None)
        return
    elif kind == "Arch":
        b.arch(wall, (length, THICK * 2, high), (min(200.0, length * 0.5), min(240.0, high - 50)))
        return
    else:
        wide, low, tall = {
            "Window": (min(220.0, length * 0.55), 95.0, min(150.0, high - 130)),
            "Door": (130.0, 0.0, 225.0),
            "Shopfront": (length - 60, 50.0, high - 110),
        }[kind]
        side = (length - wide) / 2
        for s in (-1, 1):
            b.box(wall, (side, THICK, high), (s * (length - side) / 2, 0, 0))
            b.box(trim, (7, THICK + 5, tall), (s * (wide / 2 - 3), 0, low), body=None)
        b.box(wall, (wide, THICK, high - low - tall), (0, 0, low + tall))
        b.box(trim, (wide, THICK + 5, 7), (0, 0, low + tall - 7), body=None)
        if low:
            b.box(wall, (wide, THICK, low))
            b.box(trim, (wide + 16, THICK + 14, 4), (0, 0, low), body=None)
            b.box("Glass", (wide - 14, 2, tall - 8), (0, 0, low + 4))
            for i in range(1, max(2, int(wide // 80))):
                b.box(trim, (5, 6, tall), (-wide / 2 + i * wide / max(2, int(wide // 80)), 0, low), body=None)
            if m.style.old:
                b.box(trim, (wide, 6, 5), (0, 0, low + tall * 0.5), body=None)
    for s in (-1, 1):
        b.box(
            base or trim,
            (length if kind != "Door" else 0.1, 2, 110 if base else 10),
            (0, s * (THICK / 2 + 1), 0),
            body=None,
        )


@family("pillar")
def pillar(m: KitMaker) -> None:
    """A pillar of a hall."""
    stone, high = m.opt("of", m.mat("stone")), m.opt("high", 300.0)
    kind = m.opt("kind", m.pick("Round", "Square", "Clustered"))
    m.say(
        f"{kind}Pillar",
        ROOM,
        f"{kind} pillar of {word(stone)}, {high / 100:.1f} m high.",
        camel(stone),
        tags="pillar column support",
    )
    m.b.box(stone, (70, 70, 26))
    if kind == "Square":
        m.b.box(stone, (50, 50, high - 50), (0, 0, 26), bevel=3)
    else:
        m.b.cylinder(stone, 25, high - 50, (0, 0, 26), segments=18)
        if kind == "Clustered":
            for x, y in ((25, 0), (-25, 0), (0, 25), (0, -25)):
                m.b.cylinder(stone, 9, high - 50, (x, y, 26), segments=10, body=None)
    m.b.box(stone, (74, 74, 24), (0, 0, high - 24))


@family("dais")
def dais(m: KitMaker) -> None:
    """A stage, a dais or a plinth that things stand on."""
    of, wide, deep, high = m.opt("of", m.mat("wood")), m.opt("width", 600.0), m.opt("depth", 300.0), m.opt("high", 40.0)
    m.say(
        m.opt("noun", "Stage"),
        ROOM,
        f"Raised stage of {word(of)}, {wide / 100:.1f} x {deep / 100:.1f} m, {high / 100:.1f} m high.",
        camel(of),
        tags="stage platform plinth",
    )
    m.b.box(of, (wide, deep, high))
    m.b.box(m.mat("trim"), (wide + 4, deep + 4, 5), (0, 0, high - 9), body=None)
    m.top(high, wide - 30, deep - 30)


@family("stairs")
def stairs(m: KitMaker) -> None:
    """A flight of stairs that rises to -Y."""
    of, wide, steps = m.opt("of", m.mat("stone")), m.opt("width", 300.0), m.opt("steps", 10)
    m.say(
        "StairFlight",
        ROOM,
        f"Flight of {steps} {word(of)} steps that rises to the back, {wide / 100:.1f} m wide.",
        camel(of),
        tags="stairs steps",
    )
    for i in range(steps):
        m.b.box(of, (wide, 30, 17 * (i + 1)), (0, (steps / 2 - i) * 30 - 15, 0))
    for s in (-1, 1):
        m.b.tube(
            m.mat("metal"),
            [(s * (wide / 2 - 6), steps * 15, 95), (s * (wide / 2 - 6), -steps * 15, 95 + 17 * steps)],
            3,
        )
        for i in range(0, steps, 3):
            m.b.cylinder(
                m.mat("metal"),
                2,
                90,
                (s * (wide / 2 - 6), (steps / 2 - i) * 30 - 15, 17 * (i + 1)),
                segments=6,
                body=None,
            )


@family("rug", flat=True)
def rug(m: KitMaker) -> None:
    """A carpet on the floor."""
    of, wide, deep = (
        m.opt("of", m.pick("RedRug", "BlueRug", "GreenRug")),
        m.opt("width", m.uni(160, 300, 20)),
        m.opt("depth", m.uni(120, 200, 20)),
    )
    m.say(
        "Rug",
        "decor",
        f"Woven rug, {wide:.0f} x {deep:.0f} cm.",
        camel(of).replace("Rug", ""),
        "Large" if wide > 230 else "Small",
        tags="rug carpet",
    )
    m.b.box(of if not of.endswith("Rug") else "BlackCloth", (wide, deep, 0.6), body="box")
    if of.endswith("Rug"):
        m.b.quad(
            of,
            [
                (-wide / 2, -deep / 2, 0.8),
                (wide / 2, -deep / 2, 0.8),
                (wide / 2, deep / 2, 0.8),
                (-wide / 2, deep / 2, 0.8),
            ],
        )


@family("beam")
def beam(m: KitMaker) -> None:
    """A beam or truss along X that lies on two walls."""
    length, of, deep = m.opt("length", 1000.0), m.opt("of", m.mat("wood")), m.opt("deep", 26.0)
    truss = m.opt("truss", False)
    m.say(
        "RoofTruss" if truss else "CeilingBeam",
        ROOM,
        f"{word(of).capitalize()} {'truss' if truss else 'beam'} that spans {length / 100:.1f} m.",
        camel(of),
        tags="beam ceiling roof",
    )
    m.b.box(of, (length, 14 if truss else 22, 12 if truss else deep))
    if truss:
        m.b.box(of, (length * 0.94, 14, 10), (0, 0, 90), body=None)
        n = max(2, int(length // 140))
        for i in range(n):
            x0, x1 = (i / n - 0.5) * length * 0.94, ((i + 1) / n - 0.5) * length * 0.94
            m.b.tube(of, [(x0, 0, 8 if i % 2 else 94), (x1, 0, 94 if i % 2 else 8)], 4)
