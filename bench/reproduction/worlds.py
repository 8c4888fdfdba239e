"""Printed means as the trials of a warehouse: every case of a group has the group's mean.

Each suite holds the columns of one or two tables; a study over it gives those means back, and all that follows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import duckdb
import pyarrow as pa
import pyarrow.parquet as pq

from c4s.protocol.case import SEMANTIC
from c4s.protocol.rules import I2S_WEIGHTS, PHYSICS_RATE
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, TEXT_TO_SCENE, Setting
from warehouse.database import rebuild
from warehouse.parquet import arrow_schema

SIDES: Final[Mapping[str, Setting]] = {"t2s": TEXT_TO_SCENE, "indoor": INDOOR_REPAIR, "outdoor": OUTDOOR_REPAIR}
"""Settings by their names in the tables."""
REPAIR_SIDES: Final = ("indoor", "outdoor")
TIERS: Final = ("easy", "medium", "hard")
REASONS: Final = {
    "unresolved_dependencies": "unresolved_dependencies",
    "empty_scene": "minimum_actors",
    "no_submission": "no_submission",
    "missing_result": "missing_result",
}
"""Our reason codes by the paper's columns."""


@dataclass(frozen=True)
class PrintedGroup:
    """Cases of one configuration that all have the same numbers."""

    suite: str
    configuration: str
    side: str
    cases: int
    visibility: str = "public"
    difficulty: str | None = None
    values: Mapping[str, Any] = field(default_factory=dict)
    """Columns of outcomes; ``semantic`` is the component."""
    first: int = 1
    """Number of the first case, where a side of a set has several groups."""


def write_worlds(root: Path, reference: duckdb.DuckDBPyConnection) -> Path:
    """Write every suite as parts of a warehouse and build its database.

    Args:
        root: a new folder.
        reference: connection that has the printed tables by name.
    """
    for suite, groups in _by_suite(
        [*_mains(reference), *_domains(reference), *_tiers(reference), *_zeros(reference)]
    ).items():
        _write(root, suite, groups)
    rebuild(root)
    return root


def _mains(reference: duckdb.DuckDBPyConnection) -> Iterator[PrintedGroup]:
    """The main tables: a suite of each set, and one of both."""
    sizes = _sizes(reference)
    for name in ("public", "private"):
        for row in _rows(reference, f"FROM main_results_{name}"):
            for side, cases in sizes[name].items():
                t2s = side == "t2s"
                quality = {"semantic": row["semantic"]} if t2s else {"repair_f1": row["repair_f1"]}
                physics, score = (row["physical_t2s"], row["s_t2s"]) if t2s else (row["physical_i2s"], row["s_i2s"])
                values = {**quality, PHYSICS_RATE: physics, "score": score}
                for suite in (name, "both"):
                    yield PrintedGroup(suite, row["agent"], side, cases, name, values=values)


def _domains(reference: duckdb.DuckDBPyConnection) -> Iterator[PrintedGroup]:
    """Precision, recall and F1 by domain: a suite of each set, and one of both. The score is F1's part of it."""
    sizes = _sizes(reference)
    for row in _rows(reference, "FROM repair_prf_by_domain"):
        rates = {f"repair_{name}": row[name] / 100 for name in ("precision", "recall", "f1")}
        values = {**rates, PHYSICS_RATE: 0.0, "score": I2S_WEIGHTS["repair_f1"] * rates["repair_f1"]}
        for suite in (f"domains-{row['set']}", "domains"):
            yield PrintedGroup(
                suite, row["agent"], row["domain"], sizes[row["set"]][row["domain"]], row["set"], values=values
            )


def _tiers(reference: duckdb.DuckDBPyConnection) -> Iterator[PrintedGroup]:
    """Scores by difficulty over the full suite."""
    counts = {row["setting"].lower(): row for row in _rows(reference, "FROM difficulty_tier_counts")}
    for row in _rows(reference, "FROM difficulty"):
        for side in SIDES:
            first = 1
            for tier in TIERS:
                score = row[f"{'t2s' if side == 't2s' else 'i2s'}_{tier}"]
                cases = counts[side][tier]
                yield PrintedGroup("tiers", row["agent"], side, cases, "public", tier, {"score": score}, first)
                first += cases


def _zeros(reference: duckdb.DuckDBPyConnection) -> Iterator[PrintedGroup]:
    """The zeros by reason; the other cases of each configuration are measured."""
    sizes = _sizes(reference)["public"]
    found = {
        (row["agent"], row["track"].lower()): row
        for row in _rows(reference, "FROM invalid_breakdown WHERE agent <> 'Total'")
    }
    for (agent,) in reference.execute("SELECT agent FROM main_results_public").fetchall():
        for side, cases in sizes.items():
            first = 1
            for column, code in REASONS.items():
                zeros = found.get((agent, side), {}).get(column, 0)
                if zeros:
                    values = {"score": 0.0, "status": "zero_invalid_candidate", "reason_code": code}
                    yield PrintedGroup("zeros", agent, side, zeros, values=values, first=first)
                first += zeros
            yield PrintedGroup("zeros", agent, side, cases - first + 1, values={"score": 0.5}, first=first)


def _sizes(reference: duckdb.DuckDBPyConnection) -> dict[str, dict[str, int]]:
    return {row["set"]: {side: row[side] for side in SIDES} for row in _rows(reference, "FROM set_composition")}


def _rows(reference: duckdb.DuckDBPyConnection, sql: str) -> list[dict[str, Any]]:
    found = reference.execute(sql)
    names = [column[0] for column in found.description or ()]
    return [dict(zip(names, row, strict=True)) for row in found.fetchall()]


def _by_suite(groups: Iterable[PrintedGroup]) -> dict[str, list[PrintedGroup]]:
    found: dict[str, list[PrintedGroup]] = {}
    for group in groups:
        found.setdefault(group.suite, []).append(group)
    return found


def _write(root: Path, suite: str, groups: list[PrintedGroup]) -> None:
    rows: dict[str, list[dict[str, Any]]] = {"schedule": [], "outcomes": [], "components": []}
    for group in groups:
        for place in range(group.first, group.first + group.cases):
            for table, row in _trial(suite, group, place):
                rows[table].append(row)
    for table, found in rows.items():
        schema = arrow_schema(table)
        made = pa.table({name: [row.get(name) for row in found] for name in schema.names}, schema=schema)
        for configuration in dict.fromkeys(row["configuration"] for row in found):
            own = made.filter(pa.compute.equal(made["configuration"], configuration))
            folder = root / table / f"suite={suite}" / f"configuration={configuration}"
            folder.mkdir(parents=True)
            pq.write_table(own.drop_columns(["suite", "configuration"]), folder / "printed.parquet")


def _trial(suite: str, group: PrintedGroup, place: int) -> Iterator[tuple[str, dict[str, Any]]]:
    case = f"{group.side}-{group.visibility}-{place:02d}"
    shared = {
        "trial_id": f"{suite}/{group.configuration}/{case}",
        "run_id": "printed",
        "suite": suite,
        "suite_digest": "printed",
        "configuration": group.configuration,
        "configuration_digest": group.configuration,
        "case_id": case,
        "repeat": 1,
        "setting": SIDES[group.side],
        "scene_id": case,
        "policy": "printed",
        "judge": "printed",
        "judge_version": "",
        "engine": "printed",
        "ranked": True,
    }
    words = dict.fromkeys(("planned_at", "client", "title", "prompt", "operations"), "")
    facts = {"difficulty": group.difficulty, "visibility": group.visibility, "proxy_assets": False}
    yield "schedule", {**shared, **words, **facts}
    told = {"status": "measured", "reason": "", "reason_code": "", "attempts": 1, "score_sha256": ""}
    yield "outcomes", {**shared, **told, **group.values}
    if "semantic" in group.values:
        yield "components", {**shared, "verifier": SEMANTIC, "name": "score", "value": group.values["semantic"]}
