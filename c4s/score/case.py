"""The case score of a trial, from its verdicts (paper, "Score Aggregation and Reporting"; scorer fact 7)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from c4s.protocol.numbers import required_unit_number, unit_number
from c4s.protocol.rules import CASE_POLICY, I2S_DIGITS, I2S_POLICY, I2S_WEIGHTS, T2S_DIGITS, T2S_POLICY, T2S_WEIGHTS
from c4s.records.score import CaseStatus, TrialScore
from c4s.records.suite import Setting
from c4s.records.verdict import Verdict


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


def case_score(
    *,
    case_id: str,
    setting: Setting,
    configuration: str,
    repeat: int,
    judge: str,
    engine: str,
    submitted: bool,
    verdicts: Mapping[str, Verdict],
    retained_attempt: int | None = None,
    missing_result: bool = False,
    policy: str | None = None,
    weights: Mapping[str, float] | None = None,
) -> TrialScore:
    """Score of a trial.

    The zeros are kept apart by ``status``: no submission, an invalid one (with the integrity reason), or a result
    declared missing. A verifier's fault (status ``error``, or a verdict not made yet) leaves the trial ``pending``
    with no score. A component that could not be evaluated on a valid scene is worth zero at its full weight.

    Args:
        submitted: whether the retained attempt saved a scene.
        verdicts: by verifier name: ``integrity``, ``physics``, and ``repair`` or ``detailed`` and ``overview``.
        missing_result: the operator's final word that no result will come.
        policy: id to record; the setting's published policy when None.
        weights: of the setting's components; the published ones when None.
    """
    base: dict[str, Any] = {
        "case_id": case_id,
        "setting": setting,
        "configuration": configuration,
        "repeat": repeat,
        "policy": policy or CASE_POLICY[setting],
        "judge": judge,
        "engine": engine,
        "retained_attempt": retained_attempt,
    }
    parts = ("detailed", "overview") if setting == "text-to-scene" else ("repair",)
    if missing_result:
        return _zero(base, setting, "zero_missing_result", "the result is missing")
    if not submitted:
        return _zero(base, setting, "zero_missing_submission", "no scene was saved")
    integrity = verdicts.get("integrity")
    if integrity is None or integrity.status not in ("valid", "invalid"):
        return _pending(base, "integrity", integrity)
    if integrity.status == "invalid":
        return _zero(base, setting, "zero_invalid_candidate", integrity.reason or "invalid")
    for name in ("physics", *parts):
        verdict = verdicts.get(name)
        if verdict is None or verdict.status in ("error", "valid", "invalid"):
            return _pending(base, name, verdict)
    return _measured(base, setting, verdicts, weights or (T2S_WEIGHTS if setting == "text-to-scene" else I2S_WEIGHTS))


def _pending(base: dict[str, Any], verifier: str, verdict: Verdict | None) -> TrialScore:
    reason = f"{verifier}: {'no verdict yet' if verdict is None else verdict.reason or verdict.status}"
    return TrialScore(**base, status="pending", score=None, reason=reason)


def _zero(base: dict[str, Any], setting: Setting, status: CaseStatus, reason: str) -> TrialScore:
    names = (
        ("detailed", "overview", "known_coverage")
        if setting == "text-to-scene"
        else ("repair_precision", "repair_recall", "repair_f1")
    )
    return TrialScore(**base, status=status, score=0.0, reason=reason, physics=0.0, **dict.fromkeys(names, 0.0))


def _value(verdict: Verdict) -> float | None:
    return unit_number(verdict.score) if verdict.status == "measured" else None


def _measured(
    base: dict[str, Any], setting: Setting, verdicts: Mapping[str, Verdict], weights: Mapping[str, float]
) -> TrialScore:
    physics = _value(verdicts["physics"])
    if setting == "text-to-scene":
        row = t2s_case(
            valid=True,
            detailed=_value(verdicts["detailed"]),
            overview=_value(verdicts["overview"]),
            physics=physics,
            weights=weights,
        )
        coverage = unit_number(verdicts["detailed"].measurements.get("known_coverage"))
        return TrialScore(
            **base,
            status=row["status"],
            score=row["score"],
            detailed=row["detailed"],
            overview=row["overview"],
            physics=row["physics"],
            known_coverage=coverage,
            reason=_missing(row["missing_components"]),
        )
    repair = verdicts["repair"]
    f1 = _value(repair)
    missing = [name for name, value in (("repair", f1), ("physics", physics)) if value is None]
    row = i2s_case(valid=True, repair_f1=f1 or 0.0, physics=physics or 0.0, weights=weights)
    rates = {
        name: (unit_number(repair.measurements.get(name)) if f1 is not None else 0.0)
        for name in ("precision", "recall")
    }
    return TrialScore(
        **base,
        status="measured_with_missing_zero" if missing else "measured",
        score=row["score"],
        physics=row["physics"],
        repair_f1=row["repair_f1"],
        repair_precision=rates["precision"],
        repair_recall=rates["recall"],
        reason=_missing(missing),
    )


def _missing(names: list[str]) -> str:
    return f"worth zero, not evaluated: {', '.join(names)}" if names else ""
