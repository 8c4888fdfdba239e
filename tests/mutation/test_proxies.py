"""Proxy geometry (EI02): other meshes in the place of things."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, Mutate, rewarded
from tests.mutation.scenes import Scene, changed, is_solid, made_of, smallest

CUBE = "/Engine/BasicShapes/Cube.Cube"


def cubes(given: Scene) -> Scene:
    like = smallest(given)
    return changed(given, is_solid, lambda one: made_of(one, CUBE, like))


def one_asset(given: Scene) -> Scene:
    like = smallest(given)
    return changed(given, is_solid, lambda one: made_of(one, like["asset_path"], like))


@pytest.mark.parametrize("mutate", [cubes, one_asset])
def test_proxies_are_worth_less(mutate: Mutate, repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(mutate)
        assert rewarded(found) == {}
        assert all(mutant.score < base.score for base, mutant in found.values())
