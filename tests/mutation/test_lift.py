"""Lift: the same scene in the air."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Choice, changed, is_mesh, is_solid, shifted


@pytest.mark.parametrize("choice", [is_solid, is_mesh])
def test_lifting_does_not_pay(choice: Choice, repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(lambda given: changed(given, choice, lambda one: shifted(one, (0.0, 0.0, 1000.0))))
        assert rewarded(found) == {}
