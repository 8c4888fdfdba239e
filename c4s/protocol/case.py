"""The case score as numbers (paper, "Score Aggregation and Reporting"; scorer fact 7)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Final

from c4s.protocol.numbers import required_unit_number, unit_number
from c4s.protocol.rules import I2S_DIGITS, I2S_POLICY, I2S_WEIGHTS, T2S_DIGITS, T2S_POLICY, T2S_WEIGHTS

SEMANTIC: Final = "semantic"
"""Name of the semantic score among a trial's components."""


def t2s_case(
    *, valid: bool, detailed: Any, overview: Any, physics: Any, weights: Mapping[str, float] = T2S_WEIGHTS
) -> dict[str, Any]:
    """Text-to-scene case score. A component that is no number in [0, 1] keeps its weight and is worth zero."""
    given = {"detailed": detailed, "overview": overview, "physics": physics}
    if not valid:
        return {"policy": T2S_POLICY, "status": "zero_invalid_candidate", "score": 0.0, **dict.fromkeys(given, 0.0)}
    values = {name: unit_number(value) for name, value in given.items()}
    missing = [name for name, value in values.items() if value is None]
    used = {name: value or 0.0 for name, value in values.items()}
    total = 0.0
    for name, weight in weights.items():
        total += weight * used[name]
    score = round(total, T2S_DIGITS)
    return {
        "policy": T2S_POLICY,
        "status": "measured_with_missing_zero" if missing else "measured",
        "missing_components": missing,
        "score": score,
        **used,
    }


def i2s_case(
    *, valid: bool, repair_f1: Any, physics: Any, weights: Mapping[str, float] = I2S_WEIGHTS
) -> dict[str, Any]:
    """Image-to-scene case score. Raises ``BadInput`` when a component of a valid case is no number in [0, 1]."""
    if not valid:
        return {
            "policy": I2S_POLICY,
            "status": "zero_invalid_candidate",
            "score": 0.0,
            "repair_f1": 0.0,
            "physics": 0.0,
        }
    used = {
        "repair_f1": required_unit_number(repair_f1, "repair_f1"),
        "physics": required_unit_number(physics, "physics"),
    }
    score = round(math.fsum(weight * used[name] for name, weight in weights.items()), I2S_DIGITS)
    return {"policy": I2S_POLICY, "status": "measured", "score": score, **used}


def semantic_score(*, detailed: float, overview: float, weights: Mapping[str, float] = T2S_WEIGHTS) -> float:
    """Detailed and Overview Alignment as one number (paper, "Semantic Verifier aggregation"); not rounded.

    The case score is this at their common weight, and physics at its own.
    """
    alpha, beta = weights["detailed"], weights["overview"]
    return (alpha * detailed + beta * overview) / (alpha + beta)


def semantic_of(values: Mapping[str, float], weights: Mapping[str, float]) -> float | None:
    """``semantic_score`` of a case's components; None under a policy that gives its halves no weight."""
    if not weights["detailed"] + weights["overview"]:
        return None
    return semantic_score(detailed=values["detailed"], overview=values["overview"], weights=weights)
