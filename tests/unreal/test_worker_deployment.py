"""What ships for hosts: the entrypoint starts a worker of this c4s, and files name what there is."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from typer.testing import CliRunner

from c4s.cli.main import app
from tests.house.tree import ROOT

DEPLOY = ROOT / "deploy" / "unreal-worker"
VARIABLE = re.compile(r"C4S_[A-Z_]+")


def entrypoint(tmp_path: Path, *arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """Run it with a ``c4s`` that says how it was called."""
    program = tmp_path / "c4s"
    program.write_text('#!/bin/sh\necho c4s "$@"\n')
    program.chmod(0o755)
    return subprocess.run(
        ["sh", str(DEPLOY / "entrypoint.sh"), *arguments],
        env={"PATH": f"{tmp_path}:{os.environ['PATH']}", **variables},
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_entrypoint_starts_one_worker_or_any_command(tmp_path: Path) -> None:
    told = entrypoint(tmp_path, PREFECT_API_URL="http://server/api", C4S_STORE="s3://bucket")
    assert (told.returncode, told.stdout, told.stderr) == (0, "c4s worker --pool engines --slots 1\n", "")
    assert entrypoint(tmp_path, "c4s", "doctor").stdout == "c4s doctor\n"
    refused = entrypoint(tmp_path)
    assert refused.returncode == 2 and refused.stderr.count("\n") == 1 and "PREFECT_API_URL" in refused.stderr


def test_the_worker_that_the_files_start_is_a_command() -> None:
    told = CliRunner().invoke(app, ["worker", "--help"]).stdout
    assert "--pool" in told and "--slots" in told and "engines" in told


@pytest.mark.parametrize("file", sorted(path.name for path in DEPLOY.iterdir()))
def test_files_name_folders_and_variables_that_there_are(file: str) -> None:
    text = (DEPLOY / file).read_text()
    code = "\n".join(path.read_text() for path in (ROOT / "c4s").rglob("*.py"))
    known = {*VARIABLE.findall(code), "C4S_ROOT", "C4S_SLOTS"}
    assert set(VARIABLE.findall(text)) <= known
    for line in text.splitlines():
        if line.startswith("COPY "):
            for source in [word for word in line.split()[1:-1] if not word.startswith("--")]:
                assert (ROOT / source).exists(), line
