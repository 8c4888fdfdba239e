"""An attempt as a timeline: its calls over time, its budgets, what it cost; whole texts in a file of their own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from c4s.names import shown
from c4s.trajectory import PYTHON_TOOL
from reports.case.asked import CaseRows
from reports.case.code import code_tokens
from reports.frame import Board, SiteContext, SitePicture
from reports.frame.board import Row
from warehouse.trial_part import trial_part

HEAD: Final = 240
"""Characters of a text that stand in the page itself."""
TRACK: Final = 1_000
"""Width of the strip, in its own units."""
LEAST_MARK: Final = 3.0
_LOOKS: Final = ("screenshot", "preview", "render")
_READS: Final = ("get_", "list_", "search_", "read_", "find_", "describe_", "validate_", "is_")


@dataclass(frozen=True)
class Text:
    """A text of a call: its beginning, and how long it is."""

    head: str
    kept: int
    """Characters that the warehouse keeps."""
    whole: int

    @property
    def more(self) -> bool:
        """Whether the page has only its beginning."""
        return self.kept > len(self.head)


@dataclass(frozen=True)
class Call:
    """A tool call."""

    number: int
    tool: str
    kind: str
    """``python``, ``look``, ``read``, ``save`` or ``edit``."""
    outcome: str
    error: str
    start_s: float | None
    duration_s: float | None
    x: float
    width: float
    """Place on the strip."""
    arguments: Text
    script: Text
    answer: Text
    screenshots: Sequence[SitePicture]


@dataclass(frozen=True)
class Bar:
    """What was used of a budget."""

    name: str
    used: float | None
    of: float | None
    unit: str

    @property
    def share(self) -> float | None:
        """Of the budget; null where there is none."""
        return min(1.0, self.used / self.of) if self.used is not None and self.of else None


@dataclass(frozen=True)
class Attempt:
    """An attempt with its calls."""

    row: Row
    retained: bool
    bars: Sequence[Bar]
    calls: Sequence[Call]
    tools: Sequence[Row]
    name: str
    """Of the whole texts among the data of the site."""
    data: str
    """Their file, below the site; empty where every text is whole in the page."""
    ticks: Sequence[tuple[float, float]]
    """Places on the strip, and their seconds."""


def attempts_of(
    site: SiteContext, board: Board, trial: Row, asked: CaseRows, screenshots: Sequence[SitePicture]
) -> list[Attempt]:
    """Every attempt of a trial; its texts are put on the site."""
    trial_id = trial["trial_id"]
    calls = trial_part(
        site.warehouse, "calls", suite=board.suite, configuration=trial["configuration"], trial_id=trial_id
    )
    named = {picture.view: picture for picture in screenshots}
    made = []
    for row in asked.attempts.get(trial_id, []):
        own = sorted((call for call in calls if call["attempt"] == row["attempt"]), key=lambda call: int(call["call"]))
        name = f"calls-{trial_id}-{row['attempt']}"
        long_s = max([row["wall_s"], *((call["start_s"] or 0) + (call["duration_s"] or 0) for call in own), 1e-6])
        made.append(
            Attempt(
                row,
                row["attempt"] == asked.retained.get(trial_id),
                _bars(row, asked.plan),
                [_call(call, long_s, named) for call in own],
                [tool for tool in asked.tools.get(trial_id, []) if tool["attempt"] == row["attempt"]],
                name,
                _put(site, name, own),
                [(TRACK * part / 4, long_s * part / 4) for part in range(5)],
            )
        )
    return made


def _bars(row: Row, plan: Row) -> list[Bar]:
    wall = plan["wall_budget_s"]
    tokens = None if row["input_tokens"] is None else row["input_tokens"] + (row["output_tokens"] or 0)
    return [
        Bar("Tool calls", row["tool_calls"], plan["call_budget"], ""),
        Bar("Minutes", row["wall_s"] / 60, None if wall is None else wall / 60, ""),
        Bar("Tokens", tokens, None, ""),
        Bar("Cost", row["cost_usd"], None, "$"),
    ]


def _call(row: Row, long_s: float, named: Mapping[str, SitePicture]) -> Call:
    start, took = row["start_s"] or 0.0, row["duration_s"] or 0.0
    return Call(
        int(row["call"]),
        row["tool"],
        _kind(row["tool"]),
        row["outcome"],
        row["error"],
        row["start_s"],
        row["duration_s"],
        round(TRACK * start / long_s, 1),
        round(max(LEAST_MARK, TRACK * took / long_s), 1),
        _text(row, "arguments"),
        _text(row, "script"),
        _text(row, "answer"),
        [named[view] for view in row["screenshots"].split() if view in named],
    )


def _text(row: Row, name: str) -> Text:
    text = shown(row[name], keep="\n\t")
    return Text(text[:HEAD], len(text), max(len(text), int(row[f"{name}_characters"])))


def _kind(tool: str) -> str:
    if tool == PYTHON_TOOL:
        return "python"
    if any(word in tool for word in _LOOKS):
        return "look"
    if tool.startswith("save"):
        return "save"
    return "read" if tool.startswith(_READS) else "edit"


def _put(site: SiteContext, name: str, calls: Sequence[Row]) -> str:
    """Put the texts that are longer than their beginnings on the site, as a script that hands them over."""
    texts: dict[str, dict[str, Any]] = {}
    for row in calls:
        for part in ("arguments", "script", "answer"):
            text = shown(row[part], keep="\n\t")
            if len(text) > HEAD or (part == "script" and text):
                texts.setdefault(str(row["call"]), {})[part] = code_tokens(text) if part == "script" else text
    return site.put_data(name, texts) if texts else ""
