"""What is kept of a run: ``trajectory.jsonl``, one JSON object a line, and the pictures beside it by their SHA-256."""

from __future__ import annotations

import errno
import os
import time
import weakref
from pathlib import Path
from typing import Any, BinaryIO

import orjson

from c4s.files import digest_bytes, write_bytes
from c4s.toolbox.size import whole


class RunRecord:
    """Appends to a trajectory. Lines are written by one thread, pictures by any."""

    def __init__(self, trajectory: Path) -> None:
        self._trajectory = trajectory
        self._lines = 0
        self._file: BinaryIO | None = None

    def write(self, event: str, tool: str, request: str | None, **fields: Any) -> None:
        """Append one line, numbered and dated; it is in the file, not in a buffer, when this returns.

        A process that is killed afterwards has lost nothing. Raises ``OSError`` when the line cannot be written whole.
        """
        if self._file is None:
            self._trajectory.parent.mkdir(parents=True, exist_ok=True)
            self._file = self._trajectory.open("ab", buffering=0)
            weakref.finalize(self, self._file.close)
        self._lines += 1
        line = orjson.dumps(
            {
                "seq": self._lines,
                "time": round(time.time(), 4),
                "event": event,
                "tool": whole(short(tool)),
                "request": None if request is None else whole(request),
                **fields,
            },
            option=orjson.OPT_APPEND_NEWLINE,
        )
        if self._file.write(line) != len(line):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def keep(self, image: bytes) -> dict[str, Any]:
        """Keep a picture; how the line of its call names it."""
        sha256 = digest_bytes(image)
        path = self._trajectory.parent / "images" / f"{sha256}.png"
        if not path.is_file():
            write_bytes(path, image)
        return {"sha256": sha256, "bytes": len(image)}


NAME_CHARACTERS = 300
"""Longest tool name or request id that is written down as it is."""


def short(name: str) -> str:
    """A name that a client chose, as it is written down: one that is too long by its beginning and its SHA-256."""
    return (
        name
        if len(name) <= NAME_CHARACTERS
        else f"{whole(name[: NAME_CHARACTERS // 2])} ... sha256 {digest_bytes(whole(name).encode())}"
    )
