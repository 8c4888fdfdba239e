"""A worker process loads what its stage works with, not what every stage of a trial might."""

from __future__ import annotations

import subprocess
import sys

import pytest

HEAVY = ("duckdb", "jsonschema", "mcp", "numba", "pandas", "pyarrow", "scipy")


def test_stages_are_known_without_what_they_work_with() -> None:
    code = f"import sys, c4s.run.stages; print(*(name for name in {HEAVY} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []


def test_checking_calls_makes_no_grammar_of_web_addresses() -> None:
    code = "import sys, c4s.toolbox.arguments; print('rfc3987_syntax' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == ["False"]


@pytest.mark.parametrize("module", ["c4s.evidence", "cases.starter.suite", "c4s.cli.evaluation"])
def test_what_is_done_is_found_without_what_makes_it(module: str) -> None:
    makers = ("jsonschema", "numba", "openpyxl", "scipy.spatial", "trimesh")
    code = f"import sys, {module}; print(*(name for name in {makers} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []
