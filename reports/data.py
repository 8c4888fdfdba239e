"""What the pages show, asked of the warehouse. Pages read nothing else."""

from __future__ import annotations

import json
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from warehouse.database import rows

Row = dict[str, Any]
Field = tuple[str, str, str, str]
"""What results must share to be compared: suite, policy, judge, engine."""


@dataclass(frozen=True)
class Board:
    """One leaderboard: results that share suite, policy, judge and engine."""

    suite: str
    policy: str
    judge: str
    engine: str
    standings: list[Row]
    cases: list[Row]
    """One row a case: its fields and ``scores``, configuration to trial row."""
    zeros: list[Row]


def boards(warehouse: Path) -> list[Board]:
    """All leaderboards of the warehouse."""
    standings: dict[Field, list[Row]] = defaultdict(list)
    for row in rows(warehouse, "SELECT * FROM leaderboard"):
        standings[_field(row)].append(row)
    trials: dict[Field, list[Row]] = defaultdict(list)
    for row in rows(warehouse, "SELECT * FROM case_scores ORDER BY setting, case_id, repeat"):
        trials[_field(row)].append(row)
    zeros = rows(warehouse, "SELECT * FROM zero_reasons")
    return [
        Board(
            *field,
            standings=found,
            cases=_by_case(trials[field]),
            zeros=[row for row in zeros if row["suite"] == field[0]],
        )
        for field, found in standings.items()
    ]


def _field(row: Row) -> Field:
    return row["suite"], row["policy"], row["judge"], row["engine"]


def _by_case(trials: list[Row]) -> list[Row]:
    cases: dict[str, Row] = {}
    for trial in trials:
        case = cases.setdefault(trial["case_id"], {**trial, "scores": defaultdict(list)})
        case["scores"][trial["configuration"]].append(trial)
    return list(cases.values())


def prompt(warehouse: Path, suite: str, case_id: str) -> str:
    """A case's prompt."""
    found = rows(
        warehouse, f"SELECT prompt FROM schedule WHERE suite = {_text(suite)} AND case_id = {_text(case_id)} LIMIT 1"
    )
    return str(found[0]["prompt"])


def pictures(warehouse: Path, suite: str) -> list[Row]:
    """Every picture of a suite."""
    return rows(
        warehouse,
        "SELECT case_id, configuration, repeat, role, view, width, height, jpeg FROM pictures "
        f"WHERE suite = {_text(suite)} ORDER BY case_id, role, configuration, repeat, view",
    )


def findings(warehouse: Path, suite: str) -> dict[tuple[str, str, int], list[Row]]:
    """Findings by (case, configuration, repeat)."""
    found: dict[tuple[str, str, int], list[Row]] = defaultdict(list)
    query = f"SELECT * FROM judged WHERE suite = {_text(suite)} ORDER BY verifier, outcome, subject"
    for row in rows(warehouse, query):
        found[(row["case_id"], row["configuration"], row["repeat"])].append(row)
    return found


def verdicts(warehouse: Path, suite: str) -> dict[tuple[str, str, int], list[Row]]:
    """Verdicts by (case, configuration, repeat), their documents parsed."""
    found: dict[tuple[str, str, int], list[Row]] = defaultdict(list)
    for row in rows(warehouse, f"SELECT * FROM verdicts WHERE suite = {_text(suite)} ORDER BY verifier"):
        found[(row["case_id"], row["configuration"], row["repeat"])].append(
            {**row, "document": json.loads(row["document"])}
        )
    return found


def _text(value: str) -> str:
    return "'" + value.replace("'", "''") + "'"
