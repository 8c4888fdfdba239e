"""JSON-lines files for the batch commands: plain or gzip, one row in, one line out."""

from __future__ import annotations

import gzip
import json
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from c4s.errors import BadInput


def read_rows(path: Path) -> Iterator[dict[str, Any]]:
    """Rows of a JSON-lines file, gzip or not. ``BadInput`` names the first line that is no object."""
    if not path.is_file():
        raise BadInput("no such file", where=str(path))
    with path.open("rb") as raw:
        zipped = raw.read(2) == b"\x1f\x8b"
    opened: Any = gzip.open if zipped else open
    try:
        with opened(path, "rt", encoding="utf-8") as lines:
            for number, line in enumerate(lines, start=1):
                if line.strip():
                    row = json.loads(line)
                    if not isinstance(row, dict):
                        raise BadInput("not a JSON object", where=f"{path}:{number}")
                    yield row
    except (ValueError, EOFError, OSError) as error:
        raise BadInput(f"not JSON lines: {error}", where=str(path)) from None


def write_rows(path: Path, verify: Callable[[Iterable[dict[str, Any]]], Iterator[dict[str, Any]]]) -> None:
    """Print one JSON line a row of the file."""
    for result in verify(read_rows(path)):
        sys.stdout.write(json.dumps(result, ensure_ascii=False) + "\n")
