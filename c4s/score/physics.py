"""Physical safety from its two leaves (paper, "Physical Safety"; scorer fact 4)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.score.numbers import unit_number
from c4s.score.policy import (
    PHYSICS_DIGITS,
    PHYSICS_LEAF_WEIGHTS,
    PHYSICS_LEAVES,
    PHYSICS_POLICY,
    T2S_FLOATING_METRIC,
    Direction,
)


def safety(raw: float, direction: Direction) -> float:
    """A leaf's raw score as safety: 1 is best."""
    return 1 - raw if direction == "lower_is_better" else raw


def _mapping(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, Mapping) else {}


def _leaf_name(leaf: Mapping[str, Any]) -> str:
    return str(leaf.get("leaf_id") or str(leaf.get("report_id") or "").rpartition(".")[2])


def _direction(name: str, leaf: Mapping[str, Any], metrics: Mapping[str, Any]) -> Direction:
    known: tuple[Direction, ...] = ("lower_is_better", "higher_is_better")
    for said in (_mapping(leaf.get("metadata")).get("score_direction"),
                 _mapping(metrics.get("leaf_score_directions")).get(name)):
        for direction in known:
            if said == direction:
                return direction
    return PHYSICS_LEAVES[name]


def physics_from_report(report: Any, floating_rate: float | None = None,
                        weights: Mapping[str, float] = PHYSICS_LEAF_WEIGHTS) -> dict[str, Any]:
    """Physical safety of a recorded report.

    A leaf that is not ``measured``, or whose score is no number in [0, 1], is worth zero at its full weight. A report
    without any leaf keeps its measured scalar.

    Args:
        report: ``{"status", "score", "metrics": {"leaf_results": [...]}}`` or null.
        floating_rate: share of floating actors by the support rule; it replaces the recorded floating leaf.
        weights: of the two leaves.

    Returns:
        ``policy``, ``score`` (four decimals), ``leaves`` and ``floating_source``.
    """
    report = _mapping(report)
    metrics = _mapping(report.get("metrics"))
    results = metrics.get("leaf_results")
    leaves = [leaf for leaf in results if isinstance(leaf, Mapping)] if isinstance(results, list) else []
    scalar = (unit_number(report.get("score"))
              if report.get("status") == "measured" and not leaves and floating_rate is None else None)
    source = "recorded" if scalar is None else "recorded_legacy_scalar"
    rows: dict[str, dict[str, Any]] = {}
    for name in PHYSICS_LEAVES:
        leaf = next((leaf for leaf in leaves if _leaf_name(leaf) == name), {})
        direction = _direction(name, leaf, metrics)
        raw = unit_number(leaf.get("score"))
        measured = leaf.get("status") == "measured" and raw is not None
        rows[name] = {"status": str(leaf.get("status") or "missing"), "raw_score": raw, "direction": direction,
                      "safety": safety(raw, direction) if measured and raw is not None else scalar}
    score = sum(weights[name] * (row["safety"] or 0.0) for name, row in rows.items())
    if floating_rate is not None:
        score = weights["floating"] * (1 - floating_rate) \
            + weights["solid_penetration"] * (rows["solid_penetration"]["safety"] or 0.0)
        rows["floating"] = {"status": "measured", "raw_score": floating_rate,
                            "direction": rows["floating"]["direction"],
                            "safety": round(1 - floating_rate, PHYSICS_DIGITS), "metric": T2S_FLOATING_METRIC}
        source = "recomputed_from_snapshot"
    return {"policy": PHYSICS_POLICY, "score": round(score, PHYSICS_DIGITS), "leaves": rows, "floating_source": source}
