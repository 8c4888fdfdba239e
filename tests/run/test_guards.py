"""What stops a whole run, by real files of its folder, with stages that only say what they were."""

from __future__ import annotations

import asyncio
import os
import signal
import time
from collections import Counter
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from c4s.engine import EngineDied
from c4s.errors import BadInput
from c4s.files import append_json_line
from c4s.meter.spending import Ledger, SpendingLimitReached
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.run import bounds
from c4s.run.bounds import moment, seconds_of
from c4s.run.drive import Pending, refuse_pending, run_trials
from c4s.run.guards import StoppedByGuard, Watchman, ask, set_guards
from c4s.run.limits import Stage
from c4s.run.overseer import Overseer
from c4s.run.plan import Trial
from c4s.run.signals import ending_in_order
from tests.run.test_orchestration import DummyPool, finished, planned

Act = Callable[[Stage, Trial, Overseer, Counter[str]], object]
MIXED = (("a", "pending"), ("b", "done"))
"""A journal and what stands in it, in turn."""


def outcome(number: int) -> AttemptOutcome:
    return AttemptOutcome(attempt=number, ended_by="finished", submission="/Game/A")


def score(trial: Trial, value: float = 0.5) -> TrialScore:
    return TrialScore(
        case_id=trial.case.case_id,
        setting=trial.case.setting,
        configuration=trial.configuration.name,
        repeat=trial.repeat,
        status="measured",
        score=value,
        policy="p",
        judge="rule",
        engine="headless",
    )


def work(
    made: list[Trial], plan: Plan, act: Act = lambda *_: None, tell: Callable[[str], None] = lambda line: None
) -> tuple[list[Pending], Counter[str], Overseer]:
    """Run trials behind one slot; ``act`` is called in each stage, with how often each was begun."""
    seen: Counter[str] = Counter()
    overseer = Overseer(made[0].run, tell=tell)

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        seen[stage] += 1
        act(stage, trial, overseer, seen)
        if stage == "attempt":
            outcome(*arguments).write(trial.folder.attempt(*arguments).outcome)
            return outcome(*arguments)
        return score(trial) if stage == "score" else True

    async def all_of_it() -> list[Pending]:
        async with DummyPool(1, processors=1) as pool:
            overseer.begin(pool.slots)
            return await run_trials(made, plan, pool, run, overseer=overseer)

    pending = finished(all_of_it())
    overseer.end()
    return pending, seen, overseer


def stopped(pending: list[Pending], total: int) -> StoppedByGuard:
    with pytest.raises(StoppedByGuard) as told:
        refuse_pending(pending, total)
    return told.value


def test_a_drained_run_ends_what_is_in_work_and_goes_on_later(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 40)
    set_guards(RunFolder(tmp_path))

    def drain(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "attempt" and seen[stage] == 3:
            ask(RunFolder(tmp_path), "drain")
            overseer.look()

    lines: list[str] = []
    pending, seen, _ = work(made, plan, drain, lines.append)
    assert seen["attempt"] == seen["score"] == seen["persist"] == 3, "what was in work was scored and stored"
    error = stopped(pending, len(made))
    assert len(pending) == 37 and error.exit_code == 1
    assert "37 of 40 trials left" in error.line() and "asked it to drain" in error.line()
    assert "run the same command again" in error.line() and len(lines) == 1 and "stopping" in lines[0]
    assert not list(tmp_path.glob("*/*/*/faults.jsonl")), "nobody failed"
    left = [trial for trial in made if not trial.folder.attempts()]
    set_guards(RunFolder(tmp_path))
    again, seen, _ = work(left, plan)
    assert not again and seen["attempt"] == 37


def test_no_second_attempt_starts_in_a_run_that_is_stopped(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 1)
    set_guards(RunFolder(tmp_path))
    overseer = Overseer(tmp_path, tell=lambda line: None)

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage == "integrity":
            ask(RunFolder(tmp_path), "drain")
            overseer.look()
            return False
        return outcome(*arguments)

    async def all_of_it() -> list[Pending]:
        async with DummyPool(1, processors=1) as pool:
            return await run_trials(made, plan, pool, run, overseer=overseer)

    pending = finished(all_of_it())
    assert [type(one.error) for one in pending] == [StoppedByGuard]
    assert not made[0].folder.faults.exists() and not made[0].folder.score.exists()


def test_nothing_starts_while_a_run_is_paused(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 4)
    set_guards(RunFolder(tmp_path))
    began: list[tuple[Stage, bool]] = []

    def pause(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        began.append((stage, overseer.paused))
        if len(began) == 5:
            ask(RunFolder(tmp_path), "pause")
            overseer.look()
            asyncio.get_running_loop().call_later(0.2, ask, RunFolder(tmp_path), "go")

    lines: list[str] = []
    pending, seen, _ = work(made, plan, pause, lines.append)
    assert not pending and seen["persist"] == 4
    assert not any(paused for _, paused in began), "no stage began while the run was paused"
    assert ["paused" in lines[0], lines[1]] == [True, "going on"]


def test_a_run_whose_trials_fail_for_one_cause_stops(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 60)
    set_guards(RunFolder(tmp_path), most_faults=5)

    def die(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "attempt":
            raise EngineDied("SIGSEGV", during="start", where="logs")

    pending, seen, _ = work(made, plan, die)
    error = stopped(pending, len(made))
    assert seen["attempt"] == 5 and len(pending) == 60 and error.exit_code == 3
    assert "5 trials in a row failed with EngineDied" in error.line() and "faults.jsonl" in error.line()


def test_failures_between_which_trials_succeed_do_not_stop_a_run(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 12)
    set_guards(RunFolder(tmp_path), most_faults=2)

    def die_at_times(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "score" and seen[stage] % 2:
            raise EngineDied("SIGSEGV", during="start", where="logs")

    pending, seen, overseer = work(made, plan, die_at_times)
    assert len(pending) == 6 and seen["attempt"] == 12 and overseer.stopped is None
    with pytest.raises(Exception, match=r"more in .*faults\.jsonl"):
        refuse_pending(pending, 12)


def test_failures_of_an_earlier_start_do_not_count(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 8)

    def die(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "attempt":
            raise EngineDied("SIGSEGV", during="start", where="logs")

    set_guards(RunFolder(tmp_path), most_faults=4)
    work(made, plan, die)
    set_guards(RunFolder(tmp_path), most_faults=4)
    assert work(made, plan)[0] == []


def test_no_attempt_starts_after_the_deadline(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 3)
    set_guards(RunFolder(tmp_path), deadline=time.time() - 1)
    pending, seen, _ = work(made, plan)
    error = stopped(pending, 3)
    assert not seen and "deadline" in error.line() and "later --deadline" in error.line() and error.exit_code == 1


def test_what_is_booked_stops_the_run_at_its_limit(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 20)
    set_guards(RunFolder(tmp_path), spend_usd=1.0)
    ledger = Ledger(RunFolder(tmp_path).spending, 1.0)

    def spend(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "attempt":
            ledger.settle(str(ledger.hold(0.5)), 0.25)
            overseer.look()

    pending, seen, _ = work(made, plan, spend)
    error = stopped(pending, 20)
    assert seen["attempt"] == 4 and len(pending) == 16 and error.exit_code == 1
    assert "1.0000 of 1.0000 USD" in error.line() and "raise the limit" in error.line()


@pytest.mark.parametrize(
    ("limit", "told"), [({"judge_usd": 1.0}, "1.0000 of 1.0000 USD"), ({"judge_tokens": 90}, "90 of")]
)
def test_what_a_judge_uses_stops_the_run_at_its_limit(tmp_path: Path, limit: dict[str, Any], told: str) -> None:
    run = RunFolder(tmp_path)
    set_guards(run, **limit)
    judging = Ledger(run.judging, None)
    judging.settle(str(judging.hold(0.5, 100)), 0.5, 45)
    assert Watchman(run).look() == (False, None)
    judging.settle(str(judging.hold(0.5, 100)), 0.5, 45)
    found = Watchman(run).look()[1]
    assert found is not None and told in found.line() and "--judge-" in found.line() and found.exit_code == 1


def test_a_limit_of_nothing_stops_no_run_that_uses_no_model(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 2)
    set_guards(RunFolder(tmp_path), spend_usd=0.0)
    assert work(made, plan)[0] == []


def test_a_request_that_was_refused_for_spending_stops_the_run(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 6)
    set_guards(RunFolder(tmp_path))

    def refuse(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "attempt":
            raise SpendingLimitReached("the spending limit of this run is reached", todo="raise the limit")

    pending, seen, _ = work(made, plan, refuse)
    assert seen["attempt"] == 1 and "spending limit" in stopped(pending, 6).line()


def test_whoever_looks_at_the_folder_comes_to_the_same(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 10)
    set_guards(RunFolder(tmp_path), most_faults=3)

    def die(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        raise EngineDied("SIGSEGV", during="start", where="logs")

    _, _, overseer = work(made, plan, die)
    _, found = Watchman(RunFolder(tmp_path)).look()
    assert found and overseer.stopped and found.line() == overseer.stopped.line()


def journalled(run: RunFolder, events: list[tuple[str, int, str]]) -> None:
    """Events (journal, time in seconds after the bounds were set, what) as two processes wrote them."""
    since = set_guards(run, most_faults=3).since
    run.journals.mkdir()
    for name, after, what in events:
        told = {"time": since + after, "event": what, "trial": "a/b/r1", "error": "EngineDied", "line": "it died"}
        append_json_line(run.journals / f"{name}.jsonl", told)


def test_what_fails_in_a_row_is_told_by_time_whoever_wrote_it(tmp_path: Path) -> None:
    mixed, real = RunFolder(tmp_path / "mixed"), RunFolder(tmp_path / "real")
    for run in (mixed, real):
        run.root.mkdir()
    journalled(mixed, [(name, 2 * n + k, what) for n in range(9) for k, (name, what) in enumerate(MIXED)])
    assert Watchman(mixed).look() == (False, None)
    journalled(real, [("a", 0, "done"), *(("b", n, "pending") for n in (1, 3, 5)), ("a", 9, "begun")])
    _, found = Watchman(real).look()
    assert found is not None and found.guard == "faults" and "3 trials in a row" in found.what


def test_a_word_counts_for_the_bounds_that_it_was_asked_under_whatever_the_clocks_say(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = RunFolder(tmp_path)
    with pytest.raises(BadInput, match="nobody has begun this run"):
        ask(run, "drain")
    guards = set_guards(run)
    with monkeypatch.context() as late:
        late.setattr("c4s.run.guards.time.time", lambda: guards.since - 30)
        ask(run, "drain")
    _, found = Watchman(run).look()
    assert found is not None and found.guard == "drain"
    kept = run.asked.read_bytes()
    set_guards(run)
    run.asked.write_bytes(kept)
    assert Watchman(run).look() == (False, None)


def test_a_garbled_word_of_an_operator_asks_nothing(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 2)
    set_guards(RunFolder(tmp_path))
    RunFolder(tmp_path).asked.write_text("{")
    assert work(made, plan)[0] == []


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("8h", timedelta(hours=8)),
        ("1h30m", timedelta(minutes=90)),
        ("2d", timedelta(days=2)),
        ("45s", timedelta(0, 45)),
    ],
)
def test_a_deadline_as_a_duration(text: str, after: timedelta, monkeypatch: pytest.MonkeyPatch) -> None:
    noon = datetime(2026, 11, 23, 12, tzinfo=UTC)

    class Noon(datetime):
        @classmethod
        def now(cls, tz: Any = None) -> Any:
            return noon

    monkeypatch.setattr(bounds, "datetime", Noon)
    assert moment(text, "--deadline") == (noon + after).timestamp()


def test_a_deadline_as_a_time() -> None:
    at = (datetime.now().astimezone() + timedelta(hours=3)).replace(second=0, microsecond=0)
    assert moment(at.isoformat(), "--deadline") == moment(at.strftime("%H:%M"), "--deadline") == at.timestamp()
    before = datetime.fromtimestamp(moment((at - timedelta(hours=5)).strftime("%H:%M"), "--deadline")).astimezone()
    assert before == at + timedelta(hours=19)


@pytest.mark.parametrize("change", ["STD{noon}DST,J{day}/0,J{other}", "STD{noon}DST,J{other},J{day}/0"])
def test_a_deadline_as_a_time_after_clocks_were_set(change: str, monkeypatch: pytest.MonkeyPatch) -> None:
    today = datetime.now(UTC)
    day, other = (min((today + timedelta(days=days)).timetuple().tm_yday, 365) for days in (1, 120))
    monkeypatch.setenv("TZ", change.format(noon=today.hour - 12, day=day, other=other))
    try:
        time.tzset()
        here = datetime.now().astimezone()
        wanted = here - timedelta(minutes=5)
        at = datetime.fromtimestamp(moment(wanted.strftime("%H:%M"), "--deadline")).astimezone()
    finally:
        monkeypatch.undo()
        time.tzset()
    assert at.utcoffset() != here.utcoffset(), "clocks are set tonight"
    assert at.strftime("%H:%M") == wanted.strftime("%H:%M")
    assert (at.date() - wanted.date()).days == 1


@pytest.mark.parametrize(
    "text", ["", " ", "soon", "-1h", "0s", "2020-01-01", "2999-01-01T00:00", "1e9h", "9999999999d", "25:00"]
)
def test_what_is_no_deadline(text: str) -> None:
    with pytest.raises(BadInput, match="--deadline"):
        moment(text, "--deadline")


def test_a_duration() -> None:
    assert seconds_of("1d2h3m4s", "--older") == 93784


def endless(tmp_path: Path, numbers: tuple[signal.Signals, ...], term_s: float) -> tuple[list[str], Counter[str]]:
    """Run trials whose attempts do not end, get the signals while the first is in work, and be ended at once."""
    plan, made = planned(tmp_path, 4)
    set_guards(RunFolder(tmp_path))
    lines: list[str] = []
    seen: Counter[str] = Counter()
    overseer = Overseer(tmp_path, tell=lines.append)

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        seen[stage] += 1
        loop = asyncio.get_running_loop()
        for count, number in enumerate(numbers):
            loop.call_later(0.05 * count, os.kill, os.getpid(), number)
        await asyncio.Event().wait()

    async def all_of_it() -> list[Pending]:
        async with DummyPool(1, processors=1) as pool:
            with ending_in_order(overseer, term_s):
                return await run_trials(made, plan, pool, run, overseer=overseer)

    before = signal.getsignal(signal.SIGTERM)
    with pytest.raises(KeyboardInterrupt):
        finished(all_of_it())
    assert signal.getsignal(signal.SIGTERM) is before and overseer.stopped is not None
    return lines, seen


def test_the_second_ctrl_c_ends_a_run_at_once(tmp_path: Path) -> None:
    lines, seen = endless(tmp_path, (signal.SIGINT, signal.SIGINT), 60.0)
    assert len(lines) == 1 and "Ctrl-C asked it to end" in lines[0] and seen == {"attempt": 1}


def test_a_run_that_does_not_end_in_time_after_sigterm_is_ended(tmp_path: Path) -> None:
    lines, seen = endless(tmp_path, (signal.SIGTERM,), 0.1)
    assert len(lines) == 1 and "SIGTERM asked it to end" in lines[0] and seen == {"attempt": 1}
