"""Overview Alignment: four prompt dimensions, modified by structural integrity (scorer fact 6)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.numbers import record, unit_number
from c4s.protocol.rules import (
    OVERVIEW_VIEWS,
    OVERVIEW_WEIGHTS,
    SEVERE_CAP,
    SEVERE_CONFIDENCE,
    SEVERE_VIEWS,
    STRUCTURE_FLOOR,
    STRUCTURE_SHARE,
    UNUSABLE_STATUSES,
)


def overview_score(
    dimension_scores: Mapping[str, Any],
    structural_score: Any,
    severe_cap_eligible: bool,
    weights: Mapping[str, float] = OVERVIEW_WEIGHTS,
) -> dict[str, Any]:
    """Score of one overview judgement, four decimals, with its parts.

    Args:
        dimension_scores: of the prompt-aware call, by dimension.
        structural_score: of the prompt-free call.
        severe_cap_eligible: whether a severe defect was told with enough certainty and evidence.
        weights: of the dimensions.

    Raises ``BadInput`` when a dimension is missing or a score is no number in [0, 1]. Extra dimensions are ignored.
    """
    missing = [name for name in OVERVIEW_WEIGHTS if name not in dimension_scores]
    if missing:
        raise BadInput(f"overview judgement lacks {', '.join(missing)}")
    values = {name: unit_number(dimension_scores[name]) for name in OVERVIEW_WEIGHTS}
    structure = unit_number(structural_score)
    known = {name: value for name, value in values.items() if value is not None}
    if structure is None or len(known) < len(values):
        raise BadInput("overview dimension and structural scores must be numbers in [0, 1]")
    alignment = math.fsum(weight * known[name] for name, weight in weights.items())
    multiplier = STRUCTURE_FLOOR + STRUCTURE_SHARE * structure
    before = alignment * multiplier
    score = min(before, SEVERE_CAP) if severe_cap_eligible else before
    return {
        "status": "measured",
        "score": round(score, 4),
        "prompt_alignment_score": round(alignment, 4),
        "structural_integrity_score": round(structure, 4),
        "structural_multiplier": round(multiplier, 4),
        "score_before_severe_cap": round(before, 4),
        "severe_cap_eligible": bool(severe_cap_eligible),
        "severe_cap_applied": bool(severe_cap_eligible and before > SEVERE_CAP),
    }


def severe_cap_eligible(
    *, severe: bool, confidence: float, views: list[int], categories: list[str], issues: list[str]
) -> bool:
    """Whether a judge's severe defect may cap the score: sure enough, seen in two views, and named."""
    shown = {view - 1 for view in views} if views and min(views) >= 1 and max(views) == OVERVIEW_VIEWS else set(views)
    seen = {view for view in shown if 0 <= view < OVERVIEW_VIEWS}
    return bool(
        severe
        and confidence >= SEVERE_CONFIDENCE
        and len(seen) >= SEVERE_VIEWS
        and any(categories)
        and any(issue.strip() for issue in issues)
    )


def overview_from_report(report: Any) -> dict[str, Any]:
    """Overview score recomputed from a recorded report; ``{"status", "score": None}`` when it cannot be used."""
    report = record(report, "report")
    metrics = record(report.get("metrics"), "metrics")
    dimensions = record(metrics.get("dimensions"), "dimensions")
    status = report.get("status")
    if str(status or "").casefold() in UNUSABLE_STATUSES or not dimensions:
        return {"status": str(status or "missing"), "score": None}
    return overview_score(
        {name: record(row, name).get("score") for name, row in dimensions.items()},
        metrics.get("structural_integrity_score"),
        bool(metrics.get("severe_structural_cap_eligible")),
    )
