"""The score of a scene that was saved elsewhere: it enters as an attempt that has ended, and is verified as any."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from c4s.engine import backend
from c4s.engine.content import content_fault
from c4s.errors import BadInput
from c4s.files import parse_json, write_json
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration, Plan
from c4s.records.score import TrialScore
from c4s.records.suite import PackRef, SuiteFolder
from c4s.run.attempt import last_saved
from c4s.run.check import freeze_submission
from c4s.run.choices import check_judge
from c4s.run.drive import in_slots, stage_functions
from c4s.run.lease import holding
from c4s.run.limits import Stage
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.trial import run_trial

MOST_MANIFEST_BYTES = 1 << 20


def grade(
    suite: Path,
    case: str,
    submission: Path,
    root: Callable[[], Path],
    *,
    configuration: Configuration,
    policy: str,
    judge: str,
    engine: str,
) -> TrialScore:
    """Verify and score a submission as the one attempt of a run of its own.

    Args:
        suite: the built suite, withheld tree included.
        case: id of the case.
        submission: an attempt's folder as ``c4s serve --out`` leaves it, or the submission in it. An agent may have
            written to it, so nothing in it is trusted: links and special files make it no submission.
        root: makes a new folder for the run; called once all else is in order.
        configuration: whose work it was, for the record.
        policy: as for a run.
        judge: as for a run.
        engine: as for a run.

    ``BadInput`` where the folder is not there, and for all that a plan refuses.
    """
    if not submission.is_dir():
        raise BadInput("no such folder", where=str(submission), todo="give what `c4s serve CASE --out` left")
    trial, plan = open_trial(suite, case, root, configuration=configuration, policy=policy, judge=judge, engine=engine)
    enter(trial, plan, submission)
    return score_recorded(trial, plan)


def open_trial(
    suite: Path,
    case: str,
    root: Callable[[], Path],
    *,
    configuration: Configuration,
    policy: str,
    judge: str,
    engine: str,
) -> tuple[Trial, Plan]:
    """The one trial of a run of its own, whose attempt is made by other means; arguments as those of ``grade``."""
    plan = make_plan(
        SuiteFolder(suite), [configuration], run_id="grade", policy=policy, judge=judge, engine=engine, cases=[case]
    )
    check_judge(plan)
    run = root()
    plan = open_run(run, plan)
    (trial,) = trials(run, suite, plan)
    return trial, plan


def score_recorded(trial: Trial, plan: Plan) -> TrialScore:
    """Verify and score the attempt that a trial has on record; no other is made."""
    with holding(trial.run) as held:
        return asyncio.run(_scored(trial, plan, [held]))


async def _scored(trial: Trial, plan: Plan, held: list[Any]) -> TrialScore:
    inside = stage_functions()

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage == "attempt":
            return AttemptOutcome.read(trial.folder.attempt(*arguments).outcome)
        return await inside(stage, trial, plan, *arguments)

    async with Pool() as pool:
        return await run_trial(trial, plan, in_slots(pool, run, trial, plan, held=held), attempts=1)


def enter(trial: Trial, plan: Plan, source: Path) -> AttemptOutcome:
    """Copy a submission into a trial's first attempt and put on record that it has ended."""
    given, kept = AttemptFolder(source), trial.folder.attempt(1)
    whole = given.submission.is_dir() and not given.submission.is_symlink()
    content = given.submission if whole else source
    kept.agent.mkdir(parents=True)
    kept.usage.touch()
    kept.trajectory.touch()
    frozen = SuiteFolder(trial.suite).agent_case(trial.case.alias).packs
    write_json(kept.manifest, {"packs": _mounted(given.manifest, frozen), "engine": plan.engine})
    unsound = content_fault(content)
    saved = None
    if unsound is None:
        shutil.copytree(content, kept.submission, symlinks=True)
        unsound = content_fault(kept.submission)
    if unsound is None:
        saved = last_saved(kept.submission, backend(plan.engine).level_suffix)
    outcome = AttemptOutcome(
        attempt=1,
        ended_by="finished" if unsound is None else "agent_error",
        submission=saved,
        submission_sha256=None if saved is None else freeze_submission(kept),
        client=trial.working.client,
        model=trial.working.model,
        message="entered from a folder" if unsound is None else f"this cannot be submitted: {unsound}",
    )
    outcome.write(kept.outcome)
    return outcome


def numbers(score: TrialScore) -> dict[str, float]:
    """A score as finite numbers by name: ``reward``, ``valid`` (1 or 0), and every component that was evaluated."""
    assert score.score is not None, "a score that is pending is a fault"
    parts = {name: float(value) for name, value in score.components.items() if value is not None}
    return {"reward": score.score, "valid": float(score.retained_attempt is not None), **parts}


def _mounted(manifest: Path, frozen: list[PackRef]) -> dict[str, str]:
    """The packs that the attempt says it had, by digest; those that its case names where it says nothing."""
    try:
        told = parse_json(manifest.read_bytes()[:MOST_MANIFEST_BYTES]) if manifest.is_file() else None
        packs = told["packs"] if isinstance(told, dict) else None
    except (OSError, ValueError, KeyError, RecursionError):
        packs = None
    if isinstance(packs, dict) and all(isinstance(value, str) for value in packs.values()):
        return {str(name): value for name, value in packs.items()}
    return {reference.pack_id: reference.digest for reference in frozen}
