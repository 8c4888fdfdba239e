"""Answers of studies on pages: asked once, their tables ready to be shown, what they refuse told."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from pathlib import Path
from typing import Final

from c4s.errors import BadInput
from c4s.records.analysis import Column, Findings, StudyResult, Table, Value
from reports.frame.board import Board, Row
from reports.text import step
from warehouse.analyses import StudyOptions, result_of, results_of, study_named
from warehouse.analyses.tables import marks, method_of, printed

SHARES: Final = ("score", "share")
"""Units of values in [0, 1]."""


@dataclass(frozen=True)
class Answer:
    """What a study says of a leaderboard, or why it says nothing."""

    study: str
    title: str
    agents: tuple[str, ...] = ()
    result: StudyResult | None = None
    refusal: str = ""

    @property
    def findings(self) -> Findings:
        """Its findings; none where it says nothing."""
        return Findings(tables=[]) if self.result is None else self.result.findings

    @property
    def identity(self) -> str:
        """What `c4s analyze` prints of the same answer; empty where there is none."""
        return "" if self.result is None else self.result.identity()

    @property
    def command(self) -> str:
        """The command that gives the same answer."""
        return " ".join(["c4s analyze", self.study, *(f"-a {agent}" for agent in self.agents)])

    @property
    def methods(self) -> list[str]:
        """How its intervals were made, or why there are none."""
        return [method_of(one) for one in self.findings.intervals]

    def table(self, name: str) -> Table | None:
        """One of its tables; None where it has no rows or is not there."""
        return next((table for table in self.findings.tables if table.name == name and table.rows), None)

    def rows(self, name: str) -> list[Row]:
        """The rows of one of its tables."""
        table = self.table(name)
        return [] if table is None else [dict(row) for row in table.rows]


@dataclass
class Studies:
    """Asks each study once of each leaderboard."""

    warehouse: Path
    _known: dict[tuple[str, ...], Answer] = field(default_factory=dict)

    def answer(self, board: Board, name: str) -> Answer:
        """A study's answer with its own options."""
        study = study_named(name)
        key = (repr(board.scope), name)
        if key not in self._known:
            try:
                made = Answer(name, study.title, result=result_of(self.warehouse, study, board.scope))
            except BadInput as error:
                made = Answer(name, study.title, refusal=error.line())
            self._known[key] = made
        return self._known[key]

    def pairs(self, board: Board, agents: Sequence[str]) -> list[Answer]:
        """The paired differences of every two complete configurations, the first of ``agents`` less the second."""
        study = study_named("paired")
        asked = list(combinations(agents, 2))
        options = [StudyOptions(agents=list(pair)) for pair in asked]
        made = results_of(self.warehouse, study, board.scope, options)
        return [Answer(study.name, study.title, pair, one) for pair, one in zip(asked, made, strict=True)]


@dataclass(frozen=True)
class Cell:
    """A value of a table, as it is shown."""

    text: str
    key: Value
    """What rows are sorted by."""
    number: bool
    """Whether it is one, or stands for one that is not known."""
    mark: str = ""
    """``best``, ``second`` or nothing."""
    shade: str = ""
    value: float | None = None
    """Of a share or score, in [0, 1]."""
    low: float | None = None
    high: float | None = None
    ends: str = ""
    """Its interval as it is shown."""


@dataclass(frozen=True)
class Grid:
    """A table as it is shown: ends of intervals are in the cell of what they are of."""

    name: str
    title: str
    columns: list[Column]
    rows: list[list[Cell]]

    @property
    def heads(self) -> list[tuple[Column, bool]]:
        """Columns, and whether they hold numbers."""
        return [(column, any(row[place].number for row in self.rows)) for place, column in enumerate(self.columns)]


def grid(
    table: Table,
    *,
    columns: Sequence[str] = (),
    heat: bool = False,
    order: Sequence[str] = (),
    where: Callable[[Row], bool] = lambda row: True,
) -> Grid:
    """A table as pages show it.

    Args:
        table: of a study.
        columns: which are shown, in this order; without any all but the ends of intervals.
        heat: whether shares are shaded.
        order: of configurations; without any as the study has them.
        where: which rows are shown. Marks are by all rows.
    """
    known = {column.name: column for column in table.columns}
    chosen = [known[name] for name in columns] if columns else [one for one in table.columns if not _is_end(one, known)]
    marked = {column.name: marks(table, column) for column in chosen}
    rows = [
        [_cell(row, column, marked[column.name][place], heat) for column in chosen]
        for place, row in sorted(enumerate(table.rows), key=lambda one: _rank(one[1], order))
        if where(dict(row))
    ]
    return Grid(table.name, table.title, chosen, rows)


def _rank(row: Row, order: Sequence[str]) -> int:
    name = row.get("configuration")
    return order.index(name) if name in order else len(order)


def _is_end(column: Column, known: dict[str, Column]) -> bool:
    stem, _, end = column.name.rpartition("_")
    return end in ("low", "high") and stem in known


def _cell(row: Row, column: Column, mark: str, heat: bool) -> Cell:
    value = row.get(column.name)
    told = isinstance(value, int | float) and not isinstance(value, bool)
    share = float(value) if isinstance(value, int | float) and told and column.unit in SHARES else None
    low, high = (_number(row.get(f"{column.name}_{end}")) for end in ("low", "high"))
    shown = "–" if value is None else str(printed(value, column))
    shade = step(share) if heat else ""
    ends = "" if low is None or high is None else f"{printed(low, column)} to {printed(high, column)}"
    if share is not None:
        ends = ends.replace(" to ", "–")
    number = told or (value is None and bool(column.unit or column.decimals))
    return Cell(shown, value, number, mark, shade, share, low, high, ends)


def _number(value: Value) -> float | None:
    return float(value) if isinstance(value, int | float) else None
