"""What the plan's judge says of a valid submission."""

from __future__ import annotations

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.judgement import Judgements
from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="judge-{trial.name}", cache_policy=NO_CACHE)
async def judge(trial: Trial, plan: Plan) -> Judgements:
    """Judge every claim of the case."""
    return await work(stages.judge, trial, plan)
