"""The walkable space against Recast itself: the same cells, and the same components, in 200 scenes."""

from __future__ import annotations

import numpy as np
import pytest

from bench.navigation import SEED, compare, random_bodies
from bench.recast import NoRecast, library

try:
    library()
except NoRecast as missing:
    pytest.skip(str(missing), allow_module_level=True)


def test_two_hundred_random_scenes_have_the_area_and_the_components_of_recast() -> None:
    rng = np.random.default_rng(SEED)
    found = [compare(random_bodies(rng)) for _ in range(200)]
    assert max(one.area_off for one in found) <= 0.03
    assert all(one.same_components for one in found)
    assert sum(one.components > 1 for one in found) > 50
    assert sum(one.cells_off == 0 for one in found) >= 190
