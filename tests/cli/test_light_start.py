"""Help, usage errors and ``doctor`` start without the libraries that only a command's work needs."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import typer

from c4s.cli.main import app

HEAVY = (
    "PIL.Image",
    "coacd",
    "coal",
    "duckdb",
    "embreex",
    "fastapi",
    "fcl",
    "httpx",
    "jinja2",
    "jsonschema",
    "mcp",
    "mcp_types",
    "numba",
    "numpy",
    "pandas",
    "prefect",
    "pyarrow",
    "scipy",
    "shapely",
    "sqlalchemy",
    "starlette",
    "trimesh",
)
PROBE = f"""
import sys
from c4s.cli.main import main
try:
    main()
except SystemExit as end:
    print("ended", end.code, *(name for name in {HEAVY} if name in sys.modules), file=sys.stderr)
"""


def _ending(home: Path, *arguments: str) -> str:
    """The exit code of ``c4s`` in a fresh process, and the heavy modules that it imported."""
    environment = {name: value for name, value in os.environ.items() if name != "PREFECT_API_URL"}
    done = subprocess.run(
        [sys.executable, "-c", PROBE, *arguments],
        env={**environment, "C4S_HOME": str(home)},
        text=True,
        capture_output=True,
        timeout=60,
        check=True,
    )
    return done.stderr.splitlines()[-1].removeprefix("ended ")


def _commands() -> Iterator[tuple[str, ...]]:
    """Every command and group of commands of ``c4s``."""
    waiting = [((), typer.main.get_command(app))]
    while waiting:
        path, command = waiting.pop()
        yield path
        waiting += [((*path, name), inner) for name, inner in getattr(command, "commands", {}).items()]


COMMANDS = sorted(_commands())


def test_every_command_is_asked() -> None:
    assert {(), ("run",), ("agent", "try"), ("suite", "import", "code4scene")} <= set(COMMANDS)


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_help_imports_nothing_heavy(tmp_path: Path, command: tuple[str, ...]) -> None:
    assert _ending(tmp_path, *command, "--help") == "0"


@pytest.mark.parametrize("arguments", [("frobnicate",), ("run", "--nosuch"), ("run", "nosuch"), ("suite", "show")])
def test_a_wrong_command_line_imports_nothing_heavy(tmp_path: Path, arguments: tuple[str, ...]) -> None:
    assert _ending(tmp_path, *arguments) == "2"


def test_doctor_imports_nothing_heavy(tmp_path: Path) -> None:
    assert _ending(tmp_path, "doctor") in ("0", "1")
