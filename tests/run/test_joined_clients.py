"""Agent clients of other distributions: a real one is installed, listed, named where a client is unknown, and works."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = """[build-system]
requires = ["setuptools>=80"]
build-backend = "setuptools.build_meta"
[project]
name = "tiny-agents"
version = "1.2"
[project.entry-points."c4s.agents"]
tiny = "tiny_agents:Tiny"
noop = "tiny_agents:Tiny"
broken = "tiny_agents:Nothing"
idle = "tiny_agents:Idle"
[tool.setuptools]
py-modules = ["tiny_agents"]
"""
MODULE = """from c4s.agents.base import AgentReport
class Tiny:
    def run(self, context):
        with context.connect() as tools:
            tools.call("save_scene_as", name="tiny")
        return AgentReport(client_version="tiny 1.2")
class Idle:
    pass
"""


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the distribution ``tiny-agents`` installed into it."""
    root = tmp_path_factory.mktemp("tiny")
    source, place = root / "source", root / "installed"
    source.mkdir()
    (source / "pyproject.toml").write_text(PROJECT)
    (source / "tiny_agents.py").write_text(MODULE)
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation", "--no-index"]
    subprocess.run([*pip, "--target", str(place), str(source)], check=True, capture_output=True)
    return place


def c4s(installed: Path, home: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "C4S_HOME": str(home), "PYTHONPATH": str(installed)}
    command = [sys.executable, "-m", "c4s.cli", *arguments]
    return subprocess.run(command, env=environment, text=True, capture_output=True, check=False)


def test_they_are_listed_with_their_distribution_and_take_no_name_of_c4ss_own(installed: Path, tmp_path: Path) -> None:
    rows = json.loads(c4s(installed, tmp_path, "agent", "list", "--json").stdout)
    theirs = {row["client"]: row for row in rows if row["from"] == "tiny-agents 1.2"}
    assert theirs.keys() == {"tiny", "noop", "broken", "idle"}
    assert theirs["tiny"]["ready"] and not theirs["tiny"]["problem"]
    assert "of c4s's own" in theirs["noop"]["problem"]
    assert "cannot be loaded" in theirs["broken"]["problem"] and "no method `run`" in theirs["idle"]["problem"]
    assert [row["from"] for row in rows if row["client"] == "noop"] == ["c4s", "tiny-agents 1.2"]


def test_one_works_a_trial_and_an_unknown_client_is_told_of_them(installed: Path, home: Path, tmp_path: Path) -> None:
    told: dict[str, Path] = {}
    for client in ("tiny", "tyni", "broken"):
        told[client] = tmp_path / f"{client}.yaml"
        told[client].write_text(f"name: mine\nclient: {client}\nharness: tester\n")
    options = ("--case", "text-flat-family", "--suite", "small", "--json", "--no-open")
    done = c4s(installed, home, "agent", "try", str(told["tiny"]), *options)
    assert done.returncode == 0, done.stderr
    score = json.loads(done.stdout)
    plan = json.loads((Path(score["folder"]) / "run/plan.json").read_text())
    assert plan["configurations"][0]["harness"] == "tester"
    (outcome,) = (Path(score["folder"]) / "run").rglob("attempt-1/outcome.json")
    assert json.loads(outcome.read_text())["client_version"] == "tiny 1.2"
    unknown = c4s(installed, home, "agent", "try", str(told["tyni"]), *options)
    assert unknown.returncode == 2 and "unknown agent client 'tyni'" in unknown.stderr and "tiny" in unknown.stderr
    broken = c4s(installed, home, "agent", "try", str(told["broken"]), *options)
    assert (broken.returncode, broken.stderr.count("\n")) == (2, 1) and "tiny-agents 1.2" in broken.stderr
