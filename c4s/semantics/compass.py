"""Sides of the compass: which way is north in a scene that was built to a prompt.

Nobody tells an agent which way is north, or which way up a map is held. So north is where it makes most of a prompt's
own claims of sides true: of eight ways to lay a compass on the plan (four turns, either hand) the best, once for the
whole scene. With fewer than three such claims nearly any layout fits one of the eight, and where the best suits less
than 0.6 of them the scene has no north: nothing is decided then.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from c4s.protocol.numbers import mean
from c4s.semantics.distributions import plan_centres
from c4s.semantics.inventory import Array, Thing
from c4s.semantics.relation_words import COMPASS

LEAST_CLAIMS: Final = 3
LEAST_SUIT: Final = 0.6
"""The best compass must suit the claims this well on average; things thrown down by chance reach about half."""
SIDEWAYS: Final = 1.0
"""A way leads to a side when it goes at least this much further that way than sideways."""
_SLACK: Final = 1e-9
"""Compasses whose suits differ by rounding alone are as good as each other."""


def sides(claims: Mapping[str, tuple[str, Sequence[Thing], Sequence[Thing]]]) -> dict[str, tuple[float, float]]:
    """The share of each claim's subjects that lie to the named side of its references, under the best compass;
    and the share that lies on that half of the plan at all. Where several compasses are as good, the least of the one
    and the most of the other: what holds under some of them only is not decided.

    Args:
        claims: by id the side (a key of ``COMPASS``), subjects and references, neither empty.

    Empty with fewer than three claims, and where no compass suits them.
    """
    if len(claims) < LEAST_CLAIMS:
        return {}
    ways = {key: _ways(subjects, references) for key, (_, subjects, references) in claims.items()}
    shares = [
        {key: _shares(ways[key], compass @ COMPASS[side]) for key, (side, _, _) in claims.items()}
        for compass in _compasses()
    ]
    most = max(map(_suits, shares))
    best = [one for one in shares if _suits(one) >= most - _SLACK]
    if most < LEAST_SUIT:
        return {}
    return {key: (min(one[key][0] for one in best), max(one[key][1] for one in best)) for key in claims}


def _ways(subjects: Sequence[Thing], references: Sequence[Thing]) -> Array:
    """From the middle of the references' plan to each subject (n, 2), cm."""
    low = np.min([thing.low[:2] for thing in references], axis=0)
    high = np.max([thing.high[:2] for thing in references], axis=0)
    return np.asarray(plan_centres(subjects) - (low + high) / 2)


def _suits(shares: Mapping[str, tuple[float, float]]) -> float:
    return mean(sure for sure, _ in shares.values())


def _shares(ways: Array, side: Array) -> tuple[float, float]:
    forward = ways @ side
    aside = np.abs(ways @ np.array([-side[1], side[0]]))
    return float(np.mean((forward > 0) & (forward >= SIDEWAYS * aside))), float(np.mean(forward > 0))


def _compasses() -> list[Array]:
    turn = np.array([[0, -1], [1, 0]])
    mirror = np.array([[-1, 0], [0, 1]])
    turns = [np.linalg.matrix_power(turn, n) for n in range(4)]
    return [*turns, *(mirror @ one for one in turns)]
