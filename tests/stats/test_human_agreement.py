"""Agreement and consensus on made rankings whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import kendalltau

from bench.made_people import planted_scores, rankings, scenes
from c4s.stats.human import (
    ADOPTED,
    L2,
    POINTS,
    HumanOrder,
    Preferences,
    SceneTable,
    between_annotators,
    between_groups,
    consensus,
    krippendorff_alpha,
    left_out,
    log_worths,
    macro_mean,
    rho_by_prompt,
    tau_by_prompt,
    with_scores,
)

PROMPTS, SEED = 12, 7


@pytest.fixture(scope="module")
def worth() -> np.ndarray:
    """Of scenes that are all told apart."""
    return planted_scores(SceneTable.of(scenes(PROMPTS, SEED)), ADOPTED) + np.arange(POINTS) * 1e-6


def test_a_consensus_is_the_optimum_of_its_penalised_likelihood() -> None:
    """Three of four say 0 > 1 > 2: the gradient of the log-likelihood less L2 times the squares is 0 there."""
    orders = [(0, 1, 2)] * 3 + [(2, 1, 0)]
    (found,) = log_worths([HumanOrder(0, n, order) for n, order in enumerate(orders)], 1, 3)

    def gain(theta: np.ndarray) -> float:
        total = -L2 * (theta**2).sum()
        for order in orders:
            for at in range(len(order) - 1):
                rest = theta[list(order[at:])]
                total += rest[0] - np.log(np.exp(rest).sum())
        return float(total)

    steps = np.eye(3) * 1e-5
    gradient = [(gain(found + step) - gain(found - step)) / 2e-5 for step in steps]
    assert np.abs(gradient).max() < 1e-4 and found.sum() == pytest.approx(0, abs=1e-6)
    assert found[0] > found[1] > found[2]


def test_unanimous_annotators_have_a_finite_consensus_and_agree_wholly(worth: np.ndarray) -> None:
    orders = rankings(worth, SEED)
    preferences, worths = Preferences.of(orders, PROMPTS, POINTS), log_worths(orders, PROMPTS, POINTS)
    assert np.isfinite(worths).all() and np.abs(worths).max() < 10
    assert between_annotators(preferences).tolist() == [1.0] * PROMPTS
    assert tau_by_prompt(worth, worths).tolist() == pytest.approx([1.0] * PROMPTS)
    assert krippendorff_alpha(preferences, SEED, draws=100).value == pytest.approx(1.0)


def test_noise_lowers_every_measure_of_agreement(worth: np.ndarray) -> None:
    """From hands that hardly err to hands that only click, every measure falls, and at the end it is chance."""
    found = []
    for sharpness in (60.0, 12.0, 0.0):
        orders = rankings(worth, SEED, sharpness)
        preferences, worths = Preferences.of(orders, PROMPTS, POINTS), log_worths(orders, PROMPTS, POINTS)
        found.append(
            [
                between_annotators(preferences).mean(),
                krippendorff_alpha(preferences, SEED, draws=100).value,
                with_scores(worth, preferences).mean(),
                with_scores(worth, consensus(worths)).mean(),
                tau_by_prompt(worth, worths).mean(),
            ]
        )
    table = np.array(found)
    assert (np.diff(table, axis=0) < 0).all()
    assert np.abs(table[-1] - [0.5, 0, 0.5, 0.5, 0]).max() < 0.15


def test_groups_of_annotators_agree_as_their_hands_are_sure(worth: np.ndarray) -> None:
    some = worth[:2]
    shares, taus = between_groups(rankings(some, SEED, 60.0), 2, POINTS, SEED)
    random_shares, random_taus = between_groups(rankings(some, SEED, 0.0), 2, POINTS, SEED)
    assert shares.mean() > 0.8 > 0.65 > random_shares.mean() and taus.mean() > 0.6 > 0.3 > random_taus.mean()


def test_who_clicks_at_random_is_found_by_leaving_each_out(worth: np.ndarray) -> None:
    orders = rankings(worth, SEED, 15.0, clickers={4})
    shares = {who: float(np.nanmean(found)) for who, found in left_out(orders, PROMPTS, POINTS).items()}
    assert min(shares, key=lambda who: shares[who]) == 4
    assert shares[4] < 0.62 < min(share for who, share in shares.items() if who != 4)


def test_two_annotators_on_one_pair_are_counted_by_hand() -> None:
    """A pair with votes 2 : 1 has one equal pair of annotators in three, one with 3 : 0 three in three."""
    orders = [HumanOrder(0, 0, (0, 1, 2)), HumanOrder(0, 1, (0, 2, 1)), HumanOrder(0, 2, (1, 0, 2))]
    found = between_annotators(Preferences.of(orders, 2, 3))
    assert found[0] == pytest.approx((1 / 3 + 1 + 1 / 3) / 3) and np.isnan(found[1])


def test_ties_of_a_score_agree_with_nothing() -> None:
    preferences = Preferences.of([HumanOrder(0, 0, (0, 1, 2))], 1, 3)
    assert with_scores(np.array([[0.9, 0.5, 0.5]]), preferences) == pytest.approx([2 / 3])
    assert with_scores(np.array([[0.9, 0.5, 0.5 - 5e-9]]), preferences) == pytest.approx([2 / 3])
    assert with_scores(np.array([[0.9, 0.5, 0.4]]), preferences) == pytest.approx([1.0])


def test_correlations_are_those_of_scipy_and_missing_where_they_have_no_value() -> None:
    one, two = np.array([[0.1, 0.4, 0.4, 0.9], [0.5] * 4]), np.array([[0.2, 0.3, 0.9, 0.7], [1.0, 2.0, 3.0, 4.0]])
    assert tau_by_prompt(one, two)[0] == pytest.approx(kendalltau(one[0], two[0]).statistic)
    assert np.isnan(tau_by_prompt(one, two)[1]) and np.isnan(rho_by_prompt(one, two)[1])
    assert rho_by_prompt(one, one)[0] == pytest.approx(1.0)


def test_whole_prompts_are_drawn() -> None:
    """With prompts that are all 0 or 1, the ends of the interval are multiples of one prompt."""
    found = macro_mean(np.array([1.0, 1.0, 0.0, np.nan, 1.0]), SEED)
    assert (found.value, found.prompts) == (0.75, 4)
    assert (found.low * 4, found.high) == (pytest.approx(1.0), 1.0)
    assert macro_mean(np.array([1.0, 1.0, 0.0, np.nan, 1.0]), SEED) == found
    alone = macro_mean(np.array([0.5]), SEED)
    assert alone.value == 0.5 and np.isnan(alone.low)
