"""Lines on standard error: text for people, or JSON for a collector of logs where ``C4S_LOG`` is ``json``."""

from __future__ import annotations

import json
import os
import sys
import time
from typing import Any, Final

from c4s.errors import BadInput
from c4s.names import shown

CHOICE: Final = "C4S_LOG"


def as_json() -> bool:
    """Whether standard error takes JSON lines."""
    return os.environ.get(CHOICE, "").strip() == "json"


def check_choice() -> None:
    """``BadInput`` for a ``C4S_LOG`` that is no choice."""
    told = os.environ.get(CHOICE, "").strip()
    if told not in ("", "json"):
        raise BadInput(f"{told!r} is no kind of log", where=CHOICE, todo="set it to json, or unset it")


def json_line(level: str, message: str, at: float, **fields: Any) -> str:
    """A line of a log: ASCII, with everything else escaped. ``at`` is Unix time in seconds."""
    whole = time.strftime("%Y-%m-%dT%H:%M:%S", time.gmtime(at))
    told = {"time": f"{whole}.{int(at % 1 * 1000):03}Z", "level": level, "message": message, **fields}
    return json.dumps(told, default=str)


def tell(text: str, level: str = "info") -> None:
    """One line on standard error, at once."""
    line = json_line(level, text, time.time(), pid=os.getpid()) if as_json() else shown(text)
    print(line, file=sys.stderr, flush=True)
