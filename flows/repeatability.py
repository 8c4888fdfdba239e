"""The repeatability flow: stored evidence judged several times over, and how far the scores agree."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from typing import Any

from prefect import flow
from prefect.artifacts import acreate_table_artifact

from c4s.files import write_text
from c4s.run.lease import holding
from c4s.run.plan import trials as scheduled
from c4s.run.pool import Pool
from c4s.run.repeatability import repeatability as found_in
from c4s.run.repeating import JudgedScene, Study, repeat_scene, study_of
from c4s.run.store import open_store, share_suite, shared_plan
from flows.family import die_with_the_worker
from flows.server import tie
from reports.deviations import deviations_svg

tie()


@flow(name="repeatability", flow_run_name="{run_id}")
async def repeatability(
    run_id: str, repeats: int = 3, agents: Sequence[str] = (), cases: Sequence[str] = (), slots: int | None = None
) -> dict[str, Any]:
    """Ask a run's model judge the stored requests of Detailed Alignment several times over, beside the run's record.

    Returns the findings (``docs/schemas/repeatability.schema.json``) without the scenes. What is there already is not
    asked again.

    Args:
        run_id: folder name of the run.
        repeats: how often, 2 to 20.
        agents: only these configurations (default: all).
        cases: only these cases (default: all).
        slots: processes at once (default: one a core).
    """
    die_with_the_worker()
    run, plan = shared_plan(run_id)
    suite, store = share_suite(plan.suite_id), open_store()
    with holding(run):
        if store.apart:
            for trial in scheduled(run, suite, plan):
                store.pull(trial.folder.root)
        study = study_of(run, suite, plan, repeats, agents, cases)
        store.pull_files(study.folder.root)
        async with Pool(slots, processors=slots) as pool:
            await asyncio.gather(*(_repeat(pool, study, scene, number) for scene, number in study.left()))
        found = found_in(study)
        found.write(study.folder.record)
        write_text(study.folder.picture, deviations_svg(found))
        store.push_files(study.folder.root)
    taus = ", ".join("none" if row.tau_b is None else f"{row.tau_b:.3f}" for row in found.agreements)
    await acreate_table_artifact(
        [
            {
                "rank": row.rank,
                "configuration": row.configuration,
                "means": " ".join(f"{mean:.4f}" for mean in row.means),
                "sd": f"{row.sd:.4f}",
            }
            for row in found.configurations
        ],
        key="repeatability",
        description=f"{repeats} repeats of run {run_id}: tau-b {taus}; {found.fallbacks} fallbacks; {found.cohort}",
    )
    return found.summary()


async def _repeat(pool: Pool, study: Study, scene: JudgedScene, number: int) -> None:
    limit = pool.limit("judge", scene.trial, study.plan)
    async with pool.slots[limit.kind].slot(0):
        await pool.run(limit, repeat_scene, scene, study.plan, study.folder, number)
