"""Gardens, and borders and fences around them; playgrounds and graveyards."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cases.open190.layout import Assets, Box, Pair, StagedPlace


def garden(
    p: StagedPlace,
    box: Box,
    *,
    beds: int = 3,
    centre: str = "",
    hedge: bool = True,
    path: str = "Gravel",
    benches: Assets = (),
    plants: Assets = (),
    trees: Assets = (),
) -> None:
    """A formal garden: crossing paths, hedges, beds of flowers, benches that look to the middle."""
    x0, y0, x1, y1 = box
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    p.trail([(x0, cy), (x1, cy)], 220, path)
    p.trail([(cx, y0), (cx, y1)], 220, path, z=1.6)
    if centre:
        p.put(centre, cx, cy)
    plants = plants or p.kit("flowers", 6)
    bed = p.one("bed", length=300.0, wide=130.0)
    for sx in (-1, 1):
        for sy in (-1, 1):
            qx, qy = cx + sx * (x1 - x0) / 4, cy + sy * (y1 - y0) / 4
            for i in range(beds):
                by = qy + (i - (beds - 1) / 2) * 260
                p.put(bed, qx, by, 2.0)
                for k in range(4):
                    p.put(plants, qx - 105 + 70 * k, by + p.uni(-22, 22), 0, p.uni(0, 360))
            if benches:
                p.put(benches, cx + sx * 330, cy + sy * 175, yaw=0 if sy < 0 else 180)
            if trees:
                p.put(
                    trees,
                    cx + sx * ((x1 - x0) / 2 - 190),
                    cy + sy * ((y1 - y0) / 2 - 190),
                    yaw=p.uni(0, 360),
                    scale=0.75,
                )
    if hedge:
        piece = p.kit("hedge", 2, length=300.0, high=100.0)
        for a, b in (((x0, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0))):
            border(p, a, b, piece, opening=300.0)


def border(p: StagedPlace, a: Pair, b: Pair, pieces: Sequence[str], opening: float = 0.0) -> None:
    """Fences, walls or hedges end to end from a to b, with an opening in the middle."""
    length, yaw = math.hypot(b[0] - a[0], b[1] - a[1]), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
    step = p.thing(pieces[0]).width + 1
    count = int(length // step)
    start = (length - count * step) / 2
    for i in range(count):
        x = start + (i + 0.5) * step
        if opening and abs(x - length / 2) < opening / 2 + step * 0.3:
            continue
        with p.at(a[0], a[1], yaw):
            p.relate("in_row", p.put(pieces, x, 0))


def enclosure(p: StagedPlace, box: Box, pieces: Sequence[str], *, gate: str = "", sides: str = "SENW") -> None:
    """A fence or wall around a rectangle, with a gate in the middle of its south side."""
    x0, y0, x1, y1 = box
    for side, a, b in (
        ("S", (x0, y0), (x1, y0)),
        ("E", (x1, y0), (x1, y1)),
        ("N", (x1, y1), (x0, y1)),
        ("W", (x0, y1), (x0, y0)),
    ):
        if side in sides:
            border(p, a, b, pieces, opening=(p.thing(gate).width if gate else 300.0) if side == "S" else 0.0)
    if gate:
        p.put(gate, (x0 + x1) / 2, y0, slack=3)


def playground(p: StagedPlace, x: float, y: float, wide: float = 1500.0) -> None:
    """Play things on a rubber square with a low fence and benches."""
    h = wide / 2
    with p.at(x, y):
        p.ground((-h, -h, h, h), "Rubber", tile=wide / 2, z=0.8)
        things = p.kinds(
            "play", "Slide", "Swing", "Seesaw", "Sandbox", "ClimbingFrame", "Roundabout", "SpringHorse", "PlayHouse"
        )
        for i, name in enumerate(things):
            p.put(name, -h * 0.66 + h * 0.66 * (i % 3), -h * 0.62 + h * 0.64 * (i // 3), yaw=p.uni(-20, 20))
        enclosure(p, (-h, -h, h, h), p.kit("fence", 1, kind="Picket", length=250.0))
        p.row((-h * 0.6, h * 0.9), (h * 0.6, h * 0.9), p.kit("bench", 2, back=True), 3, yaw=180)


def cemetery(p: StagedPlace, box: Box, columns: int, lines: int) -> None:
    """Graves in rows behind a wall."""
    p.grid(box, p.kit("tomb", 8), columns, lines, jitter=14)
