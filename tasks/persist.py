"""The trial's rows in the warehouse."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from prefect import task
from prefect.cache_policies import NO_CACHE

from c4s.records.plan import Plan
from c4s.run.drive import store
from c4s.run.plan import Trial
from c4s.run.pool import work
from warehouse.ingest import ingest_trial


@task(task_run_name="persist-{trial.name}", cache_policy=NO_CACHE)
async def persist(trial: Trial, plan: Plan, warehouse: Path) -> None:
    """Write the rows of a scored trial."""
    await work(partial(store, partial(ingest_trial, warehouse=warehouse)), trial, plan)
