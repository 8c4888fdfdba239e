"""A home where baselines played: real trials with calls, judgements, scenes, zeros and second attempts."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Final

from tests.run.conftest import apart

REPAIR: Final = "indoor-flat-01-mirrored-bath"
TEXT: Final = "text-flat-family"
AGENTS: Final = ("planner", "random", "vandal", "oracle")
RUN: Final = "seen"


def play(home: Path, small: Path) -> None:
    """Run the agents on a text and a repair of the suite in the home ``small``, in a home apart from it."""
    apart(home, small)
    chosen = [word for name in AGENTS for word in ("-a", name)] + ["-c", REPAIR, "-c", TEXT]
    subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", *chosen, "--run-id", RUN, "--json"],
        env={**os.environ, "C4S_HOME": str(home), "COLUMNS": "140"},
        check=True,
        timeout=280,
        capture_output=True,
    )


def page_of(home: Path, case_id: str) -> Path:
    """The page of a case."""
    (page,) = (home / "site" / "cases").glob(f"*--{case_id}--*.html")
    return page
