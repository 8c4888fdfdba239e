"""The records of a run: the frozen plan, an attempt's outcome, a trial's score."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from c4s.case.package import Setting
from c4s.model import Record


class Configuration(Record):
    """An agent configuration: client, model and options. ``name`` is its identity in tables."""

    name: str
    client: str
    """``noop``, ``random``, ``planner``, ``vandal``, ``oracle``, or the name of an agent client."""
    model: str | None = None
    options: dict[str, Any] = Field(default_factory=dict)


class PlannedCase(Record):
    """A scheduled case with the digests that identify its content."""

    case_id: str
    setting: Setting
    scene_id: str
    agent_digest: str
    withheld_digest: str


class Plan(Record):
    """What a run will do, frozen before it starts. Nothing volatile (path, port, time) is part of it."""

    schema_version: Literal["c4s.plan.v1"] = "c4s.plan.v1"
    run_id: str
    suite_id: str
    suite_digest: str
    configurations: list[Configuration]
    cases: list[PlannedCase]
    repeats: int = 1
    policy: str
    judge: str
    """``rule`` for the offline rule judge, else the judge model's id."""
    engine: str
    """``headless`` or ``unreal``."""
    versions: dict[str, str]


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
    message: str = ""


CaseStatus = Literal[
    "measured",
    "measured_with_missing_zero",
    "zero_invalid_candidate",
    "zero_missing_submission",
    "zero_missing_result",
    "pending",
]


class TrialScore(Record):
    """A trial's case score with its parts. ``status`` keeps the reasons for a zero apart."""

    schema_version: Literal["c4s.score.v1"] = "c4s.score.v1"
    case_id: str
    setting: Setting
    configuration: str
    repeat: int
    status: CaseStatus
    score: float | None
    reason: str = ""
    detailed: float | None = None
    known_coverage: float | None = None
    overview: float | None = None
    physics: float | None = None
    repair_precision: float | None = None
    repair_recall: float | None = None
    repair_f1: float | None = None
    policy: str
    judge: str
    engine: str
    retained_attempt: int | None = None
