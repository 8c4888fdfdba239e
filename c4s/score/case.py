"""The case score of a trial, from its verdicts (paper, "Score Aggregation and Reporting"; scorer fact 7)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Final

from c4s.protocol.numbers import required_unit_number, unit_number
from c4s.protocol.rules import CASE_POLICY, I2S_DIGITS, I2S_POLICY, I2S_WEIGHTS, T2S_DIGITS, T2S_POLICY, T2S_WEIGHTS
from c4s.protocol.settings import Setting, is_construction
from c4s.records.score import CaseStatus, TrialScore
from c4s.records.verdict import Verdict
from c4s.verify.registry import GATE, headlines_of, verifiers_of

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
        verdicts: by verifier name: the gate's, and those of the setting (``c4s.verify.registry``).
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
    if missing_result:
        return _zero(base, "zero_missing_result", "the result is missing")
    if not submitted:
        return _zero(base, "zero_missing_submission", "no scene was saved")
    gate = verdicts.get(GATE)
    if gate is None or gate.status not in ("valid", "invalid"):
        return _pending(base, GATE, gate)
    if gate.status == "invalid":
        return _zero(base, "zero_invalid_candidate", gate.reason or "invalid")
    for verifier in verifiers_of(setting):
        verdict = verdicts.get(verifier.name)
        if verdict is None or verdict.status in ("error", "valid", "invalid"):
            return _pending(base, verifier.name, verdict)
    return _measured(base, verdicts, weights or (T2S_WEIGHTS if is_construction(setting) else I2S_WEIGHTS))


def _pending(base: dict[str, Any], verifier: str, verdict: Verdict | None) -> TrialScore:
    reason = f"{verifier}: {'no verdict yet' if verdict is None else verdict.reason or verdict.status}"
    return TrialScore(**base, status="pending", score=None, reason=reason)


def _zero(base: dict[str, Any], status: CaseStatus, reason: str) -> TrialScore:
    joint = [SEMANTIC] if is_construction(base["setting"]) else []
    components = dict.fromkeys([*headlines_of(base["setting"]), *joint], 0.0)
    return TrialScore(**base, status=status, score=0.0, reason=reason, components=components)


def _measured(base: dict[str, Any], verdicts: Mapping[str, Verdict], weights: Mapping[str, float]) -> TrialScore:
    rows = verifiers_of(base["setting"])
    values = {row.weighed_as: verdicts[row.name].score for row in rows if row.weighed_as}
    missing = [row.name for row in rows if row.weighed_as and values[row.weighed_as] is None]
    used = {name: value or 0.0 for name, value in values.items()}
    made = (t2s_case if is_construction(base["setting"]) else i2s_case)(valid=True, weights=weights, **used)
    components: dict[str, float | None] = {
        name: value for row in rows for name, value in row.shown(verdicts[row.name]).items()
    }
    if is_construction(base["setting"]) and weights["detailed"] + weights["overview"] > 0:
        components[SEMANTIC] = semantic_score(detailed=used["detailed"], overview=used["overview"], weights=weights)
    return TrialScore(
        **base,
        status="measured_with_missing_zero" if missing else "measured",
        score=made["score"],
        components=components,
        reason=f"worth zero, not evaluated: {', '.join(missing)}" if missing else "",
    )
