"""Attempts as trajectories in ATIF v1.8 (Agent Trajectory Interchange Format), which Harbor's viewer and others read.

A step is the prompt, then one a tool call, in the order of their start: c4s sees an agent's calls and not its words, so
the message of a step is empty, and how many model requests led to a call is not told. Pictures lie beside the
document. Token counts are those of the whole attempt.
"""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from c4s.files import write_json
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration
from c4s.trajectory.lines import counted_calls, read_lines

VERSION = "ATIF-v1.8"
DOCUMENT, IMAGES = "trajectory.json", "images"
NOTES = "Steps are tool calls as c4s recorded them; messages of the model are not recorded. Totals are of the attempt."
ENDED = "the process ended before the tool did"


def write_atif(
    attempt: AttemptFolder, out: Path, *, session: str, configuration: Configuration, prompt: str
) -> dict[str, Any]:
    """Write an attempt as a folder with its trajectory and pictures; the document.

    Args:
        attempt: one that has ended.
        out: a new folder.
        session: the trial, by name.
        configuration: who worked.
        prompt: what the case says.

    ``BadInput`` where the attempt's record cannot be read.
    """
    outcome = AttemptOutcome.read(attempt.outcome)
    calls = sorted(counted_calls(read_lines(attempt.trajectory)), key=lambda line: int(line["call"]))
    steps: list[dict[str, Any]] = [{"step_id": 1, "source": "user", "message": prompt}]
    steps += [_step(number, line) for number, line in enumerate(calls, start=2)]
    document = {
        "schema_version": VERSION,
        "session_id": session,
        "trajectory_id": f"{session}/{attempt.root.name}",
        "agent": _agent(configuration, outcome),
        "steps": steps,
        "notes": NOTES,
        "final_metrics": _known(
            total_prompt_tokens=outcome.input_tokens,
            total_completion_tokens=outcome.output_tokens,
            total_cost_usd=outcome.cost_usd,
            total_steps=len(steps),
            extra={"tool_calls": outcome.tool_calls, "wall_s": outcome.wall_s},
        ),
        "extra": {"ended_by": outcome.ended_by, "submission": outcome.submission, "message": outcome.message},
    }
    (out / IMAGES).mkdir(parents=True)
    for line in calls:
        for image in line.get("images", []):
            shutil.copyfile(attempt.images / _file(image), out / IMAGES / _file(image))
    write_json(out / DOCUMENT, document)
    return document


def _agent(configuration: Configuration, outcome: AttemptOutcome) -> dict[str, Any]:
    extra = _known(client=outcome.client, harness=configuration.harness, options=configuration.options or None)
    return _known(
        name=configuration.name, version=outcome.client_version or "unknown", model_name=outcome.model, extra=extra
    )


def _step(number: int, line: Mapping[str, Any]) -> dict[str, Any]:
    name = str(line["call"])
    text = str(line.get("result") or line.get("error") or ENDED)
    pictures = [
        {"type": "image", "source": {"media_type": "image/png", "path": f"{IMAGES}/{_file(image)}"}}
        for image in line.get("images", [])
    ]
    content: Any = [{"type": "text", "text": text}, *pictures] if pictures else text
    result = {"source_call_id": name, "content": content, "extra": {"outcome": line["outcome"]}}
    return _known(
        step_id=number,
        timestamp=_time(line),
        source="agent",
        message="",
        tool_calls=[{"tool_call_id": name, "function_name": line["tool"], "arguments": line["arguments"]}],
        observation={"results": [result]},
    )


def _time(line: Mapping[str, Any]) -> str | None:
    """When a call began: its line is written when it ends."""
    ended = line.get("time")
    if not isinstance(ended, int | float):
        return None
    return datetime.fromtimestamp(ended - float(line.get("duration_s") or 0.0), UTC).isoformat()


def _file(image: Mapping[str, Any]) -> str:
    return f"{image['sha256']}.png"


def _known(**fields: Any) -> dict[str, Any]:
    """The fields that are known."""
    return {name: value for name, value in fields.items() if value is not None}
