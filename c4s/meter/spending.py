"""What a run has spent, shared by all processes that work on it: an append-only file under a lock.

A request is entered before it is sent, with an estimate (a hold), and settled when its cost is known. A request whose
cost stays unknown, and one whose process died, keep their hold as their cost: the limit errs towards stopping early.
A run is stopped when settled costs and open holds reach the limit, so it can pass the limit by one request of each
process that was admitted below it, and by what other machines spent since their files were fetched, where machines
share an object store. The file is part of the run folder: a resumed run goes on from what was spent.
"""

from __future__ import annotations

import fcntl
import json
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from c4s.errors import MachineryFault
from c4s.files import add_line


class SpendingLimitReached(MachineryFault):
    """The run may spend no more on models. The trial stays pending."""


@dataclass(frozen=True)
class Spent:
    """US dollars spent by a run: settled, held for open or unsettled requests, and how many have no known cost."""

    settled_usd: float
    held_usd: float
    unknown: int

    @property
    def total_usd(self) -> float:
        """What counts against the limit."""
        return self.settled_usd + self.held_usd


class _Book:
    """The sums over one spending file, read as it grows."""

    def __init__(self) -> None:
        self._offset = 0
        self._held: dict[str, float] = {}
        self._settled, self._unknown = 0.0, 0

    def sums(self) -> Spent:
        """What was read so far adds up to."""
        return Spent(self._settled, sum(self._held.values()), self._unknown)

    def read(self, lines: BinaryIO) -> None:
        """Take in the whole lines that were added."""
        lines.seek(self._offset)
        added = lines.read()
        whole = added[: added.rfind(b"\n") + 1]
        self._offset += len(whole)
        for line in whole.splitlines():
            self._take(line)

    def _take(self, line: bytes) -> None:
        """One entry. A line that a crash cut short says nothing; what it would have settled stays held."""
        try:
            entry = json.loads(line)
        except ValueError:
            return
        if "hold" in entry:
            self._held[entry["hold"]] = entry["usd"] or 0.0
        elif entry["usd"] is None:
            self._unknown += 1
        else:
            self._settled += entry["usd"]
            self._held.pop(entry["settle"], None)


class Ledger:
    """The spending file of a run. Safe for threads and processes.

    Args:
        path: the file of this machine, or of all that share its folder.
        limit_usd: what the run may spend; None for no limit.
        elsewhere: folder with a folder for each machine that has a spending file of its own, as it was last fetched.
    """

    def __init__(self, path: Path, limit_usd: float | None, elsewhere: Path | None = None) -> None:
        self.path, self.limit_usd, self._elsewhere = path, limit_usd, elsewhere
        self._own = _Book()
        self._others: dict[Path, _Book] = {}

    @property
    def begun(self) -> bool:
        """Whether any machine has spent on models."""
        return self.path.is_file() or any(self._files_elsewhere())

    def hold(self, estimate_usd: float | None) -> str | None:
        """Enter a request: its entry, or None when the limit is reached or the estimate is unknown under a limit."""
        with self._opened() as lines:
            if self.limit_usd is not None and (estimate_usd is None or self._sums().total_usd >= self.limit_usd):
                return None
            entry = uuid.uuid4().hex
            add_line(lines, json.dumps({"hold": entry, "usd": estimate_usd}).encode())
            return entry

    def settle(self, entry: str, cost_usd: float | None) -> None:
        """Enter what the request cost; None keeps the hold as its cost."""
        with self._opened() as lines:
            add_line(lines, json.dumps({"settle": entry, "usd": cost_usd}).encode())

    def spent(self) -> Spent:
        """The sums over the files."""
        if not self.begun:
            return Spent(0.0, 0.0, 0)
        with self._opened():
            return self._sums()

    def _sums(self) -> Spent:
        for path in self._files_elsewhere():
            with path.open("rb") as lines:
                self._others.setdefault(path, _Book()).read(lines)
        books = [self._own.sums(), *(book.sums() for book in self._others.values())]
        return Spent(
            sum(book.settled_usd for book in books),
            sum(book.held_usd for book in books),
            sum(book.unknown for book in books),
        )

    def _files_elsewhere(self) -> list[Path]:
        return [] if self._elsewhere is None else sorted(self._elsewhere.glob(f"*/{self.path.name}"))

    @contextmanager
    def _opened(self) -> Iterator[BinaryIO]:
        """The file under its lock, read to its end."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        with self.path.open("ab+") as lines:
            fcntl.flock(lines, fcntl.LOCK_EX)
            self._own.read(lines)
            yield lines
