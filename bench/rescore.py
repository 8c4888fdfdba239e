"""Scoring 2,000 stored trials again under another policy: trials per minute, reading included."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

from bench.row import Row
from bench.scored_run import make_run
from c4s.score.policies import POLICIES
from c4s.score.rescore import rescore

_TRIALS, _GOAL = 2000, 10_000


def rows() -> list[Row]:
    """One pass over a made run folder under the strict tolerances."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder) / "made"
        make_run(root, _TRIALS)
        began = time.perf_counter()
        report = rescore(root, POLICIES["strict-tolerance"]).report()
        seconds = time.perf_counter() - began
    rate = 60 * report["trials"] / seconds
    return [
        Row(
            f"re-scoring stored trials ({report['trials']} timed)",
            rate,
            f"{_GOAL:,} per minute",
            rate >= _GOAL,
            unit="trials/min",
        )
    ]
