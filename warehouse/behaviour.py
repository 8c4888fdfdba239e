"""What an agent did in a trial, as rows: its attempts, the tools that it called, the Python that it sent.

Every attempt has its rows. One of them is the trial's recorded run, which the questions about behaviour look at: runs
count there, not successes (paper, "Trajectory measurements"), so a trial without a valid submission has one too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from c4s.records.attempt import AttemptOutcome
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.run.plan import Trial
from c4s.trajectory import Analysis, analyse
from warehouse.records import AttemptRow, SubmissionRow, ToolUseRow
from warehouse.usage import usage_columns

Attempts = Sequence[tuple[AttemptRow, Analysis]]


def attempt_rows(trial: Trial, score: TrialScore, key: dict[str, Any]) -> Iterator[tuple[AttemptRow, Analysis]]:
    """Every attempt with the analysis of its trajectory."""
    folders = trial.folder.attempts()
    last = folders[-1].number if folders else None
    recorded = last if score.retained_attempt is None else score.retained_attempt
    for folder in folders:
        outcome, did, gate = AttemptOutcome.read(folder.outcome), analyse(folder.trajectory), folder.integrity
        yield (
            AttemptRow(
                **key,
                attempt=outcome.attempt,
                ended_by=outcome.ended_by,
                recorded=outcome.attempt == recorded,
                client=outcome.client,
                model=outcome.model,
                client_version=outcome.client_version,
                harness=trial.configuration.harness,
                engine_version=outcome.engine_version,
                sandbox=outcome.sandbox,
                submission=outcome.submission,
                valid=Verdict.read(gate).status == "valid" if gate.is_file() else None,
                tool_calls=outcome.tool_calls,
                polling_calls=did.polling,
                python_calls=did.python,
                failed_calls=did.failed,
                named_transform_calls=did.named_transform_calls,
                wall_s=outcome.wall_s,
                input_tokens=outcome.input_tokens,
                output_tokens=outcome.output_tokens,
                cost_usd=outcome.cost_usd,
                **usage_columns(folder.usage),
                message=outcome.message,
            ),
            did,
        )


def tool_use_rows(attempts: Attempts, key: dict[str, Any]) -> list[ToolUseRow]:
    """How often each attempt called each tool."""
    return [
        ToolUseRow(**key, attempt=row.attempt, recorded=row.recorded, tool=tool, calls=calls)
        for row, did in attempts
        for tool, calls in did.by_tool.items()
    ]


def submission_rows(attempts: Attempts, key: dict[str, Any]) -> list[SubmissionRow]:
    """The Python submissions of each attempt."""
    return [
        SubmissionRow(
            **key,
            attempt=row.attempt,
            recorded=row.recorded,
            call=one.call,
            parseable=one.parseable,
            families=" ".join(one.families),
            feedback=one.feedback,
            failed=one.failed,
            errors=" ".join(one.errors),
        )
        for row, did in attempts
        for one in did.submissions
    ]
