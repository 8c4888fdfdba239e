"""How far a run is, read from its folder: the same for a run in this process, in another one, and on other machines.

A look reads the lines that were added to the journals since the last one, and the end of each trajectory in work; what
it costs does not grow with the plan.
"""

from __future__ import annotations

import json
import threading
import time
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.meter.spending import Ledger
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.guards import Guards
from c4s.records.lease import Lease, Owner
from c4s.records.plan import Plan
from c4s.records.progress import Running, Slot, Snapshot, Standing, State, Trouble
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run.guards import asked_of, guards_of
from c4s.run.journal import Tail
from c4s.run.lease import holder
from c4s.run.owner import is_gone, is_near
from c4s.run.sharing import FETCH_S, fetch_elsewhere
from c4s.run.store import open_store

_TAIL_BYTES = 64 << 10


@dataclass
class _Work:
    """A stage in work, as its journal told."""

    trial: str
    event: dict[str, Any]
    journal: Path


@dataclass
class _Sums:
    """What is known of a configuration's trials."""

    done: int = 0
    scores: dict[str, float] = field(default_factory=dict)
    """By trial."""
    costs: list[float] = field(default_factory=list)
    seconds: dict[str, float] = field(default_factory=lambda: defaultdict(float))
    """In slots, by kind."""
    timed: int = 0
    """Trials that ended in a journal: those behind ``seconds``."""


class Progress:
    """Reads a run again and again.

    Args:
        run: the run folder; it has a plan.
        suite: the suite's folder, for the budgets of attempts in work; they are left out where it is not there.
    """

    def __init__(self, run: Path, suite: Path | None = None) -> None:
        self._run, self._suite = RunFolder(run), suite
        self._one_at_a_time = threading.Lock()
        self._tail = Tail(self._run)
        self._ledger = Ledger(self._run.spending, None, self._run.elsewhere)
        self._fetch_at = 0.0
        self._held: Lease | None = None
        self._plan: Plan | None = None
        self._plan_time = 0
        self._cases: dict[str, str] = {}
        self._done: set[str] = set()
        self._pending: dict[str, dict[str, Any]] = {}
        self._begun: dict[str, float] = {}
        """Trials of which a stage ran, that are neither done nor pending, and when the last one started."""
        self._work: dict[tuple[str, str, Any], _Work] = {}
        self._sums: dict[str, _Sums] = defaultdict(_Sums)
        self._owners: dict[Path, Owner] = {}
        self._over: set[Owner] = set()
        """Processes whose work on the run is over."""
        self._slots: dict[Path, dict[str, int]] = {}
        self._reused: dict[str, int] = {}
        self._word: State = "running"
        self._why, self._word_time, self._since = "", 0.0, 0.0

    def read(self) -> Snapshot:
        """The run now; any thread may ask. ``BadInput`` where its plan cannot be read."""
        with self._one_at_a_time:
            return self._read()

    def _read(self) -> Snapshot:
        if not open_store().apart:
            self._held = holder(self._run)
        elif time.monotonic() >= self._fetch_at:
            self._fetch_at = time.monotonic() + FETCH_S
            fetch_elsewhere(self._run)
            self._held = holder(self._run)
        grown = self._read_plan()
        for journal, event in self._tail.read():
            self._take(journal, event)
        if grown:
            self._find_scored()
        guards = guards_of(self._run)
        if guards is not None and guards.since != self._since:
            self._begin_anew(guards.since)
        return self._snapshot(self._plan_now())

    def _begin_anew(self, since: float) -> None:
        """Somebody gave the run its bounds anew and works on it: what failed before is tried again."""
        self._since = since
        self._begun = {trial: at for trial, at in self._begun.items() if at >= since}
        self._pending = {trial: event for trial, event in self._pending.items() if event.get("time", 0.0) >= since}
        if self._word_time < since:
            self._word, self._why = "running", ""

    def _plan_now(self) -> Plan:
        if self._plan is None:
            raise BadInput("this run has no plan", where=str(self._run.plan))
        return self._plan

    def _read_plan(self) -> bool:
        """Whether the plan is another one than at the last look."""
        try:
            changed = self._run.plan.stat().st_mtime_ns
        except FileNotFoundError:
            return False
        if changed == self._plan_time:
            return False
        self._plan, self._plan_time = Plan.read(self._run.plan), changed
        self._cases = {case.alias: case.case_id for case in self._plan.cases}
        return True

    def _find_scored(self) -> None:
        """Trials that were scored without a journal: by an older c4s, or while the disk was full."""
        for name in self._names():
            path = self._run.trial_named(name).score
            if name not in self._done and name not in self._begun and path.is_file():
                try:
                    score = TrialScore.read(path).score
                except BadInput:
                    continue
                self._count(name, score)

    def _names(self) -> list[str]:
        plan = self._plan_now()
        return [
            f"{chosen.name}/{case.alias}/r{repeat}"
            for chosen in plan.configurations
            for case in plan.cases
            for repeat in range(1, plan.repeats + 1)
        ]

    def _take(self, journal: Path, event: dict[str, Any]) -> None:
        """One line of a journal."""
        what, trial = event.get("event"), event.get("trial")
        if isinstance(trial, str):
            self._take_trial(journal, str(what), trial, event)
        elif what == "begun":
            self._owners[journal] = Owner.parse(event.get("owner"), where=str(journal))
            self._over.discard(self._owners[journal])
            self._slots[journal], self._reused = event.get("slots") or {}, event.get("reused") or self._reused
            self._forget(journal)
        elif what == "over":
            self._slots.pop(journal, None)
            if journal in self._owners:
                self._over.add(self._owners[journal])
            self._forget(journal)
        elif what in ("paused", "going"):
            self._said("paused" if what == "paused" else "running", "as asked" if what == "paused" else "", event)
        elif what == "stopped":
            self._said("stopping", str(event.get("line", "")), event)

    def _said(self, word: State, why: str, event: dict[str, Any]) -> None:
        self._word, self._why, self._word_time = word, why, float(event.get("time", 0.0))

    def _take_trial(self, journal: Path, what: str, trial: str, event: dict[str, Any]) -> None:
        sums = self._sums[trial.partition("/")[0]]
        key = (trial, str(event.get("stage")), event.get("attempt") or event.get("verifier"))
        if what == "started":
            self._pending.pop(trial, None)
            if trial in self._done:
                self._done.discard(trial)
                sums.done -= 1
                sums.scores.pop(trial, None)
            self._begun[trial] = float(event.get("time", 0.0))
            for other in [key for key, work in self._work.items() if work.trial == trial and work.journal != journal]:
                del self._work[other]
            self._work[key] = _Work(trial, event, journal)
        elif what in ("ended", "failed"):
            self._work.pop(key, None)
            sums.seconds[str(event.get("kind"))] += event.get("seconds") or 0.0
            if event.get("cost_usd") is not None:
                sums.costs.append(event["cost_usd"])
        elif what == "done":
            sums.timed += 1
            self._begun.pop(trial, None)
            self._count(trial, event.get("score"))
        elif what == "pending":
            self._begun.pop(trial, None)
            self._pending[trial] = event

    def _count(self, trial: str, score: float | None) -> None:
        sums = self._sums[trial.partition("/")[0]]
        if trial not in self._done:
            self._done.add(trial)
            sums.done += 1
            if score is not None:
                sums.scores[trial] = score

    def _forget(self, journal: Path) -> None:
        """What a journal's process had in work is in work no more."""
        for key in [key for key, work in self._work.items() if work.journal == journal]:
            self._begun.pop(self._work.pop(key).trial, None)

    def _snapshot(self, plan: Plan) -> Snapshot:
        held = self._held
        if held is not None and held.owner in self._over:
            held = None
        if held is None:
            self._begun.clear()
        for journal, owner in self._owners.items():
            if (held is None and not _lives(owner)) or (is_near(owner) and is_gone(owner)):
                self._slots.pop(journal, None)
                self._forget(journal)
        planned = len(plan.configurations) * len(plan.cases) * plan.repeats
        standings = [self._standing(chosen.name, len(plan.cases) * plan.repeats) for chosen in plan.configurations]
        done, guards = sum(row.done for row in standings), guards_of(self._run)
        running = [self._running(work) for work in self._work.values()]
        in_work = len({work.trial for work in self._work.values()} | self._begun.keys())
        state, why = self._state(held, done == planned)
        return Snapshot(
            run_id=plan.run_id,
            suite_id=plan.suite_id,
            state=state,
            why=why,
            time=round(time.time(), 3),
            holder=None if held is None else f"process {held.owner.pid} on {held.owner.host}",
            planned=planned,
            done=done,
            reused=sum(self._reused.values()),
            pending=len(self._pending),
            waiting=max(0, planned - done - len(self._pending) - in_work),
            running=sorted(running, key=lambda one: -one.seconds),
            slots=self._busy(),
            standings=standings,
            troubles=self._troubles(),
            spent_usd=round(self._ledger.spent().total_usd, 6) if self._ledger.begun else None,
            **_bounds(guards),
            left_s=self._left(standings) if state in ("running", "paused") else None,
        )

    def _state(self, held: Lease | None, all_done: bool) -> tuple[State, str]:
        if held is None:
            if all_done:
                return "done", ""
            if self._work:
                return "running", "whoever led it has ended; what was sent to the work pools goes on"
            return ("stopped", self._why) if self._word == "stopping" else ("idle", "")
        asked = asked_of(self._run, guards_of(self._run))
        if self._word == "running" and asked is not None and asked.word != "go":
            return "paused" if asked.word == "pause" else "stopping", f"{asked.by} asked it to {asked.word}"
        return self._word, self._why

    def _standing(self, configuration: str, planned: int) -> Standing:
        sums = self._sums[configuration]
        return Standing(
            configuration=configuration,
            planned=planned,
            done=min(planned, sums.done + self._reused.get(configuration, 0)),
            pending=sum(name.partition("/")[0] == configuration for name in self._pending),
            scored=len(sums.scores),
            mean_score=sum(sums.scores.values()) / len(sums.scores) if sums.scores else None,
            cost_usd=round(sum(sums.costs), 6) if sums.costs else None,
        )

    def _running(self, work: _Work) -> Running:
        configuration, alias, repeat = work.trial.split("/")
        event, folder = work.event, self._run.trial_named(work.trial)
        owner = self._owners.get(work.journal)
        is_attempt = event["stage"] == "attempt"
        budget = self._budget(alias) if is_attempt else (None, None)
        verifier = event.get("verifier")
        return Running(
            configuration=configuration,
            case=self._cases.get(alias, alias),
            repeat=int(repeat[1:]),
            stage=f"{event['stage']} {verifier}" if verifier else event["stage"],
            attempt=event.get("attempt"),
            seconds=round(max(0.0, time.time() - event["time"]), 1),
            host=owner.host if owner else "",
            calls=_calls(folder, event.get("attempt") or 1) if is_attempt else None,
            calls_budget=budget[0],
            wall_budget_s=budget[1],
        )

    def _budget(self, alias: str) -> tuple[int | None, float | None]:
        try:
            case = SuiteFolder(self._suite).agent_case(alias) if self._suite is not None else None
        except BadInput:
            return None, None
        return (None, None) if case is None else (case.budget.tool_calls, 60.0 * case.budget.wall_minutes)

    def _busy(self) -> list[Slot]:
        counts: Counter[str] = Counter()
        for slots in self._slots.values():
            counts.update(slots)
        busy = Counter(str(work.event.get("kind")) for work in self._work.values())
        return [Slot(kind=kind, count=count, busy=min(count, busy[kind])) for kind, count in counts.items()]

    def _troubles(self) -> list[Trouble]:
        by_cause: dict[str, list[tuple[str, dict[str, Any]]]] = defaultdict(list)
        for trial, event in self._pending.items():
            by_cause[str(event.get("error"))].append((trial, event))
        return [
            Trouble(
                error=cause,
                trials=len(found),
                line=str(found[-1][1].get("line", "")),
                faults=str(self._run.trial_named(found[-1][0]).faults),
            )
            for cause, found in sorted(by_cause.items(), key=lambda item: -len(item[1]))
        ]

    def _left(self, standings: list[Standing]) -> float | None:
        """Seconds until the last trial ends: the work that is left for each kind of slot, over its slots."""
        timed = sum(self._sums[row.configuration].timed for row in standings)
        if not timed:
            return None
        counts = {slot.kind: slot.count for slot in self._busy()}
        every: dict[str, float] = defaultdict(float)
        work: dict[str, float] = defaultdict(float)
        for row in standings:
            for kind, seconds in self._sums[row.configuration].seconds.items():
                every[kind] += seconds
        for row in standings:
            sums = self._sums[row.configuration]
            own, trials = (sums.seconds, sums.timed) if sums.timed else (every, timed)
            for kind, seconds in own.items():
                work[kind] += seconds / trials * (row.planned - row.done - row.pending)
        for one in self._work.values():
            work[str(one.event.get("kind"))] -= max(0.0, time.time() - one.event["time"])
        return max(
            (max(0.0, seconds) / counts[kind] for kind, seconds in work.items() if counts.get(kind)), default=0.0
        )


def _lives(owner: Owner) -> bool:
    """Whether a process is known to run: one of another machine is not."""
    return is_near(owner) and not is_gone(owner)


def _bounds(guards: Guards | None) -> dict[str, float | None]:
    if guards is None:
        return {}
    return {"spend_limit_usd": guards.spend_usd, "deadline": guards.deadline}


def _calls(folder: TrialFolder, attempt: int) -> int | None:
    """Number of the last call in a trajectory that is written; None before the first."""
    path = folder.attempt(attempt).trajectory
    try:
        with path.open("rb") as source:
            source.seek(max(0, path.stat().st_size - _TAIL_BYTES))
            lines = source.read().splitlines()
    except FileNotFoundError:
        return None
    for line in reversed(lines):
        try:
            return int(json.loads(line)["call"])
        except (ValueError, KeyError, TypeError):
            continue
    return None
