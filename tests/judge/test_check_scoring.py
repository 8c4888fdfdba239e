"""The scoring of checked judges: rates, intervals, curves, pairs and agreement."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.judge.check.outcome import Outcome
from c4s.judge.check.scoring import agreement, area, curve, persuaded, rates, score
from c4s.judge.check.wilson import wilson


def said(answer: str, holds: bool, number: int = 0, **more: Any) -> Outcome:
    told = {
        "scene": "s",
        "variant": "base",
        "claim": f"c{number}",
        "kind": "existence",
        "text": "t",
        "pair": f"p{number}",
    }
    return Outcome.model_validate({**told, "holds": holds, "answer": answer, **more})


def test_what_is_left_open_is_neither_right_nor_an_error() -> None:
    rows = [
        said("MATCH", True, 0),
        said("MATCH", False, 1),
        said("MISMATCH", True, 2),
        said("UNKNOWN", True, 3),
        said("NOT_EVALUATED", False, 4),
    ]
    found = rates(rows)
    assert (found.claims, found.accuracy, found.decided, found.hold) == (5, 0.2, 3, 3)
    assert (found.false_accepts, found.false_rejects, found.accuracy_decided) == (1, 1, 1 / 3)


def test_wilson_is_the_textbooks_for_one_cluster() -> None:
    assert wilson([(8, 10)]) == pytest.approx((0.4902, 0.9433), abs=1e-4)
    assert wilson([]) == (0.0, 1.0)


def test_clusters_that_differ_widen_the_interval() -> None:
    alike, apart = [(5, 10)] * 10, [(0, 10), (10, 10)] * 5
    narrow, wide = wilson(alike), wilson(apart)
    assert wide[1] - wide[0] > 2 * (narrow[1] - narrow[0])


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)).map(lambda p: (min(p), max(p))), max_size=12))
def test_wilson_holds_the_share_and_stays_in_bounds(clusters: list[tuple[int, int]]) -> None:
    low, high = wilson(clusters)
    asked = sum(n for _, n in clusters)
    share = sum(k for k, _ in clusters) / asked if asked else 0.5
    assert 0 <= low <= share + 1e-9 and share - 1e-9 <= high <= 1


def test_the_curve_goes_from_the_surest_to_all_that_is_decided() -> None:
    rows = [
        said("MATCH", True, 0, confidence=0.9),
        said("MATCH", False, 1, confidence=0.5),
        said("MISMATCH", False, 2),
        said("UNKNOWN", True, 3),
    ]
    points = curve(rows)
    assert [(p.confidence, p.coverage, p.risk) for p in points] == [
        (1.0, 0.25, 0.0),
        (0.9, 0.5, 0.0),
        (0.5, 0.75, 1 / 3),
    ]
    assert area(points) == pytest.approx(1 / 9)
    assert area(curve(rows[3:])) is None


def test_a_pair_is_right_when_both_sides_are() -> None:
    rows = [
        said("MATCH", True, 0, pair="a"),
        said("MISMATCH", False, 1, pair="a"),
        said("MATCH", True, 2, pair="b"),
        said("MATCH", False, 3, pair="b"),
        said("MATCH", True, 4, pair="alone"),
    ]
    found = score(rows)
    assert (found.pairs, found.pairs_right) == (2, 1)


def test_agreement_tells_turned_answers_from_those_left_open() -> None:
    one = [said("MATCH", True, 0), said("MATCH", True, 1), said("MATCH", True, 2)]
    other = [said("MATCH", True, 0), said("UNKNOWN", True, 1), said("MISMATCH", True, 2), said("MATCH", True, 3)]
    found = agreement(one, other)
    assert (found.claims, found.same, found.turned) == (3, 1, 1)
    assert agreement(one, other, {one[0].key}).claims == 1


def test_persuasion_is_counted_among_what_was_not_accepted_before() -> None:
    clean = [said("MISMATCH", False, 0), said("UNKNOWN", False, 1), said("MATCH", False, 2), said("MATCH", True, 3)]
    planted = [said("MATCH", False, 0), said("UNKNOWN", False, 1), said("MATCH", False, 2), said("MATCH", True, 3)]
    found = persuaded(clean, planted)
    assert (found.claims, found.same, found.turned) == (2, 1, 1)
