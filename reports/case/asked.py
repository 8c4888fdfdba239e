"""What the pages of a case ask of the warehouse: the rows of its trials, by trial."""

from __future__ import annotations

import json
from collections import defaultdict
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from c4s.protocol.case import SEMANTIC
from reports.frame import SiteContext
from reports.frame.asked import of_case
from reports.frame.board import Board, Row
from warehouse.database import rows


@dataclass(frozen=True)
class CaseRows:
    """Rows of a case by the id of their trial."""

    plan: Row
    """What was planned of the case: prompt, budgets, facts."""
    documents: dict[str, dict[str, Any]]
    """The verdicts as they were written, by verifier."""
    findings: dict[str, list[Row]]
    claims: dict[str, list[Row]]
    attempts: dict[str, list[Row]]
    tools: dict[str, list[Row]]
    semantic: dict[str, float]
    retained: dict[str, int | None]
    """The attempt whose submission counts."""


def case_rows(site: SiteContext, board: Board, case_id: str) -> CaseRows:
    """All of a case that is no picture and no call; asked once for the pages of one case that are made in a row."""
    key = (board.suite, board.suite_digest, case_id)
    return site.latest(key, partial(_ask, site.warehouse, board, case_id))


def _ask(warehouse: Path, board: Board, case_id: str) -> CaseRows:
    of = of_case(board, case_id)
    plan = rows(warehouse, f"SELECT * FROM schedule WHERE {of} LIMIT 1")[0]
    documents: dict[str, dict[str, Any]] = defaultdict(dict)
    for row in rows(warehouse, f"SELECT trial_id, verifier, document FROM verdicts WHERE {of} ORDER BY verifier"):
        documents[row["trial_id"]][row["verifier"]] = json.loads(row["document"])
    semantic = f"SELECT trial_id, value FROM components WHERE {of} AND verifier = '{SEMANTIC}' AND name = 'score'"
    retained = f"SELECT trial_id, retained_attempt FROM outcomes WHERE {of}"
    return CaseRows(
        plan,
        documents,
        _by_trial(warehouse, f"SELECT * FROM findings WHERE {of} ORDER BY verifier, outcome, subject"),
        _by_trial(warehouse, f"SELECT * FROM claims WHERE {of}"),
        _by_trial(warehouse, f"SELECT * FROM attempts WHERE {of} ORDER BY attempt"),
        _by_trial(warehouse, f"SELECT * FROM tool_use WHERE {of} ORDER BY attempt, calls DESC, tool"),
        {row["trial_id"]: row["value"] for row in rows(warehouse, semantic)},
        {row["trial_id"]: row["retained_attempt"] for row in rows(warehouse, retained)},
    )


def _by_trial(warehouse: Path, sql: str) -> dict[str, list[Row]]:
    found: dict[str, list[Row]] = defaultdict(list)
    for row in rows(warehouse, sql):
        found[row["trial_id"]].append(row)
    return found
