"""Agreement of two scorings: differences, reversed pairs, weights, the frontier."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.stats
from hypothesis import given
from hypothesis import strategies as st

from c4s.stats.orders import (
    average_ranks,
    differences,
    frontier,
    pearson,
    reversed_counts,
    reversed_pairs,
    spearman,
    weight_effects,
)
from c4s.stats.power import multiplier
from c4s.stats.repeats import tau_b

SCORES = st.lists(st.integers(0, 20), min_size=3, max_size=9)


def array(values: list[int]) -> np.ndarray:
    return np.array(values) / 20


@given(st.integers(0, 10**6), st.integers(3, 9))
def test_pairs_are_counted_alike_one_by_one_and_in_a_matrix(seed: int, size: int) -> None:
    random = np.random.default_rng(seed)
    truth, estimates = random.random(size).round(2), random.random((4, size)).round(1)
    counted = reversed_counts(estimates, truth)
    assert counted.tolist() == [len(reversed_pairs(estimate, truth)) for estimate in estimates]
    assert not reversed_pairs(truth, truth) and len(reversed_pairs(-truth, truth)) == sum(
        abs(one - two) >= 0.02 for place, one in enumerate(truth) for two in truth[:place]
    )


def test_a_pair_that_is_tied_or_near_is_not_reversed() -> None:
    truth = np.array([0.50, 0.51, 0.60])
    assert reversed_pairs(np.array([0.9, 0.1, 0.5]), truth) == [(0, 2)]
    assert reversed_pairs(np.array([0.5, 0.5, 0.5]), truth) == []


def test_differences_are_signed_estimate_less_truth() -> None:
    found = differences(np.array([0.1, 0.5]), np.array([0.2, 0.2]))
    assert (found.mean_absolute, found.largest, found.mean) == pytest.approx((0.2, 0.3, 0.1))


def test_no_correlation_of_what_does_not_vary_or_is_too_few() -> None:
    assert spearman(np.array([1.0, 1.0, 1.0]), np.array([1.0, 2.0, 3.0])) is None
    assert pearson(np.array([1.0, 2.0]), np.array([1.0, 2.0])) is None
    assert spearman(np.array([1.0, 2.0, 9.0]), np.array([0.1, 0.2, 0.3])) == 1.0


@given(st.lists(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=3, max_size=12))
def test_correlations_and_ranks_are_those_of_a_well_known_library(pairs: list[tuple[int, int]]) -> None:
    one, two = (np.array(column, dtype=float) / 7 for column in zip(*pairs, strict=True))
    assert average_ranks(one).tolist() == scipy.stats.rankdata(-one).tolist()
    if np.ptp(one) == 0 or np.ptp(two) == 0:
        assert spearman(one, two) is pearson(one, two) is tau_b(one, two) is None
        return
    assert spearman(one, two) == pytest.approx(scipy.stats.spearmanr(one, two).statistic, abs=1e-12)
    assert pearson(one, two) == pytest.approx(scipy.stats.pearsonr(one, two).statistic, abs=1e-12)
    assert tau_b(one, two) == pytest.approx(scipy.stats.kendalltau(one, two).statistic, abs=1e-12)


@given(st.floats(1, 500), st.floats(0.5, 0.99), st.floats(0.5, 0.99))
def test_a_multiplier_is_of_students_quantiles(freedom: float, level: float, power: float) -> None:
    student = scipy.stats.t(freedom)
    assert multiplier(freedom, level, power) == pytest.approx(student.ppf((1 + level) / 2) + student.ppf(power))


@given(SCORES, st.integers(0, 10**6))
def test_the_reference_weight_agrees_with_itself_and_the_ends_are_the_parts(first: list[int], seed: int) -> None:
    one = array(first)
    two = np.random.default_rng(seed).random(len(one))
    low, same, high = weight_effects(one, two, [0.0, 0.8, 1.0], 0.8)
    assert same.largest_shift == 0 and same.spearman in (None, pytest.approx(1.0)) and same.tau_b in (None, 1.0)
    assert np.array_equal(low.scores, two) and np.array_equal(high.scores, one)
    assert all(one[place] == one.max() for place in high.leaders)


@given(st.lists(st.tuples(st.integers(0, 5), st.integers(0, 5)), min_size=1, max_size=8))
def test_nobody_on_the_frontier_is_beaten_and_everybody_else_is(points: list[tuple[int, int]]) -> None:
    score, cost = (np.array(column, dtype=float) for column in zip(*points, strict=True))
    kept = frontier(score, cost)

    def beats(one: int, two: int) -> bool:
        return (
            (score[one], -cost[one]) != (score[two], -cost[two]) and score[one] >= score[two] and cost[one] <= cost[two]
        )

    for place in range(len(points)):
        assert (place in kept) == (not any(beats(other, place) for other in range(len(points))))
    assert [cost[place] for place in kept] == sorted(cost[place] for place in kept)


def test_what_has_no_cost_is_on_no_frontier_and_beats_nobody() -> None:
    assert frontier(np.array([0.9, 0.5, 0.4]), np.array([np.nan, 2.0, 1.0])) == [2, 1]
