"""Whether one configuration's scores on the same cases change from night to night (ours).

Without drift the runs of a case could as well have come in any other order. So what the nights' means show is compared
with what they show when the nights of each case are shuffled, each case by itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from c4s.stats.bootstrap import DRAWS, SEED, Floats

_AT_ONCE: Final = 500
_ROUNDING: Final = 1e-12


@dataclass(frozen=True)
class Drift:
    """How far nights differ, with p-values of shuffled nights (+1 rule)."""

    slope: float
    """Least-squares change of the mean a night."""
    slope_p: float
    """Two-sided."""
    spread: float
    """Standard deviation (n) of the nights' means."""
    spread_p: float
    """Chance of as large a spread without drift."""


def drift(scores: object, shares: object, draws: int = DRAWS, seed: int = SEED) -> Drift:
    """Drift of a weighted mean.

    Args:
        scores: shape (cases, nights) in the order of the nights, at least two, finite.
        shares: weight of each case in the mean, shape (cases,); they sum to 1.

    Raises:
        ValueError: fewer than two nights, or a score that is not finite.
    """
    table = np.asarray(scores, dtype=np.float64)
    if table.ndim != 2 or table.shape[1] < 2 or not np.isfinite(table).all():
        raise ValueError("a finite score a case in each of at least two nights is expected")
    weights = np.asarray(shares, dtype=np.float64)
    slope, spread = (float(found[0]) for found in _shown((weights @ table)[None]))
    random = np.random.default_rng(seed)
    steeper, wider = 0, 0
    for first in range(0, draws, _AT_ONCE):
        count = min(_AT_ONCE, draws - first)
        order = np.argsort(random.random((count, *table.shape)), axis=2)
        means = np.einsum("c,bcn->bn", weights, np.take_along_axis(table[None], order, axis=2))
        slopes, spreads = _shown(means)
        steeper += int((np.abs(slopes) >= abs(slope) - _ROUNDING).sum())
        wider += int((spreads >= spread - _ROUNDING).sum())
    return Drift(slope, (1 + steeper) / (1 + draws), spread, (1 + wider) / (1 + draws))


def _shown(means: Floats) -> tuple[Floats, Floats]:
    """Slopes and spreads of nights' means, shape (draws, nights) to (draws,)."""
    nights = np.arange(means.shape[1]) - (means.shape[1] - 1) / 2
    return means @ nights / (nights @ nights), means.std(axis=1)
