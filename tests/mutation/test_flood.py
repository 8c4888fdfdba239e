"""Flood: more of everything that is there, or very much of one thing, among the rest."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, Mutate, rewarded
from tests.mutation.scenes import Scene, added, copies, kinds, smallest

STEP_CM = 400.0


def of_one(given: Scene) -> Scene:
    return added(given, copies(smallest(given), 300, (2000.0, -6000.0)))


def of_all(given: Scene) -> Scene:
    rows = (copies(one, 4, (2500.0, STEP_CM * n), 10 * n) for n, one in enumerate(kinds(given)))
    return added(given, (one for row in rows for one in row))


@pytest.mark.parametrize("flood", [of_one, of_all])
def test_a_flood_costs_a_repair(flood: Mutate, repair_mutants: Check) -> None:
    found = repair_mutants(flood)
    assert rewarded(found) == {}
    assert all(mutant.score < base.score for base, mutant in found.values())


@pytest.mark.parametrize("flood", [of_one, of_all])
def test_a_flood_that_pays_in_a_text_is_told(flood: Mutate, text_mutants: Check) -> None:
    found = rewarded(text_mutants(flood))
    assert found and all("diluted_population" in told for told in found.values())
