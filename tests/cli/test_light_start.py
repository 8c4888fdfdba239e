"""Help, usage errors and ``doctor`` start without the libraries that only a command's work needs."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest
import typer
from typer.testing import CliRunner

from c4s.cli.main import app
from c4s.engine.headless.version import ENGINE_VERSION
from c4s.protocol.rules import DEFAULT_POLICY

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

FORKED = f"""
import json, os, sys
import rich.markdown, typer.rich_utils
import c4s.cli.main
for command in json.loads(sys.argv[1]):
    read, write = os.pipe()
    child = os.fork()
    if not child:
        sys.argv = ["c4s", *command, "--help"]
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        code = 0
        try:
            c4s.cli.main.main()
        except SystemExit as end:
            code = end.code
        except BaseException as error:
            code = repr(error)
        os.write(write, json.dumps([code, *(name for name in {HEAVY} if name in sys.modules)]).encode())
        os._exit(0)
    os.close(write)
    print(os.read(read, 65536).decode(), flush=True)
    os.close(read)
    os.waitpid(child, 0)
"""
"""Each command's help in a fork of a process that has imported what every command and every help does."""


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
    waiting: list[tuple[tuple[str, ...], Any]] = [((), typer.main.get_command(app))]
    while waiting:
        path, command = waiting.pop()
        yield path
        waiting += [((*path, name), inner) for name, inner in getattr(command, "commands", {}).items()]


COMMANDS = sorted(_commands())


def test_every_command_is_asked() -> None:
    assert {(), ("run",), ("agent", "try"), ("suite", "import", "code4scene")} <= set(COMMANDS)


def test_the_help_says_of_each_command_what_the_command_says_of_itself() -> None:
    said = {name: command.get_short_help_str(200) for name, command in typer.main.get_command(app).commands.items()}  # type: ignore[attr-defined]
    shown = " ".join(CliRunner().invoke(app, ["--help"], env={"COLUMNS": "400"}).output.split())
    assert len(said) > 20 and [name for name, line in said.items() if f"│ {name} {line}" not in shown] == []


def test_a_command_imports_no_other(tmp_path: Path) -> None:
    others = "import sys; from c4s.cli.main import main\ntry: main()\nexcept SystemExit: print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", others, "sql"],
        env={**os.environ, "C4S_HOME": str(tmp_path)},
        text=True,
        capture_output=True,
        check=True,
    )
    assert "c4s.cli.sql" in done.stdout.split() and not {"c4s.cli.suite", "c4s.cli.agent", "c4s.cli.human"} & set(
        done.stdout.split()
    )


def test_the_version_names_the_engine_and_the_policy() -> None:
    said = CliRunner().invoke(app, ["--version"])
    assert said.exit_code == 0
    assert said.output.splitlines() == [
        f"c4s {version('c4s')}",
        f"engine {ENGINE_VERSION}",
        *said.output.splitlines()[2:],
    ]
    assert DEFAULT_POLICY in said.output.splitlines()[2]


@pytest.fixture(scope="module")
def helped(tmp_path_factory: pytest.TempPathFactory) -> dict[tuple[str, ...], list[Any]]:
    """By command how its help ended: the exit code, and the heavy modules that were imported."""
    done = subprocess.run(
        [sys.executable, "-c", FORKED, json.dumps(COMMANDS)],
        env={**os.environ, "C4S_HOME": str(tmp_path_factory.mktemp("home"))},
        text=True,
        capture_output=True,
        check=True,
    )
    return dict(zip(COMMANDS, map(json.loads, done.stdout.splitlines()), strict=True))


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_help_imports_nothing_heavy(helped: dict[tuple[str, ...], list[Any]], command: tuple[str, ...]) -> None:
    assert helped[command] == [0]


def test_the_list_of_clients_imports_nothing_heavy(tmp_path: Path) -> None:
    assert _ending(tmp_path, "agent", "list") == "0"


@pytest.mark.parametrize("arguments", [("frobnicate",), ("run", "--nosuch"), ("run", "nosuch"), ("suite", "show")])
def test_a_wrong_command_line_imports_nothing_heavy(tmp_path: Path, arguments: tuple[str, ...]) -> None:
    assert _ending(tmp_path, *arguments) == "2"


def test_doctor_imports_nothing_heavy(tmp_path: Path) -> None:
    assert _ending(tmp_path, "doctor") in ("0", "1")
