"""The printed output of a job, kept by the host: what is written once can be neither lost nor changed by the engine."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any, BinaryIO

PAGE_BYTES = 4 << 20


class JobLog:
    """A file of a job's output. One thread writes, any reads."""

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self.path = path
        self.size = 0
        """Bytes written so far."""
        self._file: BinaryIO | None = None
        self._lock = threading.Lock()

    def write(self, data: bytes) -> None:
        """Append bytes."""
        with self._lock:
            if self._file is None:
                self._file = self.path.open("ab", buffering=0)
            self._file.write(data)
            self.size += len(data)

    def close(self) -> None:
        """Let go of the file; writing opens it again."""
        with self._lock:
            if self._file is not None:
                self._file.close()
                self._file = None

    def read(self, offset: int, *, complete: bool) -> dict[str, Any]:
        """Whole lines from byte ``offset``: 4 MiB of them, or one line that is longer; the unfinished last line only
        when the log is ``complete``.

        ``next_offset`` is where to read on; ``more`` says that there is more to read now.
        """
        with self._lock:
            size = self.size
        if offset >= size:
            return {"python_logs": [], "next_offset": offset, "more": False}
        data = bytearray()
        with self.path.open("rb") as file:
            file.seek(offset)
            while b"\n" not in data and len(data) < size - offset:
                data += file.read(min(PAGE_BYTES, size - offset - len(data)))
        last = offset + len(data) >= size
        if not (complete and last):
            del data[data.rfind(b"\n") + 1 :]
        text = data.decode("utf-8", "replace")
        lines = text.removesuffix("\n").split("\n") if text else []
        return {"python_logs": lines, "next_offset": offset + len(data), "more": not last}

    def part(self, offset: int | None, most: int) -> dict[str, Any]:
        """At most ``most`` bytes from byte ``offset`` on, or the last ones, as lines, whether they are whole or not.

        As ``read``, with where it begins (``offset``) and how much there is (``log_bytes``).
        """
        with self._lock:
            size = self.size
        start = max(0, size - most) if offset is None else min(offset, size)
        data = b""
        if start < size and most:
            with self.path.open("rb") as file:
                file.seek(start)
                data = file.read(min(most, size - start))
        end = start + len(data)
        lines = data.decode("utf-8", "replace").removesuffix("\n").split("\n") if data else []
        return {"python_logs": lines, "offset": start, "next_offset": end, "more": end < size, "log_bytes": size}

    def tail(self, size: int) -> str:
        """The last ``size`` bytes as text."""
        with self._lock:
            if self.size == 0:
                return ""
        with self.path.open("rb") as file:
            file.seek(max(0, self.size - size))
            return file.read().decode("utf-8", "replace").strip()
