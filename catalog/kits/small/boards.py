"""Standing boards: whiteboards, screens, paintings, mirrors, maps."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word


@family("board")
def board(m: KitMaker) -> None:
    """A standing board: whiteboard, blackboard, screen, painting on a stand, mirror, map."""
    kind = m.opt(
        "kind", m.pick("Whiteboard", "Blackboard", "PosterStand", "FloorMirror", "ProjectionScreen", "TimetableBoard")
    )
    w, h = {
        "Whiteboard": (180, 100),
        "Blackboard": (220, 110),
        "PosterStand": (90, 130),
        "FloorMirror": (60, 150),
        "ProjectionScreen": (240, 150),
        "TimetableBoard": (200, 90),
    }[kind]
    frame = m.mat("wood") if kind in ("Blackboard", "FloorMirror") else m.mat("metal")
    m.say(
        kind,
        "equipment",
        f"{word(kind).capitalize()} on a stand of {word(frame)}.",
        camel(frame),
        tags="board stand wall",
    )
    face = {
        "Whiteboard": "WhitePaint",
        "Blackboard": "DarkLeaf",
        "FloorMirror": "Mirror",
        "ProjectionScreen": "WhitePaint",
        "TimetableBoard": "TimetableScreen",
    }.get(kind) or m.pick("Landscape", "Sunset", "Seascape")
    low = 20 if kind in ("FloorMirror", "PosterStand") else 80
    for x in (-1, 1):
        m.b.box(frame, (4, 46, 4), (x * (w / 2 - 8), 0, 0))
        m.b.box(frame, (4, 4, low + h), (x * (w / 2 - 8), 0, 0))
    m.b.box(frame, (w, 5, h), (0, 0, low))
    m.b.panel(face, w - 8, h - 8, (0, 2.8, low + 4))
    m.b.panel(face, w - 8, h - 8, (0, -2.8, low + 4), (0, 180, 0))
