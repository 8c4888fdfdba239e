"""Printing results: JSON for programs, tables for people."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Sequence
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

PLAIN_COLUMNS = 160
"""Width of output that goes to a file or a pipe and not to a terminal."""
NARROW_TEXT, NARROW_NAME = 12, 5
"""The least width of a column of texts, and of any column for its name."""
console = Console(width=None if sys.stdout.isatty() or "COLUMNS" in os.environ else PLAIN_COLUMNS)
progress_console = Console(stderr=True)
"""Progress goes to standard error, so that output can be piped."""


def print_json(value: Any) -> None:
    """One JSON value on standard output."""
    print(json.dumps(value, ensure_ascii=False, default=str))


def cell(value: Any) -> str:
    """A value as people read it: three decimals, an empty cell for nothing."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.3f}" if isinstance(value, float) else str(value)


def print_table(columns: Sequence[str], rows: Sequence[Sequence[Any]], *, title: str = "") -> None:
    """A table; numbers are right-aligned, and what stands in a cell is text: brackets in it mean nothing.

    Where the columns do not fit side by side, each row is a block with a line a column.
    """
    table = Table(title=title or None, title_justify="left", header_style="bold", show_edge=False, pad_edge=False)
    width = 3 * (len(columns) - 1)
    for index, column in enumerate(columns):
        numeric = any(isinstance(row[index], int | float) for row in rows)
        widest = max((len(cell(row[index])) for row in rows), default=0)
        narrowest = widest if numeric else min(widest, NARROW_TEXT)
        table.add_column(
            column, justify="right" if numeric else "left", no_wrap=numeric, overflow="fold", min_width=narrowest
        )
        width += max(narrowest, NARROW_NAME)
    if width > console.width:
        _print_blocks(columns, rows, title)
        return
    for row in rows:
        table.add_row(*(Text(cell(value)) for value in row))
    console.print(table)


def _print_blocks(columns: Sequence[str], rows: Sequence[Sequence[Any]], title: str) -> None:
    if title:
        console.print(Text(title, style="bold"))
    for row in rows:
        block = Table.grid(padding=(0, 2))
        for column, value in zip(columns, row, strict=True):
            block.add_row(Text(column, style="bold"), Text(cell(value)))
        console.print(block, Text(""))


def grouped(rows: Sequence[dict[str, str]], key: str, name: str) -> dict[str, list[str]]:
    """The names of rows by what they have in common."""
    found: dict[str, list[str]] = {}
    for row in rows:
        found.setdefault(row[key], []).append(row[name])
    return found
