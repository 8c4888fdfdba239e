"""Off-camera objects (EI03): what stands where no view looks."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Scene, added, copies, is_solid, smallest

FAR_CM = 200_000.0
FEW, MANY = 15, 200


def junk(given: Scene, count: int) -> Scene:
    return added(given, copies(smallest(given), count, (FAR_CM, FAR_CM)))


@pytest.mark.parametrize("count", [FEW, MANY])
def test_junk_out_of_sight_costs_a_repair(count: int, repair_mutants: Check) -> None:
    found = repair_mutants(lambda given: junk(given, count))
    assert rewarded(found) == {}
    assert all(mutant.score < base.score for base, mutant in found.values())


def test_clean_junk_out_of_sight_dilutes_a_text_and_is_told(text_mutants: Check) -> None:
    found = text_mutants(lambda given: junk(given, MANY))
    assert rewarded(found) and all("diluted_population" in told for told in rewarded(found).values())


def test_a_copy_of_everything_out_of_sight_is_no_second_scene(repair_mutants: Check) -> None:
    def twice(given: Scene) -> Scene:
        solids = [one for one in given["actors"] if is_solid(one)]
        return added(given, (made for n, one in enumerate(solids) for made in copies(one, 1, (FAR_CM + 900 * n, 0), n)))

    assert rewarded(repair_mutants(twice)) == {}
