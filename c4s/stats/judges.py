"""How far two judges agree on the same things (ours; Krippendorff's alpha, Cohen's kappa)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from c4s.stats.alpha import interval_alpha
from c4s.stats.repeats import tau_b


@dataclass(frozen=True)
class ScoreAgreement:
    """Two judges' scores of the same scenes. None where there is no spread to tell it by."""

    things: int
    bias: float
    """Mean of the first judge's scores less the second's."""
    distance: float
    """Mean absolute difference."""
    equal: float
    """Share of equal scores."""
    tau_b: float | None
    alpha: float | None
    """Krippendorff's, interval scale: 1 is full agreement, 0 what chance gives."""


def score_agreement(one: object, other: object) -> ScoreAgreement:
    """Of two judges' scores of the same things, shape (things,), finite, at least one."""
    pair = np.stack([np.asarray(one, dtype=np.float64), np.asarray(other, dtype=np.float64)])
    differences = pair[0] - pair[1]
    return ScoreAgreement(
        things=pair.shape[1],
        bias=float(differences.mean()),
        distance=float(np.abs(differences).mean()),
        equal=float((np.abs(differences) <= 1e-12).mean()),
        tau_b=tau_b(pair[0], pair[1]),
        alpha=interval_alpha(pair),
    )


def kappa(table: object) -> float | None:
    """Cohen's kappa of two judges' decisions: 1 is full agreement, 0 what chance gives.

    Args:
        table: how often the first gave the row's answer and the second the column's, shape (answers, answers).

    Returns:
        None where both always give one answer, or there is none.
    """
    counts = np.asarray(table, dtype=np.float64)
    total = counts.sum()
    if not total:
        return None
    shares = counts / total
    chance = float(shares.sum(axis=1) @ shares.sum(axis=0))
    return float((np.trace(shares) - chance) / (1 - chance)) if chance < 1 - 1e-12 else None
