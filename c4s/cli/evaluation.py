"""Running a plan in this process: no scheduler, visible progress, nothing started when all is done."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from c4s.cli.progress import watch
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE
from c4s.home import runs_root, site_root, warehouse_root
from c4s.judge.names import DEFAULT_JUDGE
from c4s.protocol.baselines import BASELINES
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.check import check_kept
from c4s.run.choices import check_ready
from c4s.run.configurations import configuration
from c4s.run.drive import Pending, refuse_pending, run_trials, stage_functions
from c4s.run.plan import Trial, make_plan, open_run, trial_id, trials
from c4s.run.pool import Pool
from c4s.run.stages import inputs
from reports.site import build_site
from warehouse.database import rebuild
from warehouse.ingest import ingest_schedule, ingest_trial, is_stored
from warehouse.parquet import part_path


@dataclass(frozen=True)
class Evaluation:
    """What came of an evaluation."""

    page: str
    ran: int
    skipped: int
    seconds: float


def evaluate_here(
    suite: str,
    agents: Sequence[str],
    *,
    run_id: str | None = None,
    cases: Sequence[str] = (),
    repeats: int = 1,
    policy: str = DEFAULT_POLICY,
    judge: str = DEFAULT_JUDGE,
    engine: str = DEFAULT_ENGINE,
    slots: int | None = None,
) -> Evaluation:
    """Evaluate in this process. Raises ``BadInput`` before anything is started where the request cannot be met."""
    started = time.perf_counter()
    folder, run, warehouse = built_suite(suite), runs_root() / (run_id or suite), warehouse_root()
    plan = make_plan(
        SuiteFolder(folder),
        [configuration(name) for name in agents or BASELINES],
        run_id=run.name,
        policy=policy,
        judge=judge,
        engine=engine,
        repeats=repeats,
        cases=cases,
    )
    scheduled = list(trials(run, folder, plan))
    for trial in {trial.case.case_id: trial for trial in scheduled}.values():
        inputs(trial)
    missing = [trial for trial in scheduled if not is_stored(trial, plan, warehouse)]
    for trial in missing:
        check_kept(trial)
    if missing:
        check_ready(plan.configurations)
    plan = open_run(run, plan)
    page = site_root() / "index.html"
    if missing or not page.is_file():
        ingest_schedule(run, folder, plan, warehouse)
        stored = [
            part_path(warehouse, "outcomes", plan.suite_id, trial.configuration.name, trial_id(plan, trial))
            for trial in scheduled
        ]
        with watch(scheduled, {path for path in stored if path.is_file()}, stored):
            pending = asyncio.run(_run(missing, plan, slots))
            rebuild(warehouse)
            page = build_site(warehouse, site_root())
        refuse_pending(pending, len(missing))
    return Evaluation(page.as_uri(), len(missing), len(scheduled) - len(missing), time.perf_counter() - started)


async def _run(missing: Sequence[Trial], plan: Plan, slots: int | None) -> list[Pending]:
    async with Pool(slots) as pool:
        return await run_trials(missing, plan, pool, stage_functions(partial(ingest_trial, warehouse=warehouse_root())))
