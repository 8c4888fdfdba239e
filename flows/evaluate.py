"""The evaluate flow: what the plan asks for and the run folder does not hold yet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Literal

from prefect import flow
from pydantic import Field

from c4s.engine import DEFAULT_ENGINE, engine_kinds
from c4s.home import runs_root, site_root, warehouse_root
from c4s.judge.names import DEFAULT_JUDGE
from c4s.names import place_in
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.bounds import MOST_FAULTS, MOST_REPEATS, MOST_SLOTS, MOST_TOKENS, amount, count, moment
from c4s.run.choices import check_judge, check_ready, default_agents
from c4s.run.configurations import configuration
from c4s.run.drive import Pending, refuse_pending, run_trials, settle_all
from c4s.run.guards import MOST_IN_A_ROW
from c4s.run.headroom import print_line
from c4s.run.lease import Held, holding
from c4s.run.overseer import Overseer
from c4s.run.oversight import RunBounds, every, overseen
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.progress import Progress
from c4s.run.signals import ending_in_order
from c4s.run.store import open_store, send_suite, share_suite
from flows.artifacts import shown
from flows.coordinate import Coordinator
from flows.family import die_with_the_worker
from flows.server import tie
from flows.trial import as_tasks
from reports.site import check_place
from reports.status import REFRESH_S, write_status
from tasks.publish import publish
from warehouse.done import look_up
from warehouse.ingest import ingest_schedule

tie()
if TYPE_CHECKING:
    Engine = str
else:
    Engine = Literal[*engine_kinds()]


@flow(name="evaluate", flow_run_name="{suite} on {workers}", validate_parameters=False)
async def evaluate(
    suite: str = "starter",
    agents: Sequence[str] = (),
    run_id: str | None = None,
    cases: Sequence[str] = (),
    repeats: Annotated[int, Field(ge=1, le=MOST_REPEATS)] = 1,
    policy: str = DEFAULT_POLICY,
    judge: str = DEFAULT_JUDGE,
    engine: Engine = DEFAULT_ENGINE,
    workers: Literal["here", "pools"] = "here",
    slots: Annotated[int | None, Field(ge=1, le=MOST_SLOTS)] = None,
    deadline: str | None = None,
    spend: Annotated[float | None, Field(ge=0)] = None,
    judge_spend: Annotated[float | None, Field(ge=0)] = None,
    judge_tokens: Annotated[int | None, Field(ge=0, le=MOST_TOKENS)] = None,
    accept_faults: bool = False,
    most_faults: Annotated[int, Field(ge=1, le=MOST_FAULTS)] = MOST_IN_A_ROW,
    notify: str | None = None,
) -> str:
    """Run, verify, store and publish a suite. Returns the address of the leaderboard page.

    Run it again with the same parameters to complete a run that was stopped; what is done is reused. Where somebody
    else works on the run, it fails and says who.

    Args:
        suite: id of a built suite.
        agents: configuration names, or files on the machine that runs this flow (default: the baselines that can work
            on the suite).
        run_id: folder name of the run (default: the suite's id).
        cases: only these cases (default: all).
        repeats: repeats of each case.
        policy: id of a score policy that ships.
        judge: who judges: a name, or the YAML file of a judge on the machine that runs this flow.
        engine: which engine. Results of different engines are never ranked together.
        workers: here, in this flow's own process; or pools, on the workers of the work pools.
        slots: engine processes at once, where it runs here (default: one a core).
        deadline: no attempt starts after it: 8h, 1h30m, 07:30, 2026-11-24T07:30.
        spend: US dollars that the whole run may spend on models.
        judge_spend: US dollars that the whole run may spend on its judge.
        judge_tokens: tokens that the whole run's judge may use.
        accept_faults: a claim that the judge's endpoint fails on for good is an error, worth 0.
        most_faults: stop when so many trials in a row fail for one cause.
        notify: address or command that is told when a guard stops the run, and how it ends.
    """
    die_with_the_worker()
    bounds = RunBounds(
        deadline=None if deadline is None else moment(deadline, "deadline"),
        spend_usd=None if spend is None else amount(spend, "spend"),
        judge_usd=None if judge_spend is None else amount(judge_spend, "judge_spend"),
        judge_tokens=None if judge_tokens is None else count(judge_tokens, MOST_TOKENS, "judge_tokens", least=0),
        accept_faults=accept_faults,
        most_faults=count(most_faults, MOST_FAULTS, "most_faults"),
        notify=notify,
    )
    count(repeats, MOST_REPEATS, "repeats")
    if slots is not None:
        count(slots, MOST_SLOTS, "slots")
    bounds.check()
    folder, run = share_suite(suite), place_in(runs_root(), run_id or suite, "run")
    names, left_out = (agents, []) if agents else default_agents(SuiteFolder(folder), cases)
    for row in left_out:
        print_line(f"without {row.agent}: {row.reason}")
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
    warehouse, store = warehouse_root(), open_store()
    check_place(site_root())
    with holding(run) as held:
        store.pull_files(warehouse)
        scheduled = list(trials(run, folder, plan))
        found = look_up(scheduled, plan, warehouse)
        if found.missing:
            check_ready(plan.configurations)
            check_judge(plan, bounds.judge_usd)
        store.pull_files(RunFolder(run).plan)
        plan = open_run(run, plan)
        send_suite(suite)
        store.push_files(RunFolder(run).plan)
        ready, refused = settle_all(found.missing, plan, print_line)
        if not ready:
            refuse_pending(refused, len(scheduled))
        ingest_schedule(run, folder, plan, warehouse)
        page, pool = site_root() / "index.html", Pool(1 if workers == "pools" else slots)
        progress = Progress(run, folder)
        with (
            every(
                REFRESH_S, lambda: write_status(progress.read(), RunFolder(run).status_page, page), "the status page"
            ),
            overseen(run, folder, plan, pool, bounds, found.elsewhere) as overseer,
        ):
            async with shown(progress, run, page):
                with ending_in_order(overseer):
                    refused += await (
                        Coordinator(plan, held, overseer, print_line).run(ready)
                        if workers == "pools"
                        else _here(ready, plan, pool, held, overseer)
                    )
                store.pull_files(warehouse)
                publish(warehouse, site_root())
                store.push_files(site_root())
            refuse_pending(refused, len(scheduled))
    return page.as_uri()


async def _here(ready: Sequence[Trial], plan: Plan, pool: Pool, held: Held, overseer: Overseer) -> list[Pending]:
    async with pool:
        return await run_trials(ready, plan, pool, as_tasks(warehouse_root()), held, overseer)
