"""``python -m bench`` finds the benchmarks and prints their rows."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from bench.__main__ import benchmarks

ROOT = Path(__file__).parents[2]


def test_a_named_benchmark_gives_rows_and_an_unknown_name_is_bad_usage() -> None:
    assert {"contacts", "repair_f1", "rescore"} <= {name for name, _ in benchmarks()}
    done = subprocess.run(
        [sys.executable, "-m", "bench", "rescore", "--json"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    (row,) = json.loads(done.stdout)
    assert row["unit"] == "trials/min" and row["ours"] > 0 and done.returncode == (0 if row["met"] else 1)
    bad = subprocess.run(
        [sys.executable, "-m", "bench", "nosuch"], cwd=ROOT, capture_output=True, text=True, timeout=60, check=False
    )
    assert bad.returncode == 2 and "unknown benchmark nosuch" in bad.stderr
