"""What pages ask of the warehouse, each of one leaderboard or of one of its public cases."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

from reports.frame.board import PUBLIC, Board, Row
from warehouse.database import rows


def prompt(warehouse: Path, board: Board, case_id: str) -> str:
    """A case's prompt."""
    found = rows(warehouse, f"SELECT prompt FROM schedule WHERE {of_case(board, case_id)} LIMIT 1")
    return str(found[0]["prompt"])


def made_with(warehouse: Path, board: Board, configuration: str) -> list[Row]:
    """What a configuration's attempts were made with, each combination once: client, harness, model, engine."""
    return rows(
        warehouse,
        "SELECT DISTINCT client, client_version, harness, model, engine_version FROM attempts "
        f"WHERE configuration = {text(configuration)} AND {of_board(board)} ORDER BY ALL",
    )


def pictures(warehouse: Path, board: Board, case_ids: Sequence[str]) -> list[Row]:
    """Every picture of some cases: those of a trial have its id, those of a case itself none."""
    return rows(
        warehouse,
        "SELECT trial_id, case_id, role, view, width, height, brightness, jpeg FROM pictures "
        f"WHERE {of_cases(board, case_ids)} ORDER BY case_id, role, trial_id, view",
    )


def findings(warehouse: Path, board: Board, case_id: str) -> dict[str, list[Row]]:
    """Findings of a case by trial."""
    found: dict[str, list[Row]] = defaultdict(list)
    asked = f"SELECT * FROM findings WHERE {of_case(board, case_id)} ORDER BY verifier, outcome, subject"
    for row in rows(warehouse, asked):
        found[row["trial_id"]].append(row)
    return found


def verdicts(warehouse: Path, board: Board, case_id: str) -> dict[str, list[Row]]:
    """Verdicts of a case by trial, their documents parsed."""
    found: dict[str, list[Row]] = defaultdict(list)
    for row in rows(warehouse, f"SELECT * FROM verdicts WHERE {of_case(board, case_id)} ORDER BY verifier"):
        found[row["trial_id"]].append({**row, "document": json.loads(row["document"])})
    return found


def of_board(board: Board) -> str:
    """The condition of a row of the public cases of the board's suite."""
    suite = f"suite = {text(board.suite)} AND suite_digest = {text(board.suite_digest)}"
    return f"{suite} AND case_id IN (SELECT case_id FROM schedule WHERE {suite} AND {PUBLIC})"


def of_case(board: Board, case_id: str) -> str:
    """The condition of a row of a public case of the board's suite."""
    return of_cases(board, [case_id])


def of_cases(board: Board, case_ids: Sequence[str]) -> str:
    """The condition of a row of some of the public cases of the board's suite."""
    return f"case_id IN ({', '.join(map(text, case_ids))}) AND {of_board(board)}"


def text(value: str) -> str:
    """A text as SQL has it."""
    return "'" + value.replace("'", "''") + "'"
