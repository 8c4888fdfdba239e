"""The leaderboard of a million trials, against pandas over the same rows in Parquet.

    python -m bench leaderboard
    python -m bench.leaderboard [--trials 1000000]

Ours is ``c4s sql leaderboard`` from opening the database to the last row: every column of it. The rival reads the two
tables it needs as one Parquet file each, its best case, only the columns it needs, and computes the same columns and
ranks. Means of settings are kept in our database since the rows were taken in, so a second row tells what the same
question takes where nothing is kept: the SQL of the leaderboard over those two files. The last night of the trials lies
there as runs write it, a part a trial: also what it takes to take those in. All of it is processor time of all threads:
what else is at work on the machine does not count.
"""

from __future__ import annotations

import argparse
import math
import random
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from bench.row import Row
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTINGS, is_construction
from warehouse.database import arrow, catch_up, rebuild
from warehouse.database import rows as answer
from warehouse.parquet import arrow_schema
from warehouse.records import HEADLINES
from warehouse.refresh import THREADS
from warehouse.tables import FOUNDATIONS, view_statements

TRIALS, NIGHT, CASES, CONFIGURATIONS = 1_000_000, 1_330, 190, 14
GOAL_RATIO = 10.0
REPEATED = 3
PARTS = ["detailed", "overview", "physics", "repair_f1"]
_DETAILED, _OVERVIEW, _PHYSICS, _REPAIR = PARTS
"""What the leaderboard tells beside scores."""


def _made(number: int, rng: random.Random) -> tuple[dict[str, Any], dict[str, Any]]:
    """The rows of a trial in the tables ``schedule`` and ``outcomes``."""
    cell, repeat = number % (CASES * CONFIGURATIONS), number // (CASES * CONFIGURATIONS) + 1
    case, configuration = cell % CASES, f"agent-{cell // CASES}"
    key = {
        "trial_id": f"{number:016x}",
        "run_id": "made",
        "suite_digest": "d" * 64,
        "configuration_digest": configuration,
        "case_id": f"case-{case}",
        "repeat": repeat,
        "setting": SETTINGS[case % len(SETTINGS)],
        "scene_id": "made",
        "policy": "p",
        "judge": "rule",
        "judge_version": "",
        "engine": "headless",
        "ranked": True,
    }
    plan = dict.fromkeys(("client", "title", "operations"), "") | {"prompt": "A yard. " * 40, "proxy_assets": False}
    plan["visibility"] = "public"
    score = {name: rng.random() for name in ("score", *HEADLINES)}
    scored = {
        "status": "measured",
        "reason": "",
        "reason_code": "",
        "attempts": 1,
        "score_sha256": "0" * 64,
        "attempt_wall_s": 60.0,
    }
    return {**key, **plan, "planned_at": "2026-01-01"}, {**key, **score, **scored}


def _table(table: str, rows: Sequence[dict[str, Any]]) -> pa.Table:
    schema = arrow_schema(table, partitions=False)
    return pa.table({name: [row.get(name) for row in rows] for name in schema.names}, schema=schema)


def _store(root: Path, numbers: range) -> None:
    """Write trials as runs do: a part a configuration of the schedule, a part a trial of the outcomes."""
    rng = random.Random(numbers.start)
    planned: dict[str, list[dict[str, Any]]] = {}
    for number in numbers:
        schedule, outcome = _made(number, rng)
        planned.setdefault(schedule["configuration_digest"], []).append(schedule)
        _write(root, "outcomes", schedule["configuration_digest"], _table("outcomes", [outcome]))
    for name, rows in planned.items():
        _write(root, "schedule", name, _table("schedule", rows))


def _store_many(root: Path, trials: int) -> int:
    """Write whole repeats of every case by every configuration, a part a configuration; how many trials they are.

    Repeats differ in their scores.
    """
    cells, chance = CASES * CONFIGURATIONS, np.random.default_rng(1)
    repeats = -(-trials // cells)
    first = [_made(number, random.Random(number)) for number in range(cells)]
    for agent in range(CONFIGURATIONS):
        own = first[agent * CASES : (agent + 1) * CASES]
        repeat = np.repeat(np.arange(repeats), CASES)
        number = repeat * cells + agent * CASES + np.tile(np.arange(CASES), repeats)
        told = {"trial_id": [f"{one:016x}" for one in number.tolist()], "repeat": repeat + 1}
        for place, table in enumerate(("schedule", "outcomes")):
            rows = pa.concat_tables([_table(table, [pair[place] for pair in own])] * repeats)
            scores = {name: chance.random(len(rows)) for name in ("score", *HEADLINES) if name in rows.column_names}
            for name, values in (told | scores).items():
                field = rows.schema.field(name)
                rows = rows.set_column(rows.column_names.index(name), field, pa.array(values, field.type))
            _write(root, table, f"agent-{agent}", rows)
    return repeats * cells


def _write(root: Path, table: str, configuration: str, rows: pa.Table) -> None:
    folder = root / table / "suite=made" / f"configuration={configuration}"
    folder.mkdir(parents=True, exist_ok=True)
    pq.write_table(rows, folder / f"{rows['trial_id'][0]}.parquet", compression="zstd")


def _seconds(work: Callable[[], Any]) -> tuple[float, Any]:
    """Processor time of all threads, the best of three."""
    best, made = float("inf"), None
    for _ in range(REPEATED):
        started = time.process_time()
        made = work()
        best = min(best, time.process_time() - started)
    return best, made


def _rival(schedule: Path, outcomes: Path) -> pd.DataFrame:
    """The leaderboard in pandas: the same coverage gate, means by setting, weights and ranks."""
    trials = pd.read_parquet(schedule, columns=["trial_id", "configuration_digest", "setting", "case_id"])
    scores = pd.read_parquet(outcomes, columns=["trial_id", "score", *PARTS])
    joined = trials.merge(scores, on="trial_id", how="left")
    joined[PARTS] = joined[PARTS].fillna(0.0)
    groups = joined.groupby(["configuration_digest", "setting"])
    cases, distinct = groups.size(), groups["case_id"].nunique()
    whole = (groups["score"].count() == cases) & distinct.eq(
        joined.groupby("setting")["case_id"].nunique(), level="setting"
    )
    means = groups[["score", *PARTS]].mean().where(whole)
    text = means.xs(next(setting for setting in SETTINGS if is_construction(setting)), level="setting")
    indoor, outdoor = means.xs(INDOOR_REPAIR, level="setting"), means.xs(OUTDOOR_REPAIR, level="setting")
    many, more = cases.xs(INDOOR_REPAIR, level="setting"), cases.xs(OUTDOOR_REPAIR, level="setting")
    repairs = (indoor.mul(many, axis=0) + outdoor.mul(more, axis=0)).div(many + more, axis=0)
    board = pd.DataFrame(
        {
            "model_score": 0.5 * text["score"] + 0.5 * repairs["score"],
            "text_to_scene": text["score"],
            "image_to_scene": repairs["score"],
            "indoor": indoor["score"],
            "outdoor": outdoor["score"],
            "detailed": text[_DETAILED],
            "overview": text[_OVERVIEW],
            "text_physics": text[_PHYSICS],
            "repair_f1": repairs[_REPAIR],
            "image_physics": repairs[_PHYSICS],
        }
    )
    board["rank"] = board["model_score"].rank(ascending=False, method="min")
    return board.sort_values("model_score", ascending=False)


def _from_files(schedule: Path, outcomes: Path) -> list[dict[str, Any]]:
    """The questions that the leaderboard is made of, over two Parquet files, with nothing kept."""
    with duckdb.connect(config={"threads": THREADS}) as connection:
        for table, path in (("schedule", schedule), ("outcomes", outcomes)):
            connection.execute(f"CREATE VIEW {table} AS SELECT * FROM read_parquet('{path}')")
        for name, statement in view_statements(schedule.parent):
            if name == "settings" or name in (*FOUNDATIONS[:4], "leaderboard"):
                connection.execute(f"CREATE VIEW {name} AS {statement}")
        found = connection.execute("SELECT * FROM leaderboard")
        names = [column[0] for column in found.description or []]
        return [dict(zip(names, row, strict=True)) for row in found.fetchall()]


def rows(trials: int = TRIALS) -> list[Row]:
    """The leaderboard, and what it takes to have it up to date."""
    with tempfile.TemporaryDirectory() as folder:
        root, whole = Path(folder) / "warehouse", Path(folder)
        stored = _store_many(root, trials)
        rebuild(root)
        _store(root, range(stored, stored + NIGHT))
        started = time.process_time()
        rebuild(root)
        night = time.process_time() - started
        schedule, outcomes = whole / "schedule.parquet", whole / "outcomes.parquet"
        for path in (schedule, outcomes):
            pq.write_table(arrow(root, f"SELECT * FROM {path.stem}"), path, compression="zstd")

        def asked() -> list[dict[str, Any]]:
            catch_up(root)
            return answer(root, "SELECT * FROM leaderboard")

        ours, found = _seconds(asked)
        unkept, again = _seconds(lambda: _from_files(schedule, outcomes))
        theirs, board = _seconds(lambda: _rival(schedule, outcomes))
        wanted = {str(name): row.to_dict() for name, row in board.iterrows()}
        for told in (found, again):
            assert len(told) == len(wanted)
            for row in told:
                assert all(
                    math.isclose(row[name], value) for name, value in wanted[row["configuration_digest"]].items()
                )
        count, rival = f"{stored + NIGHT:,} trials", "pandas, one Parquet file a table"
        goal = f"at least {GOAL_RATIO:g} times as fast"
        return [
            Row(f"leaderboard of {count}", ours, goal, theirs / ours >= GOAL_RATIO, "s", rival, theirs, theirs / ours),
            Row(f"leaderboard of {count}, nothing kept", unkept, "–", True, "s", rival, theirs, theirs / unkept),
            Row(f"taking in a night of {NIGHT:,} parts beside them", night, "–", True),
        ]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="python -m bench.leaderboard", description=__doc__)
    parser.add_argument("--trials", type=int, default=TRIALS)
    for row in rows(parser.parse_args().trials):
        print(row, file=sys.stdout)
