"""Ways through a walkable space: distances, routes over cells, and their straightening."""

from __future__ import annotations

from typing import Any

import numpy as np

from c4s.navigation.compiled import inner, kernel

STRAIGHT, DIAGONAL = 5, 7
"""What a step to the next cell, and across a corner, costs."""
_SIDES = ((-1, 0), (0, 1), (1, 0), (0, -1))
_FAR = 1 << 30


@inner
def _across(links: Any, region: Any, index: int, side: int) -> int:
    """The span across the corner between ``side`` and the next one, where both ways around it lead there; else -1."""
    turn = (side + 1) & 3
    one, two = links[index, side], links[index, turn]
    if one < 0 or two < 0 or region[one] < 0 or region[two] < 0:
        return -1
    first, second = links[one, turn], links[two, side]
    if first < 0 or first != second or region[first] < 0:
        return -1
    return int(first)


@kernel
def spread(links: Any, region: Any, start: int) -> Any:
    """Cost of the cheapest way from a span to every other, and the span before it on that way (-1: none).

    A bucket queue (Dial): costs are small integers, so the frontier never spans more than ``DIAGONAL`` + 1 of them.
    """
    cost = np.full(len(links), _FAR, np.int32)
    before = np.full(len(links), -1, np.int32)
    ring = DIAGONAL + 1
    size = 1024
    queue = np.empty((ring, size), np.int32)
    held = np.zeros(ring, np.int64)
    cost[start] = 0
    queue[0, 0] = start
    held[0] = 1
    now, empty = 0, 0
    while empty < ring:
        slot = now % ring
        if held[slot] == 0:
            empty += 1
            now += 1
            continue
        empty = 0
        held[slot] -= 1
        index = queue[slot, held[slot]]
        if cost[index] != now:
            continue
        for move in range(8):
            side = move & 3
            if move < 4:
                other = links[index, side]
                if other < 0 or region[other] < 0:
                    continue
                reached = now + STRAIGHT
            else:
                other = _across(links, region, index, side)
                if other < 0:
                    continue
                reached = now + DIAGONAL
            if reached < cost[other]:
                cost[other], before[other] = reached, index
                into = reached % ring
                if held[into] == size:
                    wider = np.empty((ring, 2 * size), np.int32)
                    wider[:, :size] = queue
                    queue, size = wider, 2 * size
                queue[into, held[into]] = other
                held[into] += 1
    return cost, before


@inner
def _sees(links: Any, region: Any, column: Any, columns: int, start: int, goal: int) -> bool:
    """Whether the straight line between two cell centres stays on what can be walked on, and leads from one to the
    other."""
    x, y = column[start] % columns, column[start] // columns
    to_x, to_y = column[goal] % columns, column[goal] // columns
    right, up = 2 if to_x > x else 0, 1 if to_y > y else 3
    wide, deep = abs(to_x - x), abs(to_y - y)
    at, i, j = start, 0, 0
    while i < wide or j < deep:
        ahead = (1 + 2 * i) * deep - (1 + 2 * j) * wide
        if ahead == 0:
            side = right if (right + 1) & 3 == up else up
            at = _across(links, region, at, side)
            i += 1
            j += 1
        elif ahead < 0:
            at = links[at, right]
            i += 1
        else:
            at = links[at, up]
            j += 1
        if at < 0 or region[at] < 0:
            return False
    return at == goal


@kernel
def straighten(links: Any, region: Any, column: Any, columns: int, way: Any) -> Any:
    """The corners of a way over spans, each in sight of the one before; the body's clearance is that of the cells."""
    corners = np.empty(len(way), np.int32)
    corners[0] = way[0]
    made, anchor = 1, 0
    for index in range(1, len(way) - 1):
        if not _sees(links, region, column, columns, way[anchor], way[index + 1]):
            corners[made] = way[index]
            made += 1
            anchor = index
    if len(way) > 1:
        corners[made] = way[len(way) - 1]
        made += 1
    return corners[:made]
