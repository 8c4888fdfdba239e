"""The pictures of a valid submission."""

from __future__ import annotations

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot


@task(task_run_name="look-{trial.name}")
def look(trial: Trial, plan: Plan, valid: bool) -> None:
    """Take the pictures, by a clean engine."""
    if valid:
        in_slot(stages.look, trial, plan)
