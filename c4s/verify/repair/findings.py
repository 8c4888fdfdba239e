"""What a repair verdict says of single actors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from c4s.records.verdict import Verdict
from c4s.verify.verifier import Finding

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
