"""A home with a run whose scenes pages show in three dimensions: two baselines on a repair and a text of the flat."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Final

from tests.run.conftest import build_small

REPAIR: Final = "indoor-flat-01-mirrored-bath"
TEXT: Final = "text-flat-family"
AGENTS: Final = ("planner", "random")


def make_home(home: Path) -> None:
    """Build the suite, run it, and write its pages."""
    build_small(home)
    chosen = [word for name in AGENTS for word in ("-a", name)] + ["-c", REPAIR, "-c", TEXT]
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", *chosen, "--run-id", "seen", "--json"],
        env={**os.environ, "C4S_HOME": str(home)},
        text=True,
        capture_output=True,
        timeout=280,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["ran"] == len(AGENTS) * 2


def page_of(home: Path, case_id: str) -> Path:
    """The page of a case."""
    (page,) = (home / "site" / "cases").glob(f"*--{case_id}--*.html")
    return page
