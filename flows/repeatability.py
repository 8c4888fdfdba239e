"""The repeatability flow: stored evidence judged several times over, and how far the scores agree."""

from __future__ import annotations

import asyncio
import statistics
from collections.abc import Sequence
from itertools import combinations
from typing import Any

from prefect import flow
from prefect.artifacts import acreate_table_artifact

from c4s.errors import BadInput
from c4s.records.plan import Plan
from c4s.run.plan import Trial
from c4s.run.plan import trials as scheduled
from c4s.run.pool import Pool
from c4s.run.rejudging import judged_anew
from c4s.run.stages import retained
from c4s.run.store import open_store, share_suite, shared_plan
from c4s.verify.registry import is_judged
from flows.family import die_with_the_worker
from flows.server import tie

tie()
MOST_REPEATS = 20


@flow(name="repeatability", flow_run_name="{run_id}")
async def repeatability(
    run_id: str, repeats: int = 5, agents: Sequence[str] = (), slots: int | None = None
) -> list[dict[str, Any]]:
    """Judge the stored evidence of a run's judged trials several times over. Nothing on record changes.

    Returns a row a configuration: its trials, the mean score of each repeat, and their standard deviation. The table
    artifact says too on which share of pairs of configurations each two repeats agree who is better.

    Args:
        run_id: folder name of the run.
        repeats: how often, 2 to 20.
        agents: only these configurations (default: all).
        slots: processes at once (default: one a core).
    """
    die_with_the_worker()
    if not 2 <= repeats <= MOST_REPEATS:
        raise BadInput(f"{repeats} repeats", todo=f"give 2 to {MOST_REPEATS}")
    run, plan = shared_plan(run_id)
    suite, store = share_suite(plan.suite_id), open_store()
    chosen = [trial for trial in scheduled(run, suite, plan) if not agents or trial.configuration.name in agents]
    if store.apart:
        for trial in chosen:
            store.pull(trial.folder.root)
    judged = [trial for trial in chosen if is_judged(trial.case.setting) and retained(trial) is not None]
    if not judged:
        raise BadInput("no trial of this run has a judged submission", where=run_id, todo="choose another run")
    scores: dict[str, list[list[float]]] = {}
    async with Pool(slots, processors=slots) as pool:
        for _ in range(repeats):
            made: dict[str, list[float]] = {}
            found: list[float] = await asyncio.gather(*(_score(pool, trial, plan) for trial in judged))
            for trial, score in zip(judged, found, strict=True):
                made.setdefault(trial.configuration.name, []).append(score)
            for name, values in made.items():
                scores.setdefault(name, []).append(values)
    means = {name: [statistics.fmean(values) for values in each] for name, each in scores.items()}
    rows = [
        {"configuration": name, "trials": len(scores[name][0]), "means": each, "sd": statistics.stdev(each)}
        for name, each in means.items()
    ]
    await acreate_table_artifact(
        [{**row, "means": " ".join(f"{value:.4f}" for value in means[str(row["configuration"])])} for row in rows],
        key="repeatability",
        description=f"{repeats} repeats of run {run_id}; repeats agree on {_agreement(means, repeats):.1%} of pairs",
    )
    return rows


async def _score(pool: Pool, trial: Trial, plan: Plan) -> float:
    limit = pool.limit("judge", trial, plan)
    async with pool.slots[limit.kind].slot(0):
        return (await pool.run(limit, judged_anew, trial, plan))[0]


def _agreement(means: dict[str, list[float]], repeats: int) -> float:
    """The share of (pair of repeats, pair of configurations) in which both repeats say the same of who is better."""
    pairs = [
        ((means[one][a] > means[two][a]) - (means[one][a] < means[two][a]))
        == ((means[one][b] > means[two][b]) - (means[one][b] < means[two][b]))
        for one, two in combinations(means, 2)
        for a, b in combinations(range(repeats), 2)
    ]
    return sum(pairs) / len(pairs) if pairs else 1.0
