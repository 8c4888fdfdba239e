"""One-to-one matching: maximum cardinality by augmenting paths, and minimum cost by successive shortest paths.

The cost solver is our own because ties must fall as the benchmark's scorer lets them fall (scorer fact 2.8): rows enter
one by one, and among columns of equal reduced cost the lower index wins. SciPy's solver breaks ties differently.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

_COMPILE_FROM = 4000
"""Entries of a cost matrix from which the compiled loop repays loading the compiler."""


def maximum_matching(left: Iterable[int], edges: Callable[[int], Sequence[int]],
                     taken: dict[int, int] | None = None) -> dict[int, int]:
    """Maximum-cardinality matching, ``{left: right}``.

    ``left`` nodes enter in order and, once matched, stay matched; ``edges(node)`` lists the right nodes of a left
    node, preferred first. Right nodes in ``taken`` (right to left) belong to others and stay there.
    """
    reserved = taken or {}
    owner: dict[int, int] = {}
    held: dict[int, int] = {}
    for root in left:
        seen: set[int] = set()
        path = [(root, iter(edges(root)))]
        while path:
            node, options = path[-1]
            right = next((r for r in options if r not in seen and r not in reserved), None)
            if right is None:
                path.pop()
                continue
            seen.add(right)
            if right in owner:
                path.append((owner[right], iter(edges(owner[right]))))
                continue
            freed = [held[successor] for successor, _ in path[1:]] + [right]
            for (member, _), taken_now in zip(path, freed, strict=True):
                owner[taken_now], held[member] = member, taken_now
            break
    return held


def _solve(cost: Any) -> Any:
    """Column of each row for ``rows <= columns``, by shortest augmenting paths with dual potentials."""
    rows, columns = cost.shape
    row_dual, column_dual = np.zeros(rows + 1), np.zeros(columns + 1)
    row_of, previous = np.zeros(columns + 1, np.int64), np.zeros(columns + 1, np.int64)
    for row in range(1, rows + 1):
        row_of[0] = row
        column = 0
        slack = np.full(columns + 1, np.inf)
        seen = np.zeros(columns + 1, np.bool_)
        while True:
            seen[column] = True
            current, step, best = row_of[column], np.inf, -1
            for j in range(1, columns + 1):
                if seen[j]:
                    continue
                reduced = cost[current - 1, j - 1] - row_dual[current] - column_dual[j]
                if reduced < slack[j]:
                    slack[j] = reduced
                    previous[j] = column
                if slack[j] < step:
                    step = slack[j]
                    best = j
            for j in range(columns + 1):
                if seen[j]:
                    row_dual[row_of[j]] += step
                    column_dual[j] -= step
                else:
                    slack[j] -= step
            column = best
            if row_of[column] == 0:
                break
        while column != 0:
            row_of[column] = row_of[previous[column]]
            column = previous[column]
    result = np.zeros(rows, np.int64)
    for j in range(1, columns + 1):
        if row_of[j] > 0:
            result[row_of[j] - 1] = j - 1
    return result


@cache
def _compiled() -> Callable[[Any], Any]:
    from numba import njit

    compiled: Callable[[Any], Any] = njit(cache=True)(_solve)
    return compiled


def minimum_cost(cost: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Pairs ``(row, column)`` of a minimum-cost assignment of ``min(rows, columns)`` pairs, by row."""
    if cost.size == 0:
        return []
    if cost.shape[0] > cost.shape[1]:
        return sorted((row, column) for column, row in minimum_cost(np.ascontiguousarray(cost.T)))
    solve = _compiled() if cost.size >= _COMPILE_FROM else _solve
    return [(row, int(column)) for row, column in enumerate(solve(np.ascontiguousarray(cost, dtype=np.float64)))]
