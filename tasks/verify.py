"""The verifiers that fan out once a submission is valid."""

from __future__ import annotations

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot


@task(task_run_name="{name}-{trial.name}")
def verify(trial: Trial, plan: Plan, valid: bool, name: str) -> None:
    """One verifier of the table."""
    if valid:
        in_slot(stages.verify, trial, plan, name)
