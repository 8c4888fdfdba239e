"""Walls and fences of whole pieces around a flat, a hall, a pen."""

from __future__ import annotations

import math
from collections.abc import Sequence

from c4s.agents.baselines.blocks import Block, Piece, grouped, joined
from c4s.agents.baselines.palette import PaletteItem

HOLES = frozenset({"window", "door", "doorway", "opening"})
LEAST_HEIGHT_M, MOST_HEIGHT_M, THIN_SHARE = 2.0, 5.0, 0.5
EDGE_M = 0.2


def walled(inner: Block, least: tuple[float, float], palette: Sequence[PaletteItem]) -> Block:
    """Walls on all sides of a block about the origin, no closer than a length and a width in metres.

    One wall has the doorway; in the others every second piece has a window. Without walls in the palette there is the
    ground alone.
    """
    walls = [item for item in palette if "wall" in item.words and _is_wall(item)]
    plain = [item for item in walls if not item.words & HOLES]
    family = max((_family(item) for item in plain), key=[_family(item) for item in walls].count, default="")
    plain = sorted((item for item in plain if _family(item) == family), key=lambda item: -_length(item))
    window = [item for item in walls if "window" in item.words][:1]
    doorway = [item for item in walls if item.words & HOLES and item not in window][:1]
    sides = max(inner.width + 2 * EDGE_M, least[0]), max(inner.depth + 2 * EDGE_M, least[1])
    inner.rect = (-sides[0] / 2, -sides[1] / 2, sides[0] / 2, sides[1] / 2)
    return enclosed(inner, plain, window, doorway) if plain else inner


def enclosed(
    inner: Block, plain: Sequence[PaletteItem], window: Sequence[PaletteItem] = (), doorway: Sequence[PaletteItem] = ()
) -> Block:
    """Whole pieces, the longest of them first, on all sides of a block about the origin."""
    step = min(map(_length, plain))
    width, depth = (max(1, math.ceil(side / step - 1e-6)) * step for side in (inner.width, inner.depth))
    inner.rect = (-width / 2, -depth / 2, width / 2, depth / 2)
    pieces: list[Piece] = []
    for side in range(4):
        length, half = (width, depth / 2) if side % 2 == 0 else (depth, width / 2)
        at = -length / 2
        for item in _row(length, plain, window if side else (), () if side else doorway):
            middle = at + _length(item) / 2
            out = (half + min(item.width, item.depth) / 2) * (1 if side in (1, 2) else -1)
            x, y = (middle, out) if side % 2 == 0 else (out, middle)
            pieces.append(Piece(item, x, y, yaw=90 if (item.width < item.depth) != (side % 2 == 1) else 0))
            at += _length(item)
    return joined([inner, grouped(pieces)])


def _row(
    length: float, plain: Sequence[PaletteItem], window: Sequence[PaletteItem], doorway: Sequence[PaletteItem]
) -> list[PaletteItem]:
    """The pieces of one side, the longest that still have room."""
    row: list[PaletteItem] = []
    left = length
    choice: Sequence[PaletteItem] = [*doorway, *plain]
    while item := next((item for item in choice if _length(item) <= left + 1e-6), None):
        row.append(item)
        left -= _length(item)
        choice = [*window, *plain] if len(row) % 2 else plain
    return row


def is_thin(item: PaletteItem) -> bool:
    """Whether it can be a piece of a wall or a fence."""
    return min(item.width, item.depth) < THIN_SHARE * max(item.width, item.depth)


def _is_wall(item: PaletteItem) -> bool:
    return is_thin(item) and LEAST_HEIGHT_M <= item.height <= MOST_HEIGHT_M


def _family(item: PaletteItem) -> str:
    """The first word of its name: walls of one family go together."""
    return item.name.split()[0]


def _length(item: PaletteItem) -> float:
    return max(0.1, round(max(item.width, item.depth), 1))
