"""The evaluate flow: what the plan asks for and the run folder does not hold yet."""

from __future__ import annotations

from collections.abc import Sequence

from prefect import flow

from c4s.engine import DEFAULT_ENGINE
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.judge.names import DEFAULT_JUDGE
from c4s.protocol.baselines import BASELINES
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.suite import SuiteFolder
from c4s.run.check import check_kept
from c4s.run.choices import check_ready
from c4s.run.configurations import configuration
from c4s.run.drive import refuse_pending, run_trials
from c4s.run.plan import make_plan, open_run, trials
from c4s.run.pool import Pool
from flows.trial import as_tasks
from tasks.publish import publish
from warehouse.ingest import ingest_schedule, is_stored


@flow(name="evaluate", validate_parameters=False)
async def evaluate(
    suite: str = "starter",
    agents: Sequence[str] = BASELINES,
    run_id: str | None = None,
    cases: Sequence[str] = (),
    repeats: int = 1,
    policy: str = DEFAULT_POLICY,
    judge: str = DEFAULT_JUDGE,
    engine: str = DEFAULT_ENGINE,
    slots: int | None = None,
) -> str:
    """Run, verify, store and publish a suite. Returns the address of the leaderboard page.

    Run it again with the same arguments to complete a run that was stopped; finished trials are skipped.

    Args:
        suite: id of a built suite.
        agents: configuration names or files (default: the five baselines).
        run_id: folder name of the run (default: the suite's id).
        cases: only these cases.
        repeats: repeats of each case.
        policy: id of a score policy that ships.
        judge: name of a judge.
        engine: name of an engine.
        slots: engine processes at once (default: one a core).
    """
    folder, run = suites_root() / suite, runs_root() / (run_id or suite)
    plan = make_plan(
        SuiteFolder(folder),
        [configuration(name) for name in agents],
        run_id=run.name,
        policy=policy,
        judge=judge,
        engine=engine,
        repeats=repeats,
        cases=cases,
    )
    warehouse = warehouse_root()
    missing = [trial for trial in trials(run, folder, plan) if not is_stored(trial, plan, warehouse)]
    for trial in missing:
        check_kept(trial)
    if missing:
        check_ready(plan.configurations)
    plan = open_run(run, plan)
    ingest_schedule(run, folder, plan, warehouse)
    async with Pool(slots) as pool:
        pending = await run_trials(missing, plan, pool, as_tasks(warehouse))
    page = publish(warehouse, site_root())
    refuse_pending(pending, len(missing))
    return page.as_uri()
