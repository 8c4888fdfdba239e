"""Evidence from a clean engine, and the integrity gate."""

from __future__ import annotations

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot


@task(task_run_name="integrity-{number}-{trial.name}")
def integrity(trial: Trial, plan: Plan, number: int, ran: bool, valid_before: bool = False) -> bool:
    """Whether the trial has a valid submission after attempt ``number``."""
    return in_slot(stages.integrity, trial, plan, number) if ran else valid_before
