"""Watching a night of 7,980 trials: what a look costs, against looking for a file of each trial."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

from bench.row import Row
from c4s.cli.run_view import view
from c4s.protocol.settings import SETTINGS
from c4s.records.folder import RunFolder
from c4s.records.journal import Event
from c4s.records.plan import Configuration, Plan, PlannedCase
from c4s.run.guards import Watchman, set_guards
from c4s.run.journal import Journal
from c4s.run.lease import holding
from c4s.run.limits import LIMITS
from c4s.run.progress import Progress
from reports.status import write_status

AGENTS, CASES, REPEATS, TIMES = 14, 190, 3, 15
STAGES = [(stage, limit.kind) for stage, limit in LIMITS.items() if stage != "control"]


def rows() -> list[Row]:
    """A look at the run, what the guards cost a second, a line of the journal, a page."""
    with tempfile.TemporaryDirectory() as name:
        run = RunFolder(Path(name) / "runs" / "night")
        names = _plan(run)
        set_guards(run)
        wrote = time.perf_counter()
        events = _journal(run, names)
        line_s = (time.perf_counter() - wrote) / events
        with holding(run.root):
            progress = Progress(run.root)
            first = time.perf_counter()
            now = progress.read()
            first = time.perf_counter() - first
            watchman = Watchman(run)
            watchman.look()
            files = [run.trial_named(name).score for name in names]
            every = _takes(lambda: sum(path.is_file() for path in files))
            page, board = Path(name) / "status.html", Path(name) / "index.html"
            look = _takes(progress.read)
            return [
                Row(
                    f"progress: a look at {len(names):,} trials",
                    look,
                    "5x",
                    every / look >= 5,
                    rival="a stat a trial",
                    theirs=every,
                    ratio=every / look,
                ),
                _under(f"progress: the first look, {events:,} lines", first, 5),
                _under("progress: a look at the guards", _takes(watchman.look), 0.005),
                _under("progress: a line of the journal", line_s, 0.001),
                _under("progress: the terminal's view", _takes(lambda: view(now, 50)), 0.05),
                _under("progress: the status page", _takes(lambda: write_status(now, page, board)), 0.2),
            ]


def _under(name: str, seconds: float, most: float) -> Row:
    return Row(name, seconds, f"under {1000 * most:g} ms", seconds < most)


def _takes(work: Callable[[], object]) -> float:
    taken = []
    for _ in range(TIMES):
        started = time.perf_counter()
        work()
        taken.append(time.perf_counter() - started)
    return median(taken)


def _plan(run: RunFolder) -> list[str]:
    """The plan on file; the trials by their paths below the run's."""
    cases = [
        PlannedCase(
            case_id=f"case-{number}",
            alias=f"case-{number}",
            setting=SETTINGS[0],
            scene_id="made",
            agent_digest="",
            withheld_digest="",
        )
        for number in range(CASES)
    ]
    agents = [Configuration(name=f"agent-{number}", client="noop") for number in range(AGENTS)]
    Plan(
        run_id="night",
        suite_id="made",
        suite_digest="",
        configurations=agents,
        cases=cases,
        repeats=REPEATS,
        policy="",
        judge="rule",
        engine="headless",
        versions={},
    ).write(run.plan)
    return [f"{a.name}/{c.alias}/r{r + 1}" for r in range(REPEATS) for c in cases for a in agents]


def _journal(run: RunFolder, names: list[str]) -> int:
    """All stages of all trials but the last 16, which are in work; how many lines that is."""
    journal = Journal(run)
    count = 0

    def note(event: str, **fields: Any) -> None:
        nonlocal count
        count += 1
        journal(Event.model_validate({"time": time.time(), "event": event, **fields}))

    note("begun", owner=journal.owner, slots={"engine": 16, "processor": 2})
    for name in names[:-16]:
        for stage, kind in STAGES:
            note("started", trial=name, stage=stage, kind=kind)
            note(
                "ended", trial=name, stage=stage, kind=kind, seconds=10.0, cost_usd=0.1 if stage == "attempt" else None
            )
        note("done", trial=name, score=0.5, status="measured")
    for name in names[-16:]:
        note("started", trial=name, stage="attempt", attempt=1, kind="engine")
    journal.close()
    return count
