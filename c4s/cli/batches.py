"""JSON-lines files for the batch commands: plain or gzip, one row in, one line out. Nothing is held but the row."""

from __future__ import annotations

import gzip
import json
import sys
import zlib
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import no_place

Row = dict[str, Any]


def _lines(path: Path) -> Iterator[bytes]:
    """Lines that are not blank. Raises ``BadInput`` when the file is missing, cut off or no gzip file inside."""
    if not path.is_file():
        raise BadInput("no such file", where=str(path))
    with path.open("rb") as raw:
        opened: Any = gzip.open if raw.read(2) == b"\x1f\x8b" else open
    try:
        with opened(path, "rb") as lines:
            while line := lines.readline(BOUNDS["row_bytes"].most + 1):
                BOUNDS["row_bytes"].hold(len(line), where=str(path))
                if line.strip():
                    yield line
    except (EOFError, OSError, zlib.error) as error:
        told = no_place(error) if isinstance(error, OSError) else str(error)
        raise BadInput(f"cannot read this file to its end: {told}", where=str(path), todo="is it complete?") from None


def read_rows(path: Path) -> Iterator[Row | BadInput]:
    """Rows of a JSON-lines file, gzip or not, one at a time; for a line that is no JSON object, what is wrong."""
    for number, line in enumerate(_lines(path), start=1):
        try:
            row = json.loads(line)
        except (ValueError, RecursionError) as error:
            yield BadInput(f"row {number} is not JSON: {error}")
            continue
        yield row if isinstance(row, dict) else BadInput(f"row {number} is not a JSON object")


def write_rows(path: Path, verify: Callable[[Iterable[Row]], Iterator[Row]]) -> None:
    """Print one JSON line a row of the file, in order, each as soon as it is known."""
    for row in read_rows(path):
        results = [{"name": None, "error": row.line()}] if isinstance(row, BadInput) else verify((row,))
        for result in results:
            sys.stdout.write(json.dumps(result) + "\n")
