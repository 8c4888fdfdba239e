"""A verdict: one verifier's report on one submission. Pure data; every verifier returns one."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from c4s.records.base import Record

Status = Literal["measured", "not_applicable", "not_evaluated", "error", "valid", "invalid"]


class Verdict(Record):
    """One verifier's report.

    ``status`` follows the paper (evaluation protocol): a ``measured`` score is a finite number in [0, 1] and is no
    pass mark; the other measurement statuses carry no number. Integrity is ``valid`` or ``invalid``.
    """

    schema_version: Literal["c4s.verdict.v1"] = "c4s.verdict.v1"
    verifier: str
    """``integrity``, ``physics``, ``repair``, ``detailed`` or ``overview``."""
    status: Status
    score: float | None = None
    policy: str
    """Id of the policy under which it was made."""
    measurements: dict[str, Any] = Field(default_factory=dict)
    population: dict[str, int] = Field(default_factory=dict)
    """How many actors, targets or requirements were eligible, evaluated, unresolved."""
    advisories: list[dict[str, Any]] = Field(default_factory=list)
    """Known oddities of the protocol in this case: ``{"code", "text", "actors"}``. They never change the score."""
    inputs: dict[str, str] = Field(default_factory=dict)
    """SHA-256 of each file that was read."""
    reason: str = ""
    """Why there is no number, or why it is invalid."""
