"""The editor's log: lines with their time, frame and category, on standard output and in a file."""

from __future__ import annotations

import io
import os
import threading
from datetime import UTC, datetime
from pathlib import Path
from typing import TextIO

from c4s.engine.headless.log import EngineLog


class EditorLog(EngineLog):
    """Writes as an editor does: ``[2026.11.23-08.00.00:123][  0]LogPython: Warning: text``."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        file.parent.mkdir(parents=True, exist_ok=True)
        self._file = file.open("a", encoding="utf-8", errors="backslashreplace")
        self._output = os.dup(1)
        self._lock = threading.Lock()
        self.frame = 0

    def write(self, category: str, text: str, severity: str = "Display") -> None:
        """One line; ``Display`` is not written out, as in an editor."""
        now = datetime.now(UTC)
        mark = "" if severity == "Display" else f"{severity}: "
        stamp = f"[{now:%Y.%m.%d-%H.%M.%S}:{now.microsecond // 1000:03}][{self.frame % 1000:3}]"
        line = f"{stamp}{category}: {mark}{text}\n"
        with self._lock:
            self._file.write(line)
            self._file.flush()
            os.write(self._output, line.encode("utf-8", "backslashreplace"))

    def _emit(self, severity: str, text: str) -> None:
        self.lines.append((severity, text))
        self.write("LogPython", text, severity)


class LogStream(io.TextIOBase):
    """What Python's output is in an editor: lines of its log."""

    def __init__(self, log: EditorLog, severity: str) -> None:
        super().__init__()
        self._log, self._severity, self._held = log, severity, ""

    def write(self, text: str) -> int:
        """Log the lines that are whole."""
        *whole, self._held = (self._held + text).split("\n")
        for line in whole:
            self._log.write("LogPython", line, self._severity)
        return len(text)

    def writable(self) -> bool:
        """It is."""
        return True


def streams(log: EditorLog) -> tuple[TextIO, TextIO]:
    """Standard output and error of Python in an editor."""
    return LogStream(log, "Display"), LogStream(log, "Error")  # type: ignore[return-value]
