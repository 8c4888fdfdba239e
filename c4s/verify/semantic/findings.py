"""What the detailed verdict says of single requirements."""

from __future__ import annotations

from collections.abc import Iterator

from c4s.records.verdict import Verdict
from c4s.verify.verifier import Finding


def detailed_findings(verdict: Verdict) -> Iterator[Finding]:
    """Each requirement with its decision, in the bundle's order."""
    for row in verdict.measurements.get("decisions", []):
        yield Finding(
            str(row.get("text", "")),
            str(row.get("evaluation_status", row.get("status", ""))),
            str(row.get("reason", "")),
        )
