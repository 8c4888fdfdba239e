"""What of a height field can be walked on: Recast's filters, compact field, erosion and regions, in steps and cells."""

from __future__ import annotations

from typing import Any

import numpy as np

from c4s.navigation.compiled import inner, kernel

NOWHERE = -1
_OPEN = 1 << 30
"""Height of the sky, and depth of where there is nothing."""


@kernel
def low_obstacles(first: Any, top: Any, walkable: Any, climb: int) -> None:
    """What is too steep to stand on but no higher than a step above what is not, can be stepped on."""
    for column in range(len(first) - 1):
        before = False
        for index in range(first[column], first[column + 1]):
            now = walkable[index] != 0
            if not now and before and top[index] - top[index - 1] <= climb:
                walkable[index] = 1
            before = now


@inner
def _ceiling(first: Any, bottom: Any, column: int, index: int) -> int:
    """What is above a span of a column."""
    return bottom[index + 1] if index + 1 < first[column + 1] else _OPEN


@inner
def _is_ledge(
    first: Any, bottom: Any, top: Any, index: int, ceiling: int, beside: int, height: int, climb: int, reach: Any
) -> bool:
    """Whether the drop into the column ``beside`` is deeper than a step; widens ``reach`` by what can be stepped to."""
    floor = top[index]
    opening = bottom[first[beside]] if first[beside] < first[beside + 1] else _OPEN
    if min(ceiling, opening) - floor > height:
        return True
    for other in range(first[beside], first[beside + 1]):
        above = _ceiling(first, bottom, beside, other)
        if min(ceiling, above) - max(floor, top[other]) > height:
            step = top[other] - floor
            if step < -climb:
                return True
            if step <= climb:
                reach[0], reach[1] = min(reach[0], top[other]), max(reach[1], top[other])
    return False


@kernel
def ledges(first: Any, bottom: Any, top: Any, walkable: Any, columns: int, rows: int, height: int, climb: int) -> Any:
    """``walkable`` without spans beside a drop, on too steep a stair, or under too low a ceiling."""
    kept = walkable.copy()
    reach = np.empty(2, np.int64)
    for row in range(rows):
        for column in range(columns):
            number = row * columns + column
            for index in range(first[number], first[number + 1]):
                if not walkable[index]:
                    continue
                ceiling = _ceiling(first, bottom, number, index)
                if (
                    ceiling - top[index] <= height
                    or column == 0
                    or row == 0
                    or column == columns - 1
                    or row == rows - 1
                ):
                    kept[index] = 0
                    continue
                reach[0] = reach[1] = top[index]
                if (
                    _is_ledge(first, bottom, top, index, ceiling, number - 1, height, climb, reach)
                    or _is_ledge(first, bottom, top, index, ceiling, number + 1, height, climb, reach)
                    or _is_ledge(first, bottom, top, index, ceiling, number - columns, height, climb, reach)
                    or _is_ledge(first, bottom, top, index, ceiling, number + columns, height, climb, reach)
                    or reach[1] - reach[0] > climb
                ):
                    kept[index] = 0
    return kept


@kernel
def compact(first: Any, bottom: Any, top: Any, walkable: Any) -> Any:
    """The walkable spans alone: ``(first, floor, ceiling)`` by column."""
    count = 0
    for index in range(len(walkable)):
        count += walkable[index] != 0
    starts = np.empty(len(first), np.int32)
    floor, above = np.empty(count, np.int32), np.empty(count, np.int32)
    made = 0
    for column in range(len(first) - 1):
        starts[column] = made
        for index in range(first[column], first[column + 1]):
            if walkable[index]:
                floor[made] = top[index]
                above[made] = _ceiling(first, bottom, column, index)
                made += 1
    starts[len(first) - 1] = made
    return starts, floor, above


@inner
def _beside(first: Any, floor: Any, above: Any, index: int, column: int, height: int, climb: int) -> int:
    for other in range(first[column], first[column + 1]):
        room = min(above[index], above[other]) - max(floor[index], floor[other])
        if room >= height and abs(floor[other] - floor[index]) <= climb:
            return other
    return NOWHERE


@kernel
def connect(first: Any, floor: Any, above: Any, columns: int, rows: int, height: int, climb: int) -> Any:
    """Where one gets from each walkable span: (spans, 4) towards -x, +y, +x, -y; ``NOWHERE`` where one does not."""
    links = np.full((len(floor), 4), NOWHERE, np.int32)
    for row in range(rows):
        for column in range(columns):
            number = row * columns + column
            for index in range(first[number], first[number + 1]):
                if column > 0:
                    links[index, 0] = _beside(first, floor, above, index, number - 1, height, climb)
                if row + 1 < rows:
                    links[index, 1] = _beside(first, floor, above, index, number + columns, height, climb)
                if column + 1 < columns:
                    links[index, 2] = _beside(first, floor, above, index, number + 1, height, climb)
                if row > 0:
                    links[index, 3] = _beside(first, floor, above, index, number - columns, height, climb)
    return links


@kernel
def erode(links: Any, radius: int) -> Any:
    """Which spans keep the body's radius (cells) from all that cannot be walked on: (spans) 0 or 1."""
    count = len(links)
    far = 255
    distance = np.full(count, far, np.uint8)
    for index in range(count):
        for side in range(4):
            if links[index, side] == NOWHERE:
                distance[index] = 0
                break
    for index in range(count):
        best = int(distance[index])
        for side, turn in ((0, 3), (3, 2)):
            other = links[index, side]
            if other != NOWHERE:
                best = min(best, distance[other] + 2)
                across = links[other, turn]
                if across != NOWHERE:
                    best = min(best, distance[across] + 3)
        distance[index] = best
    for index in range(count - 1, -1, -1):
        best = int(distance[index])
        for side, turn in ((2, 1), (1, 0)):
            other = links[index, side]
            if other != NOWHERE:
                best = min(best, distance[other] + 2)
                across = links[other, turn]
                if across != NOWHERE:
                    best = min(best, distance[across] + 3)
        distance[index] = best
    kept = np.empty(count, np.uint8)
    for index in range(count):
        kept[index] = 1 if distance[index] >= 2 * radius else 0
    return kept


@kernel
def regions(links: Any, kept: Any, least: int) -> Any:
    """The connected regions of what was kept: ``(region of each span, cells of each region)``.

    Regions of fewer than ``least`` cells are dropped; regions are numbered in the order of their first span.
    """
    region = np.full(len(links), NOWHERE, np.int32)
    sizes = np.zeros(16, np.int64)
    stack = np.empty(max(len(links), 1), np.int32)
    made = 0
    for start in range(len(links)):
        if not kept[start] or region[start] != NOWHERE:
            continue
        depth, used = 1, 0
        stack[0] = start
        region[start] = made
        while used < depth:
            index = stack[used]
            used += 1
            for side in range(4):
                other = links[index, side]
                if other != NOWHERE and kept[other] and region[other] == NOWHERE:
                    region[other] = made
                    stack[depth] = other
                    depth += 1
        if depth < least:
            for member in range(depth):
                region[stack[member]] = NOWHERE
                kept[stack[member]] = 0
            continue
        if made == len(sizes):
            sizes = np.concatenate((sizes, np.zeros(len(sizes), np.int64)))
        sizes[made] = depth
        made += 1
    return region, sizes[:made]
