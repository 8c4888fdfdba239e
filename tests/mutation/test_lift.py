"""Lift: the same scene in the air."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import changed, is_solid, shifted


def test_lifting_does_not_pay(repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(lambda given: changed(given, is_solid, lambda one: shifted(one, (0.0, 0.0, 1000.0))))
        assert rewarded(found) == {}
