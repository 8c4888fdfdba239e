"""The outcome tables. These models are the single source of column names, types and units."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import create_model

from c4s.protocol.settings import Setting
from c4s.records.base import Record
from c4s.records.score import CaseStatus
from c4s.verify.registry import VERIFIERS

Visibility = Literal["public", "private"]


class TrialKey(Record):
    """What every row carries: which trial it belongs to."""

    trial_id: str
    """16 hex digits by content: suite, case, configuration, repeat, policy, judge, engine."""
    run_id: str
    suite: str
    suite_digest: str
    """Of the suite's record: another build of a suite is another suite."""
    configuration: str
    """Its name. Two contents may have one: ``configuration_digest`` tells them apart, the questions show its start."""
    configuration_digest: str
    """SHA-256 of the configuration's canonical JSON."""
    case_id: str
    repeat: int


class ScoredTrial(TrialKey):
    """A trial with its case score in [0, 1] and what it took."""

    setting: Setting
    scene_id: str
    status: CaseStatus
    score: float | None
    reason: str
    attempts: int
    retained_attempt: int | None
    tool_calls: int | None
    """Of the recorded run, like the time, tokens and cost: the retained attempt, without one the last."""
    attempt_wall_s: float | None
    evaluation_s: float | None
    """Seconds that exporting evidence, verifying and scoring took, all stages together."""
    orchestration_s: float | None
    """Seconds that handing the stages to worker processes cost beyond the stages; waiting for a slot not counted."""
    input_tokens: int | None
    output_tokens: int | None
    cost_usd: float | None
    ranked: bool
    """False for configurations that only validate the evaluator."""
    policy: str
    judge: str
    engine: str
    sandbox: str | None = None
    """What confined the engine of the recorded run."""
    score_sha256: str


HEADLINES = tuple(name for verifier in VERIFIERS.values() for name in verifier.headlines)
_COLUMNS: dict[str, Any] = dict.fromkeys(HEADLINES, (float | None, None))
OutcomeRow = create_model(
    "OutcomeRow",
    __base__=ScoredTrial,
    __doc__="Table ``outcomes``: one row a trial, with the headline numbers of every verifier (its row of the table).",
    **_COLUMNS,
)


class AttemptRow(TrialKey):
    """Table ``attempts``: every attempt."""

    attempt: int
    ended_by: str
    recorded: bool
    """Whether it is the trial's recorded run: the first attempt with a valid submission, else the last."""
    client: str
    """Which client worked; empty where it was not recorded."""
    model: str | None
    client_version: str
    """As the client told; empty where it did not."""
    engine_version: str
    sandbox: str
    """What confined the engine: ``bubblewrap``, ``landlock``, ``none``; empty where it was not recorded."""
    submission: str | None
    valid: bool | None
    tool_calls: int
    """Calls with a start, failed and unfinished ones too; a repeated request id counts once."""
    polling_calls: int
    """Asynchronous status checks among them. Reported means leave them out."""
    python_calls: int
    failed_calls: int
    named_transform_calls: int
    wall_s: float
    input_tokens: int | None
    output_tokens: int | None
    cost_usd: float | None
    message: str


class ToolUseRow(TrialKey):
    """Table ``tool_use``: how often an attempt called a tool."""

    attempt: int
    recorded: bool
    tool: str
    calls: int


class SubmissionRow(TrialKey):
    """Table ``python_submissions``: one row a Python submission of an attempt."""

    attempt: int
    recorded: bool
    call: int
    """Number of the tool call in the attempt, from 1."""
    parseable: bool
    families: str
    """Operation families that the script attempts, separated by blanks."""
    feedback: bool
    """Whether an answer or a log showed that it ran. False rules nothing out."""
    failed: bool
    errors: str
    """Exception classes that its answers and logs report, each once, separated by blanks."""


class VerdictRow(TrialKey):
    """Table ``verdicts``: one row a verifier and trial; ``document`` is the whole verdict as JSON."""

    verifier: str
    status: str
    score: float | None
    reason: str
    policy: str
    document: str
    verdict_sha256: str


class ComponentRow(TrialKey):
    """Table ``components``: one row a number that a verdict's score is made of, and the score itself (``score``).

    ``semantic`` stands beside the verifiers: Detailed and Overview Alignment as one. A number that was not measured
    has no row.
    """

    verifier: str
    name: str
    """``floating``, ``families.content_quantity``, ``profiles.strict.f1``, ... (``components.py`` of each verifier)."""
    value: float
    """A share in [0, 1], or a count (``tp``, ``fp``, ``fn``)."""


class FindingRow(TrialKey):
    """Table ``findings``: an actor or requirement that a verifier decided on."""

    verifier: str
    subject: str
    """Actor label or requirement text."""
    outcome: str
    """``TP``, ``FP``, ``FN``, ``MATCH``, ``MISMATCH``, ``UNKNOWN``, ``floating``, ``penetrating``."""
    detail: str


class PictureRow(TrialKey):
    """Table ``pictures``: what the case pages show, as JPEG."""

    role: Literal["start", "truth", "submission"]
    view: str
    width: int
    height: int
    jpeg: bytes


class ScheduleRow(Record):
    """Table ``schedule``: one row a planned trial, so that a missing outcome is seen."""

    trial_id: str
    run_id: str
    suite: str
    suite_digest: str
    planned_at: str
    """When the plan was frozen (UTC): the time of its file. It tells which build of a suite is the latest."""
    configuration: str
    configuration_digest: str
    client: str
    model: str | None
    case_id: str
    title: str
    prompt: str
    setting: Setting
    scene_id: str
    repeat: int
    operations: str
    operation_group: str | None
    difficulty: str | None
    proxy_assets: bool
    policy: str
    judge: str
    engine: str
    ranked: bool


TABLES: dict[str, type[Record]] = {
    "outcomes": OutcomeRow,
    "attempts": AttemptRow,
    "tool_use": ToolUseRow,
    "python_submissions": SubmissionRow,
    "verdicts": VerdictRow,
    "components": ComponentRow,
    "findings": FindingRow,
    "pictures": PictureRow,
    "schedule": ScheduleRow,
}
