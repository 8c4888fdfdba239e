"""One verifier on a valid submission."""

from __future__ import annotations

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.plan import Plan
from c4s.records.verdict import Verdict
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="{name}-{trial.name}", cache_policy=NO_CACHE)
async def verify(trial: Trial, plan: Plan, name: str) -> Verdict:
    """The verdict of a verifier of the table."""
    return await work(stages.verify, trial, plan, name)
