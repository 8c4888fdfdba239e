"""The verifiers that fan out once a submission is valid."""

from __future__ import annotations

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot


@task(task_run_name="physics-{trial.name}")
def physics(trial: Trial, plan: Plan, valid: bool) -> None:
    """Support and penetration."""
    if valid:
        in_slot(stages.physics, trial, plan)


@task(task_run_name="repair-{trial.name}")
def repair(trial: Trial, plan: Plan, valid: bool) -> None:
    """Repair F1."""
    if valid:
        in_slot(stages.repair, trial, plan)


@task(task_run_name="{verifier}-{trial.name}")
def semantic(trial: Trial, plan: Plan, valid: bool, verifier: str) -> None:
    """Detailed or Overview Alignment."""
    if valid:
        in_slot(stages.semantic, trial, plan, verifier)
