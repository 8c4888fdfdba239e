"""Case scores of trials: weights, the kinds of zero, and what stays pending."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol.case import i2s_case, t2s_case
from c4s.protocol.rules import I2S_POLICY, T2S_POLICY
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.score.case import case_score

UNIT = st.floats(0, 1)


def verdict(verifier: str, status: Any = "measured", score: float | None = None, **extra: Any) -> Verdict:
    return Verdict(verifier=verifier, status=status, score=score, policy="test", **extra)


VALID = verdict("integrity", "valid")
T2S = {
    "integrity": VALID,
    "physics": verdict("physics", score=0.5),
    "detailed": verdict("detailed", score=0.8, measurements={"known_coverage": 0.9}),
    "overview": verdict("overview", score=0.6),
}
I2S = {
    "integrity": VALID,
    "physics": verdict("physics", score=0.5),
    "repair": verdict("repair", score=0.75, measurements={"precision": 0.6, "recall": 1.0}),
}


def score(setting: Any, verdicts: dict[str, Verdict], *, submitted: bool = True, **extra: Any) -> TrialScore:
    return case_score(
        case_id="c",
        setting=setting,
        configuration="a",
        repeat=1,
        judge="rule",
        engine="headless",
        submitted=submitted,
        verdicts=verdicts,
        **extra,
    )


def test_measured_cases() -> None:
    built = score("text-to-scene", T2S)
    assert (built.status, built.score, built.components["known_coverage"], built.policy) == (
        "measured",
        0.62,
        0.9,
        T2S_POLICY,
    )
    repaired = score("image-to-scene/indoor", I2S)
    assert (repaired.status, repaired.score, repaired.policy) == ("measured", 0.7, I2S_POLICY)
    assert (
        repaired.components["repair_precision"],
        repaired.components["repair_recall"],
        repaired.components["repair_f1"],
    ) == (0.6, 1.0, 0.75)


@pytest.mark.parametrize("setting", ["text-to-scene", "image-to-scene/outdoor"])
def test_the_reasons_for_a_zero_are_kept_apart(setting: Any) -> None:
    broken = {"integrity": verdict("integrity", "invalid", reason="minimum_actors: 0 of at least 1 actors")}
    rows = [score(setting, {}, submitted=False), score(setting, broken), score(setting, {}, missing_result=True)]
    assert [row.status for row in rows] == ["zero_missing_submission", "zero_invalid_candidate", "zero_missing_result"]
    assert [row.score for row in rows] == [0.0, 0.0, 0.0]
    assert rows[1].reason == "minimum_actors: 0 of at least 1 actors"
    assert all(row.components["physics"] == 0.0 for row in rows)
    if setting != "text-to-scene":
        assert all(
            row.components["repair_f1"] == row.components["repair_precision"] == row.components["repair_recall"] == 0.0
            for row in rows
        )


def test_a_fault_of_the_machinery_is_pending_and_never_a_score() -> None:
    for verdicts in (
        {},
        {"integrity": verdict("integrity", "error", reason="no snapshot")},
        {**I2S, "physics": verdict("physics", "error", reason="engine died")},
        {"integrity": VALID, "physics": I2S["physics"]},
    ):
        pending = score("image-to-scene/indoor", verdicts)
        assert (pending.status, pending.score) == ("pending", None)
        assert pending.reason


def test_an_unavailable_component_keeps_its_weight() -> None:
    built = score("text-to-scene", {**T2S, "overview": verdict("overview", "not_evaluated")})
    assert (built.status, built.score, built.components["overview"]) == ("measured_with_missing_zero", 0.26, 0.0)
    repaired = score("image-to-scene/indoor", {**I2S, "repair": verdict("repair", "not_evaluated")})
    assert (repaired.status, repaired.score, repaired.components["repair_f1"]) == (
        "measured_with_missing_zero",
        0.1,
        0.0,
    )
    neutral = score("image-to-scene/indoor", {**I2S, "physics": verdict("physics", "not_applicable")})
    assert (neutral.status, neutral.score) == ("measured_with_missing_zero", 0.6)


@given(UNIT, UNIT, UNIT)
def test_scores_stay_in_range_and_follow_the_weights(a: float, b: float, c: float) -> None:
    built = t2s_case(valid=True, detailed=a, overview=b, physics=c)["score"]
    assert 0 <= built <= 1
    assert built == pytest.approx(0.2 * a + 0.6 * b + 0.2 * c, abs=5.1e-5)
    repaired = i2s_case(valid=True, repair_f1=a, physics=c)["score"]
    assert 0 <= repaired <= 1
    assert repaired == pytest.approx(0.8 * a + 0.2 * c, abs=5.1e-7)


@pytest.mark.parametrize("bad", [None, True, "0.5", float("nan"), float("inf"), -0.1, 1.1])
def test_what_is_no_number(bad: Any) -> None:
    assert t2s_case(valid=True, detailed=bad, overview=1.0, physics=1.0)["missing_components"] == ["detailed"]
    with pytest.raises(BadInput):
        i2s_case(valid=True, repair_f1=bad, physics=0.5)
