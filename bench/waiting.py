"""Waiting for what another process does, and says nothing of."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable
from typing import Any, Final, TypeVar

PAUSE_S: Final = 0.005
LONGEST_PAUSE_S: Final = 0.1
PART: Final = 0.05
"""Of the time that was waited: so long a pause is, so that asking takes little beside what is waited for."""
T = TypeVar("T")


def until(
    happens: Callable[[], T | None], process: subprocess.Popen[Any] | None = None, pause_s: float | None = None
) -> T:
    """What a question answers, as soon as it does: None and False are no answer. It is asked without end: its caller
    has a time limit.

    Args:
        happens: the question.
        process: who is expected to bring it about: ``RuntimeError`` where it has ended before.
        pause_s: between two questions. By default it grows from ``PAUSE_S`` to ``LONGEST_PAUSE_S``: what is true for a
            moment alone may be missed.
    """
    begun = time.monotonic()
    while True:
        over = process is not None and process.poll() is not None
        answer = happens()
        if answer is not None and answer is not False:
            return answer
        if over:
            raise RuntimeError(f"the process ended before it happened: {getattr(process, 'args', '')}")
        grown = min(LONGEST_PAUSE_S, max(PAUSE_S, PART * (time.monotonic() - begun)))
        time.sleep(grown if pause_s is None else pause_s)
