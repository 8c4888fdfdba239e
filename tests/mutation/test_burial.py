"""Burial: what lies deep under the ground is supported by the published rule, and the verdict says so."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import changed, is_solid, shifted

DEPTHS_CM = (30.0, 30_000.0)


@pytest.mark.parametrize("depth", DEPTHS_CM)
def test_burying_everything_does_not_pay(depth: float, repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        assert rewarded(mutants(lambda given: changed(given, is_solid, lambda one: shifted(one, (0, 0, -depth))))) == {}


def test_burying_what_is_askew_is_told(text_mutants: Check) -> None:
    found = text_mutants(
        lambda given: changed(
            given, lambda one: is_solid(one) and len(one["label"]) % 2 == 0, lambda one: shifted(one, (0, 0, -30_000.0))
        )
    )
    assert all("supported_below_ground" in mutant.advisories for _, mutant in found.values())
    assert rewarded(found) == {}
