"""Detailed Alignment from decided requirement rows: predicates to clauses to families to a score (scorer fact 5)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from c4s.score.numbers import unit_number
from c4s.score.policy import DETAILED_DIGITS, FAMILY_WEIGHTS, UNUSABLE_STATUSES, Family


def row_score(row: Mapping[str, Any]) -> float:
    """Effective score of a row, 0 when it is no number in [0, 1].

    The unrounded value is used only where it rounds to the stored one. Older rows have ``effective_lower`` instead.
    """
    stored = unit_number(row.get("effective_score", row.get("effective_lower")))
    exact = unit_number(row.get("unrounded_effective_score"))
    if stored is None:
        return 0.0
    return exact if exact is not None and round(exact, DETAILED_DIGITS) == round(stored, DETAILED_DIGITS) else stored


def _weight(row: Mapping[str, Any]) -> float:
    value = row.get("predicate_weight", 1.0)
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) and value > 0 else 1.0


def weighted_mean(pairs: Iterable[tuple[float, float]]) -> float:
    """Mean of ``(weight, value)`` pairs."""
    items = list(pairs)
    return sum(weight * value for weight, value in items) / sum(weight for weight, _ in items)


def clauses_of(rows: Sequence[Mapping[str, Any]]) -> list[list[Mapping[str, Any]]]:
    """Rows by clause index; rows without a clause come last."""
    groups: dict[Any, list[Mapping[str, Any]]] = defaultdict(list)
    for row in rows:
        groups[row.get("clause_index")].append(row)
    return [groups[index] for index in sorted(groups, key=lambda i: (i is None, i if i is not None else 0))]


def _known(row: Mapping[str, Any]) -> float:
    return 1.0 if row.get("score_known", True) else 0.0


def _family(rows: list[Mapping[str, Any]]) -> dict[str, Any]:
    clauses = clauses_of(rows)
    weights = [max(_weight(row) for row in clause) for clause in clauses]
    score = weighted_mean((w, weighted_mean((_weight(row), row_score(row)) for row in clause))
                          for w, clause in zip(weights, clauses, strict=True))
    known = weighted_mean((w, weighted_mean((_weight(row), _known(row)) for row in clause))
                          for w, clause in zip(weights, clauses, strict=True))
    return {"score": round(score, DETAILED_DIGITS), "unrounded_score": score,
            "known_coverage": round(known, DETAILED_DIGITS), "clause_count": len(clauses),
            "active_requirement_count": len(rows)}


def detailed_score(rows: Sequence[Mapping[str, Any]],
                   family_weights: Mapping[Family, float] = FAMILY_WEIGHTS) -> dict[str, Any]:
    """Detailed Alignment of decided rows.

    Rows have ``semantic_family``, ``clause_index``, ``effective_score``, and optionally ``included`` (default true),
    ``predicate_weight`` (1), ``score_known`` (true). Family scores are rounded to four decimals before they are
    averaged with the family weights over the families that are present. Known coverage is the same mean over
    ``score_known``; it never enters the score.

    Returns:
        ``status`` (``measured``, or ``not_evaluated`` when no family is present), ``score``, ``unrounded_score``,
        ``known_coverage`` and ``families``.
    """
    groups: dict[str, list[Mapping[str, Any]]] = defaultdict(list)
    for row in rows:
        if row.get("included", True):
            groups[str(row.get("semantic_family"))].append(row)
    measured = {family: _family(groups[family]) for family in FAMILY_WEIGHTS if groups.get(family)}
    total = sum(family_weights[family] for family in FAMILY_WEIGHTS if family in measured)
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
    score = sum(families[f]["effective_weight"] * row["score"] for f, row in measured.items())
    known = sum(families[f]["effective_weight"] * row["known_coverage"] for f, row in measured.items())
    return {"status": "measured", "score": round(score, DETAILED_DIGITS), "unrounded_score": score,
            "known_coverage": round(known, DETAILED_DIGITS), "families": families}


def detailed_from_report(report: Any) -> dict[str, Any]:
    """Detailed score recomputed from a recorded report; ``{"status", "score": None}`` when it cannot be used."""
    if not isinstance(report, Mapping):
        return {"status": "missing", "score": None}
    status, metrics = report.get("status"), report.get("metrics")
    rows = metrics.get("semantic_requirement_aggregation") if isinstance(metrics, Mapping) else None
    if str(status or "").lower() in UNUSABLE_STATUSES or not isinstance(rows, list) or not rows:
        return {"status": str(status or "missing"), "score": None}
    return detailed_score([row for row in rows if isinstance(row, Mapping)])
