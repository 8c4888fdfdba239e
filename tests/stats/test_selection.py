"""Choosing cases: nested, better than chance where scores hang together, and no method chooses what it may not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.stats.selection import anchors, filtered_keys, greedy_order, left_out, lowest, plain, stratified_keys


def made(cases: int, configurations: int, seed: int) -> np.ndarray:
    """Scores of easy and hard cases, shape (cases, configurations)."""
    random = np.random.default_rng(seed)
    hardness = random.normal(0, 0.2, (cases, 1))
    return np.clip(0.5 + hardness + random.normal(0, 0.05, (cases, configurations)), 0, 1)


@given(st.integers(0, 10**6), st.integers(2, 15))
@settings(max_examples=30)
def test_the_order_holds_each_case_once_and_the_first_is_the_most_typical(seed: int, cases: int) -> None:
    values = np.random.default_rng(seed).random((cases, 3))
    order = greedy_order(values)
    assert sorted(order.tolist()) == list(range(cases))
    spread = values.std(axis=0, ddof=1)
    worst = np.abs((values - values.mean(axis=0)) / spread).max(axis=1)
    assert worst[order[0]] == pytest.approx(worst.min())


def test_greedy_estimates_what_it_was_not_shown_better_than_chance() -> None:
    values = made(60, 8, 3)[:, :, None]
    truth, random = values.mean(axis=0), np.random.default_rng(0)
    greedy = left_out(values, lambda pool: plain(len(pool), greedy_order(pool.reshape(len(pool), -1))[:20]))
    drawn = left_out(values, lambda pool: lowest(random.random((500, len(pool))), 20))
    middle = left_out(values, lambda pool: lowest(filtered_keys(pool.mean(axis=(1, 2)), random, 500), 20))
    errors = [np.abs(found - truth).mean() for found in (greedy, drawn, middle)]
    assert errors[0] < errors[1] / 1.3 and errors[0] < errors[2]


def test_all_cases_give_the_means_of_all() -> None:
    values = made(10, 4, 1)[:, :, None]
    for choose in (
        lambda pool: plain(len(pool), greedy_order(pool.reshape(len(pool), -1))),
        lambda pool: anchors(pool[:, :, 0], len(pool)),
        lambda pool: lowest(np.random.default_rng(1).random((3, len(pool))), len(pool)),
    ):
        assert np.abs(left_out(values, choose) - values.mean(axis=0)).max() < 1e-12


def test_strata_are_drawn_by_their_sizes() -> None:
    strata = ["a"] * 6 + ["b"] * 3 + ["c"] * 3
    chosen = lowest(stratified_keys(strata, np.random.default_rng(2), 200), 4) > 0
    for name, wanted in (("a", 2), ("b", 1), ("c", 1)):
        counts = chosen[:, [stratum == name for stratum in strata]].sum(axis=1)
        assert abs(counts - wanted).max() <= 1 and counts.mean() == pytest.approx(wanted, abs=0.1)
    assert (chosen.sum(axis=1) == 4).all()


def test_the_filter_leaves_out_the_easy_and_the_hard() -> None:
    means = np.array([0.1, 0.4, 0.5, 0.95])
    chosen = lowest(filtered_keys(means, np.random.default_rng(1), 50), 3)
    assert (chosen[:, [0, 3]] == 0).all() and chosen.sum(axis=1) == pytest.approx(1.0)
    everything = lowest(filtered_keys(np.array([0.0, 1.0]), np.random.default_rng(1), 5), 1)
    assert everything.sum(axis=1) == pytest.approx(1.0)


def test_anchors_are_the_middles_of_clusters_at_their_shares() -> None:
    values = np.array([[0.1], [0.11], [0.12], [0.8], [0.81]])
    shares = anchors(values, 2)[0]
    assert shares[1] == pytest.approx(0.6) and shares[3:].sum() == pytest.approx(0.4) and (shares > 0).sum() == 2


@given(st.integers(0, 10**6), st.integers(1, 12))
@settings(max_examples=30)
def test_anchors_of_equal_cases_are_still_as_many_as_asked(seed: int, size: int) -> None:
    values = np.random.default_rng(seed).integers(0, 2, (12, 2)).astype(float)
    shares = anchors(values, size)[0]
    assert (shares > 0).sum() == size and shares.sum() == pytest.approx(1.0)
