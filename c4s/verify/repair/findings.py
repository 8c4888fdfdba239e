"""What a repair verdict says of single actors, and the numbers that its score is made of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from c4s.protocol.numbers import unit_number
from c4s.records.verdict import Verdict
from c4s.verify.verifier import Components, Finding

_UNITS = {"position_cm": ("off by", "cm"), "rotation_deg": ("turned by", "deg"), "scale_pct": ("scaled by", "%")}


def repair_findings(verdict: Verdict) -> Iterator[Finding]:
    """Each target with its outcome, then each false positive."""
    for row in verdict.measurements.get("targets", []):
        yield Finding(row["actor"], row["outcome"], f"{row['operation']}: {row['reason']}{_errors(row)}")
    for row in verdict.measurements.get("false_positives", []):
        yield Finding(row["actor"], "FP", f"{row['kind'].replace('_', ' ')}: {row['reason']}")


def _errors(row: Mapping[str, Any]) -> str:
    errors = row.get("errors") or {}
    parts = [f"{verb} {errors[name]:.3g} {unit}" for name, (verb, unit) in _UNITS.items() if errors.get(name)]
    return f" ({', '.join(parts)})" if parts else ""


def repair_components(verdict: Verdict) -> Components:
    """Precision, recall and F1; all zero where the scene could not be scored."""
    measured = verdict.status == "measured"
    rates = {
        f"repair_{name}": unit_number(verdict.measurements.get(name)) if measured else 0.0
        for name in ("precision", "recall")
    }
    return {**rates, "repair_f1": verdict.score if measured else 0.0}
