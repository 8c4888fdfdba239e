"""One agent attempt."""

from __future__ import annotations

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="attempt-{number}-{trial.name}", cache_policy=NO_CACHE)
async def attempt(trial: Trial, plan: Plan, number: int) -> AttemptOutcome:
    """Run attempt ``number``, or read its outcome."""
    return await work(stages.attempt, trial, plan, number)
