"""How one attempt ended."""

from __future__ import annotations

from typing import Literal

from c4s.records.base import Record

EndedBy = Literal["finished", "call_budget", "wall_budget", "agent_error", "killed"]


class AttemptOutcome(Record):
    """How one attempt ended. Every attempt is kept."""

    schema_version: Literal["c4s.attempt.v1"] = "c4s.attempt.v1"
    attempt: int
    """1 or 2."""
    ended_by: EndedBy
    submission: str | None
    """Package path of the saved scene, ``/Game/SavedScenes/...``; null where nothing was saved."""
    submission_sha256: str | None = None
    tool_calls: int = 0
    wall_s: float = 0.0
    input_tokens: int | None = None
    output_tokens: int | None = None
    cost_usd: float | None = None
    client_version: str = ""
    engine_version: str = ""
    """As the engine of the attempt told; empty in records that are older than the field."""
    message: str = ""
