"""The two matchings against SciPy: the same size, the same cost."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import maximum_bipartite_matching

from c4s.verify.repair import compiled
from c4s.verify.repair.assignment import assigned, maximum_matching, minimum_cost

SHAPES = st.tuples(st.integers(1, 9), st.integers(1, 9), st.integers(0, 2**32 - 1))


@settings(max_examples=150, deadline=None)
@given(SHAPES, st.booleans())
def test_minimum_cost_is_minimal(shape: tuple[int, int, int], ties: bool) -> None:
    rows, columns, seed = shape
    rng = np.random.default_rng(seed)
    cost = rng.integers(0, 3, (rows, columns)).astype(float) if ties else rng.random((rows, columns))
    pairs = minimum_cost(cost)
    assert len({r for r, _ in pairs}) == len({c for _, c in pairs}) == len(pairs) == min(rows, columns)
    assert np.isclose(sum(cost[pair] for pair in pairs), cost[linear_sum_assignment(cost)].sum())


def _one_by_one(cost: NDArray[np.float64]) -> list[int]:
    """The column of each row as the published solver settles it: rows enter one by one, the lower column wins a tie."""
    rows, columns = cost.shape
    row_dual, column_dual = [0.0] * rows, [0.0] * columns
    row_of: list[int | None] = [None] * columns
    for row in range(rows):
        slack, came, settled, current, last = [np.inf] * columns, [-1] * columns, list[int](), row, -1
        while True:
            for column in set(range(columns)) - set(settled):
                reduced = (cost[current, column] - row_dual[current]) - column_dual[column]
                if reduced < slack[column]:
                    slack[column], came[column] = reduced, last
            last = min(set(range(columns)) - set(settled), key=lambda column: (slack[column], column))
            step = slack[last]
            row_dual[row] += step
            for column in settled:
                row_dual[row_of[column]] += step  # type: ignore[index]
                column_dual[column] -= step
            slack = [one - step for one in slack]
            if row_of[last] is None:
                break
            settled.append(last)
            current = row_of[last]  # type: ignore[assignment]
        while last != -1:
            row_of[last] = row if came[last] == -1 else row_of[came[last]]
            last = came[last]
    return [row_of.index(row) for row in range(rows)]


@settings(max_examples=200, deadline=None)
@given(SHAPES, st.sampled_from([1.0, 0.05, 1 / 3, 0.0]))
def test_equal_costs_are_settled_as_published(shape: tuple[int, int, int], unit: float) -> None:
    rows, columns, seed = shape
    rng = np.random.default_rng(seed)
    cost = rng.integers(0, 4, (rows, rows + columns)) * unit + rng.integers(0, 2, (rows, rows + columns)) * 0.1
    cost[(cost == 0) & (rng.random(cost.shape) < 0.5)] = -0.0
    assert minimum_cost(cost) == list(enumerate(_one_by_one(cost)))
    assert assigned(cost.tolist()) == compiled.assigned(cost).tolist()


@settings(max_examples=150, deadline=None)
@given(SHAPES, st.floats(0, 1))
def test_maximum_matching_is_maximal_and_keeps_what_others_hold(shape: tuple[int, int, int], density: float) -> None:
    rows, columns, seed = shape
    allowed = np.random.default_rng(seed).random((rows, columns)) < density
    edges = [np.nonzero(line)[0].tolist() for line in allowed]
    first = maximum_matching(range(rows), edges.__getitem__)
    best = int((maximum_bipartite_matching(csr_matrix(allowed), perm_type="column") >= 0).sum())
    assert len(first) == len(set(first.values())) == best
    assert all(allowed[left, right] for left, right in first.items())
    head = maximum_matching(range(rows // 2), edges.__getitem__)
    rest = maximum_matching(range(rows // 2, rows), edges.__getitem__, {c: r for r, c in head.items()})
    assert not set(head.values()) & set(rest.values())


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 40), st.integers(0, 40), st.integers(0, 2**32 - 1))
def test_a_table_has_the_same_answer_with_and_without_compiled_code(rows: int, more: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    cost = rng.integers(-3, 9, (rows, rows + more)) / 7 + rng.random((rows, rows + more)) * (seed % 2)
    assert assigned(cost.tolist()) == compiled.assigned(cost).tolist()


def test_equal_costs_fall_to_the_lower_column() -> None:
    assert minimum_cost(np.zeros((2, 4))) == [(0, 0), (1, 1)]
    assert minimum_cost(np.zeros((3, 2))) == [(0, 0), (1, 1)]
