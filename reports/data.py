"""What the pages show, asked of the warehouse. Pages read nothing else."""

from __future__ import annotations

import json
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from warehouse.database import rows

Row = dict[str, Any]
Field = tuple[str, str, str, str, str]
"""What results must share to be compared: suite, the digest of its build, policy, judge, engine."""


@dataclass(frozen=True)
class Board:
    """One leaderboard: results that share the build of a suite, policy, judge and engine."""

    suite: str
    suite_digest: str
    policy: str
    judge: str
    engine: str
    standings: list[Row]
    cases: list[Row]
    """One row a case: its fields and ``scores``, configuration to trial row."""
    zeros: list[Row]


def boards(warehouse: Path) -> list[Board]:
    """The leaderboards of the latest build of each suite."""
    standings: dict[Field, list[Row]] = defaultdict(list)
    for row in rows(warehouse, "SELECT * FROM leaderboard"):
        standings[_field(row)].append(row)
    trials: dict[Field, list[Row]] = defaultdict(list)
    for row in rows(warehouse, "SELECT * FROM case_scores WHERE latest ORDER BY setting, case_id, repeat"):
        trials[_field(row)].append(row)
    zeros = rows(warehouse, "SELECT * FROM zero_reasons")
    return [
        Board(
            *field,
            standings=found,
            cases=_by_case(trials[field]),
            zeros=[row for row in zeros if (row["suite"], row["build"]) == (field[0], field[1][: len(row["build"])])],
        )
        for field, found in standings.items()
    ]


def _field(row: Row) -> Field:
    return row["suite"], row["suite_digest"], row["policy"], row["judge"], row["engine"]


def _by_case(trials: list[Row]) -> list[Row]:
    cases: dict[str, Row] = {}
    for trial in trials:
        case = cases.setdefault(trial["case_id"], {**trial, "scores": defaultdict(list)})
        case["scores"][trial["configuration"]].append(trial)
    return list(cases.values())


def prompt(warehouse: Path, board: Board, case_id: str) -> str:
    """A case's prompt."""
    found = rows(warehouse, f"SELECT prompt FROM schedule WHERE {_of(board)} AND case_id = {_text(case_id)} LIMIT 1")
    return str(found[0]["prompt"])


def pictures(warehouse: Path, board: Board) -> list[Row]:
    """Every picture of a suite: those of a trial have its id, those of a case none."""
    return rows(
        warehouse,
        "SELECT trial_id, case_id, role, view, width, height, jpeg FROM pictures "
        f"WHERE {_of(board)} ORDER BY case_id, role, trial_id, view",
    )


def findings(warehouse: Path, board: Board) -> dict[str, list[Row]]:
    """Findings by trial."""
    found: dict[str, list[Row]] = defaultdict(list)
    for row in rows(warehouse, f"SELECT * FROM findings WHERE {_of(board)} ORDER BY verifier, outcome, subject"):
        found[row["trial_id"]].append(row)
    return found


def verdicts(warehouse: Path, board: Board) -> dict[str, list[Row]]:
    """Verdicts by trial, their documents parsed."""
    found: dict[str, list[Row]] = defaultdict(list)
    for row in rows(warehouse, f"SELECT * FROM verdicts WHERE {_of(board)} ORDER BY verifier"):
        found[row["trial_id"]].append({**row, "document": json.loads(row["document"])})
    return found


def _of(board: Board) -> str:
    """The condition of a row of the board's suite."""
    return f"suite = {_text(board.suite)} AND suite_digest = {_text(board.suite_digest)}"


def _text(value: str) -> str:
    return "'" + value.replace("'", "''") + "'"
