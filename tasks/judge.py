"""What the plan's judge says of a valid submission."""

from __future__ import annotations

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot


@task(task_run_name="judge-{trial.name}")
def judge(trial: Trial, plan: Plan, valid: bool) -> None:
    """Judge every claim of the case."""
    if valid:
        in_slot(stages.judge, trial, plan)
