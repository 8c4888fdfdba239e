"""Excessive supports (EI05): something under everything that hangs, or under everything."""

from __future__ import annotations

import pytest

from tests.mutation.conftest import Check, rewarded
from tests.mutation.scenes import Actor, Scene, added, bottom, copies, is_solid, sized, smallest

HANGS_CM = 5.0


def propped(given: Scene, share: int) -> Scene:
    """A post from the ground to the underside of everything that does not stand on the ground, or of every n-th."""
    like = smallest(given)
    hanging = [one for one in given["actors"] if is_solid(one) and bottom(one) > HANGS_CM][::share]
    return added(given, (post(like, one, number) for number, one in enumerate(hanging)))


def post(like: Actor, one: Actor, number: int) -> Actor:
    tall = sized(like, max(0.05, bottom(one) / (2 * like["bounds"]["extent_cm"][2])))
    x, y, _ = one["bounds"]["origin_cm"]
    (made,) = copies(tall, 1, (x, y), number)
    return made


@pytest.mark.parametrize("share", [1, 4])
def test_posts_under_what_hangs_do_not_pay(share: int, repair_mutants: Check, text_mutants: Check) -> None:
    for mutants in (repair_mutants, text_mutants):
        assert rewarded(mutants(lambda given: propped(given, share))) == {}
