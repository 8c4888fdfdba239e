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

from c4s.cli.layout import cut_digests, is_numeric, laid_out, widths_of
from c4s.errors import BadInput
from c4s.names import shown
from c4s.numbers import half_up

PLAIN_COLUMNS = 160
"""Width of output that goes to a file or a pipe and not to a terminal."""
EDGE = 2
"""Letters that a table leaves free at its right."""
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


def say_beside(text: str) -> None:
    """One line on standard error, for what goes beside the output of a command."""
    print(shown(text), file=sys.stderr, flush=True)


def draw(on: Console, text: Text) -> None:
    """A text with styles of its own, whose words went through ``shown``."""
    on.print(text, soft_wrap=True)


def cell(value: Any) -> str:
    """A value as people read it: three decimals, an empty cell for nothing."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return half_up(value, 3) if isinstance(value, float) else shown(str(value), keep="\n")


def print_table(columns: Sequence[str], rows: Sequence[Sequence[Any]], *, title: str = "", most: int = 0) -> None:
    """A table; numbers are right-aligned, and what stands in a cell is text: brackets in it mean nothing.

    Where the columns do not fit side by side, they come in groups, each with the columns that tell the rows apart; one
    or two rows are told column by column. No number and no word is folded that has room on a line.

    Args:
        most: rows that are shown; all with 0.
    """
    told = [[cell(value) for value in row] for row in (rows[:most] if most else rows)]
    titles = [shown(column) for column in columns]
    laid = laid_out(titles, told, console.width - EDGE)
    if laid.same or len(laid.groups) > 1:
        told = [cut_digests(row) for row in told]
        laid = laid_out(titles, told, console.width - EDGE)
    if not laid.groups:
        _print_blocks(columns, rows, title)
        return
    for place, group in enumerate(laid.groups):
        if place:
            console.print()
        _print_group(titles, told, [*laid.keys, *group], "" if place else title)
    if len(told) < len(rows):
        say(f"… {len(rows) - len(told):,} more rows")
    if laid.same:
        console.print(Text("In all rows: " + ", ".join(f"{titles[one]} {told[0][one]}" for one in laid.same)))


def _print_group(titles: Sequence[str], rows: Sequence[Sequence[str]], places: Sequence[int], title: str) -> None:
    table = Table(
        title=Text(shown(title), overflow="fold") if title else None,
        title_justify="left",
        header_style="bold",
        show_edge=False,
        pad_edge=False,
    )
    shown_rows = [[row[place] for place in places] for row in rows]
    widths = widths_of([titles[place] for place in places], shown_rows, console.width - EDGE)
    for place, width in zip(places, widths, strict=True):
        right = is_numeric([row[place] for row in rows])
        table.add_column(Text(titles[place]), justify="right" if right else "left", overflow="fold", width=width)
    for row in shown_rows:
        table.add_row(*map(Text, row))
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
