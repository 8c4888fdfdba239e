"""Answers as files, beside private cases."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from bench.made_warehouse import PUBLIC_SET, MadeWarehouse


def test_a_count_beside_a_domain_is_not_taken_for_a_private_cases_name(tmp_path: Path) -> None:
    private = frozenset({"outdoor-09", "outdoor-10", "outdoor-11"})
    made = MadeWarehouse(tmp_path / "warehouse", (0.7, 0.5), shape=PUBLIC_SET, private=private)
    made.write()

    def asked(*arguments: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-m", "c4s.cli", "analyze", *arguments]
        settings = {**os.environ, "C4S_HOME": str(tmp_path)}
        return subprocess.run(command, capture_output=True, text=True, env=settings, check=False)

    done = asked("main-results", "--panel", "public", "--draws", "100", "--csv", str(tmp_path / "csv"))
    assert done.returncode == 0, done.stderr
    assert "agent-01" in (tmp_path / "csv" / "main.csv").read_text()
    refused = asked("case-difficulty", "--panel", "private", "--csv", str(tmp_path / "private"))
    assert refused.returncode == 2 and "tell of private cases (case)" in refused.stderr
    assert not (tmp_path / "private").exists()
