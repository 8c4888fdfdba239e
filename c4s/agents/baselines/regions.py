"""Places and strips: ground under what stands on and near it, a fence around a fenced place."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.agents.baselines.arranging import arrange
from c4s.agents.baselines.blocks import Block, Piece, grouped, in_line, joined, tiled
from c4s.agents.baselines.grouping import Grouping
from c4s.agents.baselines.naming import is_flat
from c4s.agents.baselines.nesting import Forest
from c4s.agents.baselines.palette import PaletteItem
from c4s.agents.baselines.reading import Link, Mention
from c4s.agents.baselines.walls import enclosed, is_thin

ENCLOSING = frozenset({"fence", "railing", "hedge", "wall", "parapet", "partition", "palisade"})
LENGTH_SHARE = 1.4
"""Of the way to the edge of the plate: how long a strip is."""
PLACE_GAP_M, ROOM_GAP_M, LANE_GAP_M = 1.2, 0.6, 0.8
LEAST_PLACE_M, PLACE_EDGE_M = 6.0, 0.5


class Regions:
    """Builds the blocks of places and strips, and of what belongs to them."""

    def __init__(self, forest: Forest, palette: Sequence[PaletteItem], reach: float) -> None:
        self._forest = forest
        self._grouping = Grouping(forest)
        self._palette = palette
        self._reach = reach
        self._length = LENGTH_SHARE * reach

    def block(self, named: Mention) -> Block:
        """Any root or member of a place."""
        if named.is_place:
            return self._place(named)
        if named.is_strip:
            return self._strip(named)
        return self._grouping.block(named)

    def laid(self, members: Sequence[Mention], gap: float) -> Block:
        """Members near those that they are said to be near."""
        blocks = {named: self.block(named) for named in members}
        blocks = {named: block for named, block in blocks.items() if block.pieces}
        return arrange(blocks, self._links(members), gap, self._reach)

    def _links(self, members: Sequence[Mention]) -> list[Link]:
        """The links between groups, as those of the members that hold their ends."""
        found = []
        for link in self._forest.between_groups:
            thing, other = self._member(link.thing, members), self._member(link.other, members)
            if thing is not None and other is not None and thing is not other:
                found.append(Link(link.kind, thing, other))
        return found

    def _member(self, named: Mention, members: Sequence[Mention]) -> Mention | None:
        return next((one for one in self._forest.line(named) if one in members), None)

    def _place(self, named: Mention) -> Block:
        """What belongs to a place; outdoors on its ground, within the fence that its adjective names (``fenced``)."""
        members = [kid for _, kid in self._forest.kids.get(named, [])]
        if self._forest.indoors:
            inner = self.laid(members, ROOM_GAP_M)
            return _on_tiles(inner, named) if inner.pieces else inner
        inner = self.laid(members, PLACE_GAP_M)
        fence = self._fence(named)
        if not inner.pieces and not named.items and fence is None:
            return inner
        lack = max(0.0, LEAST_PLACE_M - min(inner.width, inner.depth))
        inner = _on_tiles(inner.grown(lack / 2 + PLACE_EDGE_M), named)
        return enclosed(inner, [fence]) if fence else inner

    def _fence(self, named: Mention) -> PaletteItem | None:
        said = named.said & ENCLOSING
        found = [item for item in self._palette if item.words & said and is_thin(item)]
        return max(found, key=lambda item: max(item.width, item.depth), default=None)

    def _strip(self, named: Mention) -> Block:
        """Lanes along x on a strip of ground, or beside a row of walls."""
        lanes: list[list[Block]] = []
        for _, kid in self._forest.kids.get(named, []):
            block = self.block(kid)
            fitting = [lane for lane in lanes if sum(b.width + 3 for b in lane) + block.width < self._length]
            if fitting:
                fitting[0].append(block)
            elif block.pieces:
                lanes.append([block])
        content = in_line([in_line(lane, 2.0) for lane in lanes], LANE_GAP_M, upright=True)
        if not named.items:
            return content
        item = named.items[0]
        length = max(self._length, content.width + 1)
        if not is_flat(item):
            count = max(1, int(length // max(item.width, item.depth)))
            yaw = 0 if item.width >= item.depth else 90
            line = in_line([grouped([Piece(item, yaw=yaw)]) for _ in range(count)], 0.0)
            return in_line([line, content], 0.3, upright=True) if content.pieces else line
        depth = max(content.depth + 1.0, item.depth)
        tiles = tiled(item, (-length / 2, -depth / 2, length / 2, depth / 2), most=80)
        return joined([tiles, content.raise_by(item.height)])


def _on_tiles(inner: Block, named: Mention) -> Block:
    if not named.items:
        return inner
    return joined([tiled(named.items[0], inner.rect), inner.raise_by(named.items[0].height)])
