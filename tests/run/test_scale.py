"""A run of many trials, made small: the whole machinery with stages that take no time, and a night in made time."""

from __future__ import annotations

import pytest

from bench import leaderboard, scale
from bench.night import RECORDED, night
from c4s.run import drive, trial_work


@pytest.fixture
def seldom(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leases and room are looked at every ten minutes of made time: nobody else is there, and a night of looks is what
    a made night takes."""
    monkeypatch.setattr(trial_work, "BEAT_S", 600.0)
    monkeypatch.setattr(drive, "LOOK_S", 600.0)


def test_every_trial_of_a_run_is_stored() -> None:
    made = scale.measured(3, 2, 2, "instant")
    assert (made.trials, made.pending, made.failures) == (12, 0, "")


def test_a_plan_is_made_and_checked_before_its_first_attempt() -> None:
    made = scale.measured(2, 3, 50, "instant", start_only=True)
    assert (made.trials, made.run_s, made.failures) == (300, 0.0, "")


def test_the_leaderboard_is_what_pandas_makes_of_the_same_parts() -> None:
    """The benchmark compares them; here it is small."""
    assert next(row.name for row in leaderboard.rows(400)).startswith("leaderboard of 3,990 trials")


@pytest.mark.usefixtures("seldom")
def test_a_night_keeps_every_slot_busy_and_takes_as_long_as_its_attempts() -> None:
    one, four = (night(slots, RECORDED, count=80) for slots in (1, 4))
    assert one.busy == pytest.approx(1.0) and four.busy == pytest.approx(4.0, rel=0.02)
    assert 3.5 * four.makespan_h < one.makespan_h < 4.1 * four.makespan_h
    assert night(4, RECORDED, count=80) == four
    late = night(4, RECORDED, count=80, start_s=600.0)
    assert late.makespan_h > four.makespan_h + 80 / 4 * 600 / 3600 * 0.95


@pytest.mark.usefixtures("seldom")
def test_verifying_waits_where_processors_are_few() -> None:
    few, enough = (night(8, RECORDED, count=80, minutes=0.05, processors=count) for count in (1, 8))
    assert few.queued > enough.queued and few.makespan_h > enough.makespan_h
