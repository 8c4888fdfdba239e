"""``python -m bench.reproduction FOLDER [--all] [--json]``: the paper's printed numbers, and ours."""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from bench.reproduction.book import Book
from bench.reproduction.figure import Figure
from bench.reproduction.figures import figures

_COLUMNS = ("check", "figure", "published", "ours", "status", "note")
_WIDEST = 60


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the table; 1 where a number stands otherwise than the reference tells."""
    parser = argparse.ArgumentParser(prog="python -m bench.reproduction", description=__doc__)
    parser.add_argument("folder", type=Path, help="folder of the restated values")
    parser.add_argument("--all", action="store_true", help="those that are exact too")
    parser.add_argument("--json", action="store_true", help="rows as JSON")
    given = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as scratch:
        book = Book.of(given.folder, Path(scratch))
        found = figures(book)
    shown = found if given.all else [figure for figure in found if figure.status != "exact"]
    if given.json:
        print(json.dumps([asdict(figure) for figure in shown], indent=1))
    else:
        print(_table(shown))
        print(", ".join(f"{status} {count}" for status, count in Counter(figure.status for figure in found).items()))
    return 0 if [figure.status for figure in found] == list(book.checks["status"]) else 1


def _table(found: Sequence[Figure]) -> str:
    lines = [_COLUMNS, *(tuple(_short(cell) for cell in asdict(figure).values()) for figure in found)]
    widths = [max(len(line[column]) for line in lines) for column in range(len(_COLUMNS))]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines
    )


def _short(text: str) -> str:
    return text if len(text) <= _WIDEST else f"{text[: _WIDEST - 1]}…"


if __name__ == "__main__":
    sys.exit(main())
