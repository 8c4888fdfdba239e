"""Rigid groups of placed assets and the ways to join them. Metres on the plate; yaw in quarter turns."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from c4s.agents.baselines.palette import PaletteItem

Rect = tuple[float, float, float, float]
"""Least x and y, most x and y."""


@dataclass(eq=False)
class Piece:
    """One asset: the middle of its plan, the height of its bottom, and what it stands on, if that is another piece."""

    item: PaletteItem
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    yaw: int = 0
    on: Piece | None = None
    scale: float = 1.0
    """In plan only."""

    @property
    def half(self) -> tuple[float, float]:
        """Half the sides of its plan."""
        sides = self.scale * self.item.width / 2, self.scale * self.item.depth / 2
        return sides if self.yaw % 180 == 0 else sides[::-1]

    @property
    def rect(self) -> Rect:
        """Its plan."""
        return self.x - self.half[0], self.y - self.half[1], self.x + self.half[0], self.y + self.half[1]


@dataclass(eq=False)
class Block:
    """Pieces that keep their places to each other, and the ground that they claim."""

    pieces: list[Piece] = field(default_factory=list)
    rect: Rect = (0.0, 0.0, 0.0, 0.0)
    units: tuple[Block, ...] = ()
    """Its parts, where they may also stand apart: copies of one thing."""

    @property
    def width(self) -> float:
        """Along x."""
        return self.rect[2] - self.rect[0]

    @property
    def depth(self) -> float:
        """Along y."""
        return self.rect[3] - self.rect[1]

    @property
    def centre(self) -> tuple[float, float]:
        """Of the claimed ground."""
        return (self.rect[0] + self.rect[2]) / 2, (self.rect[1] + self.rect[3]) / 2

    def move_to(self, x: float, y: float) -> Block:
        """Move it, its centre to a point; itself."""
        dx, dy = x - self.centre[0], y - self.centre[1]
        for piece in self.pieces:
            piece.x, piece.y = piece.x + dx, piece.y + dy
        self.rect = (self.rect[0] + dx, self.rect[1] + dy, self.rect[2] + dx, self.rect[3] + dy)
        return self

    def raise_by(self, height: float) -> Block:
        """Lift it; itself."""
        for piece in self.pieces:
            piece.z += height
        return self

    def grown(self, margin: float) -> Block:
        """With more ground around it."""
        low_x, low_y, high_x, high_y = self.rect
        return replace(self, rect=(low_x - margin, low_y - margin, high_x + margin, high_y + margin))


def single(item: PaletteItem) -> Block:
    """One asset."""
    piece = Piece(item)
    return Block([piece], piece.rect)


def grouped(pieces: Iterable[Piece]) -> Block:
    """Pieces as they lie, as one block."""
    return joined(Block([piece], piece.rect) for piece in pieces)


def joined(blocks: Iterable[Block]) -> Block:
    """Blocks as they lie, as one."""
    given = [block for block in blocks if block.pieces or block.width or block.depth]
    if not given:
        return Block()
    low_x, low_y, high_x, high_y = zip(*(block.rect for block in given), strict=True)
    rect = min(low_x), min(low_y), max(high_x), max(high_y)
    return Block([piece for block in given for piece in block.pieces], rect)


def in_line(blocks: Sequence[Block], gap: float, *, upright: bool = False) -> Block:
    """Side by side along x (or y), their middles on one line."""
    edge = 0.0
    for block in blocks:
        size = block.depth if upright else block.width
        middle = edge + size / 2
        block.move_to(0.0, middle) if upright else block.move_to(middle, 0.0)
        edge = middle + size / 2 + gap
    return joined(blocks).move_to(0.0, 0.0)


def in_grid(blocks: Sequence[Block], columns: int, gap: float) -> Block:
    """Lines of like pitch, one behind the other."""
    pitch_x = max((block.width for block in blocks), default=0.0) + gap
    pitch_y = max((block.depth for block in blocks), default=0.0) + gap
    for index, block in enumerate(blocks):
        block.move_to(index % columns * pitch_x, index // columns * pitch_y)
    return joined(blocks).move_to(0.0, 0.0)


def on_top(base: Piece, blocks: Sequence[PaletteItem]) -> list[Piece]:
    """As many of the items as have room on top of a piece, in lines along its longer side."""
    half_x, half_y = base.half
    placed: list[Piece] = []
    x, y, line = -half_x * 0.92, -half_y * 0.92, 0.0
    rest = list(blocks)
    if len(rest) == 1 and rest[0].width <= 2 * half_x and rest[0].depth <= 2 * half_y:
        return [Piece(rest[0], base.x, base.y, on=base)]
    for item in sorted(rest, key=lambda item: -item.depth):
        if x + item.width > half_x * 0.92:
            x, y, line = -half_x * 0.92, y + line + 0.03, 0.0
        if y + item.depth > half_y or x + item.width > half_x:
            continue
        placed.append(Piece(item, base.x + x + item.width / 2, base.y + y + item.depth / 2, on=base))
        x, line = x + item.width + 0.05, max(line, item.depth)
    return placed


def tiled(item: PaletteItem, rect: Rect, most: int = 60) -> Block:
    """Flat pieces of one asset edge to edge over at least a rectangle, enlarged where it would take too many."""
    width, depth = rect[2] - rect[0], rect[3] - rect[1]
    scale = 1.0
    while scale < 3.0 and _lines(width, item.width * scale) * _lines(depth, item.depth * scale) > most:
        scale += 0.25
    step_x, step_y = item.width * scale, item.depth * scale
    columns, lines = _lines(width, step_x), _lines(depth, step_y)
    x, y = (rect[0] + rect[2]) / 2, (rect[1] + rect[3]) / 2
    return grouped(
        Piece(item, x + (i - (columns - 1) / 2) * step_x, y + (j - (lines - 1) / 2) * step_y, scale=scale)
        for i in range(columns)
        for j in range(lines)
    )


def _lines(length: float, step: float) -> int:
    return max(1, math.ceil(length / step - 0.05))


def overlap(one: Rect, other: Rect) -> bool:
    """Whether two rectangles share ground."""
    return (
        one[0] < other[2] - 1e-6 and other[0] < one[2] - 1e-6 and one[1] < other[3] - 1e-6 and other[1] < one[3] - 1e-6
    )


def settle(block: Block, places: Iterator[tuple[float, float]], taken: Sequence[Rect], reach: float) -> bool:
    """Move a block to the first of the places where it is free of what is taken, within the reach; whether it was."""
    for x, y in places:
        half_x, half_y = block.width / 2, block.depth / 2
        if abs(x) + half_x > reach or abs(y) + half_y > reach:
            continue
        rect = (x - half_x, y - half_y, x + half_x, y + half_y)
        if not any(overlap(rect, other) for other in taken):
            block.move_to(x, y)
            return True
    return False
