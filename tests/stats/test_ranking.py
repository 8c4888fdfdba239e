"""Ranks under resampling, difficulty, power and judges on tables whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import kendalltau, nct, pearsonr
from scipy.stats import t as student

from c4s.stats.bootstrap import Design
from c4s.stats.difficulty import case_rest_correlations, turned_pairs
from c4s.stats.judges import kappa, score_agreement
from c4s.stats.orders import frontier, pearson, spearman, weight_effects
from c4s.stats.power import clustered_variances, detectable, multiplier, repeats_needed, sources_needed
from c4s.stats.ranks import competition_ranks, rank_interval
from c4s.stats.repeats import tau_b
from c4s.stats.stability import above_shares, order_agreements, rank_shares

SCORES = st.lists(st.lists(st.integers(0, 4), min_size=4, max_size=4), min_size=1, max_size=8)


@given(SCORES)
def test_shares_of_ranks_and_pairs_add_up(rows: list[list[int]]) -> None:
    drawn = np.array(rows, dtype=float)
    shares, above = rank_shares(drawn), above_shares(drawn)
    assert shares.sum(axis=1) == pytest.approx(1) and above + above.T == pytest.approx(1)
    assert np.diag(above) == pytest.approx(0.5) and shares[:, 0].sum() >= 1 - 1e-12
    low, high = rank_interval(drawn)
    assert (low >= 1).all() and (high <= 4).all() and (low <= high).all()


def test_means_of_the_same_numbers_in_another_order_are_tied() -> None:
    """Sums in another order differ by rounding, and rounding is no rank."""
    one, other = np.array([0.1 + 0.2 + 0.3, 0.5, 0.4]), np.array([0.3 + 0.2 + 0.1, 0.5, 0.4])
    assert one[0] != other[0]
    assert competition_ranks([one[0], other[0]]).tolist() == [1, 1]
    (effect,) = weight_effects(one[:1].repeat(2), other[:1].repeat(2), [0.8], 0.7)
    assert (effect.leaders, effect.largest_shift) == ((0, 1), 0.0)
    assert spearman(np.array([one[0], other[0], one[0]]), one) is None
    assert pearson(np.array([one[0], other[0], one[0]]), one) is None
    assert tau_b(np.array([one[0], other[0]]), np.array([2.0, 1.0])) is None
    assert frontier(np.array([other[0], one[0]]), np.array([1.0, 2.0])) == [0]


def test_ties_share_the_smallest_rank() -> None:
    assert competition_ranks([0.5, 0.9, 0.5, 0.1]).tolist() == [2, 1, 2, 4]
    assert rank_shares(np.array([[0.5, 0.5]])).tolist() == [[1.0, 0.0], [1.0, 0.0]]


@given(st.permutations(range(5)), st.permutations(range(5)))
def test_agreement_of_orders_without_ties_is_kendalls(one: list[int], other: list[int]) -> None:
    found = order_agreements(np.array(one, dtype=float), np.array([other], dtype=float))
    assert found[0] == pytest.approx(kendalltau(one, other).statistic)


def test_a_pair_that_is_tied_in_both_orders_agrees() -> None:
    observed = np.array([0.9, 0.5, 0.5])
    drawn = np.array([[0.8, 0.4, 0.4], [0.8, 0.4, 0.3], [0.1, 0.4, 0.4]])
    assert order_agreements(observed, drawn).tolist() == pytest.approx([1.0, 2 / 3, -1 / 3])


def test_a_case_is_compared_with_the_rest_and_not_with_itself() -> None:
    random = np.random.default_rng(0)
    values, shares = random.random((6, 8)), np.array([0.1, 0.1, 0.2, 0.2, 0.2, 0.2])
    found = case_rest_correlations(values, shares)
    for place in range(6):
        rest = np.delete(shares, place) @ np.delete(values, place, axis=0)
        assert found[place] == pytest.approx(pearsonr(values[place], rest).statistic)
        whole = shares @ values
        turned = sum((whole[one] - whole[two]) * (rest[one] - rest[two]) < 0 for one in range(8) for two in range(one))
        assert turned_pairs(values, shares)[place] == turned


def test_what_does_not_spread_has_no_correlation_and_ties_turn_nothing() -> None:
    values = np.array([[0.5, 0.5, 0.5], [0.1, 0.2, 0.3], [0.3, 0.2, 0.1]])
    assert np.isnan(case_rest_correlations(values, np.ones(3) / 3)[0])
    assert turned_pairs(values, np.ones(3) / 3).tolist() == [0, 0, 0]
    assert np.isnan(case_rest_correlations(values[:, :2], np.ones(3) / 3)).all()
    assert np.isnan(case_rest_correlations(values[1:2], [1.0])).all() and turned_pairs(values[1:2], [1.0]) == [0]


def test_a_clustered_variance_is_that_of_the_means_of_equal_sources() -> None:
    values = np.random.default_rng(1).random((12, 2))
    design = Design.of([place % 4 for place in range(12)], ["d"] * 12)
    means = values.reshape(3, 4, 2).mean(axis=0)
    assert clustered_variances(design, values)[0] == pytest.approx(means.var(axis=0, ddof=1) / 4)
    assert np.isnan(clustered_variances(Design.of(["a", "a"], ["d", "d"]), [0.1, 0.2])).all()


def test_a_difference_of_the_least_size_is_found_as_often_as_it_says() -> None:
    """The noncentral t of 18 degrees of freedom gives 80 % within half a point."""
    freedom = 18
    found = 1 - nct.cdf(student.ppf(0.975, freedom), freedom, multiplier(freedom))
    assert found == pytest.approx(0.8, abs=0.005)


@settings(max_examples=50)
@given(st.floats(0.005, 0.2), st.floats(1e-6, 1e-2), st.integers(2, 40))
def test_so_many_sources_are_enough_and_one_less_is_not(difference: float, variance: float, sources: int) -> None:
    needed = sources_needed(difference, variance, sources, 1)
    if needed is None:
        return
    assert detectable(variance * sources / needed, needed - 1) <= difference
    assert needed == 2 or detectable(variance * sources / (needed - 1), needed - 2) > difference


def test_repeats_help_only_against_the_noise_of_runs() -> None:
    noise = 0.0004
    assert repeats_needed(0.05, noise, noise, 1, 20) == 2
    assert repeats_needed(0.05, noise, 0.0, 1, 20) is None
    assert repeats_needed(0.2, noise, noise / 2, 3, 20) == 1
    assert sources_needed(1e-9, 0.01, 10, 1) is None


def test_judges_are_compared_as_cohen_does() -> None:
    random = np.random.default_rng(6)
    pair = random.random((2, 30)).round(2)
    found = score_agreement(*pair)
    assert found.bias == pytest.approx((pair[0] - pair[1]).mean()) and found.things == 30
    same = score_agreement(pair[0], pair[0])
    assert (same.alpha, same.tau_b, same.equal, same.distance) == (1.0, 1.0, 1.0, 0.0)
    assert score_agreement([0.5, 0.5], [0.5, 0.5]).alpha is None
    assert kappa([[20, 5], [10, 15]]) == pytest.approx(0.4)
    assert kappa([[7, 0], [0, 0]]) is None and kappa(np.zeros((2, 2))) is None and kappa([[3, 0], [0, 3]]) == 1.0
