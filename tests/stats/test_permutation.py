"""Sign flips of sources and Holm: against scipy, by hand, on data without a difference."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import permutation_test

from c4s.stats.bootstrap import Design
from c4s.stats.multiple import holm
from c4s.stats.permutation import EXACT_CLUSTERS, cluster_sums, sign_flip

SUMS = st.lists(st.integers(-5, 5), min_size=2, max_size=9)


@settings(max_examples=60, deadline=None)
@given(SUMS)
def test_all_flips_are_those_of_scipy(sums: list[int]) -> None:
    told = permutation_test(
        (np.array(sums, dtype=float),), np.sum, permutation_type="samples", n_resamples=np.inf, vectorized=False
    )
    assert sign_flip(sums).exact and sign_flip(sums).p == pytest.approx(told.pvalue)


@given(SUMS, st.randoms(use_true_random=False), st.floats(0.01, 100))
def test_neither_order_nor_sign_nor_unit_decides(sums: list[int], random: object, unit: float) -> None:
    found = sign_flip(sums)
    other = [-unit * value for value in sums]
    random.shuffle(other)  # type: ignore[attr-defined]
    assert sign_flip(other).p == found.p and found.least <= found.p <= 1.0


def test_four_sources_cannot_show_anything_at_five_percent() -> None:
    found = sign_flip([1.0, 2.0, 3.0, 4.0])
    assert (found.p, found.least, found.flips) == (0.125, 0.125, 16)


def test_ties_and_rounding_count_as_far() -> None:
    assert sign_flip([0.1, 0.2, -0.3]).p == 1.0
    assert sign_flip([0.1, 0.1, 0.1]).p == 0.25 == sign_flip([0.3, 0.3, 0.3]).p
    assert sign_flip([0.0, 0.0]) == sign_flip([]) and sign_flip([]).p == 1.0


def test_many_sources_are_drawn_with_the_observed_one_among_them() -> None:
    random = np.random.default_rng(3)
    sums = random.normal(0.2, 1, EXACT_CLUSTERS)
    exact, drawn = sign_flip(sums), sign_flip([*sums, 1e-12], draws=20_000)
    assert exact.exact and not drawn.exact and drawn.p == pytest.approx(exact.p, abs=0.01)
    assert drawn == sign_flip([*sums, 1e-12], draws=20_000)
    assert sign_flip(np.ones(40), draws=999).p == 1 / 1000 == sign_flip(np.ones(40), draws=999).least


def test_without_a_difference_p_is_small_as_often_as_it_says() -> None:
    """2,000 suites of 10 sources of unlike sizes: 5 % of the p-values are at most 0.05 (standard error 0.5 points)."""
    random = np.random.default_rng(11)
    sizes = 1 + np.arange(10) % 4
    p = np.array([sign_flip(random.normal(0, np.sqrt(sizes))).p for _ in range(2000)])
    assert 0.035 < (p <= 0.05).mean() < 0.065


def test_what_a_source_adds_is_the_sum_of_its_cases() -> None:
    design = Design.of(["a", "b", "a"], ["d", "d", "d"])
    assert cluster_sums(design, [3.0, 6.0, 0.0], [1 / 3] * 3).tolist() == pytest.approx([1.0, 2.0])
    with pytest.raises(ValueError, match="finite"):
        sign_flip([1.0, np.nan])


def test_holm_by_hand() -> None:
    assert holm([0.01, 0.04, 0.03, 0.005]).tolist() == pytest.approx([0.03, 0.06, 0.06, 0.02])
    assert holm([0.2, np.nan, 0.6]).tolist()[0] == pytest.approx(0.4) and np.isnan(holm([0.2, np.nan, 0.6])[1])
    assert holm([]).tolist() == [] and holm([0.7]).tolist() == [0.7]


@given(st.lists(st.floats(0, 1), min_size=1, max_size=12))
def test_holm_keeps_the_order_and_stays_below_bonferroni(p: list[float]) -> None:
    found = holm(p)
    assert (found >= np.array(p)).all() and (found <= np.minimum(1, len(p) * np.array(p)) + 1e-15).all()
    order = np.argsort(p, kind="stable")
    assert (np.diff(found[order]) >= 0).all()
    for one, other in pairwise(order):
        assert p[one] != p[other] or found[one] == found[other]
