"""Disabled collision (EI04): what has no body penetrates nothing, and the verdict says so."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import bodiless, changed, is_mesh, is_solid


def test_switching_all_collision_off_is_told_wherever_it_pays(repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(lambda given: changed(given, is_mesh, bodiless))
        assert all("collision_switched_off" in told for told in rewarded(found).values())


def test_switching_a_part_off_is_told_wherever_it_pays(repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(
            lambda given: changed(given, lambda one: is_solid(one) and len(one["label"]) % 2 == 0, bodiless)
        )
        assert all("collision_switched_off" in told for told in rewarded(found).values())
