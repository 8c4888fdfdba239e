"""Agreement of repeats on made tables whose truth is known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.stats.repeats import Band, agreements, as_table, centred, rank_stability, sample_deviations, tau_b


def by_order(*orders: str) -> list[list[float]]:
    """A row of means a repeat, of which each tells the order of nine configurations ``a`` to ``i``, the best first."""
    return [[1.0 - 0.05 * order.index(name) for name in "abcdefghi"] for order in orders]


def test_the_papers_shape_of_numbers_comes_of_known_orders() -> None:
    """Of 36 pairs two, one and one are turned: 1 - 2 x 2/36, 1 - 2 x 1/36, and all of them in ranks 5 to 7."""
    means = as_table(by_order("abcdefghi", "abcdfgehi", "abcdfeghi"))
    found = agreements(means)
    assert [one.repeats for one in found] == [(1, 2), (1, 3), (2, 3)]
    assert [round(one.tau_b or 0.0, 3) for one in found] == [0.889, 0.944, 0.944]
    stable = rank_stability(means)
    assert stable.leading == 4 and stable.bands == (Band(5, 7),) and stable.kept == (1, 2, 3, 4, 8, 9)
    assert stable.reversals == 2 and stable.order == (0, 1, 2, 3, 5, 4, 6, 7, 8)


def test_ties_lower_tau_b_and_reverse_nothing() -> None:
    """Four of six pairs agree and one is tied in each: 4 / 5 by the definition with ties."""
    one, two = [0.9, 0.7, 0.7, 0.1], [0.9, 0.7, 0.5, 0.5]
    means = as_table([one, two])
    assert agreements(means)[0].tau_b == pytest.approx(4 / math.sqrt(5 * 5))
    assert rank_stability(means).bands == () and rank_stability(means).leading == 4


def test_what_has_no_order_has_no_agreement() -> None:
    assert [row.tau_b for row in agreements(as_table([[0.5], [0.6]]))] == [None]
    assert tau_b(np.array([0.5, 0.5]), np.array([0.5, 0.6])) is None
    assert agreements(as_table([[0.5, 0.6]])) == [] and sample_deviations(as_table([[0.5, 0.6]])) is None


def test_deviations_are_from_the_configurations_own_mean() -> None:
    means = as_table([[0.50, 0.2], [0.56, 0.2], [0.53, 0.2]])
    assert sample_deviations(means) == pytest.approx([0.03, 0.0])
    assert centred(means).T.tolist() == [pytest.approx([-0.03, 0.03, 0.0]), pytest.approx([0.0, 0.0, 0.0])]


def test_bands_apart_stay_apart() -> None:
    stable = rank_stability(as_table(by_order("abcdefghi", "bacdefgih", "abcdefghi")))
    assert stable.bands == (Band(1, 2), Band(8, 9)) and stable.leading == 0 and stable.kept == (3, 4, 5, 6, 7)


@pytest.mark.parametrize("wrong", [[], [[]], [0.5], [[0.5, math.nan]], [[0.5], [math.inf]]])
def test_what_is_no_table_is_refused(wrong: object) -> None:
    with pytest.raises(ValueError, match="finite numbers"):
        as_table(wrong)


@given(st.lists(st.lists(st.integers(0, 5), min_size=4, max_size=4), min_size=2, max_size=4))
def test_outside_all_bands_every_repeat_tells_the_same_order(rows: list[list[int]]) -> None:
    means = as_table(rows)
    stable = rank_stability(means)
    for rank in stable.kept:
        own = stable.order[rank - 1]
        for other in range(means.shape[1]):
            signs = set(np.sign(means[:, own] - means[:, other]))
            assert not {-1.0, 1.0} <= signs
    agreed = [row.tau_b for row in agreements(means)]
    assert all(tau is None or -1.0 <= tau <= 1.0 for tau in agreed)
    assert stable.reversals or all(tau is None or tau >= 0 for tau in agreed)
