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


def minimum_cost(cost: NDArray[np.float64]) -> list[tuple[int, int]]:
    """Pairs ``(row, column)`` of a minimum-cost assignment of ``min(rows, columns)`` pairs, by row."""
    if cost.size == 0:
        return []
    if cost.shape[0] > cost.shape[1]:
        return sorted((row, column) for column, row in minimum_cost(np.ascontiguousarray(cost.T)))
    from c4s.verify.repair.compiled import assigned

    return list(enumerate(assigned(np.ascontiguousarray(cost)).tolist()))
