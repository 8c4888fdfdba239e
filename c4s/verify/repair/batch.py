"""Actor Repair F1 over many cases at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.repair import NOMINAL, Tolerances
from c4s.verify.repair.counts import repair
from c4s.verify.repair.verdict import counts_record


def repair_row(row: Any, profile: Tolerances = NOMINAL) -> dict[str, Any]:
    """``{"name", tp, fp, fn, precision, recall, f1}`` of a row with ``input``, ``ground_truth`` and ``candidate``
    snapshots, or ``{"name", "error"}`` with one line."""
    if not isinstance(row, Mapping):
        return {"name": None, "error": "a row must be a JSON object"}
    try:
        result = repair(row.get("input"), row.get("ground_truth"), row.get("candidate"), profile)
    except BadInput as error:
        return {"name": row.get("name"), "error": error.line()}
    return {"name": row.get("name"), **counts_record(result)}


def repair_batch(rows: Iterable[Any], profile: Tolerances = NOMINAL) -> Iterator[dict[str, Any]]:
    """One result row for each row, in order. A bad row is answered with its error and stops nothing."""
    return (repair_row(row, profile) for row in rows)
