"""Printing results: JSON for programs, tables and lines for people. Nothing is printed but here.

What is printed may come from anybody: a label, a pack, an answer of a model. People are shown it with every character
that is not visible written as its escape, and brackets in it are no markup.
"""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from c4s.errors import BadInput
from c4s.names import shown

PLAIN_COLUMNS = 160
"""Width of output that goes to a file or a pipe and not to a terminal."""
NARROW_TEXT, NARROW_NAME = 12, 5
"""The least width of a column of texts, and of any column for its name."""
console = Console(width=None if sys.stdout.isatty() or "COLUMNS" in os.environ else PLAIN_COLUMNS)
progress_console = Console(stderr=True)
"""Progress goes to standard error, so that output can be piped."""


def check_new_file(path: Path) -> None:
    """``BadInput`` for a file that cannot be written: its folder is not there, or it is a folder itself."""
    if path.is_dir():
        raise BadInput("this is a folder", where=str(path), todo="name a file")
    if not path.parent.is_dir():
        raise BadInput("no such folder", where=str(path.parent), todo="make it, or name a file elsewhere")


def print_json(value: Any) -> None:
    """One JSON value on standard output."""
    text = json.dumps(value, ensure_ascii=False, default=str)
    print(text if text.isprintable() else re.sub(r"[^ -~]", _json_escape, text), flush=True)


def _json_escape(found: re.Match[str]) -> str:
    one = found.group()
    return one if one.isprintable() else json.dumps(one)[1:-1]


def say(text: str, *, style: str = "") -> None:
    """One line on standard output."""
    if style:
        console.print(Text(shown(text)), style=style, soft_wrap=True)
    else:
        print(shown(text), flush=True)


def draw(on: Console, text: Text) -> None:
    """A text with styles of its own, whose words went through ``shown``."""
    on.print(text, soft_wrap=True)


def cell(value: Any) -> str:
    """A value as people read it: three decimals, an empty cell for nothing."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.3f}" if isinstance(value, float) else shown(str(value), keep="\n")


def print_table(columns: Sequence[str], rows: Sequence[Sequence[Any]], *, title: str = "") -> None:
    """A table; numbers are right-aligned, and what stands in a cell is text: brackets in it mean nothing.

    Where the columns do not fit side by side, each row is a block with a line a column.
    """
    table = Table(
        title=Text(shown(title)) if title else None,
        title_justify="left",
        header_style="bold",
        show_edge=False,
        pad_edge=False,
    )
    width = 3 * (len(columns) - 1)
    for index, column in enumerate(columns):
        numeric = any(isinstance(row[index], int | float) for row in rows)
        widest = max((len(cell(row[index])) for row in rows), default=0)
        narrowest = widest if numeric else min(widest, NARROW_TEXT)
        table.add_column(
            Text(shown(column)), justify="right" if numeric else "left", overflow="fold", min_width=narrowest
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
        console.print(Text(shown(title), style="bold"))
    for row in rows:
        block = Table.grid(padding=(0, 2))
        for column, value in zip(columns, row, strict=True):
            block.add_row(Text(shown(column), style="bold"), Text(cell(value)))
        console.print(block, Text(""))


def grouped(rows: Sequence[dict[str, str]], key: str, name: str) -> dict[str, list[str]]:
    """The names of rows by what they have in common."""
    found: dict[str, list[str]] = {}
    for row in rows:
        found.setdefault(row[key], []).append(row[name])
    return found
