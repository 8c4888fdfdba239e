"""The case score of a trial, from its verdicts (paper, "Score Aggregation and Reporting"; scorer fact 7)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.protocol.case import SEMANTIC, i2s_case, semantic_of, t2s_case
from c4s.protocol.rules import CASE_POLICY, GATE, I2S_WEIGHTS, T2S_WEIGHTS
from c4s.protocol.settings import Setting, is_construction
from c4s.records.score import CaseStatus, TrialScore
from c4s.records.verdict import Verdict
from c4s.verify.registry import headlines_of, weighed_of


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
        verdicts: by verifier name: the gate's, and those of the setting that have a weight (``c4s.verify.registry``).
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
    for verifier in weighed_of(setting):
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
    rows = weighed_of(base["setting"])
    values = {row.weighed_as: verdicts[row.name].score for row in rows}
    missing = [row.name for row in rows if values[row.weighed_as] is None]
    used = {name: value or 0.0 for name, value in values.items()}
    made = (t2s_case if is_construction(base["setting"]) else i2s_case)(valid=True, weights=weights, **used)
    components: dict[str, float | None] = {
        name: value for row in rows for name, value in row.shown(verdicts[row.name]).items()
    }
    if is_construction(base["setting"]):
        components[SEMANTIC] = semantic_of(used, weights)
    return TrialScore(
        **base,
        status="measured_with_missing_zero" if missing else "measured",
        score=made["score"],
        components=components,
        reason=f"worth zero, not evaluated: {', '.join(missing)}" if missing else "",
    )
