"""A named thing in all its copies with what stands on and near it, as one block in which nothing overlaps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import cycle, islice

from c4s.agents.baselines.blocks import Block, in_grid, in_line, joined, on_top, single
from c4s.agents.baselines.naming import is_flat
from c4s.agents.baselines.nesting import Forest, stands_on
from c4s.agents.baselines.palette import PaletteItem
from c4s.agents.baselines.reading import Mention

LARGE_M = 6.0


class Grouping:
    """Builds the blocks of one forest."""

    def __init__(self, forest: Forest) -> None:
        self._forest = forest

    def block(self, named: Mention) -> Block:
        """A thing that is neither a place nor a strip, in all its copies, with what belongs to it."""
        kids = self._forest.kids.get(named, [])
        if not named.items:
            return self._beside(Block(), [kid for _, kid in kids])
        if all(is_flat(item) for item in named.items):
            return self._flat(named, kids)
        units = [single(item) for item in islice(cycle(named.items), _count(named))]
        above = [kid for kind, kid in kids if kind == "on" and stands_on(named.items, kid.items)]
        tops: list[list[PaletteItem]] = [[] for _ in units]
        for kid in above:
            for index, item in enumerate(islice(cycle(kid.items), _count(kid, len(tops)))):
                tops[index % len(tops)].append(item)
        for unit, items in zip(units, tops, strict=True):
            unit.pieces += on_top(unit.pieces[0], items)
        gap = _gap(units[0])
        block = in_grid(units, math.ceil(math.sqrt(len(units))), gap) if len(units) > 3 else in_line(units, gap)
        beside = [kid for _, kid in kids if kid not in above]
        if not beside and len(units) > 1:
            block.units = tuple(units)
        return self._beside(block, beside)

    def _flat(self, named: Mention, kids: Sequence[tuple[str, Mention]]) -> Block:
        """A rug, or a patch of ground, under what stands on it."""
        item = named.items[0]
        over = in_line([self.block(kid) for kind, kid in kids if kind == "on"], 0.3)
        block = joined([single(item), over.raise_by(item.height)])
        return self._beside(block, [kid for kind, kid in kids if kind != "on"])

    def _beside(self, block: Block, kids: Sequence[Mention]) -> Block:
        """What else belongs to it, along its sides in turn: right, left, behind, in front."""
        for index, kid in enumerate(kids):
            other = self.block(kid)
            if not other.pieces:
                continue
            if not block.pieces:
                block = other
                continue
            order = [block, other] if index % 2 == 0 else [other, block]
            block = in_line(order, min(_gap(block), _gap(other)), upright=index % 4 > 1)
        return block


def _count(named: Mention, bases: int = 1) -> int:
    """How often it stands: as said; else one, in the plural a few, or one on each of several bases."""
    if named.counted or not named.plural:
        return named.count
    if bases > 1:
        return bases
    size = max(max(item.width, item.depth) for item in named.items)
    return max(len(named.items), 3 if size > LARGE_M else 4)


def _gap(block: Block) -> float:
    """Room to walk between things of a size."""
    return min(1.5, max(0.15, 0.2 * min(block.width, block.depth)))
