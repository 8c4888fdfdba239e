"""Reading ``trajectory.jsonl``, also one that a killed process left behind."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import read_json_lines

_OF_A_CALL = {"call": int, "tool": str, "arguments": dict, "outcome": str}
"""What is asked of the record of a call; the end of a record that a killed process left may lack."""


def read_lines(trajectory: Path) -> list[dict[str, Any]]:
    """The lines of a trajectory in their order. A last line that was cut off in the middle was never complete: it is
    left out."""
    lines = read_json_lines(trajectory, what="trajectory", cut=True)
    for number, line in enumerate(lines, start=1):
        fields = _OF_A_CALL if line.get("event") in ("started", "call") else {"event": str}
        for name, kind in fields.items():
            if not isinstance(line.get(name), kind):
                raise BadInput(f"record {number} of this trajectory has no {name}", where=str(trajectory))
    return lines


def counted_calls(lines: Iterable[Mapping[str, Any]]) -> Iterator[Mapping[str, Any]]:
    """One line for every call that started, in the order of the file; each request id once.

    A call has a line ``started`` before its tool runs and a line ``call`` at its end. Where there is no second one, the
    process ended before the tool did, and the first one stands for it: its outcome is ``unfinished``.
    """
    lines = list(lines)
    ended = {line.get("call") for line in lines if line.get("event") == "call"}
    seen: set[str] = set()
    for line in lines:
        event, request = line.get("event"), line.get("request")
        unfinished = event == "started" and line.get("call") not in ended
        if not unfinished and not (event == "call" and line.get("counted")):
            continue
        if isinstance(request, str):
            if request in seen:
                continue
            seen.add(request)
        yield line
