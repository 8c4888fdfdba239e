"""What an agent was told of a Python submission: which answers and logs belong to it, and which errors they report."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

_RAISED = re.compile(
    r"^(?:\s*(?:\||\+)\s*)?(?:[A-Za-z_]\w*\.)*"
    r"([A-Z]\w*(?:Error|Exception|Exit|Interrupt|Iteration))(?::|$)",
    re.MULTILINE,
)
_JOB = re.compile(r'"job_id":\s*"((?:[^"\\]|\\.)*)"')
_STATUS = re.compile(r'"status":\s*"(\w+)"')


@dataclass(frozen=True, slots=True)
class ScriptAnswer:
    """A tool's answer as far as it was recorded."""

    job_id: str | None
    status: str | None
    """``started``, ``running``, ``done`` or ``error``."""
    text: str
    """What the agent read of output and error."""

    @property
    def tells_of_execution(self) -> bool:
        """Whether it shows that the script ran. A startup acknowledgement alone does not (paper)."""
        return self.status in ("done", "error") or (self.status == "running" and bool(self.text.strip()))


def read_answer(line: Mapping[str, Any]) -> ScriptAnswer:
    """The answer of a recorded call; one that was cut short is read as far as it goes."""
    recorded = str(line.get("result") or "")
    try:
        told = json.loads(recorded)
    except ValueError:
        job, status = _JOB.search(recorded), _STATUS.search(recorded)
        return ScriptAnswer(
            json.loads(f'"{job[1]}"') if job else None,
            status[1] if status else None,
            recorded.replace("\\n", "\n").replace('\\"', '"'),
        )
    result = told.get("result") if isinstance(told, dict) else None
    if not isinstance(result, dict):
        return ScriptAnswer(None, None, "")
    texts = [str(result[key]) for key in ("error", "output") if result.get(key)]
    job_id = result.get("job_id")
    return ScriptAnswer(str(job_id) if job_id is not None else None, result.get("status"), "\n".join(texts))


def error_families(text: str) -> list[str]:
    """The exception classes that a text reports, in order, each once: the last line of every traceback."""
    return list(dict.fromkeys(_RAISED.findall(text)))


@dataclass(slots=True)
class Feedback:
    """All that was told of one submission. A report that is repeated counts once."""

    observed: bool = False
    errors: dict[str, None] = field(default_factory=dict)
    failed: bool = False

    def add(self, answer: ScriptAnswer) -> None:
        """Take in one answer that belongs to the submission."""
        self.observed |= answer.tells_of_execution
        self.failed |= answer.status == "error"
        self.errors |= dict.fromkeys(error_families(answer.text))
