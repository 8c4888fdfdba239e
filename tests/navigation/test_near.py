"""What is within reach of a place, against SciPy's tree."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from c4s.navigation.projection import Near


@given(st.integers(0, 300), st.integers(0, 2**32 - 1), st.sampled_from([0.0, 10.0, 25.0, 50.0]), st.booleans())
def test_the_same_points_are_within_reach_as_in_a_tree(count: int, seed: int, reach: float, lattice: bool) -> None:
    rng = np.random.default_rng(seed)
    points = rng.integers(-20, 20, (count, 2)) * 5.0 if lattice else rng.random((count, 2)) * 200 - 100
    for place in rng.integers(-20, 20, (4, 2)) * 5.0:
        expected = cKDTree(points).query_ball_point(place, reach, return_sorted=True) if count else []
        assert Near(points).within(place, reach).tolist() == expected
