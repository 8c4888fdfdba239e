"""What the detailed verdict says of single requirements."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from c4s.records.verdict import Verdict
from c4s.verify.verifier import Finding


def detailed_findings(verdict: Verdict) -> Iterator[Finding]:
    """Each requirement with its decision, in the bundle's order."""
    for row in verdict.measurements.get("decisions", []):
        yield Finding(
            str(row.get("text", "")),
            str(row.get("evaluation_status", row.get("status", ""))),
            f"{row.get('reason', '')}{_seen(row)}",
        )


def _seen(row: Mapping[str, Any]) -> str:
    """The views that an answer by sight rests on, and how sure it was; nothing of one by state."""
    views, sure = row.get("views") or [], row.get("confidence")
    told = [*(str(view) for view in views), *([] if sure is None else [f"confidence {sure:.2f}"])]
    return f" ({', '.join(told)})" if told else ""
