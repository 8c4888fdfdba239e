"""Physical safety from its two leaves (paper, "Physical Safety"; scorer fact 4)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.numbers import record, unit_number
from c4s.protocol.rules import PHYSICS_DIGITS, PHYSICS_LEAF_WEIGHTS, PHYSICS_LEAVES, PHYSICS_POLICY, T2S_FLOATING_METRIC


def safety(raw: float, direction: Any) -> float:
    """A leaf's raw score as safety: 1 is best."""
    return 1 - raw if direction == "lower_is_better" else raw


def _leaves(results: Any) -> dict[str, Mapping[str, Any]]:
    """Leaves by name; of two with one name the later counts."""
    if not results:
        return {}
    if not isinstance(results, (list, tuple)):
        raise BadInput("leaf_results must be a list")
    return {
        str(leaf.get("leaf_id") or str(leaf.get("report_id", "")).split(".")[-1]): leaf
        for leaf in results
        if isinstance(leaf, Mapping)
    }


def _direction(name: str, leaf: Mapping[str, Any], metrics: Mapping[str, Any]) -> Any:
    """Direction of a raw score: the leaf's own word, else the report's, else the published one."""
    said = record(leaf.get("metadata"), "metadata").get("score_direction")
    return said or record(metrics.get("leaf_score_directions"), "leaf_score_directions").get(name, PHYSICS_LEAVES[name])


def physics_from_report(
    report: Any,
    floating_rate: float | None = None,
    weights: Mapping[str, float] = PHYSICS_LEAF_WEIGHTS,
    *,
    whole_scene: bool = False,
) -> dict[str, Any]:
    """Physical safety of a recorded report.

    A leaf that is not ``measured``, or whose score is no number in [0, 1], is worth zero at its full weight.

    Args:
        report: ``{"status", "score", "metrics": {"leaf_results": [...]}}`` or null.
        floating_rate: share of floating actors by the support rule; it replaces the recorded floating leaf.
        weights: of the two leaves.
        whole_scene: text-to-scene. Elsewhere an older report without any leaf keeps its measured scalar.

    Returns:
        ``policy``, ``score`` (four decimals), ``leaves`` and ``floating_source``.

    Raises ``BadInput`` for a report that has another shape.
    """
    report = record(report, "report")
    metrics = record(report.get("metrics"), "metrics")
    leaves = _leaves(metrics.get("leaf_results"))
    scalar = (
        unit_number(report.get("score"))
        if report.get("status") == "measured"
        and not metrics.get("leaf_results")
        and floating_rate is None
        and not whole_scene
        else None
    )
    source = "recorded" if scalar is None else "recorded_legacy_scalar"
    rows: dict[str, dict[str, Any]] = {}
    for name in PHYSICS_LEAVES:
        leaf = leaves.get(name, {})
        direction = _direction(name, leaf, metrics)
        raw = unit_number(leaf.get("score"))
        measured = leaf.get("status") == "measured" and raw is not None
        rows[name] = {
            "status": str(leaf.get("status") or "missing"),
            "raw_score": raw,
            "direction": direction,
            "safety": safety(raw, direction) if measured and raw is not None else scalar,
        }
    if floating_rate is not None:
        source = "recomputed_from_snapshot"
        rows["floating"] = {
            "status": "measured",
            "raw_score": floating_rate,
            "direction": rows["floating"]["direction"],
            "safety": round(1 - floating_rate, PHYSICS_DIGITS),
            "metric": T2S_FLOATING_METRIC,
        }
    floating = 1 - floating_rate if floating_rate is not None else rows["floating"]["safety"] or 0.0
    score = weights["floating"] * floating + weights["solid_penetration"] * (rows["solid_penetration"]["safety"] or 0.0)
    return {
        "policy": PHYSICS_POLICY,
        "score": round(scalar if scalar is not None else score, PHYSICS_DIGITS),
        "leaves": rows,
        "floating_source": source,
    }
