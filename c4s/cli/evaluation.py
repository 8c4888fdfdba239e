"""Running a plan in this process: no scheduler, visible progress, nothing started when all is done."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial

from c4s.cli.run_view import drawn
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.judge.names import DEFAULT_JUDGE
from c4s.names import place_in
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.folder import RunFolder
from c4s.records.plan import LeftOut, Plan
from c4s.records.suite import SuiteFolder
from c4s.run.choices import check_judge, check_ready, default_agents
from c4s.run.configurations import configuration
from c4s.run.drive import Pending, refuse_pending, run_trials, settle_all, stage_functions
from c4s.run.headroom import print_line
from c4s.run.inputs import inputs
from c4s.run.lease import Held, holding
from c4s.run.overseer import Overseer
from c4s.run.oversight import RunBounds, every, overseen
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.progress import Progress
from c4s.run.signals import ending_in_order
from c4s.run.store import open_store, send_suite
from c4s.stderr import tell
from reports.place import check_place
from warehouse.database import is_current, rebuild
from warehouse.done import look_up
from warehouse.ingest import ingest_schedule, ingest_trial


@dataclass(frozen=True)
class Evaluation:
    """What came of an evaluation."""

    page: str
    run_id: str
    ran: int
    reused: dict[str, int]
    """How many of the trials were done, by the run that holds them."""
    seconds: float
    left_out: list[LeftOut] = field(default_factory=list)
    """Default agents that cannot work on its cases, and why."""

    def line(self) -> str:
        """It, for people."""
        told = [f"{_trials(self.ran)} run in {self.seconds:.0f} s"]
        for holder, count in self.reused.items():
            where = "" if holder == self.run_id else f" from run {holder!r}"
            told.append(f"{_trials(count)} {'is' if count == 1 else 'are'} done and reused{where}")
        return ", ".join(told)


def _trials(count: int) -> str:
    return f"{count} trial{'' if count == 1 else 's'}"


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
    wait: bool = False,
    bounds: RunBounds | None = None,
) -> Evaluation:
    """Evaluate in this process. Raises ``BadInput`` before anything is started where the request cannot be met.

    Where somebody else works on the run, ``wait`` waits for them; else that is ``BadInput`` too. ``StoppedByGuard``
    where one of ``bounds``, an operator or a signal ended the run before it was done.
    """
    started = time.perf_counter()
    bounds = bounds or RunBounds()
    bounds.check()
    folder, warehouse, store = built_suite(suite), warehouse_root(), open_store()
    run = place_in(runs_root(), run_id or suite, "run")
    names, left_out = (agents, []) if agents else default_agents(SuiteFolder(folder), cases)
    plan = make_plan(
        SuiteFolder(folder),
        [configuration(name) for name in names],
        run_id=run.name,
        policy=policy,
        judge=judge,
        engine=engine,
        repeats=repeats,
        cases=cases,
        left_out=left_out,
    )
    scheduled = list(trials(run, folder, plan))
    for trial in {trial.case.case_id: trial for trial in scheduled}.values():
        inputs(trial)
    check_place(site_root())
    page = site_root() / "index.html"
    with holding(run, wait=print_line if wait else None) as held:
        store.pull_files(warehouse)
        store.pull_files(RunFolder(run).plan)
        found = look_up(scheduled, plan, warehouse)
        if found.missing:
            check_ready(plan.configurations)
            check_judge(plan, bounds.judge_usd)
        for row in left_out:
            tell(f"c4s: without {row.agent}: {row.reason}")
        plan = open_run(run, plan)
        send_suite(suite)
        store.push_files(RunFolder(run).plan)
        ready, refused = settle_all(found.missing, plan, print_line)
        if not ready:
            refuse_pending(refused, len(scheduled))
        if ready or found.elsewhere or not page.is_file() or not is_current(warehouse):
            from reports.site import build_site
            from reports.status import REFRESH_S, write_status

            ingest_schedule(run, folder, plan, warehouse)
            progress, pool, status = Progress(run, folder), Pool(slots), RunFolder(run).status_page
            with (
                every(REFRESH_S, lambda: write_status(progress.read(), status, page), "the status page"),
                overseen(run, folder, plan, pool, bounds, found.elsewhere) as overseer,
            ):
                with drawn(progress):
                    refused += asyncio.run(_run(ready, plan, pool, held, overseer))
                    rebuild(warehouse)
                    build_site(warehouse, site_root(), suites_root())
                    store.push_files(site_root())
                refuse_pending(refused, len(scheduled))
        refuse_pending(refused, len(scheduled))
    ran, seconds = len(found.missing), time.perf_counter() - started
    return Evaluation(page.as_uri(), run.name, ran, dict(found.holders), seconds, left_out)


async def _run(ready: Sequence[Trial], plan: Plan, pool: Pool, held: Held, overseer: Overseer) -> list[Pending]:
    persist = partial(ingest_trial, warehouse=warehouse_root())
    async with pool:
        with ending_in_order(overseer):
            return await run_trials(ready, plan, pool, stage_functions(persist), held, overseer)
