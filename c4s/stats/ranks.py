"""Ranks of configurations, with ties as the paper has them, and how far resampling moves them."""

from __future__ import annotations

from typing import Final

import numpy as np

from c4s.stats.bootstrap import LEVEL, Floats, Integers, percentile_interval

DIGITS: Final = 12
"""Scores that differ beyond them only are equal: means of the same numbers in another order differ by rounding."""


def settled(scores: object) -> Floats:
    """Scores by which an order may be told: to ``DIGITS`` decimals."""
    return np.asarray(np.round(np.asarray(scores, dtype=np.float64), DIGITS), dtype=np.float64)


def competition_ranks(scores: object) -> Integers:
    """Ranks along the last axis, the highest score first; equal scores share the smallest (paper, "Running cases").

    Args:
        scores: shape (..., configurations), finite.

    Returns:
        The same shape, from 1.
    """
    table = settled(scores)
    better = table[..., None, :] > table[..., :, None]
    return np.asarray(1 + better.sum(axis=-1), dtype=np.int64)


def rank_interval(drawn: Floats, level: float = LEVEL) -> tuple[Integers, Integers]:
    """Smallest and largest ranks that the middle of the draws gives each configuration, whole numbers.

    Args:
        drawn: scores, shape (draws, configurations).
    """
    low, high = percentile_interval(competition_ranks(drawn).astype(np.float64), level)
    return np.floor(low).astype(np.int64), np.ceil(high).astype(np.int64)
