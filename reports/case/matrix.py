"""Every requirement or repair target of a case against every run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED
from reports.case.asked import CaseRows
from reports.case.runs import CaseRun

SIGNS: Final = {"MATCH": "✓", "TP": "✓", "MISMATCH": "✗", "FN": "✗", "UNKNOWN": "?", "NOT_EVALUATED": "–", "ERROR": "!"}


@dataclass(frozen=True)
class MatrixRow:
    """One requirement or target."""

    text: str
    note: str
    cells: Sequence[tuple[CaseRun, str]]
    """What it is in each run: an outcome, or nothing."""


@dataclass(frozen=True)
class Matrix:
    """All of them, in the case's order."""

    runs: Sequence[CaseRun]
    rows: Sequence[MatrixRow]
    signs = SIGNS


def matrix_of(asked: CaseRows, runs: Sequence[CaseRun]) -> Matrix:
    """Of the runs that were measured."""
    found: dict[str, tuple[str, str]] = {}
    outcomes: dict[tuple[str, str], str] = {}
    for run in runs:
        trial_id = run.trial["trial_id"]
        for name, text, note, outcome in _decisions(asked.documents.get(trial_id, {})):
            found.setdefault(name, (text, note))
            outcomes[name, trial_id] = outcome
    shown = [run for run in runs if any((name, run.trial["trial_id"]) in outcomes for name in found)]
    return Matrix(
        shown,
        [
            MatrixRow(text, note, [(run, outcomes.get((name, run.trial["trial_id"]), "")) for run in shown])
            for name, (text, note) in found.items()
        ],
    )


def _decisions(documents: dict[str, Any]) -> list[tuple[str, str, str, str]]:
    """Name, text, note and outcome of each requirement and each target."""
    detailed = documents.get(DETAILED.name, {}).get("measurements", {}).get("decisions", [])
    targets = documents.get(REPAIR.name, {}).get("measurements", {}).get("targets", [])
    return [
        *(
            (
                row["node_id"],
                str(row.get("text", row["node_id"])),
                str(row.get("predicate_type", "")).replace("_", " "),
                row["status"],
            )
            for row in detailed
        ),
        *((row.get("identity") or row["actor"], row["actor"], _target(row), row["outcome"]) for row in targets),
    ]


def _target(row: dict[str, Any]) -> str:
    return f"{row['operation']}: {', '.join(row.get('fields', []))}"
