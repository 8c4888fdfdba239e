"""What the host does before it starts engines, so that they start fast: bytecode of what only engines import."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

SCRIPT = """
import sys
from c4s.engine.headless.host.bytecode import compile_sources
compile_sources()
print("c4s.engine.headless.process.main" in sys.modules)
"""
ENGINE_SIDE = "engine/headless/process/main.*.pyc"


def compiled(tmp_path: Path, **environment: str) -> list[Path]:
    """The bytecode of the engine's main module that is there after the host has compiled its sources."""
    cache = tmp_path / "bytecode"
    variables = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    given = {"C4S_HOME": str(tmp_path / "home"), "PYTHONPYCACHEPREFIX": str(cache), **environment}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], env={**variables, **given}, capture_output=True, text=True, check=True
    )
    assert done.stdout == "False\n"
    return list(cache.rglob(ENGINE_SIDE))


def test_modules_that_only_engines_import_are_compiled_by_the_host(tmp_path: Path) -> None:
    (made,) = compiled(tmp_path)
    before = made.stat().st_mtime_ns
    (again,) = compiled(tmp_path)
    assert again.stat().st_mtime_ns == before


def test_a_python_that_writes_no_bytecode_writes_none(tmp_path: Path) -> None:
    assert compiled(tmp_path, PYTHONDONTWRITEBYTECODE="1") == []
