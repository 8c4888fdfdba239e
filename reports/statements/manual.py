"""The warehouse's tables and questions as the data page shows them, with answers where they may be shown."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from warehouse.database import ask, rows
from warehouse.manual import EXAMPLES, ToldColumn, told_columns, told_table
from warehouse.records import TABLES

MOST_ROWS: Final = 8
"""Rows of an answer that are shown."""


@dataclass(frozen=True)
class ManualAnswer:
    """What the warehouse answered to an example."""

    columns: list[str]
    rows: list[tuple[Any, ...]]
    more: int
    """Rows that are not shown."""


@dataclass(frozen=True)
class ManualTable:
    """A table of the warehouse."""

    name: str
    about: str
    columns: list[ToldColumn]
    sql: str
    count: int | None
    """Rows; None, as the answer, where private cases are in the warehouse: they would tell of them."""
    answer: ManualAnswer | None


def has_private(warehouse: Path) -> bool:
    """Whether a private case is planned or done in the warehouse."""
    return bool(rows(warehouse, "SELECT 1 FROM schedule WHERE visibility <> 'public' LIMIT 1"))


def manual_tables(warehouse: Path) -> list[ManualTable]:
    """Every table, in the manual's order."""
    hide = has_private(warehouse)
    return [
        ManualTable(
            name=name,
            about=told_table(name).replace("``", ""),
            columns=told_columns(name),
            sql=EXAMPLES[name],
            count=None if hide else int(rows(warehouse, f"SELECT count(*) AS count FROM {name}")[0]["count"]),
            answer=None if hide else _answer(warehouse, EXAMPLES[name]),
        )
        for name in TABLES
    ]


def _answer(warehouse: Path, sql: str) -> ManualAnswer:
    columns, found = ask(warehouse, sql)
    return ManualAnswer(columns, found[:MOST_ROWS], max(0, len(found) - MOST_ROWS))
