"""An attempt's trajectory as data (paper, "Trajectory measurements")."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from c4s.records.base import Record
from c4s.trajectory.feedback import Feedback, read_answer
from c4s.trajectory.lines import counted_calls, read_lines
from c4s.trajectory.operations import families_of

PYTHON_TOOL, POLLING_TOOL = "execute_python_script", "read_job_log"
TRANSFORM_TOOLS = frozenset({"set_actor_transform"})


class Submission(Record):
    """One Python submission of an attempt."""

    call: int
    """Number of the tool call, from 1."""
    parseable: bool
    families: list[str]
    """Operation families that occur; empty for a script that does not parse."""
    feedback: bool
    """Whether an answer or a log showed that it ran. False rules nothing out."""
    errors: list[str]
    """Exception classes that its answers and logs report, each once."""
    failed: bool
    """Whether it ended by an error."""


class Analysis(Record):
    """What one attempt did. Calls count when they started, failed or unfinished too; a request id counts once."""

    calls: int
    polling: int
    """Asynchronous status checks among the calls."""
    python: int
    failed: int
    """Calls that gave no result: answered with an error, or unfinished."""
    unfinished: int
    """Calls that were cut short by the end of their run, or of its process."""
    named_transform_calls: int
    by_tool: dict[str, int]
    submissions: list[Submission]

    @property
    def non_polling(self) -> int:
        """Calls without the status checks: what reported means count."""
        return self.calls - self.polling


def analyse_lines(lines: Iterable[Mapping[str, Any]]) -> Analysis:
    """The analysis of trajectory lines, in their order."""
    by_tool: Counter[str] = Counter()
    failed = unfinished = 0
    scripts: list[tuple[int, str, Feedback]] = []
    by_job: dict[str, Feedback] = {}
    for number, line in enumerate(sorted(counted_calls(lines), key=lambda line: int(line.get("call") or 0)), 1):
        tool = str(line.get("tool"))
        by_tool[tool] += 1
        failed += line.get("outcome") != "ok"
        unfinished += line.get("outcome") in ("ended", "unfinished")
        answer = read_answer(line)
        if tool == PYTHON_TOOL:
            feedback = Feedback()
            arguments = line.get("arguments")
            script = arguments.get("script") if isinstance(arguments, Mapping) else None
            scripts.append((number, script if isinstance(script, str) else "", feedback))
            if answer.job_id is not None:
                by_job[answer.job_id] = feedback
            feedback.add(answer)
        elif tool == POLLING_TOOL and answer.job_id in by_job:
            by_job[answer.job_id].add(answer)
    return Analysis(
        calls=by_tool.total(),
        polling=by_tool[POLLING_TOOL],
        python=by_tool[PYTHON_TOOL],
        failed=failed,
        unfinished=unfinished,
        named_transform_calls=sum(by_tool[tool] for tool in TRANSFORM_TOOLS),
        by_tool=dict(sorted(by_tool.items())),
        submissions=[_submission(*script) for script in scripts],
    )


def _submission(call: int, script: str, feedback: Feedback) -> Submission:
    families = families_of(script) if script.strip() else None
    return Submission(
        call=call,
        parseable=families is not None,
        families=list(families or ()),
        feedback=feedback.observed,
        errors=list(feedback.errors),
        failed=feedback.failed,
    )


def analyse(trajectory: Path) -> Analysis:
    """The analysis of a ``trajectory.jsonl``; one that is not there is an attempt without calls."""
    if not trajectory.is_file():
        return analyse_lines(())
    return analyse_lines(read_lines(trajectory))
