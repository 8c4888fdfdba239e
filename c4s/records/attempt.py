"""How one attempt ended."""

from __future__ import annotations

from typing import ClassVar, Literal

from c4s.records.base import Sealed

EndedBy = Literal["finished", "call_budget", "wall_budget", "agent_error", "killed", "repeats_spent"]
"""``repeats_spent``: each run of it ended with a failure that the agent may have caused (``c4s.records.fault``)."""


class AttemptOutcome(Sealed):
    """How one attempt ended. Every attempt is kept."""

    REMEDY: ClassVar[str] = "restore the file, or run this trial again under another --run-id"
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
    client: str = ""
    """Which client worked: a configuration may name another one a case. Empty in records that are older."""
    model: str | None = None
    client_version: str = ""
    engine_version: str = ""
    """As the engine of the attempt told; empty in records that are older than the field."""
    sandbox: str = ""
    """What confined the engine: ``bubblewrap``, ``landlock``, ``none``; empty in records that are older."""
    message: str = ""
