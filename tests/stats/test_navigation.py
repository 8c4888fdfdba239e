"""Embodied utility: the withheld are no zeros, rooms are units, changes are paired."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.stats.navigation import alignment, paired_change, room_means, utility, utility_mean

NAN = float("nan")
VALUES = st.lists(st.one_of(st.just(NAN), st.floats(0, 1)), min_size=1, max_size=40)


@given(VALUES)
def test_the_conservative_mean_is_the_measured_one_times_the_coverage(values: list[float]) -> None:
    found = utility_mean(np.array(values))
    known = [value for value in values if not np.isnan(value)]
    assert found.records == len(values) and found.withheld == len(values) - len(known)
    assert found.conservative == pytest.approx((found.measured or 0.0) * found.coverage, abs=1e-12)
    assert found.measured is None if not known else found.measured == pytest.approx(np.mean(known))


def test_a_zero_that_was_measured_counts_in_both_means_and_a_withheld_one_in_one() -> None:
    found = utility_mean(np.array([0.6, 0.0, NAN]))
    assert (found.zeros, found.withheld, found.measured) == (1, 1, 0.3) and found.conservative == pytest.approx(0.2)
    assert found.standard_error == pytest.approx(np.std([0.6, 0, 0], ddof=1) / np.sqrt(3))
    assert utility_mean(np.array([0.4])).standard_error is None


def test_without_a_record_there_is_no_mean_and_without_a_walk_no_utility() -> None:
    with pytest.raises(ValueError, match="record"):
        utility_mean(np.array([]))
    with pytest.raises(ValueError, match="walk"):
        utility(0.5, 0, 0)
    assert utility(0.27, 1, 3) == pytest.approx(0.09)


def test_rooms_count_once_however_many_edits_they_have() -> None:
    found = room_means(np.array([0.1, 0.3, 0.8, NAN, NAN]), ["a", "a", "b", "b", "c"])
    assert (found.rooms, found.measured) == (3, 2) and found.mean == pytest.approx(0.5)
    assert found.median == pytest.approx(0.5)
    assert room_means(np.array([NAN]), ["a"]).mean is None


@given(VALUES)
def test_a_change_against_itself_is_none_and_turns_its_sign(values: list[float]) -> None:
    after = np.array(values)
    before = np.linspace(0, 1, len(values))
    assert paired_change(after, after).mean == 0
    assert paired_change(after, before).mean == pytest.approx(-paired_change(before, after).mean)


def test_alignment_needs_three_configurations() -> None:
    assert alignment(np.array([0.1, 0.2]), np.array([0.1, 0.3])).spearman is None
    found = alignment(np.array([0.1, 0.2, 0.4]), np.array([0.1, 0.3, 0.7]))
    assert found.configurations == 3 and found.spearman == 1.0 and found.pearson == pytest.approx(1.0)
