"""What a trial's judge works with: its folder, the run's limits, and whether the run takes no more work."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path

from c4s.judge.desk import Desk
from c4s.meter.spending import Ledger
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.run.guards import asked_of, guards_of
from c4s.run.plan import Trial


def desk(trial: Trial, plan: Plan) -> Desk:
    """The desk of a trial's judge."""
    guards = guards_of(RunFolder(trial.run))
    return _in_run(
        trial,
        Desk(exchanges=trial.folder.exchanges(plan.judge), accept_faults=guards is not None and guards.accept_faults),
    )


def repeat_desk(trial: Trial, answers: Path, exchanges: Path) -> Desk:
    """The desk of a repeat, which asks everything anew, takes no fault for an answer, and writes where it is told."""
    return _in_run(trial, Desk(exchanges=exchanges, answers=answers, fresh=True))


def _in_run(trial: Trial, bare: Desk) -> Desk:
    """A desk within the limits of a run."""
    run = RunFolder(trial.run)
    guards = guards_of(run)

    def wait(seconds: float) -> bool:
        asked = asked_of(run, guards)
        if asked is not None and asked.word == "drain":
            return True
        return threading.Event().wait(seconds)

    ledger = Ledger(
        run.judging,
        None if guards is None else guards.judge_usd,
        run.elsewhere,
        limit_tokens=None if guards is None else guards.judge_tokens,
    )
    return replace(bare, ledger=ledger, wait=wait)
