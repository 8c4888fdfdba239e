"""``python -m bench [NAME ...] [--json]``: run the benchmarks (all, or those named) and print one table.

A benchmark is a module of this package with ``rows() -> list[Row]``. Ratios are measured in one run on one machine.
"""

from __future__ import annotations

import argparse
import importlib
import json
import pkgutil
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

import bench
from bench.row import Row

_COLUMNS = ("benchmark", "ours", "rival", "rival takes", "ratio", "goal", "met")


def benchmarks() -> Iterator[tuple[str, Any]]:
    """Modules of this package that have rows, by name."""
    for found in pkgutil.iter_modules(bench.__path__):
        if found.name != "__main__":
            module = importlib.import_module(f"bench.{found.name}")
            if hasattr(module, "rows"):
                yield found.name, module


def _cells(row: Row) -> list[str]:
    def amount(value: float | None) -> str:
        return "–" if value is None else f"{value:,.3g} {row.unit}" if value < 1000 else f"{value:,.0f} {row.unit}"

    return [
        row.name,
        amount(row.ours),
        row.rival or "–",
        amount(row.theirs),
        "–" if row.ratio is None else f"{row.ratio:.1f}x",
        row.goal,
        "yes" if row.met else "NO",
    ]


def _table(lines: Sequence[Sequence[str]]) -> str:
    """Columns of equal width; never wrapped, so that it can be pasted and compared."""
    widths = [max(len(cell) for cell in column) for column in zip(*lines, strict=True)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Run and print; 0 when every goal is met, else 1."""
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--json", action="store_true", help="rows as JSON")
    given = parser.parse_args(arguments)
    known = dict(benchmarks())
    unknown = sorted(set(given.names) - set(known))
    if unknown:
        parser.error(f"unknown benchmark {', '.join(unknown)}; known: {', '.join(known)}")
    rows: list[Row] = []
    for name in given.names or known:
        print(f"running {name} ...", file=sys.stderr, flush=True)
        rows += known[name].rows()
    if given.json:
        print(json.dumps([asdict(row) for row in rows], indent=1))
    else:
        print(_table([_COLUMNS, *(_cells(row) for row in rows)]))
    return 0 if all(row.met for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
