"""One-to-one matching: maximum cardinality by augmenting paths, and minimum cost by successive shortest paths.

The cost solver is our own because ties must fall as the benchmark's scorer lets them fall (scorer fact 2.8): rows enter
one by one, and among columns of equal reduced cost the lower index wins. SciPy's solver breaks ties differently.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray


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


def _solve(cost: NDArray[np.float64]) -> list[int]:
    """Column of each row for ``rows <= columns``, by shortest augmenting paths with dual potentials.

    Column 0 stands for "the row that enters"; rows and columns of the matrix count from 1.
    """
    rows, columns = cost.shape
    padded = np.concatenate([np.full((rows, 1), np.inf), cost], axis=1)
    row_dual, column_dual = np.zeros(rows + 1), np.zeros(columns + 1)
    row_of, previous = np.zeros(columns + 1, np.int64), np.zeros(columns + 1, np.int64)
    for row in range(1, rows + 1):
        row_of[0], column = row, 0
        slack = np.full(columns + 1, np.inf)
        unseen = np.ones(columns + 1, np.bool_)
        seen: list[int] = []
        while True:
            seen.append(column)
            unseen[column], slack[column] = False, np.inf
            current = row_of[column]
            reduced = padded[current - 1] - row_dual[current]
            reduced -= column_dual
            better = reduced < slack
            better &= unseen
            np.copyto(slack, reduced, where=better)
            previous[better] = column
            nearest = int(slack.argmin())
            step = slack[nearest]
            row_dual[row_of[seen]] += step
            column_dual[seen] -= step
            slack -= step
            column = nearest
            if row_of[column] == 0:
                break
        while column != 0:
            row_of[column] = row_of[previous[column]]
            column = int(previous[column])
    result = [0] * rows
    for column in map(int, np.nonzero(row_of)[0]):
        if column:
            result[row_of[column] - 1] = column - 1
    return result


def minimum_cost(cost: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Pairs ``(row, column)`` of a minimum-cost assignment of ``min(rows, columns)`` pairs, by row."""
    if cost.size == 0:
        return []
    if cost.shape[0] > cost.shape[1]:
        return sorted((row, column) for column, row in minimum_cost(np.ascontiguousarray(cost.T)))
    return list(enumerate(_solve(cost)))
