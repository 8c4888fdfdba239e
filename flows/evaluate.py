"""The evaluate flow: what the plan asks for and the run folder does not hold yet."""

from __future__ import annotations

from collections.abc import Sequence

from prefect import flow

from c4s.engine import DEFAULT_ENGINE
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.judge.names import DEFAULT_JUDGE
from c4s.names import place_in
from c4s.protocol.baselines import BASELINES
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.suite import SuiteFolder
from c4s.run.choices import check_ready
from c4s.run.configurations import configuration
from c4s.run.drive import refuse_pending, run_trials
from c4s.run.lease import holding
from c4s.run.plan import make_plan, open_run, trials
from c4s.run.pool import Pool
from flows.server import tie
from flows.trial import as_tasks
from reports.site import check_place
from tasks.publish import publish
from warehouse.done import held_by
from warehouse.ingest import ingest_schedule

tie()


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

    Run it again with the same arguments to complete a run that was stopped; what is done is reused. ``BadInput`` where
    somebody else works on the run.

    Args:
        suite: id of a built suite.
        agents: configuration names or files (default: the six baselines).
        run_id: folder name of the run (default: the suite's id).
        cases: only these cases.
        repeats: repeats of each case.
        policy: id of a score policy that ships.
        judge: name of a judge.
        engine: name of an engine.
        slots: engine processes at once (default: one a core).
    """
    folder, run = place_in(suites_root(), suite, "suite"), place_in(runs_root(), run_id or suite, "run")
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
    check_place(site_root())
    with holding(run) as held:
        missing = [trial for trial in trials(run, folder, plan) if held_by(trial, plan, warehouse) is None]
        if missing:
            check_ready(plan.configurations)
        plan = open_run(run, plan)
        ingest_schedule(run, folder, plan, warehouse)
        async with Pool(slots) as pool:
            pending = await run_trials(missing, plan, pool, as_tasks(warehouse), held)
        page = publish(warehouse, site_root())
    refuse_pending(pending, len(missing))
    return page.as_uri()
