"""What the pages of one build share: the warehouse, its leaderboards, the folder they are written to."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Final, TypeVar

from c4s.files import digest, digest_bytes, json_text
from reports.frame import asked
from reports.frame.board import Board, Row, boards
from reports.frame.studies import Answer, Studies
from warehouse.stamps import CaseKey, case_stamps

AT_ONCE: Final = 16
"""Cases whose rows and pictures are read together: some tens of MB."""

Found = TypeVar("Found")


@dataclass(frozen=True)
class SitePicture:
    """A picture on the site."""

    file: str
    """Path below the site, named by its digest."""
    view: str
    width: int
    height: int
    brightness: float | None = None
    """Mean of its grey values, in [0, 1]."""


@dataclass
class SiteContext:
    """What pages are made of; nothing is asked twice of the warehouse."""

    warehouse: Path
    folder: Path
    """Where the pages are being written."""
    _put: set[str] = field(default_factory=set)
    _latest: tuple[tuple[str, ...], Any] | None = None
    _pictures: dict[tuple[str, str, str], dict[tuple[str, str], list[SitePicture]]] = field(default_factory=dict)

    @cached_property
    def boards(self) -> list[Board]:
        """The leaderboards of the latest build of each suite, in one order on every page."""
        return boards(self.warehouse)

    @cached_property
    def studies(self) -> Studies:
        """Answers of studies, asked once a build."""
        return Studies(self.warehouse)

    def answer(self, board: Board, study: str) -> Answer:
        """What a study says of a leaderboard."""
        return self.studies.answer(board, study)

    def put_data(self, name: str, data: Any) -> str:
        """Put data beside pages as a classic script, ``c4s.put(<name>, <data>)``; returns its path."""
        told = json_text(data, indent=None).replace("<", "\\u003c")
        body = f"c4s.put({json_text(name, indent=None)}, {told});\n".encode()
        return self.put(f"data/{name}-{digest_bytes(body)[:12]}.js", body)

    @cached_property
    def stamps(self) -> dict[CaseKey, str]:
        """Digests of what the warehouse holds of each case."""
        return case_stamps(self.warehouse)

    def put(self, path: str, data: bytes) -> str:
        """Put a file on the site, which is there already where its name tells its content; returns its path."""
        if not (self.folder / path).is_file():
            (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / path).write_bytes(data)
        self._put.add(path)
        return path

    def latest(self, key: tuple[str, ...], make: Callable[[], Found]) -> Found:
        """What was made of the key, where it was the last one that was asked for; else made now."""
        if self._latest is None or self._latest[0] != key:
            self._latest = key, make()
        found: Found = self._latest[1]
        return found

    @contextmanager
    def putting(self) -> Iterator[set[str]]:
        """Collects the paths that ``put`` is given."""
        kept, self._put = self._put, set()
        try:
            yield self._put
        finally:
            self._put = kept

    def pictures(self, board: Board, case_id: str) -> dict[tuple[str, str], list[SitePicture]]:
        """Pictures of a case by (trial, role), put on the site; those of the case itself have no trial."""
        if (board.suite, board.suite_digest, case_id) not in self._pictures:
            self._read_pictures(board, case_id)
        found = self._pictures[board.suite, board.suite_digest, case_id]
        self._put |= {picture.file for pictures in found.values() for picture in pictures}
        return found

    def _read_pictures(self, board: Board, case_id: str) -> None:
        """Those of the cases that stand beside it too: a question of pictures looks at the parts of all trials."""
        chosen = self.beside(board, case_id)
        for one in chosen:
            self._pictures[board.suite, board.suite_digest, one] = defaultdict(list)
        for row in asked.pictures(self.warehouse, board, chosen):
            pictures = self._pictures[board.suite, board.suite_digest, row["case_id"]]
            pictures[row["trial_id"], row["role"]].append(self._save(row))

    def beside(self, board: Board, case_id: str) -> list[str]:
        """The cases that are read together with this one, itself among them."""
        cases = [case["case_id"] for case in board.cases]
        first = cases.index(case_id) // AT_ONCE * AT_ONCE
        return cases[first : first + AT_ONCE]

    def thumbnail(self, board: Board, case_id: str, trial_id: str) -> SitePicture | None:
        """The first picture of a submission; None where there is none."""
        return next(iter(self.pictures(board, case_id).get((trial_id, "submission"), [])), None)

    def _save(self, row: Row) -> SitePicture:
        name = self.put(f"pictures/{digest_bytes(row['jpeg'])[:20]}.jpg", row["jpeg"])
        return SitePicture(name, row["view"], row["width"], row["height"], row["brightness"])

    def stamp(self, board: Board | None = None, case_id: str | None = None) -> str:
        """Digest of what the warehouse holds: all of it, of a board, or of one case of a board."""
        if board is None:
            return digest(sorted([*key, told] for key, told in self.stamps.items()))
        build = (board.suite, board.suite_digest)
        cases = [case for *of, case in self.stamps if tuple(of) == build] if case_id is None else [case_id]
        shared = self.stamps.get(("", "", ""), "")
        return digest([board.title, board.order, shared, [[case, self.stamps[*build, case]] for case in sorted(cases)]])
