"""The engine's log: every line goes to standard output, in order with what scripts print."""

from __future__ import annotations


class EngineLog:
    """Lines with their severity (``Display``, ``Warning``, ``Error``), kept and printed."""

    def __init__(self) -> None:
        self.lines: list[tuple[str, str]] = []

    def _emit(self, severity: str, text: str) -> None:
        self.lines.append((severity, text))
        print(text if severity == "Display" else f"{severity}: {text}", flush=True)

    def display(self, text: str) -> None:
        """An ordinary line."""
        self._emit("Display", text)

    def warning(self, text: str) -> None:
        """A warning."""
        self._emit("Warning", text)

    def error(self, text: str) -> None:
        """An error."""
        self._emit("Error", text)
