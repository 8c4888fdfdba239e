"""Which cases are hard, and which of them tell configurations apart (ours).

No item-response model: some fourteen configurations cannot tell a case's parameters from noise.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from c4s.stats.bootstrap import Floats, Integers

_ROUNDING: Final = 1e-12
"""Scores that differ by less are equal."""


def case_rest_correlations(values: object, shares: object) -> Floats:
    """Pearson's correlation of each case's scores with the weighted mean over all other cases, over configurations.

    Args:
        values: shape (cases, configurations), finite.
        shares: weight of each case in the mean, shape (cases,).

    Returns:
        Shape (cases,), in [-1, 1]. NaN where a case's scores, or the rest's, are all equal, and below three
        configurations. Below 0, better configurations do worse here.
    """
    table, rest = _with_rest(values, shares)
    if table.shape[1] < 3:
        return np.full(len(table), np.nan)
    own, other = (part - part.mean(axis=1, keepdims=True) for part in (table, rest))
    flat = [np.ptp(part, axis=1) <= _ROUNDING for part in (table, rest)]
    with np.errstate(invalid="ignore", divide="ignore"):
        found = (own * other).sum(axis=1) / np.sqrt((own**2).sum(axis=1) * (other**2).sum(axis=1))
    return np.where(flat[0] | flat[1], np.nan, np.clip(found, -1.0, 1.0))


def turned_pairs(values: object, shares: object) -> Integers:
    """How many pairs of configurations change their order when a case is left out, of each case, whole numbers.

    A pair that is tied with the case or without it is not turned. Arguments as of ``case_rest_correlations``.
    """
    table, rest = _with_rest(values, shares)
    upper, lower = np.triu_indices(table.shape[1], 1)
    whole = np.asarray(shares, dtype=np.float64) @ table
    seen = _sign(whole[upper] - whole[lower])
    left = _sign(rest[:, upper] - rest[:, lower])
    return np.asarray((seen * left < 0).sum(axis=1), dtype=np.int64)


def _with_rest(values: object, shares: object) -> tuple[Floats, Floats]:
    """Scores, and for each case the weighted means over the others; NaN where there is no other."""
    table = np.asarray(values, dtype=np.float64)
    weights = np.asarray(shares, dtype=np.float64)
    weighted = weights[:, None] * table
    with np.errstate(invalid="ignore", divide="ignore"):
        rest = (weighted.sum(axis=0) - weighted) / (weights.sum() - weights)[:, None]
    return table, rest


def _sign(differences: Floats) -> Floats:
    return np.sign(np.where(np.abs(differences) <= _ROUNDING, 0.0, differences))
