"""Heap: everything within each other at one place."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Actor, changed, is_solid, shifted


def onto_one_place(one: Actor) -> Actor:
    x, y, _ = one["transform"]["location_cm"]
    return shifted(one, (300.0 - x, 300.0 - y, 0.0))


def test_a_heap_is_worth_less(repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(lambda given: changed(given, is_solid, onto_one_place))
        assert rewarded(found) == {}
        assert all(mutant.score < base.score for base, mutant in found.values())
