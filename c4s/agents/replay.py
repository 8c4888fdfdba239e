"""Agent ``replay``: the calls of a recorded trajectory again, in their order, with their arguments.

On the headless engine the same calls make the same scene: names and GUIDs of new actors follow from the calls. A script
that reads the clock or the operating system's randomness is the exception.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from c4s.agents.base import AgentContext, AgentReport
from c4s.errors import BadInput
from c4s.toolbox.client import CallRefused
from c4s.trajectory.lines import counted_calls, read_lines


def recorded_calls(trajectory: Path) -> Iterator[tuple[str, dict[str, Any], bool]]:
    """Tool, arguments and whether it succeeded, of every call that was carried out, in the order of their start.

    A call that the end of its run, or of its process, cut short was not carried out to its end and is left out. Raises
    ``BadInput``.
    """
    if not trajectory.is_file():
        raise BadInput("no such trajectory", where=str(trajectory), todo="give the trajectory of an attempt")
    for line in sorted(counted_calls(read_lines(trajectory)), key=lambda line: int(line["call"])):
        if line["outcome"] in ("ok", "error"):
            yield str(line["tool"]), dict(line["arguments"]), line["outcome"] == "ok"


class Replay:
    """The agent ``replay``; its option ``trajectory`` names the file."""

    def run(self, context: AgentContext) -> AgentReport:
        """Send the recorded calls. What is answered otherwise than before is told in the message."""
        source = context.options.get("trajectory")
        if not isinstance(source, str):
            raise BadInput("the agent `replay` needs the option `trajectory`", where=context.configuration.name)
        sent, otherwise = 0, []
        with context.connect() as tools:
            for name, arguments, succeeded in recorded_calls(Path(source)):
                sent += 1
                try:
                    tools.call(name, **arguments)
                    answered = True
                except CallRefused:
                    answered = False
                if answered != succeeded:
                    otherwise.append(f"call {sent} ({name})")
        return AgentReport(
            client_version="replay 1",
            message=f"{sent} calls" + (f"; answered otherwise: {', '.join(otherwise)}" if otherwise else ""),
        )
