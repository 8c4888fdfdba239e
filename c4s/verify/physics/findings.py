"""What a physics verdict says of single actors."""

from __future__ import annotations

from collections.abc import Iterator

from c4s.records.verdict import Verdict
from c4s.verify.verifier import Finding

PENETRATING, FLOATING = "penetrating", "floating"


def physics_findings(verdict: Verdict) -> Iterator[Finding]:
    """Each actor that floats, then each that penetrates others too deeply, leaf by leaf."""
    for leaf in verdict.measurements.get("leaf_results", []):
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
