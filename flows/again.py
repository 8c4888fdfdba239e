"""The flows reverify and rejudge: stored evidence of a run once more, by the code of today, and what that changed.

No engine is started. What was made before stays beside the new files, under ``.outdated-<digest>``; the rows and pages
are written anew, and every trial whose score is another one is told.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from prefect import flow
from prefect.artifacts import acreate_table_artifact

from c4s.home import site_root, warehouse_root
from c4s.records.folder import RunFolder
from c4s.run.again import Again, ScoreChange, set_back, stored_score
from c4s.run.drive import refuse_pending, run_trials
from c4s.run.lease import holding
from c4s.run.plan import judged_now
from c4s.run.plan import trials as scheduled
from c4s.run.pool import Pool
from c4s.run.stages import retained
from c4s.run.store import open_store, share_suite, shared_plan
from c4s.run.trial_work import holding_trial
from flows.family import die_with_the_worker
from flows.server import tie
from flows.trial import as_tasks
from tasks.publish import publish
from warehouse.ingest import ingest_schedule

tie()


@flow(name="reverify", flow_run_name="{run_id}")
async def reverify(run_id: str, agents: Sequence[str] = (), slots: int | None = None) -> list[dict[str, Any]]:
    """Verify a run's stored evidence anew. Returns the trials whose score changed, before and after.

    Args:
        run_id: folder name of the run.
        agents: only these configurations (default: all).
        slots: processes at once (default: one a core).
    """
    return await _again(run_id, agents, "verdicts", slots)


@flow(name="rejudge", flow_run_name="{run_id}")
async def rejudge(run_id: str, agents: Sequence[str] = (), slots: int | None = None) -> list[dict[str, Any]]:
    """Judge and verify a run's stored evidence anew. Returns the trials whose score changed, before and after.

    Where the judge's code has changed since, the plan goes on with its version of today; rows of the earlier version
    stay, and are never ranked with the new ones.

    Args:
        run_id: folder name of the run.
        agents: only these configurations (default: all).
        slots: processes at once (default: one a core).
    """
    return await _again(run_id, agents, "judgements", slots)


async def _again(run_id: str, agents: Sequence[str], again: Again, slots: int | None) -> list[dict[str, Any]]:
    die_with_the_worker()
    run, plan = shared_plan(run_id)
    suite, store = share_suite(plan.suite_id), open_store()
    with holding(run) as held:
        if again == "judgements":
            plan = judged_now(run, plan)
            store.push_files(RunFolder(run).plan)
            ingest_schedule(run, suite, plan, warehouse_root())
        chosen = [trial for trial in scheduled(run, suite, plan) if not agents or trial.configuration.name in agents]
        if store.apart:
            for trial in chosen:
                store.pull(trial.folder.root)
        done = [trial for trial in chosen if trial.folder.score.is_file() or retained(trial) is not None]
        before = {trial.name: stored_score(trial) for trial in done}
        for trial in done:
            async with holding_trial(trial):
                set_back(trial, plan, again)
                store.push(trial.folder.root)
        async with Pool(slots, processors=slots) as pool:
            pending = await run_trials(done, plan, pool, as_tasks(warehouse_root()), held)
        publish(warehouse_root(), site_root())
    changes = [ScoreChange(trial.name, before[trial.name], stored_score(trial)) for trial in done]
    rows = [
        {"trial": change.trial, "before": change.before, "after": change.after} for change in changes if change.changed
    ]
    await acreate_table_artifact(
        rows or [{"trial": "none", "before": None, "after": None}],
        key=f"changed-{again}",
        description=f"{len(rows)} of {len(done)} trials of the run {run_id} have another score",
    )
    refuse_pending(pending, len(done))
    return rows
