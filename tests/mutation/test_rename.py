"""Rename: other labels, also those that the published rules leave out of a test."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Actor, changed, is_solid


def called(one: Actor, start: str) -> Actor:
    return {**one, "label": f"{start}_{one['label']}", "name": f"{start}_{one['name']}"}


@pytest.mark.parametrize("start", ["Thing", "Light", "Floor", "Sky", "Oak_dining_table"])
def test_other_labels_do_not_pay_unless_it_is_told(start: str, repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        found = mutants(lambda given: changed(given, is_solid, lambda one: called(one, start)))
        assert all("label_never_supported" in told for told in rewarded(found).values())
