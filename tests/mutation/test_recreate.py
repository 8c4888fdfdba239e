"""Recreate: the same actors deleted and made anew, under other identities."""

from __future__ import annotations

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Scene, fresh, is_solid, scene


def recreated(given: Scene) -> Scene:
    return scene(
        (fresh(one, n, one["label"]) if is_solid(one) else one for n, one in enumerate(given["actors"])), given
    )


def test_a_scene_made_anew_is_worth_no_more(repair_mutants: Check, text_mutants: Check) -> None:
    assert rewarded(repair_mutants(recreated)) == {}
    found = text_mutants(recreated)
    assert rewarded(found) == {} and found["truth"][0].score == found["truth"][1].score
