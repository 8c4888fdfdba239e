"""Evidence from a clean engine, and the integrity gate."""

from __future__ import annotations

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="integrity-{number}-{trial.name}", cache_policy=NO_CACHE)
async def integrity(trial: Trial, plan: Plan, number: int) -> bool:
    """Whether attempt ``number`` left a valid submission."""
    return await work(stages.integrity, trial, plan, number)
