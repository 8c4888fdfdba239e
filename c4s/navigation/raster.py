"""Rasterising convex solids into spans of a height field, as Recast does it (``rcRasterizeTriangles``).

All lengths are in cells here: x and y by the cell size, z by the cell height, from the field's corner. A convex body
fills each column between the lowest and the highest of its surface there, so nobody can walk inside it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from c4s.navigation.compiled import inner, kernel

_FAR = 1e300
_HAIR = 1e-6
"""Heights this near to a step are on it: rounding raises no floor by a step."""
_MOST_POINTS = 12


@inner
def _clip(points: Any, count: int, out: Any, axis: int, at: float, sign: float) -> int:
    """The part of a polygon where ``sign * (coordinate - at) >= 0``; returns how many points ``out`` has then."""
    made = 0
    for index in range(count):
        nxt = index + 1 if index + 1 < count else 0
        here = sign * (points[index, axis] - at)
        there = sign * (points[nxt, axis] - at)
        if here >= 0.0:
            for part in range(3):
                out[made, part] = points[index, part]
            made += 1
        if (here > 0.0 and there < 0.0) or (here < 0.0 and there > 0.0):
            share = here / (here - there)
            for part in range(3):
                out[made, part] = points[index, part] + share * (points[nxt, part] - points[index, part])
            out[made, axis] = at
            made += 1
    return made


@inner
def _mark(field: Any, touched: Any, row: int, column: int, low: float, high: float, walkable: bool) -> None:
    if low < field[0, row, column]:
        field[0, row, column] = low
    if high > field[1, row, column]:
        field[1, row, column] = high
    if walkable and high > field[2, row, column]:
        field[2, row, column] = high
    if column < touched[row, 0]:
        touched[row, 0] = column
    if column > touched[row, 1]:
        touched[row, 1] = column


@inner
def _cross(triangle: Any, y: float, ends: Any) -> None:
    """Where a triangle crosses a line of constant y: its least and greatest x there."""
    ends[0], ends[1] = _FAR, -_FAR
    for index in range(3):
        nxt = index + 1 if index < 2 else 0
        ya, yb = triangle[index, 1], triangle[nxt, 1]
        if (ya <= y <= yb) or (yb <= y <= ya):
            xa, xb = triangle[index, 0], triangle[nxt, 0]
            if ya == yb:
                left, right = min(xa, xb), max(xa, xb)
            else:
                left = xa + (y - ya) / (yb - ya) * (xb - xa)
                right = left
            ends[0] = min(ends[0], left)
            ends[1] = max(ends[1], right)


@inner
def _draw(triangle: Any, walkable: bool, window: Any, field: Any, touched: Any, work: Any) -> None:
    """Mark what of each column one triangle meets. ``window``: first column and row, columns and rows of the field."""
    x0, y0, columns, rows = window
    low_y = min(triangle[0, 1], triangle[1, 1], triangle[2, 1])
    high_y = max(triangle[0, 1], triangle[1, 1], triangle[2, 1])
    first = max(int(np.floor(low_y)) - y0, 0)
    last = min(int(np.floor(high_y)) - y0, rows - 1)
    ax, ay = triangle[1, 0] - triangle[0, 0], triangle[1, 1] - triangle[0, 1]
    az = triangle[1, 2] - triangle[0, 2]
    bx, by = triangle[2, 0] - triangle[0, 0], triangle[2, 1] - triangle[0, 1]
    bz = triangle[2, 2] - triangle[0, 2]
    area = ax * by - ay * bx
    flat = abs(area) > 1e-9
    slope_x = slope_y = 0.0
    if flat:
        slope_x = (az * by - ay * bz) / area
        slope_y = (ax * bz - az * bx) / area
    below = min(slope_x, 0.0) + min(slope_y, 0.0)
    above = max(slope_x, 0.0) + max(slope_y, 0.0)
    one, two, ends = work[0], work[1], work[2, 0]
    for row in range(first, last + 1):
        y = float(row + y0)
        count = _clip(triangle, 3, one, 1, y, 1.0)
        count = _clip(one, count, two, 1, y + 1.0, -1.0)
        if count == 0:
            continue
        left, right = _FAR, -_FAR
        for index in range(count):
            left, right = min(left, two[index, 0]), max(right, two[index, 0])
        from_x = max(int(np.floor(left)) - x0, 0)
        to_x = min(int(np.floor(right)) - x0, columns - 1)
        inner_from, inner_to = 1.0, 0.0
        if flat and low_y <= y and y + 1.0 <= high_y:
            _cross(triangle, y, ends)
            inner_from, inner_to = ends[0], ends[1]
            _cross(triangle, y + 1.0, ends)
            inner_from, inner_to = max(inner_from, ends[0]), min(inner_to, ends[1])
        for column in range(from_x, to_x + 1):
            x = float(column + x0)
            if x >= inner_from and x + 1.0 <= inner_to:
                z = triangle[0, 2] + slope_x * (x - triangle[0, 0]) + slope_y * (y - triangle[0, 1])
                _mark(field, touched, row, column, z + below, z + above, walkable)
                continue
            cut = _clip(two, count, one, 0, x, 1.0)
            if cut == 0:
                continue
            low, high = _FAR, -_FAR
            held = _clip(one, cut, work[3], 0, x + 1.0, -1.0)
            for index in range(held):
                low, high = min(low, work[3, index, 2]), max(high, work[3, index, 2])
            if held:
                _mark(field, touched, row, column, low, high, walkable)


@kernel
def rasterise(
    triangles: Any, first_triangle: Any, walkable: Any, windows: Any, columns: int, tall: int, climb: int, most: int
) -> Any:
    """Spans of all bodies, in their order: ``(column, bottom, top, walkable, whether they are all)``.

    Args:
        triangles: (m, 3, 3) float64, the triangles of a body in a row.
        first_triangle: (bodies + 1) where each body's triangles begin.
        walkable: (m) whether a triangle is flat enough to stand on.
        windows: (bodies, 4) first column, first row, columns and rows that a body may touch.
        columns: of the whole field; the number of a column is ``row * columns + column``.
        tall: height of the field; nobody stands above it.
        climb: in steps; a top this much below the body's highest still tells what it is to stand on.
        most: how many spans there may be.
    """
    widest = tallest = 1
    for body in range(len(windows)):
        widest, tallest = max(widest, windows[body, 2]), max(tallest, windows[body, 3])
    field = np.empty((3, tallest, widest))
    field[0] = _FAR
    field[1:] = -_FAR
    touched = np.empty((tallest, 2), np.int64)
    touched[:, 0] = widest
    touched[:, 1] = -1
    work = np.empty((4, _MOST_POINTS, 3))
    size = 1 << 16
    where, bottom, top = np.empty(size, np.int32), np.empty(size, np.int32), np.empty(size, np.int32)
    stands = np.empty(size, np.uint8)
    made = 0
    for body in range(len(windows)):
        window = (windows[body, 0], windows[body, 1], windows[body, 2], windows[body, 3])
        for index in range(first_triangle[body], first_triangle[body + 1]):
            _draw(triangles[index], walkable[index], window, field, touched, work)
        for row in range(windows[body, 3]):
            if touched[row, 1] < 0:
                continue
            needed = made + touched[row, 1] - touched[row, 0] + 1
            if needed > most:
                return where[:0], bottom[:0], top[:0], stands[:0], False
            while needed > size:
                size *= 2
                where = np.concatenate((where, np.empty(size - len(where), np.int32)))
                bottom = np.concatenate((bottom, np.empty(size - len(bottom), np.int32)))
                top = np.concatenate((top, np.empty(size - len(top), np.int32)))
                stands = np.concatenate((stands, np.empty(size - len(stands), np.uint8)))
            base = (row + windows[body, 1]) * columns + windows[body, 0]
            for column in range(touched[row, 0], touched[row, 1] + 1):
                if field[1, row, column] > -_FAR:
                    peak = field[1, row, column]
                    if peak > -1.0 and field[0, row, column] < tall:
                        low = int(np.floor(max(field[0, row, column], -1.0) + _HAIR))
                        high = max(int(np.ceil(min(peak, tall + 1.0) - _HAIR)), low + 1)
                        where[made], bottom[made], top[made] = base + column, low, high
                        stands[made] = 1 if peak <= tall and field[2, row, column] >= peak - climb else 0
                        made += 1
                    field[0, row, column] = _FAR
                    field[1, row, column] = -_FAR
                    field[2, row, column] = -_FAR
            touched[row, 0] = widest
            touched[row, 1] = -1
    return where[:made], bottom[:made], top[:made], stands[:made], True


@inner
def _sort(bottom: Any, top: Any, stands: Any, first: int, last: int) -> None:
    """Order the spans ``first`` to ``last`` by the first array, in place (heap sort where there are many)."""
    if last - first <= 24:
        for index in range(first + 1, last):
            low, high, walk = bottom[index], top[index], stands[index]
            at = index - 1
            while at >= first and bottom[at] > low:
                bottom[at + 1], top[at + 1], stands[at + 1] = bottom[at], top[at], stands[at]
                at -= 1
            bottom[at + 1], top[at + 1], stands[at + 1] = low, high, walk
        return
    count = last - first
    for start in range(count // 2 - 1, -1, -1):
        _sift(bottom, top, stands, first, start, count)
    for end in range(count - 1, 0, -1):
        a, b = first, first + end
        bottom[a], bottom[b] = bottom[b], bottom[a]
        top[a], top[b] = top[b], top[a]
        stands[a], stands[b] = stands[b], stands[a]
        _sift(bottom, top, stands, first, 0, end)


@inner
def _sift(bottom: Any, top: Any, stands: Any, first: int, start: int, count: int) -> None:
    at = start
    while 2 * at + 1 < count:
        child = 2 * at + 1
        if child + 1 < count and bottom[first + child] < bottom[first + child + 1]:
            child += 1
        if bottom[first + at] >= bottom[first + child]:
            return
        a, b = first + at, first + child
        bottom[a], bottom[b] = bottom[b], bottom[a]
        top[a], top[b] = top[b], top[a]
        stands[a], stands[b] = stands[b], stands[a]
        at = child


@kernel
def merge(where: Any, bottom: Any, top: Any, stands: Any, columns: int, climb: int) -> Any:
    """Spans by column, those that overlap or touch as one: ``(first, bottom, top, walkable)``.

    ``first`` (columns + 1) tells where a column's spans begin; they rise. Of spans that become one the highest tells
    whether it can be stood on; one that ends within ``climb`` under it may tell so too, and so on downwards. The order
    of the given spans plays no part.
    """
    first = np.zeros(columns + 1, np.int32)
    for index in range(len(where)):
        first[where[index] + 1] += 1
    for column in range(columns):
        first[column + 1] += first[column]
    place = first[:-1].copy()
    low, high, walk = np.empty(len(where), np.int32), np.empty(len(where), np.int32), np.empty(len(where), np.uint8)
    for index in range(len(where)):
        at = place[where[index]]
        low[at], high[at], walk[at] = bottom[index], top[index], stands[index]
        place[where[index]] = at + 1
    made = 0
    begin = first[0]
    for column in range(columns):
        end = first[column + 1]
        first[column] = made
        if end - begin > 1:
            _sort(low, high, walk, begin, end)
        index = begin
        while index < end:
            start, peak = index, high[index]
            floor = low[index]
            index += 1
            while index < end and low[index] <= peak:
                peak = max(peak, high[index])
                index += 1
            if index - start > 1:
                _sort(high, low, walk, start, index)
            on = walk[start]
            for member in range(start + 1, index):
                near = high[member] - high[member - 1] <= climb
                on = max(on, walk[member]) if near else walk[member]
            low[made], high[made], walk[made] = floor, peak, on
            made += 1
        begin = end
    first[columns] = made
    return first, low[:made], high[:made], walk[:made]
