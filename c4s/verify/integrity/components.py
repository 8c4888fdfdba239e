"""The gate as a number."""

from __future__ import annotations

from c4s.records.verdict import Verdict
from c4s.verify.verifier import Components


def integrity_components(verdict: Verdict) -> Components:
    """``valid``: 1 or 0."""
    return {"valid": float(verdict.status == "valid")} if verdict.status in ("valid", "invalid") else {}
