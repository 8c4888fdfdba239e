"""Model aggregation: pooled means, missing results, ranks with ties, and refusals."""

from __future__ import annotations

import math
import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol.overview import overview_score, severe_cap_eligible
from c4s.score.aggregate import aggregate, ranks, setting_of
from c4s.score.batch import score_batch

T2S, INDOOR, OUTDOOR = "text-to-scene", "image-to-scene/indoor", "image-to-scene/outdoor"


def row(model: str, setting: str, case: str, score: Any, status: str = "measured", **rates: Any) -> dict[str, Any]:
    return {"model": model, "setting": setting, "case_id": case, "status": status, "score": score, **rates}


def table(model: str, t2s: float, indoor: float, *outdoor: float) -> list[dict[str, Any]]:
    return [
        row(model, T2S, "t", t2s),
        row(model, INDOOR, "i", indoor),
        *(row(model, OUTDOOR, f"o{n}", value) for n, value in enumerate(outdoor)),
    ]


def test_cases_are_pooled_not_domains() -> None:
    (only,) = aggregate(table("m", 0.4, 0.9, 0.3, 0.3))
    assert only["i2s_score"] == pytest.approx(0.5)
    assert only["model_score"] == pytest.approx(0.45)


def test_ties_share_a_rank_and_are_sorted_by_name() -> None:
    found = aggregate([*table("b", 0.5, 0.5, 0.5), *table("a", 0.5, 0.5, 0.5), *table("c", 0.1, 0.1, 0.1)])
    assert [(r["model"], r["model_rank"]) for r in found] == [("a", 1), ("b", 1), ("c", 3)]
    assert ranks([0.2, None, 0.9, 0.2]) == [2, None, 1, 2]


def test_an_absent_case_is_a_zero_or_unresolved_but_never_dropped() -> None:
    rows, schedule = table("m", 1.0, 1.0, 1.0), {T2S: ["t"], INDOOR: ["i"], OUTDOOR: ["o0", "o1"]}
    zero = aggregate(rows, schedule)[0]
    assert (zero["outdoor_i2s_score"], zero["outdoor_zero_cases"], zero["outdoor_cases"]) == (0.5, 1, 2)
    open_ = aggregate(rows, schedule, missing_as_zero=False)[0]
    assert (open_["outdoor_i2s_score"], open_["model_score"], open_["model_rank"]) == (None, None, None)
    assert open_["unresolved_cases"] == ["image-to-scene/outdoor:o1"]
    assert open_["t2s_score"] == 1.0


def test_a_pending_case_withholds_the_aggregate() -> None:
    found = aggregate([*table("m", 1.0, 1.0, 1.0), row("m", T2S, "u", 0.3, "pending")])[0]
    assert (found["t2s_score"], found["i2s_score"], found["model_score"]) == (None, 1.0, None)


@pytest.mark.parametrize(
    ("rows", "schedule"),
    [
        ([row("m", T2S, "t", 0.1), row("m", "t2s", "t", 0.2)], None),
        ([row("m", T2S, "t", 1.5)], None),
        ([row("m", T2S, "t", float("nan"))], None),
        ([row("m", "elsewhere", "t", 1.0)], None),
        ([row("m", T2S, "x", 1.0)], {T2S: ["t"]}),
        ([], {T2S: []}),
        ([row("", T2S, "x", 1.0)], None),
    ],
)
def test_refusals(rows: list[dict[str, Any]], schedule: Any) -> None:
    with pytest.raises(BadInput):
        aggregate(rows, schedule)


@settings(max_examples=40)
@given(st.lists(st.floats(0, 1), min_size=3, max_size=8), st.randoms(use_true_random=False))
def test_the_order_of_rows_does_not_matter(values: list[float], rng: random.Random) -> None:
    rows = table("m", *values[:3], *values[3:])
    shuffled = list(rows)
    rng.shuffle(shuffled)
    assert aggregate(rows) == aggregate(shuffled)


def test_setting_names() -> None:
    assert setting_of("IMAGE_TO_SCENE/INDOOR") == INDOOR
    assert setting_of("t2s") == T2S


def test_severe_cap_needs_certainty_two_views_and_words() -> None:
    good: dict[str, Any] = {
        "severe": True,
        "confidence": 0.8,
        "views": [0, 2],
        "categories": ["gap"],
        "issues": ["a wall floats"],
    }
    assert severe_cap_eligible(**good)
    changes: list[dict[str, Any]] = [
        {"severe": False},
        {"confidence": 0.79},
        {"views": [1, 1]},
        {"views": []},
        {"categories": []},
        {"issues": [" "]},
    ]
    for change in changes:
        assert not severe_cap_eligible(**(good | change))
    dimensions = dict.fromkeys(
        ("global_prompt_alignment", "composition_and_layout", "style_atmosphere_coherence", "completeness_and_polish"),
        1.0,
    )
    capped = overview_score(dimensions, 1.0, True)
    assert (capped["score"], capped["severe_cap_applied"]) == (0.4, True)


def test_a_batch_answers_bad_rows_with_one_line() -> None:
    answers = list(score_batch([3, {"name": "x", "kind": "nothing"}, {"name": "y", "kind": "i2s_case", "input": []}]))
    assert [set(answer) for answer in answers] == [{"name", "error"}] * 3


def test_a_zero_by_rule_is_zero_whatever_the_row_says() -> None:
    for status in ("zero_invalid_candidate", "zero_missing_submission", "zero_missing_result"):
        rows = table("m", 1.0, 1.0, 1.0)
        rows[0] |= {"status": status, "score": "n/a"}
        assert aggregate(rows)[0]["t2s_score"] == 0.0
        rows[1] |= {"status": status, "score": None, "repair_f1": 7}
        assert aggregate(rows)[0]["indoor_f1_case_macro"] == 0.0


def test_only_rates_that_enter_a_mean_are_read() -> None:
    rows = table("m", 1.0, 1.0, 1.0)
    rows[0]["physics"] = "n/a"
    assert aggregate(rows)[0]["t2s_score"] == 1.0
    rows[2] |= {"status": "error", "repair_f1": 7}
    assert aggregate(rows)[0]["outdoor_f1_case_macro"] is None
    rows[1]["precision"] = 7
    with pytest.raises(BadInput, match="precision"):
        aggregate(rows)


def test_a_macro_rate_needs_the_rate_of_every_row_that_is_no_zero() -> None:
    rows = [
        row("m", INDOOR, "a", 1.0, repair_f1="0.5"),
        row("m", INDOOR, "b", 1.0, repair_f1=""),
        row("m", OUTDOOR, "c", 0.0, "zero_missing_result"),
    ]
    assert aggregate(rows)[0]["indoor_f1_case_macro"] is None
    rows[1]["repair_f1"] = 1
    found = aggregate(rows)[0]
    assert (found["indoor_f1_case_macro"], found["i2s_f1_case_macro"]) == (0.75, 0.5)
    assert found["outdoor_f1_case_macro"] == 0.0


def test_unresolved_cases_keep_the_schedules_order_and_an_unscheduled_setting_does_not_count() -> None:
    schedule = {OUTDOOR: ["o1", "o0"], INDOOR: ["i"]}
    found = aggregate(table("m", 0.5, 1.0, 1.0), schedule, missing_as_zero=False)[0]
    assert found["unresolved_cases"] == [f"{OUTDOOR}:o1"] and found["t2s_cases"] == 0
    empty = aggregate([row("m", T2S, "t", 0.5)], schedule, missing_as_zero=False)[0]
    assert empty["unresolved_cases"] == [f"{OUTDOOR}:o1", f"{OUTDOOR}:o0", f"{INDOOR}:i"]


@given(st.lists(st.floats(0, 1), min_size=1, max_size=7))
def test_a_mean_of_one_setting_is_not_weighed_again(values: list[float]) -> None:
    rows = [row("m", INDOOR, f"c{n}", value, repair_f1=value) for n, value in enumerate(values)]
    found = aggregate(rows)[0]
    assert found["indoor_i2s_score"] == found["indoor_f1_case_macro"] == math.fsum(values) / len(values)


def test_the_published_shares_of_the_domains() -> None:
    rows = [
        row("m", T2S, "t", 0.0),
        *(row("m", INDOOR, f"i{n}", 1.0) for n in range(25)),
        *(row("m", OUTDOOR, f"o{n}", 0.0) for n in range(50)),
    ]
    assert aggregate(rows)[0]["i2s_score"] == pytest.approx(1 / 3)
    private = [row("m", INDOOR, f"i{n}", 1.0) for n in range(55)] + [row("m", OUTDOOR, f"o{n}", 0.0) for n in range(30)]
    assert aggregate(private)[0]["i2s_score"] == pytest.approx(11 / 17)
