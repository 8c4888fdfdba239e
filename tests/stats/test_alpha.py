"""Krippendorff's alpha against the library of that name."""

from __future__ import annotations

import krippendorff
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.stats.alpha import interval_alpha, nominal_alphas

UNIT = st.lists(st.integers(0, 5), min_size=3, max_size=3)
SCORES = st.integers(2, 4).flatmap(
    lambda judges: st.lists(st.lists(st.integers(-20, 20), min_size=judges, max_size=judges), min_size=1, max_size=12)
)


def by_library(counts: np.ndarray) -> float:
    """The library refuses units that nobody gave two labels, and divides by 0 where all labels are one."""
    pairable = counts[counts.sum(axis=1) > 1]
    if len(pairable) == 0 or (pairable.sum(axis=0) > 0).sum() < 2:
        return float("nan")
    return float(krippendorff.alpha(value_counts=counts, level_of_measurement="nominal"))


@given(st.lists(st.tuples(st.integers(0, 3), UNIT), min_size=1, max_size=12), st.data())
def test_labels_of_drawn_groups_equal_the_library(units: list[tuple[int, list[int]]], data: st.DataObject) -> None:
    numbers, group = np.unique([one for one, _ in units], return_inverse=True)
    counts = np.array([given for _, given in units])
    one_draw = st.lists(st.integers(0, len(numbers) - 1), min_size=len(numbers), max_size=len(numbers))
    drawn = np.array(data.draw(st.lists(one_draw, min_size=1, max_size=3)))
    expected = [by_library(np.concatenate([counts[group == one] for one in row])) for row in drawn]
    found = nominal_alphas(counts.astype(np.float64), group.astype(np.int64), drawn)
    assert found.tolist() == pytest.approx(expected, nan_ok=True, abs=1e-12)


@given(SCORES, st.sampled_from([0.0, 1e6]))
def test_scores_equal_the_library(things: list[list[int]], far: float) -> None:
    scores = np.array(things, dtype=np.float64).T / 8 + far
    found = interval_alpha(scores)
    if np.ptp(scores) == 0:
        assert found is None
        return
    expected = krippendorff.alpha(reliability_data=scores, level_of_measurement="interval")
    assert found == pytest.approx(expected, abs=1e-6 if far else 1e-9)
