"""Spread, passes, reliability and drift on tables whose truth is known."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import f_oneway

from c4s.stats.drift import drift
from c4s.stats.passes import pass_all, pass_at
from c4s.stats.reliability import (
    outcome_consistency,
    overall_consistency,
    resource_consistency,
    trajectory_consistency,
    unbiased_outcome_consistency,
)
from c4s.stats.variance import run_variances, spread

NAN = float("nan")


def test_planted_variances_are_recovered_without_bias() -> None:
    """400 suites of 30 cases, 1 to 4 runs each: variance 0.04 between cases, 0.01 between runs (errors under 3 %)."""
    random = np.random.default_rng(5)
    runs = 1 + np.arange(30) % 4
    found = []
    for _ in range(400):
        scores = random.normal(0, 0.2, (30, 1)) + random.normal(0, 0.1, (30, 4))
        found.append(spread(np.where(np.arange(4) < runs[:, None], scores, np.nan)))
    assert np.mean([one.between_cases for one in found]) == pytest.approx(0.04, rel=0.03)
    assert np.mean([one.between_runs for one in found]) == pytest.approx(0.01, rel=0.03)


def test_mean_squares_are_those_of_an_analysis_of_variance() -> None:
    table = np.random.default_rng(2).random((6, 5))
    found = spread(table)
    ratio = f_oneway(*table).statistic
    assert (5 * found.between_cases + found.between_runs) / found.between_runs == pytest.approx(ratio)
    assert found.between_runs == pytest.approx(np.mean(run_variances(table)))


def test_what_has_no_spread_tells_so() -> None:
    assert spread([[0.5], [0.7]]).between_runs is None and spread([[0.5, 0.7]]).between_cases is None
    same = spread([[0.5, 0.5], [0.5, 0.5]])
    assert (same.between_cases, same.between_runs, same.intraclass) == (0.0, 0.0, None)
    assert spread([[0.0, 1.0], [1.0, 0.0]]).between_cases == -0.25
    assert spread([[0.0, 1.0], [1.0, 0.0]]).intraclass == 0.0
    assert spread([[0.1] * 3] * 3).intraclass is None
    assert spread([[0.2, NAN], [NAN, NAN], [0.2, 0.4]]).cases == 2
    assert np.isnan(run_variances([[0.2, NAN]])).all()


@given(st.lists(st.booleans(), min_size=1, max_size=7), st.integers(1, 7))
def test_passes_are_shares_of_all_choices_of_k_runs(outcomes: list[bool], k: int) -> None:
    chosen = list(combinations(outcomes, k))
    one, whole = (float(found(sum(outcomes), len(outcomes), k)) for found in (pass_at, pass_all))
    if chosen:
        assert one == pytest.approx(np.mean([any(part) for part in chosen]))
        assert whole == pytest.approx(np.mean([all(part) for part in chosen]))
    else:
        assert np.isnan(one) and np.isnan(whole)


def test_passes_without_bias() -> None:
    """Of 5 runs that succeed with chance 0.4: 1 - 0.6^3 and 0.4^3 (20,000 cases, errors under 1.5 points)."""
    successes = np.random.default_rng(1).binomial(5, 0.4, 20_000)
    assert pass_at(successes, 5, 3).mean() == pytest.approx(1 - 0.6**3, abs=0.01)
    assert pass_all(successes, 5, 3).mean() == pytest.approx(0.4**3, abs=0.01)
    with pytest.raises(ValueError, match="one run"):
        pass_at(1, 2, 0)


def preprint(successes: int, runs: int) -> float:
    """The formula that was corrected: 1 - s^2 / (p (1 - p) + 1e-8)."""
    share = successes / runs
    return 1 - share * (1 - share) * runs / (runs - 1) / (share * (1 - share) + 1e-8)


@pytest.mark.parametrize(
    ("successes", "runs", "corrected"), [(0, 5, 1), (5, 5, 1), (1, 5, 0.36), (2, 5, 0.04), (2, 4, 0)]
)
def test_outcome_consistency_by_the_corrected_formula(successes: int, runs: int, corrected: float) -> None:
    """(2 p - 1)^2; the preprint's told the same of every case that is not always solved or always failed."""
    assert float(outcome_consistency(successes, runs)) == pytest.approx(corrected)
    if corrected < 1:
        assert preprint(successes, runs) == pytest.approx(-1 / (runs - 1), abs=1e-6)


@given(st.integers(2, 9), st.data())
def test_outcome_consistency_does_not_know_success_from_failure(runs: int, data: st.DataObject) -> None:
    successes = data.draw(st.integers(0, runs))
    assert 0 <= float(outcome_consistency(successes, runs)) <= 1
    assert float(outcome_consistency(successes, runs)) == pytest.approx(
        float(outcome_consistency(runs - successes, runs))
    )


def test_the_bias_of_few_runs_is_told_and_taken_away() -> None:
    """Three runs with chance 0.3: the truth is 0.16, the published mean 4 p (1 - p) / 3 = 0.28 above it."""
    successes = np.random.default_rng(4).binomial(3, 0.3, 50_000)
    runs = np.full(50_000, 3)
    assert outcome_consistency(successes, runs).mean() == pytest.approx(0.16 + 0.28, abs=0.01)
    assert unbiased_outcome_consistency(successes, runs).mean() == pytest.approx(0.16, abs=0.01)
    assert np.isnan(outcome_consistency(1, 1)) and np.isnan(unbiased_outcome_consistency(1, 1))


def test_resources_by_hand() -> None:
    assert resource_consistency([[3.0, 3.0, 3.0]]) == 1.0
    assert resource_consistency([[1.0, 3.0]]) == pytest.approx(np.exp(-np.sqrt(2) / 2))
    assert resource_consistency([[1.0, 3.0], [2.0, 2.0]]) == pytest.approx(np.exp(-np.sqrt(2) / 4))
    assert resource_consistency([[1.0, 3.0], [NAN, 2.0], [0.0, 2.0]]) == resource_consistency([[1.0, 3.0]])
    assert np.isnan(resource_consistency([[1.0], []]))


def test_trajectories_by_hand() -> None:
    assert trajectory_consistency([[2, 4, 0], [1, 2, 0]]) == 1.0
    assert trajectory_consistency([[1, 0], [0, 3]]) == pytest.approx(1 - np.sqrt(np.log(2)))
    assert np.isnan(trajectory_consistency([[1, 2]])) and np.isnan(trajectory_consistency([[1, 2], [0, 0]]))
    assert np.isnan(trajectory_consistency(np.zeros((3, 0))))
    three = trajectory_consistency([[1, 0], [1, 0], [0, 1]])
    assert three == pytest.approx(1 - 2 / 3 * np.sqrt(np.log(2)))


def test_aspects_weigh_alike_and_what_is_missing_is_left_out() -> None:
    assert overall_consistency([0.9, 0.6, 0.3]) == pytest.approx(0.6)
    assert overall_consistency([0.9, NAN, 0.3]) == pytest.approx(0.6) and np.isnan(overall_consistency([NAN]))


def test_a_planted_drift_is_found_and_none_is_not() -> None:
    random = np.random.default_rng(8)
    cases, shares = random.normal(0, 0.3, (40, 1)), np.full(40, 1 / 40)
    still = cases + random.normal(0, 0.1, (40, 6))
    falling = drift(still - 0.02 * np.arange(6), shares, 2000)
    assert falling.slope == pytest.approx(-0.02, abs=0.01) and falling.slope_p < 0.01 and falling.spread_p < 0.05
    jump = drift(still + 0.08 * (np.arange(6) == 2), shares, 2000)
    assert jump.spread_p < 0.01 < jump.slope_p
    alike = drift(np.repeat(cases, 3, axis=1), shares, 200)
    assert (alike.slope, alike.slope_p, alike.spread, alike.spread_p) == (pytest.approx(0), 1.0, pytest.approx(0), 1.0)


def test_without_drift_p_is_small_as_often_as_it_says() -> None:
    """600 series of 12 cases in 4 nights: 5 % at most 0.05 (standard error 0.9 points)."""
    random = np.random.default_rng(9)
    found = [drift(random.random((12, 4)) ** 3, np.full(12, 1 / 12), 199, seed) for seed in range(600)]
    for p in ([one.slope_p for one in found], [one.spread_p for one in found]):
        assert 0.02 < np.mean(np.array(p) <= 0.05) < 0.08


@pytest.mark.parametrize("wrong", [[0.5, 0.6], [[0.5], [0.6]], [[0.5, NAN]]])
def test_what_is_no_series_is_refused(wrong: object) -> None:
    with pytest.raises(ValueError, match="two nights"):
        drift(wrong, [0.5, 0.5])
