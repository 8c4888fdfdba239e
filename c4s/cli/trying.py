"""One trial to look at: run with a live view in a folder of its own, on no leaderboard."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.cli.live import LiveView, follow
from c4s.cli.output import console, print_table, say
from c4s.cli.suites import built_suite
from c4s.errors import BadInput
from c4s.folders import numbered_folder
from c4s.home import home
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder, RunFolder
from c4s.records.plan import Configuration, Plan
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run.choices import check_judge, check_ready
from c4s.run.drive import in_slots, stage_functions
from c4s.run.lease import Held, holding
from c4s.run.limits import Stage
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.stages import ATTEMPTS
from c4s.run.trial import run_trial

Watching = Callable[[Path], AbstractContextManager[None]]
"""Given the folder of an attempt, what surrounds it."""
_ATTEMPT = re.compile(r"attempt-[1-9]")


@dataclass(frozen=True)
class Try:
    """A trial with a folder of its own under ``tries/``."""

    root: Path
    suite: Path
    plan: Plan
    trial: Trial

    @classmethod
    def prepare(cls, chosen: Configuration, suite: Path, case: str, *, policy: str, judge: str, engine: str) -> Try:
        """Check all that is asked for, and make the folder. ``BadInput`` before anything is made."""
        plan = make_plan(
            SuiteFolder(suite), [chosen], run_id="try", policy=policy, judge=judge, engine=engine, cases=[case]
        )
        check_ready(plan.configurations)
        check_judge(plan)
        root = numbered_folder(home() / "tries", f"{chosen.name}-{plan.cases[0].alias}")
        plan = open_run(root / "run", plan)
        return cls(root, suite, plan, next(iter(trials(root / "run", suite, plan))))

    def run(self, watching: Watching | None = None, *, attempts: int = ATTEMPTS) -> TrialScore:
        """Run the trial, with so many attempts at most; while one runs, so does the block of ``watching``."""
        with holding(self.trial.run) as held:
            return asyncio.run(_watched(self.trial, self.plan, held, watching, attempts))

    def publish(self) -> Path:
        """Pages of this trial alone; returns its case page."""
        return _publish(self.root, self.suite, self.trial.case.case_id)


@contextmanager
def watch(attempt: Path) -> Iterator[None]:
    """Show every call of an attempt as it ends, then how the attempt did."""
    with follow(attempt, LiveView(console, attempt).poll):
        yield
    say_ending(attempt)


async def _watched(trial: Trial, plan: Plan, held: Held, watching: Watching | None, attempts: int) -> TrialScore:
    """The trial in worker processes; each attempt is watched while it runs."""
    inside = stage_functions()

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if watching is None or stage != "attempt":
            return await inside(stage, trial, plan, *arguments)
        with watching(trial.folder.attempt(*arguments).root):
            return await inside(stage, trial, plan, *arguments)

    async with Pool() as pool:
        return await run_trial(trial, plan, in_slots(pool, run, trial, plan, held=[held]), attempts=attempts)


def say_ending(attempt: Path) -> None:
    """How an attempt ended, what it took and what it saved, as a line."""
    outcome = AttemptOutcome.read(AttemptFolder(attempt).outcome)
    tokens = "" if outcome.input_tokens is None else f", {outcome.input_tokens} in and {outcome.output_tokens} out"
    cost = "" if outcome.cost_usd is None else f", ${outcome.cost_usd:.4f}"
    saved = f"saved {outcome.submission}" if outcome.submission else "nothing was saved"
    message = f": {outcome.message}" if outcome.message else ""
    say(
        f"attempt {outcome.attempt}: {outcome.ended_by}{message}; {outcome.tool_calls} calls in "
        f"{outcome.wall_s:.1f} s{tokens}{cost}; {saved}"
    )


def _publish(root: Path, suite: Path, case: str) -> Path:
    from reports.frame import boards, links
    from reports.site import build_site
    from warehouse.database import rebuild
    from warehouse.ingest import rebuild_from_run

    for left_out in rebuild_from_run(root / "run", suite, root / "warehouse"):
        raise left_out
    rebuild(root / "warehouse")
    build_site(root / "warehouse", root / "site")
    return root / "site" / links.case(boards(root / "warehouse")[0], case)


def print_score(trial: Trial, score: TrialScore) -> None:
    """The score with its parts, as a table."""
    parts: list[tuple[str, Any]] = [("score", score.score), ("status", score.status)]
    parts += [(name, value) for name, value in score.components.items() if value is not None]
    if score.reason:
        parts.append(("reason", score.reason))
    print_table(("", trial.name), parts)


def trial_of(attempt: Path) -> Trial:
    """The trial that an attempt's folder belongs to: ``<run>/<agent>/<case>/r<k>/attempt-<n>``."""
    folder = attempt.absolute()
    run = folder.parents[3] if len(folder.parents) > 3 else folder
    other = BadInput("not an attempt of a run", where=str(attempt), todo="give <run>/<agent>/<case>/r<k>/attempt-<n>")
    if not RunFolder(run).plan.exists() or not _ATTEMPT.fullmatch(folder.name):
        raise other
    plan = Plan.read(RunFolder(run).plan)
    suite = built_suite(plan.suite_id)
    found = next((trial for trial in trials(run, suite, plan) if trial.folder.root == folder.parent), None)
    if found is None:
        raise other
    return found
