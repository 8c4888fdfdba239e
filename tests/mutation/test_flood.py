"""Flood: more of everything that is there, or very much of one thing, among the rest."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from tests.mutation.conftest import Check, Mutate, rewarded
from tests.mutation.scenes import Actor, Scene, added, copies, fresh, is_mesh, is_solid, kinds, shifted, sized, smallest

STEP_CM = 400.0
FAR_CM = 150_000.0


def of_one(given: Scene) -> Scene:
    return added(given, copies(smallest(given), 300, (2000.0, -6000.0)))


def of_all(given: Scene) -> Scene:
    rows = (copies(one, 4, (2500.0, STEP_CM * n), 10 * n) for n, one in enumerate(kinds(given)))
    return added(given, (one for row in rows for one in row))


def _far(given: Scene) -> list[Actor]:
    """Copies of all kinds, far away."""
    rows = (copies(one, 6, (FAR_CM, 1500.0 * n), 10 * n) for n, one in enumerate(kinds(given)))
    return [one for row in rows for one in row]


def _floor(given: Scene) -> Actor:
    flat = [one for one in given["actors"] if is_mesh(one) and not is_solid(one)]
    return max(flat, key=lambda one: one["bounds"]["extent_cm"][0] * one["bounds"]["extent_cm"][1])


def _under(floor: Actor, spot: Sequence[float], number: int) -> Actor:
    """A floor of its own around a spot (x, y), its top at z = 0."""
    x, y, z = floor["bounds"]["origin_cm"]
    return fresh(shifted(floor, (spot[0] - x, spot[1] - y, -z - floor["bounds"]["extent_cm"][2])), 90_000 + number)


def on_a_floor(given: Scene) -> Scene:
    things, floor = _far(given), _floor(given)
    spots = np.array([one["bounds"]["origin_cm"][:2] for one in things])
    middle, reach = (spots.min(axis=0) + spots.max(axis=0)) / 2, float(np.ptp(spots, axis=0).max())
    wide = sized(floor, 0.55 * reach / min(floor["bounds"]["extent_cm"][:2]))
    return added(given, [*things, _under(wide, middle.tolist(), 0)])


def on_floors(given: Scene) -> Scene:
    things, floor = _far(given), _floor(given)
    return added(given, [*things, *(_under(floor, one["bounds"]["origin_cm"], n) for n, one in enumerate(things))])


@pytest.mark.parametrize("flood", [of_one, of_all])
def test_a_flood_costs_a_repair(flood: Mutate, repair_mutants: Check) -> None:
    found = repair_mutants(flood)
    assert rewarded(found) == {}
    assert all(mutant.score < base.score for base, mutant in found.values())


@pytest.mark.parametrize("flood", [of_one, of_all, on_a_floor, on_floors])
def test_a_flood_that_pays_in_a_text_is_told(flood: Mutate, text_mutants: Check) -> None:
    found = rewarded(text_mutants(flood))
    assert found and all("diluted_population" in told for told in found.values())
