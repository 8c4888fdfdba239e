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

UNPRICED = "add it to C4S_HOME/prices.yaml (docs/agents.md), or give --judge-tokens in place of --judge-spend"
"""What to do where a limit in dollars meets a model without a price."""


class SpendingLimitReached(MachineryFault):
    """The run may spend no more on models. The trial stays pending."""


@dataclass(frozen=True)
class Spent:
    """US dollars spent by a run: settled, held for open or unsettled requests, and how many have no known cost."""

    settled_usd: float
    held_usd: float
    unknown: int
    tokens: int = 0
    """Of the requests that tell theirs, and what was assumed of the others; where the file's requests are counted
    so."""
    held_tokens: int = 0
    """Those of ``tokens`` that are assumed of requests that have not told theirs yet."""

    @property
    def total_usd(self) -> float:
        """What counts against the limit."""
        return self.settled_usd + self.held_usd

    def told(self) -> str:
        """In words, what is assumed of open requests apart from what was used."""
        used = f"{self.settled_usd:.4f} USD, {self.tokens - self.held_tokens} tokens"
        if not self.held_usd and not self.held_tokens:
            return used
        return f"{used}, and up to {self.held_usd:.4f} USD, {self.held_tokens} tokens of requests not yet accounted for"


class _Book:
    """The sums over one spending file, read as it grows."""

    def __init__(self) -> None:
        self._offset = 0
        self._held: dict[str, float] = {}
        self._settled, self._unknown = 0.0, 0
        self._tokens, self._held_tokens = 0, dict[str, int]()

    def sums(self) -> Spent:
        """What was read so far adds up to."""
        held_tokens = sum(self._held_tokens.values())
        return Spent(self._settled, sum(self._held.values()), self._unknown, self._tokens, held_tokens)

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
            self._held_tokens[entry["hold"]] = assumed = entry.get("tokens") or 0
            self._tokens += assumed
            return
        assumed = self._held_tokens.pop(entry["settle"], 0)
        told = entry.get("tokens")
        self._tokens += 0 if told is None else told - assumed
        if entry["usd"] is None:
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
        limit_tokens: how many tokens the run may use; None for no limit.
    """

    def __init__(
        self, path: Path, limit_usd: float | None, elsewhere: Path | None = None, *, limit_tokens: int | None = None
    ) -> None:
        self.path, self.limit_usd, self.limit_tokens, self._elsewhere = path, limit_usd, limit_tokens, elsewhere
        self._own = _Book()
        self._others: dict[Path, _Book] = {}

    @property
    def begun(self) -> bool:
        """Whether any machine has spent on models."""
        return self.path.is_file() or any(self._files_elsewhere())

    def hold(self, estimate_usd: float | None, tokens: int = 0) -> str | None:
        """Enter a request: its entry, or None when a limit is reached or the estimate is unknown under one in dollars.

        ``tokens`` is what it is assumed to use.
        """
        with self._opened() as lines:
            unlimited = self.limit_usd is None and self.limit_tokens is None
            if not unlimited and self._reached(self._sums(), estimate_usd):
                return None
            entry = uuid.uuid4().hex
            counted = {"tokens": tokens} if tokens else {}
            add_line(lines, json.dumps({"hold": entry, "usd": estimate_usd, **counted}).encode())
            return entry

    def _reached(self, spent: Spent, estimate_usd: float | None) -> bool:
        if self.limit_tokens is not None and spent.tokens >= self.limit_tokens:
            return True
        return self.limit_usd is not None and (estimate_usd is None or spent.total_usd >= self.limit_usd)

    def settle(self, entry: str, cost_usd: float | None, tokens: int | None = None) -> None:
        """Enter what the request cost and used; None keeps what was held."""
        counted = {} if tokens is None else {"tokens": tokens}
        with self._opened() as lines:
            add_line(lines, json.dumps({"settle": entry, "usd": cost_usd, **counted}).encode())

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
            sum(book.tokens for book in books),
            sum(book.held_tokens for book in books),
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
