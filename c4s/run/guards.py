"""The guards of a whole run: what stops it before it is done, decided from files of its folder alone.

Whoever works on a run, on whichever machine, looks at the same files: the bounds (``guards.json``), what an operator
asked (``asked.json``), what was spent, and the journals. When a guard stops the run, no attempt starts any more;
attempts in work end, are verified and scored. What is left is as it was, and the same command goes on.
"""

from __future__ import annotations

import getpass
import platform
import time
from collections import Counter
from datetime import datetime
from pathlib import Path
from typing import Final, Literal

from c4s.errors import BadInput, C4SError, MachineryFault, shortage
from c4s.meter.spending import Ledger, SpendingLimitReached
from c4s.records.folder import RunFolder
from c4s.records.guards import Guards, Instruction, Word
from c4s.run.journal import Tail
from c4s.run.store import open_store

Guard = Literal["deadline", "spending", "faults", "drain", "signal"]
MOST_IN_A_ROW: Final = 20
"""Trials in a row that may fail for one cause, where the command names no other number."""
_AGAIN = "run the same command again to go on"


class StoppedByGuard(MachineryFault):
    """A guard stopped the run before it was done: the answer is no, and nothing but the run's own bounds is why."""

    exit_code = 1
    guard: Guard = "drain"


class TooManyFaults(StoppedByGuard):
    """The run stopped because its trials fail for one cause: the machinery's fault."""

    exit_code = 3


def stop(guard: Guard, what: str, todo: str = _AGAIN) -> StoppedByGuard:
    """What stops a run."""
    kind = TooManyFaults if guard == "faults" else StoppedByGuard
    made = kind(what, todo=todo)
    made.guard = guard
    return made


def cause_of(error: BaseException) -> str:
    """What failures are counted by: the name of what the machine is short of, else the error's class."""
    short = shortage(error)
    return short.name if short is not None else type(error).__name__


def ask(run: RunFolder, word: Word) -> Instruction:
    """Put on record what is asked of a run. ``BadInput`` for one that was never begun."""
    fetch_guards(run)
    guards = guards_of(run)
    if guards is None:
        raise BadInput("nobody has begun this run", where=str(run.root), todo="start it with `c4s run`")
    by = f"{getpass.getuser()} on {platform.node()}"
    asked = Instruction(word=word, of=guards.since, time=time.time(), by=by)
    asked.write(run.asked)
    open_store().push_files(run.asked)
    return asked


def fetch_guards(run: RunFolder) -> None:
    """The bounds and the last instruction, as the store has them where machines share one."""
    store = open_store()
    store.pull_files(run.guards)
    store.pull_files(run.asked)


def asked_of(run: RunFolder, guards: Guards | None) -> Instruction | None:
    """What was asked of a run under the bounds in force. A file that is no such record asks nothing: it is left."""
    try:
        asked = Instruction.read(run.asked) if run.asked.is_file() else None
    except BadInput:
        return None
    return asked if asked is not None and guards is not None and asked.of == guards.since else None


def set_guards(
    run: RunFolder,
    *,
    deadline: float | None = None,
    spend_usd: float | None = None,
    most_faults: int = MOST_IN_A_ROW,
    judge_usd: float | None = None,
    judge_tokens: int | None = None,
    accept_faults: bool = False,
) -> Guards:
    """Give a run its bounds from now on. What was asked of it before no longer holds."""
    guards = Guards(
        since=time.time(),
        deadline=deadline,
        spend_usd=spend_usd,
        judge_usd=judge_usd,
        judge_tokens=judge_tokens,
        accept_faults=accept_faults,
        most_faults=most_faults,
    )
    guards.write(run.guards)
    open_store().push_files(run.guards)
    run.asked.unlink(missing_ok=True)
    return guards


def guards_of(run: RunFolder) -> Guards | None:
    """The bounds of a run; None for one that was never given any."""
    return Guards.read(run.guards) if run.guards.is_file() else None


class Watchman:
    """Looks at the files of a run that its guards are decided from; a look reads only what is new."""

    def __init__(self, run: RunFolder) -> None:
        self._run = run
        self._tail = Tail(run)
        self._in_a_row: Counter[str] = Counter()
        self._last: dict[str, tuple[str, str]] = {}
        """Trial and reason of the last failure, by cause."""
        self._ledger = Ledger(run.spending, None, run.elsewhere)
        self._judging = Ledger(run.judging, None, run.elsewhere)

    def look(self) -> tuple[bool, StoppedByGuard | None]:
        """Whether the run is to pause, and what stops it, if anything does."""
        guards = guards_of(self._run)
        if guards is None:
            return False, None
        self._count(guards.since)
        asked = asked_of(self._run, guards)
        if asked is not None and asked.word == "drain":
            return False, stop("drain", f"{asked.by} asked it to drain")
        found = self._deadline(guards) or self._spending(guards) or self._judge(guards) or self._faults(guards)
        return asked is not None and asked.word == "pause", found

    def _deadline(self, guards: Guards) -> StoppedByGuard | None:
        if guards.deadline is None or time.time() < guards.deadline:
            return None
        told = datetime.fromtimestamp(guards.deadline).astimezone().isoformat(" ", "minutes")
        return stop("deadline", f"its deadline, {told}, has come", "run the same command again with a later --deadline")

    def _spending(self, guards: Guards) -> StoppedByGuard | None:
        if guards.spend_usd is None or not self._ledger.begun:
            return None
        spent = self._ledger.spent().total_usd
        if spent < guards.spend_usd:
            return None
        return stop(
            "spending",
            f"its spending limit is reached: {spent:.4f} of {guards.spend_usd:.4f} USD",
            "raise the limit and run the same command again",
        )

    def _judge(self, guards: Guards) -> StoppedByGuard | None:
        if (guards.judge_usd is None and guards.judge_tokens is None) or not self._judging.begun:
            return None
        spent = self._judging.spent()
        todo = "raise --judge-spend or --judge-tokens and run the same command again"
        if guards.judge_usd is not None and spent.total_usd >= guards.judge_usd:
            told = f"{spent.total_usd:.4f} of {guards.judge_usd:.4f} USD"
        elif guards.judge_tokens is not None and spent.tokens >= guards.judge_tokens:
            told = f"{spent.tokens} of {guards.judge_tokens} tokens"
        else:
            return None
        return stop("spending", f"its judge's limit is reached: {told}", todo)

    def _faults(self, guards: Guards) -> StoppedByGuard | None:
        for cause, times in self._in_a_row.items():
            if times >= guards.most_faults:
                trial, line = self._last[cause]
                faults = self._run.trial_named(trial).faults
                return stop(
                    "faults",
                    f"{times} trials in a row failed with {cause}, the last: {line}",
                    f"see to the cause ({faults}), then run the same command again",
                )
        return None

    def _count(self, since: float) -> None:
        for _, event in self._tail.read():
            if event.get("time", 0.0) < since:
                continue
            if event.get("event") == "done":
                self._in_a_row.clear()
            elif event.get("event") == "pending":
                cause = str(event.get("error"))
                self._in_a_row[cause] += 1
                self._last[cause] = (str(event.get("trial")), str(event.get("line")))


def spent_up(error: SpendingLimitReached) -> StoppedByGuard:
    """What stops a run of which a request was refused for spending."""
    return stop("spending", error.what, error.todo)


def left_over(stopped: StoppedByGuard, left: int, total: int, run: Path) -> StoppedByGuard:
    """What stopped a run, with what is left of it."""
    made = stop(stopped.guard, f"stopped with {left} of {total} trials left: {stopped.what}", stopped.todo)
    made.where = str(run)
    return made


def reason_of(error: Exception) -> str:
    """What went wrong, in a line."""
    return error.line() if isinstance(error, C4SError) else f"{type(error).__name__}: {error}"
