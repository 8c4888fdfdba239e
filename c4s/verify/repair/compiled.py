"""The kernels of the matching (``c4s.compiled``): costs of all pairs of a leftover group, and their assignment."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from c4s.compiled import Kernels, inner

_KERNELS = Kernels(Path(__file__).parent)
_SPLIT = 134217729.0
"""2**27 + 1: splits a number into two halves whose products are exact (Veltkamp)."""
_SCALE_BITS = 2045
"""The exponent bits of a number and of the power of two that brings it into [0.5, 1) sum up to this."""
_PLAIN = 1e150
"""Numbers up to this, and 0 or from its inverse, are scaled without a look at the ends of the range."""
_MOST = np.int64(2**63 - 1)
_BLOCK = 128
_DEGREES = 180.0 / math.pi
Table = NDArray[np.float64]
Numbers = NDArray[np.int64]


@inner
def _scaled(x: float, y: float, z: float) -> float:
    """Length of a vector whose largest part is in [0.5, 1): the rounding errors of squares and sums kept apart, and one
    correction of the root, as CPython 3.11's ``math.dist`` does it."""
    total, first, second, third = 1.0, 0.0, 0.0, 0.0
    for value in (x, y, z):
        split = value * _SPLIT
        high = split - (split - value)
        low = value - high
        part = high * high
        before = total
        total += part
        first += (before - total) + part
        part = 2.0 * high * low
        before = total
        total += part
        second += (before - total) + part
        third += low * low
    root = math.sqrt(total - 1.0 + (first + second + third))
    split = root * _SPLIT
    high = split - (split - root)
    low = root - high
    part = -high * high
    before = total
    total += part
    first += (before - total) + part
    part = -2.0 * high * low
    before = total
    total += part
    second += (before - total) + part
    part = -low * low
    before = total
    total += part
    third += (before - total) + part
    rest = total - 1.0 + (first + second + third)
    return root + rest / (2.0 * root)


@inner
def _distance(x: float, y: float, z: float) -> float:
    """Length of a vector as CPython 3.11's ``math.dist`` computes it, to the last bit."""
    largest = max(x, y, z)
    if math.isinf(x) or math.isinf(y) or math.isinf(z):
        return math.inf
    if math.isnan(x) or math.isnan(y) or math.isnan(z):
        return math.nan
    if largest == 0.0:
        return 0.0
    exponent = math.frexp(largest)[1]
    if exponent < -1023:
        return math.sqrt(x * x + y * y + z * z)
    scale = math.ldexp(1.0, -exponent)
    return _scaled(x * scale, y * scale, z * scale) / scale


@inner
def _distance_row(
    point: Table, columns: Table, largest: Table, scale: Table, bits: Numbers, scale_bits: Numbers, made: Table
) -> None:
    """Distance of a point and all points (3, n), in loops without a branch; ``bits`` are those of ``largest``, and
    ``scale_bits`` those of ``scale``, all of them scratch."""
    odd = 0
    for j in range(len(made)):
        x, y, z = abs(point[0] - columns[0, j]), abs(point[1] - columns[1, j]), abs(point[2] - columns[2, j])
        most = x if x > y else y
        most = most if most > z else z
        largest[j] = most
        plain = (x + y + z <= _PLAIN) & ((most >= 1.0 / _PLAIN) | (most == 0.0))
        odd += 0 if plain else 1
    for j in range(len(made)):
        scale_bits[j] = (_SCALE_BITS - (bits[j] >> 52)) << 52
    for j in range(len(made)):
        x, y, z = abs(point[0] - columns[0, j]), abs(point[1] - columns[1, j]), abs(point[2] - columns[2, j])
        length = _scaled(x * scale[j], y * scale[j], z * scale[j]) / scale[j]
        made[j] = 0.0 if largest[j] == 0.0 else length
    if odd:
        for j in range(len(made)):
            made[j] = _distance(
                abs(point[0] - columns[0, j]), abs(point[1] - columns[1, j]), abs(point[2] - columns[2, j])
            )


@_KERNELS.kernel
def distances(here: Table, there: Table) -> Table:
    """Distance of every pair of points (n, 3) and (m, 3); NaN where a coordinate is NaN."""
    made = np.empty((len(here), len(there)))
    columns = np.ascontiguousarray(there.T)
    largest, scale = np.empty(len(there)), np.empty(len(there))
    for i in range(len(here)):
        _distance_row(here[i], columns, largest, scale, largest.view(np.int64), scale.view(np.int64), made[i])
    return made


@_KERNELS.kernel
def angles(here: Table, there: Table) -> Table:
    """Angle of every pair of unit quaternions (n, 4) and (m, 4), in degrees; NaN where a part is NaN."""
    made = np.empty((len(here), len(there)))
    for i in range(len(here)):
        for j in range(len(there)):
            dot = 0.0
            for part in range(4):
                dot += here[i, part] * there[j, part]
            value = abs(dot)
            if value > 1.0:
                value = 1.0
            made[i, j] = 2.0 * math.acos(value) * _DEGREES
    return made


@_KERNELS.kernel
def costs(
    here: Table,
    there: Table,
    classes_here: Numbers,
    classes_there: Numbers,
    turned: Table,
    fields: Table,
    moved_cm: float,
    angle_cost: float,
    field_cost: float,
) -> Table:
    """Cost of every pair of actors.

    Args:
        here: locations (n, 3) in cm, NaN where unknown.
        there: locations (m, 3).
        classes_here: place in ``turned`` and ``fields`` of each of the n actors.
        classes_there: the same of the m actors.
        turned: what the angle is worth (angle / 180, 1 where unknown) of every pair of classes.
        fields: number of changed fields, location aside, of every pair of classes.
        moved_cm: from which gap along an axis a location is another one.
        angle_cost: weight of ``turned``.
        field_cost: weight of a field.
    """
    made = distances(here, there)
    columns = np.ascontiguousarray(there.T)
    for i in range(len(here)):
        turns, changes, row = turned[classes_here[i]] * angle_cost, fields[classes_here[i]], made[i]
        for j in range(len(there)):
            x, y, z = abs(here[i, 0] - columns[0, j]), abs(here[i, 1] - columns[1, j]), abs(here[i, 2] - columns[2, j])
            moved = (x > moved_cm) | (y > moved_cm) | (z > moved_cm)
            column = classes_there[j]
            cost = 1.0 if row[j] != row[j] else row[j] / (1.0 + row[j])
            row[j] = (cost + turns[column]) + field_cost * (changes[column] + (1.0 if moved else 0.0))
    return made


@inner
def _relaxed(
    costs: Table, row_dual: float, column_dual: Table, step: float, column: int, slack: Table, previous: Numbers
) -> None:
    """Take ``step`` off every slack and lower those that a row reaches for less, which come from ``column`` then.

    What is settled has NaN for a slack, which nothing is below. No slack is -0, whose bits are not those of 0.
    """
    for other in range(len(costs)):
        reduced = (costs[other] - row_dual) - column_dual[other] + 0.0
        known = slack[other] - step
        better = reduced < known
        slack[other] = reduced if better else known
        previous[other] = column if better else previous[other]


@inner
def _nearest(bits: Numbers) -> int:
    """The first of the least slacks by their ``bits``, read as whole numbers of the same order; NaN is above all."""
    found, least = 0, _MOST
    for start in range(0, len(bits), _BLOCK):
        lowest, block = _MOST, bits[start : start + _BLOCK]
        for other in range(len(block)):
            lowest = min(lowest, block[other] ^ ((block[other] >> 63) & _MOST))
        if lowest < least:
            found, least = start, lowest
    while bits[found] ^ ((bits[found] >> 63) & _MOST) != least:
        found += 1
    return found


@_KERNELS.kernel
def assigned(cost: Table) -> Numbers:
    """Column of each row for ``rows <= columns`` and finite costs, by shortest augmenting paths with dual potentials.

    Rows enter one by one; column -1 stands for where a row enters. The duals of what a row has met lie side by side
    until it has its place.
    """
    rows, columns = cost.shape
    row_dual, column_dual = np.zeros(rows), np.zeros(columns)
    row_of, previous = np.full(columns, -1, np.int64), np.zeros(columns, np.int64)
    slack = np.empty(columns)
    seen, up, down = np.empty(columns, np.int64), np.empty(columns), np.empty(columns)
    for row in range(rows):
        current, column, met, step = row, -1, 0, 0.0
        slack[:] = np.inf
        while True:
            _relaxed(cost[current], row_dual[current], column_dual, step, column, slack, previous)
            nearest = _nearest(slack.view(np.int64))
            step = slack[nearest]
            row_dual[row] += step
            for place in range(met):
                up[place] += step
                down[place] -= step
            column = nearest
            if row_of[column] == -1:
                break
            current = row_of[column]
            seen[met], up[met], down[met] = column, row_dual[current], column_dual[column]
            met += 1
            slack[column] = np.nan
        for place in range(met):
            column_dual[seen[place]], row_dual[row_of[seen[place]]] = down[place], up[place]
        while column != -1:
            before = previous[column]
            row_of[column] = row if before == -1 else row_of[before]
            column = before
    result = np.zeros(rows, np.int64)
    for column in range(columns):
        if row_of[column] != -1:
            result[row_of[column]] = column
    return result
