"""The journals of a run: written by those who work on it, read by those who watch it."""

from __future__ import annotations

import heapq
import os
import re
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import orjson

from c4s.records.folder import RunFolder
from c4s.records.journal import Event
from c4s.records.lease import Owner
from c4s.run.owner import this_process


def now() -> float:
    """Unix time, seconds: the millisecond that has begun."""
    return int(time.time() * 1000) / 1000


def process_name(owner: Owner) -> str:
    """A file name for a process, its own on all machines."""
    return f"{re.sub('[^A-Za-z0-9.-]', '-', owner.host)[:60]}-{owner.pid}-{owner.started_ticks}"


class Journal:
    """This process's journal of a run. Each line is one write: a reader never sees a part of two."""

    def __init__(self, run: RunFolder) -> None:
        run.journals.mkdir(parents=True, exist_ok=True)
        self.owner = this_process()
        self.path = run.journals / f"{process_name(self.owner)}.jsonl"
        self._file = os.open(self.path, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o644)

    def __call__(self, event: Event) -> None:
        """Append a line."""
        os.write(self._file, event.line_of_file())

    def close(self) -> None:
        """No line comes any more."""
        os.close(self._file)


class Tail:
    """Reads the whole lines that were appended to a run's journals, of all machines, since the last time."""

    def __init__(self, run: RunFolder) -> None:
        self._run = run
        self._offsets: dict[Path, int] = {}

    def read(self) -> Iterator[tuple[Path, dict[str, Any]]]:
        """New lines as plain data, each with the journal that it stands in, in the order of their times.

        A line that is no event is skipped: nobody but c4s writes here, and what a full disk cut off is worth no answer.
        """
        others = self._run.elsewhere.glob(f"*/{self._run.journals.name}/*.jsonl")
        files = [self._grown(path) for path in sorted((*self._run.journals.glob("*.jsonl"), *others))]
        return heapq.merge(*files, key=lambda found: found[1]["time"])

    def _grown(self, path: Path) -> Iterator[tuple[Path, dict[str, Any]]]:
        offset = self._offsets.get(path, 0)
        if path.stat().st_size <= offset:
            return
        with path.open("rb") as source:
            source.seek(offset)
            data = source.read()
        end = data.rfind(b"\n") + 1
        self._offsets[path] = offset + end
        for line in data[:end].splitlines():
            try:
                event = orjson.loads(line)
            except ValueError:
                continue
            if isinstance(event, dict) and isinstance(event.get("time"), float | int):
                yield path, event
