"""The file that answers of people are added to: one writer, a line an answer, on the disk before anybody is thanked."""

from __future__ import annotations

import errno
import fcntl
import os
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from c4s.errors import BadInput
from c4s.files import canonical_json, read_json_lines

ANSWERS = "file of answers"


class AnswerLog:
    """An open file of answers; nobody else can open it as long. Use it as a context manager."""

    def __init__(self, path: Path) -> None:
        """``BadInput`` where another server has it open, or it holds what is no answer."""
        path.parent.mkdir(parents=True, exist_ok=True)
        self._path = path
        self._file = path.open("ab+", buffering=0)
        try:
            self._lock()
            self._mend()
            self.rows = read_json_lines(path, what=ANSWERS)
        except BaseException:
            self._file.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._file.close()

    def add(self, row: dict[str, Any]) -> None:
        """Add an answer. When this returns it is on the disk; when it raises, it is not in the file."""
        end = self._file.seek(0, os.SEEK_END)
        line = canonical_json(row).encode() + b"\n"
        try:
            if self._file.write(line) != len(line):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(self._path))
            os.fsync(self._file.fileno())
        except OSError:
            self._file.truncate(end)
            raise
        self.rows.append(row)

    def _lock(self) -> None:
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise BadInput(
                "another server takes answers here", where=str(self._path), todo="use its links, or end it"
            ) from None

    def _mend(self) -> None:
        """Take away a last line without an end: a crash cut it off, and nobody was told that it was kept."""
        whole = self._path.read_bytes().rfind(b"\n") + 1
        if whole < self._path.stat().st_size:
            self._file.truncate(whole)
            os.fsync(self._file.fileno())
