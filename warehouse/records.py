"""The outcome tables. These models are the single source of column names, types and units."""

from __future__ import annotations

from typing import Any

from pydantic import create_model

from c4s.protocol.settings import Setting
from c4s.records.base import Record
from c4s.records.score import CaseStatus
from c4s.records.suite import Visibility
from c4s.verify.registry import VERIFIERS
from warehouse.shown import CallRow, ClaimRow, PictureRow, SceneRow, ShapeRow
from warehouse.trial_key import TrialKey

__all__ = [
    "HEADLINES",
    "TABLES",
    "AttemptRow",
    "CallRow",
    "ClaimRow",
    "ComponentRow",
    "FindingRow",
    "OutcomeRow",
    "PictureRow",
    "SceneRow",
    "ScheduleRow",
    "ScoredTrial",
    "ShapeRow",
    "SubmissionRow",
    "ToolUseRow",
    "TrialKey",
    "VerdictRow",
]


class ScoredTrial(TrialKey):
    """A trial with its case score in [0, 1] and what it took."""

    setting: Setting
    """Track and domain; the view ``settings`` lists them."""
    scene_id: str
    """The source scene. Cases of one scene are drawn together."""
    status: CaseStatus
    """``measured``, ``measured_with_missing_zero``, ``zero_...`` without a measurement, or ``pending``."""
    score: float | None
    """By the score policy; null while it is pending."""
    reason: str
    """As words. What to count by is ``reason_code``."""
    reason_code: str = ""
    """Why a trial is worth zero without being measured: ``no_submission``, ``missing_result``, or what made the scene
    invalid (``c4s.verify.integrity.verdict``). Empty where it was measured or is pending."""
    attempts: int
    """How many there were."""
    retained_attempt: int | None
    """The first with a valid submission, from 1; null without one."""
    tool_calls: int | None
    """Of the recorded run, like the time, tokens and cost: the retained attempt, without one the last."""
    attempt_wall_s: float | None
    """Of the recorded run."""
    evaluation_s: float | None
    """Seconds that exporting evidence, verifying and scoring took, all stages together."""
    orchestration_s: float | None
    """Seconds that handing the stages to worker processes cost beyond the stages; waiting for a slot not counted."""
    input_tokens: int | None
    """Of the recorded run."""
    output_tokens: int | None
    """Of the recorded run."""
    cost_usd: float | None
    """Of the recorded run."""
    ranked: bool
    """False for configurations that only validate the evaluator."""
    policy: str
    """Name of the score policy."""
    judge: str
    """Name of the judge."""
    judge_version: str = ""
    """Another version of a judge is another judge."""
    engine: str
    """Name of the engine."""
    sandbox: str | None = None
    """What confined the engine of the recorded run."""
    score_sha256: str
    """Of the file of the trial's score."""


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
    """From 1."""
    ended_by: str
    """``finished``, ``call_budget``, ``wall_budget``, ``agent_error``, ``killed`` or ``repeats_spent``."""
    recorded: bool
    """Whether it is the trial's recorded run: the first attempt with a valid submission, else the last."""
    client: str
    """Which client worked; empty where it was not recorded."""
    model: str | None
    """As the configuration names it."""
    client_version: str
    """As the client told; empty where it did not."""
    harness: str | None = None
    """The program that drove the agent, where c4s did not start it. Calls and budgets differ by harness."""
    engine_version: str
    """As the engine told; empty where it was not recorded."""
    sandbox: str
    """What confined the engine: ``bubblewrap``, ``landlock``, ``none``; empty where it was not recorded."""
    submission: str | None
    """Package path of the saved scene; null where nothing was saved."""
    valid: bool | None
    """What the integrity check said; null where it was not asked."""
    tool_calls: int
    """Calls with a start, failed and unfinished ones too; a repeated request id counts once."""
    polling_calls: int
    """Asynchronous status checks among them. Reported means leave them out."""
    python_calls: int
    """Calls among them that hand in Python."""
    failed_calls: int
    """Calls among them that failed."""
    named_transform_calls: int
    """Calls among them of tools that move one named actor."""
    wall_s: float
    """How long it took."""
    input_tokens: int | None
    """Of all requests on record."""
    output_tokens: int | None
    """Of all requests on record."""
    cost_usd: float | None
    """At the rates of the day of each request, as the run recorded it."""
    requests: int | None = None
    """Model requests on record that ask for output; None where none is."""
    unpriced_requests: int | None = None
    """Those among them of which a class that matters, or the price, is unknown."""
    fresh_input_tokens: int | None = None
    """Input that no cache held. None, like the other classes, where a request did not tell it: never 0."""
    cache_read_tokens: int | None = None
    """Input that a cache held."""
    cache_write_tokens: int | None = None
    """Input that was put into a cache."""
    fresh_input_usd: float | None = None
    """What the class costs at list rates; None, like the other classes, where a request is unpriced."""
    cache_read_usd: float | None = None
    """What cache reads cost at list rates."""
    cache_write_usd: float | None = None
    """What cache writes cost at list rates."""
    output_usd: float | None = None
    """What output costs at list rates."""
    message: str
    """What was told of its end."""


class ToolUseRow(TrialKey):
    """Table ``tool_use``: how often an attempt called a tool."""

    attempt: int
    """From 1."""
    recorded: bool
    """Whether the attempt is the trial's recorded run."""
    tool: str
    """Its name."""
    calls: int
    """Calls with a start, failed ones too."""


class SubmissionRow(TrialKey):
    """Table ``python_submissions``: one row a Python submission of an attempt."""

    attempt: int
    """From 1."""
    recorded: bool
    """Whether the attempt is the trial's recorded run."""
    call: int
    """Number of the tool call in the attempt, from 1."""
    parseable: bool
    """Whether it is Python by its grammar."""
    families: str
    """Operation families that the script attempts, separated by blanks."""
    feedback: bool
    """Whether an answer or a log showed that it ran. False rules nothing out."""
    failed: bool
    """Whether an answer or a log reported an error."""
    errors: str
    """Exception classes that its answers and logs report, each once, separated by blanks."""


class VerdictRow(TrialKey):
    """Table ``verdicts``: one row a verifier and trial; ``document`` is the whole verdict as JSON."""

    verifier: str
    """Its name."""
    status: str
    """As the verifier told: ``measured``, ``valid``, ..."""
    score: float | None
    """Null where nothing was measured."""
    reason: str
    """As words."""
    policy: str
    """Name of the policy that it measured by."""
    document: str
    """The verdict as JSON."""
    verdict_sha256: str
    """Of the verdict's file."""


class ComponentRow(TrialKey):
    """Table ``components``: one row a number that a verdict's score is made of, and the score itself (``score``).

    ``semantic`` stands beside the verifiers: Detailed and Overview Alignment as one. A number that was not measured
    has no row.
    """

    verifier: str
    """Its name."""
    name: str
    """``floating``, ``families.content_quantity``, ``profiles.strict.f1``, ... (``components.py`` of each verifier)."""
    value: float
    """A share in [0, 1], or a count (``tp``, ``fp``, ``fn``)."""


class FindingRow(TrialKey):
    """Table ``findings``: an actor or requirement that a verifier decided on."""

    verifier: str
    """Its name."""
    subject: str
    """Actor label or requirement text."""
    outcome: str
    """``TP``, ``FP``, ``FN``, ``MATCH``, ``MISMATCH``, ``UNKNOWN``, ``floating``, ``penetrating``."""
    detail: str
    """What was seen, as words."""


class ScheduleRow(Record):
    """Table ``schedule``: one row a planned trial, so that a missing outcome is seen."""

    trial_id: str
    """By content, as in every other table."""
    run_id: str
    """The run that planned it first."""
    suite: str
    """Name of the suite."""
    suite_digest: str
    """Of the suite's record."""
    planned_at: str
    """When the plan was frozen (UTC): the time of its file. It tells which build of a suite is the latest."""
    configuration: str
    """Its name."""
    configuration_digest: str
    """Of the configuration's canonical JSON."""
    client: str
    """Which client works."""
    model: str | None
    """As the configuration names it."""
    case_id: str
    """Unique in its suite."""
    title: str
    """For pages: agents do not see it."""
    prompt: str
    """What agents are asked."""
    setting: Setting
    """Track and domain."""
    scene_id: str
    """The source scene."""
    repeat: int
    """From 1."""
    operations: str
    """Corruption kinds of a repair in order, separated by blanks."""
    operation_group: str | None
    """``Restore``, ``Lifecycle``, ``Layout``, ``Symmetry`` or ``Transform``; null for a construction."""
    difficulty: str | None
    """As its authors say: ``easy``, ``medium``, ``hard``."""
    visibility: Visibility
    """The panel: ``public`` or ``private``."""
    call_budget: int | None = None
    """Tool calls that an attempt may make."""
    wall_budget_s: float | None = None
    """What an attempt may take."""
    proxy_assets: bool
    """Whether the catalog's assets stand in for content that is not there."""
    policy: str
    """Name of the score policy."""
    judge: str
    """Name of the judge."""
    judge_version: str = ""
    """Another version of a judge is another judge."""
    engine: str
    """Name of the engine."""
    ranked: bool
    """False for configurations that only validate the evaluator."""


TABLES: dict[str, type[Record]] = {
    "outcomes": OutcomeRow,
    "attempts": AttemptRow,
    "tool_use": ToolUseRow,
    "python_submissions": SubmissionRow,
    "calls": CallRow,
    "claims": ClaimRow,
    "verdicts": VerdictRow,
    "components": ComponentRow,
    "findings": FindingRow,
    "pictures": PictureRow,
    "scenes": SceneRow,
    "shapes": ShapeRow,
    "schedule": ScheduleRow,
}
