"""From verified requirements to decided rows: families, exclusions, conjunction caps and clauses (scorer fact 5)."""

from __future__ import annotations

import bisect
import math
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.protocol.detailed import clauses_of, detailed_score
from c4s.protocol.families import family_of, node_name, predicate_type, section
from c4s.protocol.numbers import record, records, unit_number, weighted_mean
from c4s.protocol.rules import (
    COMPOSITE_TYPES,
    CONJUNCTIVE_TYPES,
    DETAILED_DIGITS,
    FAMILY_WEIGHTS,
    SEMANTIC_CASE_POLICY,
    SEMANTIC_CASE_SCHEMA,
    SEMANTIC_FAMILY_POLICY,
    Family,
)

Row = dict[str, Any]
_CLAUSE = re.compile(r"[^.!?;]+[.!?;]*")
_DECIDED = frozenset({"MATCH", "MISMATCH"})
_STATUSES = _DECIDED | {"ERROR", "NOT_EVALUATED"}
_NOISE = 1e-12


def clause_spans(prompt: str) -> list[tuple[int, int]]:
    """Spans of the prompt's clauses: split behind runs of ``. ! ? ;``, blanks trimmed, empty ones dropped."""
    spans = []
    for match in _CLAUSE.finditer(prompt):
        text = match.group()
        start = match.start() + len(text) - len(text.lstrip())
        if text.strip():
            spans.append((start, start + len(text.strip())))
    return spans


def _span(requirement: Mapping[str, Any], length: int) -> tuple[int, int]:
    span = requirement.get("source_span")
    if isinstance(span, Mapping):
        span = [span.get("start"), span.get("end")]
    if (
        isinstance(span, (list, tuple))
        and len(span) == 2
        and all(isinstance(v, int) and not isinstance(v, bool) for v in span)
        and 0 <= span[0] < span[1]
    ):
        return span[0], span[1]
    return 0, max(1, length)


def _decision(requirement: Mapping[str, Any]) -> tuple[str, float, bool]:
    """Status, score and whether it is known. What was not decided is worth zero and stays in the denominator."""
    status = str(requirement.get("evaluation_status", requirement.get("verdict"))).strip().upper()
    status = status if status in _STATUSES else "NOT_EVALUATED"
    if status not in _DECIDED:
        return status, 0.0, False
    for value in (requirement.get("score"), section(requirement, "check").get("score")):
        score = unit_number(value)
        if score is not None:
            return status, score, True
    return status, 1.0 if status == "MATCH" else 0.0, True


def _identity(row: Row, requirement: Mapping[str, Any]) -> str:
    """What makes two requirements one and the same: place, words, type, and what they are bound to."""
    binding = section(requirement, "evaluation_binding")
    bound = [
        sorted((str(name), repr(value)) for name, value in section.items() if name != skipped)
        for section, skipped in (
            (section(binding, "parameters"), "predicate_type"),
            (section(binding, "entity_scopes"), None),
            (section(requirement, "entity_scopes"), None),
        )
    ]
    return repr((row["source_span"], " ".join(row["text"].casefold().split()), row["predicate_type"], bound))


class _Spans:
    """The distinct spans of rows, by start and, from one start, the longest first: outer before inner."""

    def __init__(self, rows: Sequence[Row]) -> None:
        self.spans = sorted({tuple(row["source_span"]) for row in rows}, key=lambda span: (span[0], -span[1]))
        self.number = {span: number for number, span in enumerate(self.spans)}
        rank = {place: number for number, place in enumerate(sorted({place for span in self.spans for place in span}))}
        self._ends = np.array([rank[end] for _, end in self.spans], dtype=np.int64)

    def inner(self, span: tuple[int, int]) -> NDArray[np.int64]:
        """Numbers of the spans strictly inside one of them."""
        number = self.number[span]
        after = bisect.bisect_left(self.spans, span[1], key=lambda other: other[0])
        return number + 1 + np.flatnonzero(self._ends[number + 1 : after] <= self._ends[number])

    def direct(self, span: tuple[int, int]) -> NDArray[np.int64]:
        """Numbers of the spans strictly inside one of them and inside no other such span."""
        inner = self.inner(span)
        reach = np.maximum.accumulate(np.concatenate([[-1], self._ends[inner]]))[:-1]
        return inner[self._ends[inner] > reach]


def _exclude(rows: list[Row], requirements: Sequence[Mapping[str, Any]]) -> None:
    first: set[str] = set()
    for row, requirement in zip(rows, requirements, strict=True):
        identity = _identity(row, requirement)
        if identity in first:
            row["exclusion_reason"] = "exact_duplicate"
        first.add(identity)
    spans = _Spans([row for row in rows if row["exclusion_reason"] is None])
    for row, requirement in zip(rows, requirements, strict=True):
        if row["exclusion_reason"] is not None:
            continue
        if row["predicate_type"] in COMPOSITE_TYPES and (
            requirement.get("semantic_replaced_by_children") or len(spans.inner(tuple(row["source_span"])))
        ):
            row["exclusion_reason"] = "composite_replaced_by_children"
        elif row["semantic_family"] is None:
            row["exclusion_reason"] = "unassigned_semantic_family"


def _cap(rows: list[Row]) -> None:
    """A conjunction is worth at most its direct span-children, recursively."""
    spans = _Spans(rows)
    groups: dict[tuple[int, int], list[Row]] = defaultdict(list)
    for row in rows:
        groups[tuple(row["source_span"])].append(row)
    least, known, refuted = (np.zeros(len(spans.spans)) for _ in range(3))
    for span in sorted(groups, key=lambda s: s[1] - s[0]):
        conjunctive = any(row["predicate_type"] in CONJUNCTIVE_TYPES for row in groups[span])
        inner = spans.direct(span) if conjunctive else ()
        for row in groups[span]:
            if row["predicate_type"] in CONJUNCTIVE_TYPES and len(inner):
                own = row["value"], row["score_known"]
                row["value"] = min(own[0], float(least[inner].min()))
                row["score_known"] = bool(
                    (own[1] and known[inner].all()) or (own[1] and own[0] == 0) or refuted[inner].any()
                )
                row["parent_constrained"] = row["score_known"] != own[1] or not math.isclose(
                    row["value"], own[0], abs_tol=_NOISE
                )
        number = spans.number[span]
        least[number] = min(row["value"] for row in groups[span])
        known[number] = all(row["score_known"] for row in groups[span])
        refuted[number] = any(row["score_known"] and row["value"] == 0 for row in groups[span])


def _clause(span: Sequence[int], starts: NDArray[np.int64], ends: NDArray[np.int64]) -> int:
    """The clause that holds most of a span, the first of equals; the first of all where none holds any."""
    start, end = (min(place, int(ends[-1])) for place in span)
    first, after = int(np.searchsorted(ends, start, side="right")), int(np.searchsorted(starts, end))
    if first >= after:
        return 0
    return first + int(np.argmax(np.minimum(ends[first:after], end) - np.maximum(starts[first:after], start)))


def decided_rows(prompt: str, requirements: Sequence[Mapping[str, Any]]) -> list[Row]:
    """The rows of ``detailed_score`` for verified requirements, excluded ones included with their reason."""
    rows: list[Row] = []
    for number, requirement in enumerate(requirements):
        status, score, known = _decision(requirement)
        rows.append(
            {
                "node_id": node_name(requirement, number),
                "text": str(requirement.get("text") or ""),
                "source_span": list(_span(requirement, len(prompt))),
                "predicate_type": predicate_type(requirement),
                "semantic_family": family_of(requirement),
                "predicate_weight": 1.0,
                "evaluation_status": status,
                "value": score,
                "score_known": known,
                "included": True,
                "exclusion_reason": None,
                "clause_index": None,
                "parent_constrained": False,
            }
        )
    _exclude(rows, requirements)
    active = [row for row in rows if row["exclusion_reason"] is None]
    _cap(active)
    starts, ends = np.array(clause_spans(prompt) or [(0, len(prompt))], dtype=np.int64).T
    for row in rows:
        row["included"] = row["exclusion_reason"] is None
        if row["included"]:
            row["clause_index"] = _clause(row["source_span"], starts, ends)
        row["effective_score"] = round(row["value"], DETAILED_DIGITS)
    return rows


def _clause_report(rows: Sequence[Mapping[str, Any]], texts: list[str], family: str) -> Row:
    index = rows[0]["clause_index"]
    return {
        "index": index,
        "text": texts[index],
        "semantic_family": family,
        "clause_weight": 1.0,
        "score": weighted_mean((1.0, row["value"]) for row in rows),
        "known_coverage": weighted_mean((1.0, float(row["score_known"])) for row in rows),
        "active_requirement_count": len(rows),
    }


def _rounded(record: Row) -> Row:
    return record | {
        key: round(record[key], DETAILED_DIGITS) for key in ("score", "known_coverage") if record[key] is not None
    }


def _checked_weights(given: Mapping[str, Any]) -> dict[Family, float]:
    unknown = sorted(set(given) - set(FAMILY_WEIGHTS))
    if unknown:
        raise BadInput(f"unknown semantic family weights: {', '.join(unknown)}")
    weights: dict[Family, float] = {}
    for family in FAMILY_WEIGHTS:
        value = given.get(family, 1.0)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 < value < math.inf:
            raise BadInput(f"the weight of {family} must be a positive number, not {value!r}")
        weights[family] = float(value)
    return weights


def semantic_case(
    prompt: str, requirements: Sequence[Mapping[str, Any]], family_weights: Mapping[str, float] | None = None
) -> Row:
    """The verifier's own case report: rows, clauses and families, with equal family weights unless given.

    Family values are not rounded before they are averaged, so it can differ by 0.0001 from ``detailed_score``.
    Raises ``BadInput`` for unknown families, for weights that are not positive numbers, and when requirements exist
    but none counts.
    """
    weights = _checked_weights(record(family_weights, "family_weights"))
    requirements = records(requirements, "requirements")
    rows = decided_rows(prompt, requirements)
    active = [row for row in rows if row["included"]]
    head = {
        "schema_version": SEMANTIC_CASE_SCHEMA,
        "score_policy": SEMANTIC_CASE_POLICY,
        "family_score_policy": SEMANTIC_FAMILY_POLICY,
        "family_weights": weights,
    }
    counts = {
        "source_requirement_count": len(rows),
        "active_requirement_count": len(active),
        "excluded_requirement_count": len(rows) - len(active),
        "parent_adjustment_count": sum(row["parent_constrained"] for row in rows),
    }
    if not rows:
        return (
            head | {"score": None, "known_coverage": 0.0} | counts | {"clauses": [], "families": {}, "requirements": []}
        )
    if not active:
        raise BadInput("no active semantic requirement maps to a declared family")
    texts = [prompt[a:b] for a, b in clause_spans(prompt)] or [prompt]
    families: dict[str, Row] = {}
    for family, weight in weights.items():
        mine = [row for row in active if row["semantic_family"] == family]
        if not mine:
            families[family] = {
                "score_policy": SEMANTIC_FAMILY_POLICY,
                "family_weight": weight,
                "applicable": False,
                "score": None,
                "known_coverage": 0.0,
                "active_requirement_count": 0,
                "clause_count": 0,
                "clauses": [],
            }
            continue
        clauses = [_clause_report(clause, texts, family) for clause in clauses_of(mine)]
        families[family] = {
            "score_policy": SEMANTIC_FAMILY_POLICY,
            "family_weight": weight,
            "applicable": True,
            "score": weighted_mean((1.0, c["score"]) for c in clauses),
            "known_coverage": weighted_mean((1.0, c["known_coverage"]) for c in clauses),
            "active_requirement_count": len(mine),
            "clause_count": len(clauses),
            "clauses": [_rounded(c) for c in clauses],
        }
    shown = [{key: value for key, value in row.items() if key != "value"} for row in rows]
    present = [f for f in families.values() if f["applicable"]]
    total = {
        name: round(weighted_mean((f["family_weight"], f[name]) for f in present), DETAILED_DIGITS)
        for name in ("score", "known_coverage")
    }
    return (
        head
        | total
        | counts
        | {
            "applicable_family_count": len(present),
            "clauses": [c for f in families.values() for c in f["clauses"]],
            "families": {name: _rounded(f) for name, f in families.items()},
            "requirements": shown,
        }
    )


def protocol_detailed(case: Mapping[str, Any]) -> Row | None:
    """Detailed Alignment of a ``semantic_case`` report under the benchmark's family weights; None when it is empty."""
    return detailed_score(case["requirements"]) if case["requirements"] else None
