"""Tool calls of public cases as rows: what was sent and what was answered, cut to what a page can show.

A call is an argument list and an answer; scripts stand apart. Texts are cut at the bounds below, and shorter ones hold
from ``ATTEMPT_TEXT`` on, so that no attempt can fill a warehouse. Trajectories hold no key of ours; what looks like one
all the same, and where the run lies on this machine, is left out.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from c4s.files import canonical_json
from c4s.records.folder import AttemptFolder
from c4s.run.plan import Trial
from c4s.trajectory import POLLING_TOOL, PYTHON_TOOL
from c4s.trajectory import lines as trajectory
from warehouse.pictures import image_row
from warehouse.records import AttemptRow, CallRow, PictureRow

MOST_CALLS: Final = 2_000
"""Calls of an attempt that have a row."""
ARGUMENTS, SCRIPT, ANSWER, ERROR = 4_000, 16_000, 3_000, 1_000
"""Characters that are kept."""
ATTEMPT_TEXT, AFTERWARDS = 600_000, 200
"""Characters of an attempt that are kept at these bounds, and the bound of each text after them."""
MOST_SCREENSHOTS, SCREENSHOT_WIDTH, SCREENSHOT_QUALITY = 40, 480, 70
"""Pictures of an attempt that are kept, evenly over it; their width in pixels."""
HIDDEN: Final = "***"
_KEYS: Final = re.compile(
    r"-----BEGIN [A-Z ]*PRIVATE KEY-----[\s\S]*?(?:-----END [A-Z ]*PRIVATE KEY-----|$)"
    r"|\b(?:(?:sk|pk|rk|glpat|xox[abpr])-|(?:ghp|gho|ghs|hf)_|AIza|AKIA|ASIA)[A-Za-z0-9_-]{12,}"
    r"|(?<=[Bb]earer )[A-Za-z0-9._~+/-]{16,}=*"
)
_LONGEST_KEY: Final = 4_000


class _Texts:
    """The texts of an attempt, shorter ones once it has had its share."""

    def __init__(self, place: Path) -> None:
        self._left = ATTEMPT_TEXT
        self._place = str(place)

    def cut(self, text: str, most: int) -> str:
        """What is kept of a text."""
        most = most if self._left > 0 else min(most, AFTERWARDS)
        kept = _KEYS.sub(HIDDEN, text[: most + _LONGEST_KEY].replace(self._place, "…"))[:most]
        self._left -= len(kept)
        return kept


def call_rows(trial: Trial, attempts: Sequence[AttemptRow], key: dict[str, Any]) -> list[CallRow]:
    """The calls of every attempt, in their order."""
    return [row for attempt in attempts for row in _of_attempt(trial, attempt, key)]


def screenshot_rows(trial: Trial, attempts: Sequence[AttemptRow], key: dict[str, Any]) -> Iterator[PictureRow]:
    """The pictures that the agent was shown, each once a trial; of many of an attempt an even choice."""
    done: set[str] = set()
    for attempt in attempts:
        folder = trial.folder.attempt(attempt.attempt)
        for name in _chosen(_lines(folder)):
            path = folder.images / f"{name}.png"
            if name not in done and path.is_file():
                done.add(name)
                yield image_row(path, key, "screenshot", _view(name), SCREENSHOT_WIDTH, SCREENSHOT_QUALITY)


def _of_attempt(trial: Trial, attempt: AttemptRow, key: dict[str, Any]) -> Iterator[CallRow]:
    folder = trial.folder.attempt(attempt.attempt)
    texts, lines = _Texts(trial.run.parent.absolute()), _lines(folder)
    kept = {name for name in _chosen(lines) if (folder.images / f"{name}.png").is_file()}
    for number, line in enumerate(lines[:MOST_CALLS], start=1):
        arguments = dict(line["arguments"])
        script = arguments.pop("script", "") if line["tool"] == PYTHON_TOOL else ""
        script = script if isinstance(script, str) else canonical_json(script)
        told, answer = canonical_json(arguments), str(line.get("result") or "")
        yield CallRow(
            **key,
            attempt=attempt.attempt,
            recorded=attempt.recorded,
            call=number,
            tool=texts.cut(str(line["tool"]), ERROR),
            polling=line["tool"] == POLLING_TOOL,
            outcome=str(line["outcome"]),
            error=texts.cut(str(line.get("error") or ""), ERROR),
            start_s=_number(line.get("start_s")),
            duration_s=_number(line.get("duration_s")),
            arguments=texts.cut(told, ARGUMENTS),
            arguments_characters=len(told),
            script=texts.cut(script, SCRIPT),
            script_characters=len(script),
            answer=texts.cut(answer, ANSWER),
            answer_characters=max(len(answer), int(_number(line.get("result_characters")) or 0)),
            screenshots=" ".join(_view(name) for name in _pictures(line) if name in kept),
            calls_left=None if (left := _number(line.get("tool_calls_left"))) is None else int(left),
            seconds_left=_number(line.get("seconds_left")),
        )


def _lines(folder: AttemptFolder) -> list[Mapping[str, Any]]:
    """The counted calls in the order of their start; none where nothing was recorded."""
    if not folder.trajectory.is_file():
        return []
    counted = trajectory.counted_calls(trajectory.read_lines(folder.trajectory))
    return sorted(counted, key=lambda line: int(line.get("call") or 0))


def _pictures(line: Mapping[str, Any]) -> list[str]:
    """SHA-256 of each picture of an answer."""
    images = line.get("images")
    return (
        [str(image["sha256"]) for image in images if isinstance(image, dict) and image.get("sha256")] if images else []
    )


def _chosen(lines: Sequence[Mapping[str, Any]]) -> list[str]:
    found = list(dict.fromkeys(name for line in lines[:MOST_CALLS] for name in _pictures(line)))
    if len(found) <= MOST_SCREENSHOTS:
        return found
    return [found[round(place * (len(found) - 1) / (MOST_SCREENSHOTS - 1))] for place in range(MOST_SCREENSHOTS)]


def _view(sha256: str) -> str:
    return sha256[:16]


def _number(value: Any) -> float | None:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None
