"""The trial's score, and its rows in the warehouse."""

from __future__ import annotations

from pathlib import Path

from prefect import task

from c4s.records.plan import Plan
from c4s.run import stages
from c4s.run.plan import Trial
from tasks.pool import in_slot
from warehouse.ingest import ingest_trial


def _score_and_store(trial: Trial, plan: Plan, warehouse: Path) -> None:
    stages.score(trial, plan)
    with stages.timed(trial, "persist"):
        ingest_trial(trial, plan, warehouse)


@task(task_run_name="persist-{trial.name}")
def persist(trial: Trial, plan: Plan, warehouse: Path) -> None:
    """Score the trial and write its rows."""
    in_slot(_score_and_store, trial, plan, warehouse)
