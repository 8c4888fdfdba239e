"""The compiled distance is that of the published rules, bit by bit where Python computes it as they did."""

from __future__ import annotations

import math
import sys

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from c4s.verify.repair.compiled import distances

COORDINATES = st.floats(allow_nan=True, allow_infinity=True) | st.floats(-1e6, 1e6)
POINTS = st.lists(st.tuples(COORDINATES, COORDINATES, COORDINATES), min_size=1, max_size=6)


@given(POINTS, POINTS)
def test_every_distance_is_that_of_math_dist(here: list[tuple[float, ...]], there: list[tuple[float, ...]]) -> None:
    found = distances(np.array(here), np.array(there))
    for i, one in enumerate(here):
        for j, other in enumerate(there):
            expected = math.dist(one, other)
            if math.isnan(expected):
                assert math.isnan(found[i, j])
            elif sys.version_info < (3, 12) or math.isinf(expected):
                assert found[i, j] == expected
            else:
                assert abs(found[i, j] - expected) <= math.ulp(expected)
