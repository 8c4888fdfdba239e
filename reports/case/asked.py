"""What the pages of a case ask of the warehouse: the rows of its trials, by trial."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from c4s.protocol.case import SEMANTIC
from reports.frame import SiteContext
from reports.frame.asked import of_cases
from reports.frame.board import Board, Row
from warehouse.database import rows


@dataclass(frozen=True)
class CaseRows:
    """Rows of a case by the id of their trial."""

    plan: Row
    """What was planned of the case: prompt, budgets, facts."""
    documents: dict[str, dict[str, Any]] = field(default_factory=partial(defaultdict, dict))
    """The verdicts as they were written, by verifier."""
    findings: dict[str, list[Row]] = field(default_factory=partial(defaultdict, list))
    claims: dict[str, list[Row]] = field(default_factory=partial(defaultdict, list))
    attempts: dict[str, list[Row]] = field(default_factory=partial(defaultdict, list))
    tools: dict[str, list[Row]] = field(default_factory=partial(defaultdict, list))
    semantic: dict[str, float] = field(default_factory=dict)
    retained: dict[str, int | None] = field(default_factory=dict)
    """The attempt whose submission counts."""


def case_rows(site: SiteContext, board: Board, case_id: str) -> CaseRows:
    """All of a case that is no picture and no call; asked together for the cases that stand beside it."""
    cases = site.beside(board, case_id)
    key = (board.suite, board.suite_digest, cases[0])
    return site.latest(key, partial(_ask, site.warehouse, board, cases))[case_id]


def _ask(warehouse: Path, board: Board, case_ids: Sequence[str]) -> dict[str, CaseRows]:
    of = of_cases(board, case_ids)
    plans = f"SELECT DISTINCT ON (case_id) * FROM schedule WHERE {of} ORDER BY case_id, trial_id"
    found = {row["case_id"]: CaseRows(row) for row in rows(warehouse, plans)}
    verdicts = f"SELECT case_id, trial_id, verifier, document FROM verdicts WHERE {of} ORDER BY verifier"
    for row in rows(warehouse, verdicts):
        found[row["case_id"]].documents[row["trial_id"]][row["verifier"]] = json.loads(row["document"])
    for row in rows(warehouse, f"SELECT * FROM findings WHERE {of} ORDER BY verifier, outcome, subject"):
        found[row["case_id"]].findings[row["trial_id"]].append(row)
    for row in rows(warehouse, f"SELECT * FROM claims WHERE {of}"):
        found[row["case_id"]].claims[row["trial_id"]].append(row)
    for row in rows(warehouse, f"SELECT * FROM attempts WHERE {of} ORDER BY attempt"):
        found[row["case_id"]].attempts[row["trial_id"]].append(row)
    for row in rows(warehouse, f"SELECT * FROM tool_use WHERE {of} ORDER BY attempt, calls DESC, tool"):
        found[row["case_id"]].tools[row["trial_id"]].append(row)
    semantic = (
        f"SELECT case_id, trial_id, value FROM components WHERE {of} AND verifier = '{SEMANTIC}' AND name = 'score'"
    )
    for row in rows(warehouse, semantic):
        found[row["case_id"]].semantic[row["trial_id"]] = row["value"]
    for row in rows(warehouse, f"SELECT case_id, trial_id, retained_attempt FROM outcomes WHERE {of}"):
        found[row["case_id"]].retained[row["trial_id"]] = row["retained_attempt"]
    return found
