"""What is done: a trial whose score lies sound in a run folder, with its rows in the warehouse."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from c4s.files import digest_file
from c4s.records.folder import RunFolder, is_result
from c4s.records.plan import Plan
from c4s.records.verdict import Verdict
from c4s.run.plan import Trial, trial_id
from c4s.run.store import open_store
from c4s.run.torn import is_scored
from c4s.verify.faults import holds_accepted_faults
from warehouse.ingest import TRIAL_TABLES
from warehouse.parquet import is_whole, part_path


@dataclass(frozen=True)
class Done:
    """What of a schedule is done: trials by the run that holds them."""

    missing: list[Trial]
    holders: Counter[str]
    elsewhere: Counter[str]
    """Trials that another run holds, by configuration."""


def look_up(scheduled: Iterable[Trial], plan: Plan, warehouse: Path) -> Done:
    """Look up all trials of a plan."""
    found = Done([], Counter(), Counter())
    for trial in scheduled:
        holder = held_by(trial, plan, warehouse)
        if holder is None:
            found.missing.append(trial)
            continue
        found.holders[holder] += 1
        if holder != trial.run.name:
            found.elsewhere[trial.configuration.name] += 1
    return found


def held_by(trial: Trial, plan: Plan, warehouse: Path) -> str | None:
    """Id of the run that holds the trial, mostly its own; None where it is not done.

    A trial is its content, so another run of the same folder may hold it. The run folder is the truth: a row whose
    score is not there as it was written, or without the rows of another table, counts for nothing. A fault that the
    other run accepted is no score of this one.
    """
    key = trial_id(plan, trial)

    def part(table: str) -> Path:
        return part_path(warehouse, table, plan.suite_id, trial.configuration.name, key)

    if not all(is_whole(part(table)) for table in reversed(TRIAL_TABLES)):
        return None
    try:
        (row,) = pq.ParquetFile(part("outcomes")).read(["run_id", "score_sha256"], use_threads=False).to_pylist()
    except (pa.ArrowException, OSError, ValueError):
        return None
    folder = RunFolder(trial.run.parent / str(row.get("run_id"))).trial(
        trial.configuration.name, trial.case.alias, trial.repeat
    )
    open_store().pull(folder.root, is_result)
    if not is_scored(folder) or digest_file(folder.score) != row.get("score_sha256"):
        return None
    if folder.root != trial.folder.root and any(
        holds_accepted_faults(Verdict.read(verdict)) for verdict in folder.verdicts.values()
    ):
        return None
    return str(row["run_id"])
