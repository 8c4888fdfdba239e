"""Hidden: actors that nobody sees and the verifiers count."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, Mutate, rewarded
from tests.mutation.scenes import Scene, added, changed, copies, is_solid, kinds, unseen


def all_hidden(given: Scene) -> Scene:
    return changed(given, is_solid, unseen)


def hidden_stock(given: Scene) -> Scene:
    rows = (copies(one, 2, (3000.0, 500.0 * n), 10 * n) for n, one in enumerate(kinds(given)))
    return added(given, (unseen(one) for row in rows for one in row))


@pytest.mark.parametrize("mutate", [all_hidden, hidden_stock])
def test_what_is_hidden_does_not_pay_in_a_repair(mutate: Mutate, repair_mutants: Check) -> None:
    assert rewarded(repair_mutants(mutate)) == {}


def test_a_hidden_scene_is_none(text_mutants: Check) -> None:
    found = text_mutants(all_hidden)
    assert rewarded(found) == {} and found["truth"][1].score < found["truth"][0].score - 0.05
