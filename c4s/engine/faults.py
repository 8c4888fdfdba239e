"""What goes wrong at the seam to an engine, whichever engine it is."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.errors import C4SError, MachineryFault, OverLimit


class EngineCallError(C4SError):
    """A function called in the engine raised: its message, and the name of the exception as ``kind``."""

    def __init__(self, message: str, *, function: str, kind: str) -> None:
        self.kind = kind
        self.detail = message
        super().__init__(message.strip().rpartition("\n")[2] or kind, where=function)


class EngineDied(MachineryFault):
    """The engine process ended by itself, or was ended for what it did.

    ``during`` is the kind of request that it was working on, ``lines`` what the job had printed.
    """

    def __init__(self, what: str, *, during: str, where: str, lines: Sequence[str] = ()) -> None:
        self.during, self.lines = during, list(lines)
        super().__init__(what, where=where)


class EngineOverLimit(EngineDied, OverLimit):
    """The engine process was ended for the memory, threads or files that it took."""
