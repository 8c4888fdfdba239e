"""All that watches over a run while this process works on it: guards, journal, logs, telemetry, notices."""

from __future__ import annotations

import platform
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from c4s.errors import C4SError
from c4s.meter.endpoints import spending_limit
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.run.guards import MOST_IN_A_ROW, fetch_guards, reason_of, set_guards
from c4s.run.headroom import print_line
from c4s.run.logs import logging_to
from c4s.run.notify import at_a_guard, notifier
from c4s.run.overseer import Overseer
from c4s.run.plan import Trial, trial_id
from c4s.run.pool import Pool
from c4s.run.progress import Progress
from c4s.run.telemetry import is_asked_for, sending
from c4s.stderr import check_choice

WAIT_S = 20.0


@dataclass(frozen=True)
class RunBounds:
    """What whoever starts a run gives it beside its plan. It may differ each time."""

    deadline: float | None = None
    """Unix time, seconds."""
    spend_usd: float | None = None
    """None: what ``C4S_SPENDING_LIMIT_USD`` or the operator's file says."""
    judge_usd: float | None = None
    """None: no limit, as with tokens."""
    judge_tokens: int | None = None
    accept_faults: bool = False
    most_faults: int = MOST_IN_A_ROW
    notify: str | None = None
    """None: what ``C4S_NOTIFY`` says."""

    def check(self) -> None:
        """``BadInput`` for what cannot be obeyed, before anything is started."""
        notifier(self.notify, print_line)
        check_choice()
        is_asked_for()


@contextmanager
def overseen(
    run: Path, suite: Path, plan: Plan, pool: Pool, bounds: RunBounds | None, reused: Counter[str] | None = None
) -> Iterator[Overseer]:
    """For the block, watch over a run; its plan is written.

    Args:
        run: the run folder.
        suite: the suite's folder.
        plan: the run's plan.
        pool: where this process's stages run.
        bounds: of the process that holds the run. Its notices are sent: when a guard stops the run, and at the end with
            what the block raised. None for one that works for a holder: the bounds on record hold, and it is silent.
        reused: trials of the plan that another run holds, by configuration.
    """
    folder, to = RunFolder(run), None
    if bounds is not None:
        spend = spending_limit() if bounds.spend_usd is None else bounds.spend_usd
        set_guards(
            folder,
            deadline=bounds.deadline,
            spend_usd=spend,
            most_faults=bounds.most_faults,
            judge_usd=bounds.judge_usd,
            judge_tokens=bounds.judge_tokens,
            accept_faults=bounds.accept_faults,
        )
        to = notifier(bounds.notify, print_line)
    else:
        fetch_guards(folder)
    ids, progress = ids_of(run, suite, plan), Progress(run, suite)
    started = time.monotonic()

    def notice(event: str, line: str) -> dict[str, Any]:
        return _notice(event, line, progress, folder, time.monotonic() - started)

    with ExitStack() as inside:
        listeners = [inside.enter_context(logging_to(run, ids))]
        telemetry = inside.enter_context(sending(plan.run_id, ids, progress.read))
        if telemetry is not None:
            listeners.append(telemetry)
        if to is not None:
            inside.callback(to.wait)
            listeners.append(at_a_guard(to, lambda line: notice("stopping", line)))
        overseer = Overseer(run, listeners)
        line = ""
        try:
            overseer.begin(pool.slots, reused)
            yield overseer
        except KeyboardInterrupt:
            line = "it was ended at once"
            raise
        except Exception as error:
            line = reason_of(error)
            raise
        finally:
            overseer.end()
            if to is not None:
                to.send(notice("ended", line))


def ids_of(run: Path, suite: Path, plan: Plan) -> Callable[[str], str]:
    """Ids of a plan's trials by their paths below the run's folder."""
    configurations = {chosen.name: chosen for chosen in plan.configurations}
    cases = {case.alias: case for case in plan.cases}

    @cache
    def found(name: str) -> str:
        configuration, alias, repeat = name.split("/")
        return trial_id(plan, Trial(run, suite, configurations[configuration], cases[alias], int(repeat[1:])))

    return found


def _notice(event: str, line: str, progress: Progress, folder: RunFolder, seconds: float) -> dict[str, Any]:
    """What is told of a run: short enough for a chat, with where to read more."""
    now = progress.read()
    return {
        "event": event,
        "run": now.run_id,
        "suite": now.suite_id,
        "host": platform.node(),
        "state": now.state,
        "text": f"c4s run {now.run_id} {event}: {now.done} of {now.planned} trials done, {now.pending} pending"
        + (f"; {line}" if line else ""),
        "line": line,
        "planned": now.planned,
        "done": now.done,
        "pending": now.pending,
        "spent_usd": now.spent_usd,
        "seconds": round(seconds, 1),
        "faults": [trouble.plain() for trouble in now.troubles],
        "status_page": folder.status_page.absolute().as_uri(),
    }


@contextmanager
def every(seconds: float, do: Callable[[], None], what: str) -> Iterator[None]:
    """Do something at once, every so many seconds while the block runs, and once more after it.

    It is not what the block is for: where it fails, a line tells so once, with what ``what`` names, and all goes on.
    """
    ended, told = threading.Event(), threading.Event()

    def once() -> None:
        try:
            do()
        except (C4SError, OSError) as error:
            if not told.is_set():
                print_line(f"{what} is not up to date: {reason_of(error)}")
            told.set()

    def beat() -> None:
        once()
        while not ended.wait(seconds):
            once()

    thread = threading.Thread(target=beat, name="beat", daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join(WAIT_S)
        once()
