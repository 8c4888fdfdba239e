"""Detailed Alignment from decided requirement rows: predicates to clauses to families to a score (scorer fact 5)."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.numbers import ordered_sum, record, records, unit_number, weighted_mean
from c4s.protocol.rules import DETAILED_DIGITS, FAMILY_WEIGHTS, UNUSABLE_STATUSES, Family


def _recorded(row: Mapping[str, Any], field: str) -> Any:
    """A score field of a row. Older rows record an interval: its lower end counts, and the later of two entries."""
    lower = f"{field}_lower_bound"
    older = {lower, "effective_lower"} if field == "effective_score" else {lower}
    if older.isdisjoint(row):
        return row.get(field)
    return [value for name, value in row.items() if name in older or (name == field and lower not in row)][-1]


def row_score(row: Mapping[str, Any]) -> float:
    """Effective score of a row, 0 when it is no number in [0, 1].

    The unrounded value is used only where its four decimals are the stored value.
    """
    stored = unit_number(_recorded(row, "effective_score")) or 0.0
    exact = unit_number(_recorded(row, "unrounded_effective_score"))
    return exact if exact is not None and round(exact, DETAILED_DIGITS) == stored else stored


def _weight(row: Mapping[str, Any]) -> float:
    value = row.get("predicate_weight", 1.0)
    try:
        weight = float(value)
    except (TypeError, ValueError, OverflowError):
        weight = math.nan
    if not math.isfinite(weight):
        raise BadInput(f"predicate_weight must be a number, not {value!r}")
    return weight


def clauses_of(rows: Sequence[Mapping[str, Any]]) -> list[list[Mapping[str, Any]]]:
    """Rows by clause index; rows without a clause come last."""
    groups: dict[Any, list[Mapping[str, Any]]] = defaultdict(list)
    try:
        for row in rows:
            groups[row.get("clause_index")].append(row)
        return [groups[index] for index in sorted(groups, key=lambda i: (i is None, i if i is not None else 0))]
    except TypeError:
        raise BadInput("the clause_index of each row must be a number or null") from None


def _known(row: Mapping[str, Any]) -> float:
    return 1.0 if row.get("score_known", True) else 0.0


def _family(rows: list[Mapping[str, Any]]) -> dict[str, Any]:
    clauses = clauses_of(rows)
    weights = [max(_weight(row) for row in clause) for clause in clauses]
    score = weighted_mean(
        (w, weighted_mean((_weight(row), row_score(row)) for row in clause))
        for w, clause in zip(weights, clauses, strict=True)
    )
    known = weighted_mean(
        (w, weighted_mean((_weight(row), _known(row)) for row in clause))
        for w, clause in zip(weights, clauses, strict=True)
    )
    return {
        "score": round(score, DETAILED_DIGITS),
        "unrounded_score": score,
        "known_coverage": round(known, DETAILED_DIGITS),
        "clause_count": len(clauses),
        "active_requirement_count": len(rows),
    }


def detailed_score(
    rows: Sequence[Mapping[str, Any]], family_weights: Mapping[Family, float] = FAMILY_WEIGHTS
) -> dict[str, Any]:
    """Detailed Alignment of decided rows.

    Rows have ``semantic_family``, ``clause_index``, ``effective_score``, and optionally ``included`` (default true),
    ``predicate_weight`` (1), ``score_known`` (true). Family scores are rounded to four decimals before they are
    averaged with the family weights over the families that are present. Known coverage is the same mean over
    ``score_known``; it never enters the score.

    Raises ``BadInput`` for rows that are no objects, weights that are no numbers or that sum to zero.

    Returns:
        ``status`` (``measured``, or ``not_evaluated`` when no family is present), ``score``, ``unrounded_score``,
        ``known_coverage`` and ``families``.
    """
    groups: dict[str, list[Mapping[str, Any]]] = defaultdict(list)
    for row in records(rows, "decisions"):
        if row.get("included", True):
            groups[str(row.get("semantic_family"))].append(row)
    measured = {family: _family(groups[family]) for family in FAMILY_WEIGHTS if groups.get(family)}
    total = ordered_sum(family_weights[family] for family in FAMILY_WEIGHTS if family in measured)
    families: dict[str, Any] = {}
    for family in FAMILY_WEIGHTS:
        weight = family_weights[family]
        families[family] = {"applicable": family in measured, "configured_weight": weight}
        if family in measured:
            families[family] |= measured[family] | {"effective_weight": weight / total}
        else:
            families[family] |= {"score": None, "clause_count": 0}
    if not measured:
        return {"status": "not_evaluated", "score": None, "families": families}
    score = known = 0.0
    for family, row in measured.items():
        score += families[family]["effective_weight"] * row["score"]
        known += families[family]["effective_weight"] * row["known_coverage"]
    return {
        "status": "measured",
        "score": round(score, DETAILED_DIGITS),
        "unrounded_score": score,
        "known_coverage": round(known, DETAILED_DIGITS),
        "families": families,
    }


def detailed_from_report(report: Any) -> dict[str, Any]:
    """Detailed score recomputed from a recorded report; ``{"status", "score": None}`` when it cannot be used."""
    report = record(report, "report")
    rows = record(report.get("metrics"), "metrics").get("semantic_requirement_aggregation")
    status = report.get("status")
    if not report or str(status or "").casefold() in UNUSABLE_STATUSES or not rows:
        return {"status": str(status or "missing"), "score": None}
    return detailed_score(rows)
