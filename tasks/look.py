"""The pictures of a valid submission."""

from __future__ import annotations

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="look-{trial.name}", cache_policy=NO_CACHE)
async def look(trial: Trial, plan: Plan) -> None:
    """Take the pictures, by a clean engine."""
    await work(stages.look, trial, plan)
