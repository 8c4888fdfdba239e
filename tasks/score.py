"""The trial's score."""

from __future__ import annotations

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.run.pool import work


@task(task_run_name="score-{trial.name}", cache_policy=NO_CACHE)
async def score(trial: Trial, plan: Plan) -> TrialScore:
    """Score the trial from its verdicts."""
    return await work(stages.score, trial, plan)
