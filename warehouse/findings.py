"""What a verdict says of single actors and requirements, as flat rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from c4s.records.verdict import Verdict

PENETRATING, FLOATING = "penetrating", "floating"


@dataclass(frozen=True)
class Finding:
    """One decision: about whom, what, and the measurements behind it."""

    subject: str
    outcome: str
    detail: str


def findings(verdict: Verdict) -> Iterator[Finding]:
    """The single decisions of a verdict, in its order."""
    match verdict.verifier:
        case "repair":
            yield from _repair(verdict.measurements)
        case "physics":
            yield from _physics(verdict.measurements)
        case "detailed":
            yield from _detailed(verdict.measurements)


def _repair(measurements: Mapping[str, Any]) -> Iterator[Finding]:
    for row in measurements.get("targets", []):
        yield Finding(row["actor"], row["outcome"], f"{row['operation']}: {row['reason']}{_errors(row)}")
    for row in measurements.get("false_positives", []):
        yield Finding(row["actor"], "FP", f"{row['kind'].replace('_', ' ')}: {row['reason']}")


_UNITS = {"position_cm": ("off by", "cm"), "rotation_deg": ("turned by", "deg"), "scale_pct": ("scaled by", "%")}


def _errors(row: Mapping[str, Any]) -> str:
    errors = row.get("errors") or {}
    parts = [f"{verb} {errors[name]:.3g} {unit}" for name, (verb, unit) in _UNITS.items() if errors.get(name)]
    return f" ({', '.join(parts)})" if parts else ""


def _physics(measurements: Mapping[str, Any]) -> Iterator[Finding]:
    for leaf in measurements.get("leaf_results", []):
        for actor in leaf.get("floating_actors", []):
            yield Finding(actor, FLOATING, "no support within 5 cm")
        for row in leaf.get("violations", []):
            deepest = max(row["contacts"], key=lambda contact: contact["depth_cm"])
            yield Finding(
                row["actor"],
                PENETRATING,
                f"{deepest['depth_cm']:.1f} cm into {deepest['actor']}, "
                f"tolerance {row['tolerance_cm']:.1f} cm, {len(row['contacts'])} contacts",
            )


def _detailed(measurements: Mapping[str, Any]) -> Iterator[Finding]:
    for row in measurements.get("decisions", []):
        yield Finding(
            str(row.get("text", "")),
            str(row.get("evaluation_status", row.get("status", ""))),
            str(row.get("reason", "")),
        )
