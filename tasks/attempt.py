"""One agent attempt. The second runs only where the first left no valid submission."""

from __future__ import annotations

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot


@task(task_run_name="attempt-{number}-{trial.name}")
def attempt(trial: Trial, plan: Plan, number: int, valid_before: bool = False) -> bool:
    """Run attempt ``number`` unless an earlier one was valid. Returns whether it is needed and on record."""
    if valid_before:
        return False
    in_slot(stages.attempt, trial, plan, number)
    return True
