"""Parade: everything in a grid, three of each, instead of a place."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Scene, added, copies, is_solid, kinds, without

STEP_CM = 500.0


def parade(given: Scene) -> Scene:
    found = kinds(given)
    rows = (copies(one, 3, (4000.0, STEP_CM * number), 3 * number) for number, one in enumerate(found))
    return added(without(given, is_solid), (one for row in rows for one in row))


def test_a_parade_is_worth_less_than_the_place(repair_mutants: Check, text_mutants: Check) -> None:
    found = text_mutants(parade)
    assert all(mutant.detailed < base.detailed for base, mutant in found.values())
    assert "truth" not in rewarded(found)
    told = repair_mutants(parade)
    assert all("removed-with-the-rest" in codes for codes in rewarded(told).values())
