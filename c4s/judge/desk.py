"""What a judge works with beside the evidence: where it stores what it asks, what it may spend, when it has to stop."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from c4s.meter.spending import Ledger


def _wait(seconds: float) -> bool:
    threading.Event().wait(seconds)
    return False


@dataclass(frozen=True)
class Desk:
    """The defaults are those of a judge that is asked by hand: nothing is stored, no limit is kept."""

    exchanges: Path | None = None
    """Folder for requests and answers, files by their digest."""
    ledger: Ledger | None = None
    """What the run's judge spent, with its limits."""
    accept_faults: bool = False
    """Whether a request that fails for good becomes an error on record instead of a fault."""
    fresh: bool = False
    """Whether every request is made anew: the cache is neither read nor written."""
    answers: Path | None = None
    """Folder of the answers of this judging alone, which goes on with them when it was killed; all are kept, those that
    break their contract too."""
    wait: Callable[[float], bool] = _wait
    """Waits some seconds; True where the run takes no more work."""
