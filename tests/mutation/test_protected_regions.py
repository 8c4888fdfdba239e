"""Protected-region edits (EI07): what no target asks for is moved, or is gone."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Actor, changed, is_solid, shifted, without
from tests.mutation.subjects import RepairSubject


def test_moved_background_costs_every_submission(repair: RepairSubject, repair_mutants: Check) -> None:
    def protected(one: Actor) -> bool:
        return is_solid(one) and one["stable_actor_id"] not in repair.targets

    found = repair_mutants(lambda given: changed(given, protected, lambda one: shifted(one, (20.0, 0.0, 0.0))))
    assert rewarded(found) == {}
    assert all(mutant.score < base.score for base, mutant in found.values())


def test_a_single_moved_thing_costs_a_whole_repair(repair: RepairSubject, repair_mutants: Check) -> None:
    chosen = next(
        one["stable_actor_id"]
        for one in repair.truth["actors"]
        if is_solid(one) and one["stable_actor_id"] not in repair.targets
    )
    found = repair_mutants(
        lambda given: changed(
            given, lambda one: one["stable_actor_id"] == chosen, lambda one: shifted(one, (20.0, 0.0, 0.0))
        )
    )
    assert found["truth"][1].score < found["truth"][0].score and rewarded(found) == {}


def test_who_deletes_the_scene_has_removed_and_is_told(repair_mutants: Check, text_mutants: Check) -> None:
    found = repair_mutants(lambda given: without(given, is_solid))
    assert set(rewarded(found)) <= {"start"}
    assert all("removed-with-the-rest" in told for told in rewarded(found).values())
    assert rewarded(text_mutants(lambda given: without(given, is_solid))) == {}
