"""The work of a stage that failed, for a scene known to be good."""

from __future__ import annotations

from typing import Any

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.limits import Stage
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="control-{stage}-{trial.name}", cache_policy=NO_CACHE)
async def control(trial: Trial, plan: Plan, stage: Stage, *arguments: Any) -> None:
    """Do the same for the case's own start level."""
    await work(stages.control, trial, plan, stage, *arguments)
