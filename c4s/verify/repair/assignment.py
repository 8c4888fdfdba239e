"""One-to-one matching: maximum cardinality by augmenting paths, and minimum cost by successive shortest paths.

The cost solver is our own because ties must fall as the benchmark's scorer lets them fall (scorer fact 2.8): rows enter
one by one, and among columns of equal reduced cost the lower index wins. SciPy's solver breaks ties differently.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

MOST_PLAIN: Final = 100_000
"""Steps of a table, at worst, up to which it is solved without compiled code."""


def maximum_matching(
    left: Iterable[int], edges: Callable[[int], Sequence[int]], taken: dict[int, int] | None = None
) -> dict[int, int]:
    """Maximum-cardinality matching, ``{left: right}``.

    ``left`` nodes enter in order and, once matched, stay matched. ``edges(node)`` lists the right nodes of a left
    node, preferred first; a free one is taken before others are moved. Right nodes in ``taken`` (right to left)
    belong to others and stay there.
    """
    closed = set(taken or ())
    owner: dict[int, int] = {}
    held: dict[int, int] = {}
    free: dict[int, Iterator[int]] = {}
    for root in left:
        seen: set[int] = set()
        path = [(root, iter(edges(root)))]
        while path:
            node, options = path[-1]
            if node not in free:
                free[node] = iter(edges(node))
            end = next((r for r in free[node] if r not in owner and r not in closed), None)
            if end is not None:
                freed = [held[successor] for successor, _ in path[1:]] + [end]
                for (member, _), taken_now in zip(path, freed, strict=True):
                    owner[taken_now], held[member] = member, taken_now
                break
            right = next((r for r in options if r not in seen and r not in closed), None)
            if right is None:
                path.pop()
                continue
            seen.add(right)
            path.append((owner[right], iter(edges(owner[right]))))
        else:
            closed |= seen
    return held


def minimum_cost(cost: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Pairs ``(row, column)`` of a minimum-cost assignment of ``min(rows, columns)`` pairs, by row."""
    if cost.size == 0:
        return []
    if cost.shape[0] > cost.shape[1]:
        return sorted((row, column) for column, row in minimum_cost(np.ascontiguousarray(cost.T)))
    if cost.shape[0] * cost.size <= MOST_PLAIN:
        return list(enumerate(assigned(cost.tolist())))
    from c4s.verify.repair import compiled

    return list(enumerate(compiled.assigned(np.ascontiguousarray(cost)).tolist()))


def assigned(cost: list[list[float]]) -> list[int]:
    """``compiled.assigned`` step for step in plain Python: to load compiled code takes longer than a small table."""
    rows, columns = len(cost), range(len(cost[0]))
    row_dual, column_dual = [0.0] * rows, [0.0 for _ in columns]
    row_of, previous = [-1 for _ in columns], [0 for _ in columns]
    for row in range(rows):
        current, column, step = row, -1, 0.0
        slack = [math.inf for _ in columns]
        met: list[tuple[int, float, float]] = []
        while True:
            for other in columns:
                reduced = (cost[current][other] - row_dual[current]) - column_dual[other] + 0.0
                slack[other] -= step
                if reduced < slack[other]:
                    slack[other], previous[other] = reduced, column
            column = min((other for other in columns if not math.isnan(slack[other])), key=slack.__getitem__)
            step = slack[column]
            row_dual[row] += step
            met = [(place, up + step, down - step) for place, up, down in met]
            if row_of[column] == -1:
                break
            current = row_of[column]
            met.append((column, row_dual[current], column_dual[column]))
            slack[column] = math.nan
        for place, up, down in met:
            column_dual[place], row_dual[row_of[place]] = down, up
        while column != -1:
            before = previous[column]
            row_of[column] = row if before == -1 else row_of[before]
            column = before
    return [row_of.index(row) for row in range(rows)]
