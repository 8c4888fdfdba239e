"""The two matchings against SciPy: the same size, the same cost."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linear_sum_assignment
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import maximum_bipartite_matching

from c4s.verify.repair.assignment import maximum_matching, minimum_cost

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


def test_equal_costs_fall_to_the_lower_column() -> None:
    assert minimum_cost(np.zeros((2, 4))) == [(0, 0), (1, 1)]
    assert minimum_cost(np.zeros((3, 2))) == [(0, 0), (1, 1)]
