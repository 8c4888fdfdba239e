"""The exported task folder in Harbor: its own loader reads it, ``oracle``, ``nop`` and a scripted agent run.

There are no containers: ``harbor_local.LocalEnvironment`` stands for the image. Harbor is told to send no telemetry.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from harness_made import Made

from c4s.home import home

LOAD = (
    "import sys; from pathlib import Path; from harbor.models.task.task import Task\n"
    "for path in sorted(Path(sys.argv[1]).iterdir()):\n"
    "    assert Task.is_valid_dir(path), path\n"
    "    task = Task(path)\n"
    "    print(task.name, task.config.schema_version, len(task.config.environment.mcp_servers))\n"
)
ATIF = (
    "import sys; from pathlib import Path; from harbor.models.trajectories.trajectory import Trajectory\n"
    "for path in sorted(Path(sys.argv[1]).glob('*/trajectory.json')):\n"
    "    print(len(Trajectory.model_validate_json(path.read_text()).steps))\n"
)
AGENTS = {"oracle": ("oracle", 1.0), "nop": ("nop", 0.0), "saving": ("harbor_local:SavingAgent", 0.2)}


def run(place: Path, case: str) -> list[Made]:
    """A reward for each agent, on one case; all cases of the suite are loaded."""
    with tempfile.TemporaryDirectory(prefix="c4s-harbor-") as folder:
        tasks, one, jobs = (Path(folder) / name for name in ("tasks", "one", "jobs"))
        export = [sys.executable, "-m", "c4s.cli", "suite", "export-harbor", "starter", "--out"]
        subprocess.run([*export, str(tasks)], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([*export, str(one), "--case", case], check=True, stdout=subprocess.DEVNULL)
        loaded = subprocess.run(
            [str(place / "bin/python"), "-c", LOAD, str(tasks)], capture_output=True, text=True, check=True
        )
        note = f"{len(loaded.stdout.splitlines())} tasks loaded by Harbor"
        environment = {
            **os.environ,
            "HARBOR_TELEMETRY": "0",
            "C4S_BIN": str(Path(sys.executable).parent),
            "C4S_HOME": str(home()),
            "PYTHONPATH": str(Path(__file__).parent),
        }
        made = []
        for name, (agent, expected) in AGENTS.items():
            command = [str(place / "bin/harbor"), "run", "-p", str(one), "-a", agent]
            command += ["-e", "harbor_local:LocalEnvironment", "-o", str(jobs / name)]
            done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
            rewards = [json.loads(path.read_text()) for path in (jobs / name).rglob("reward.json")]
            told = note if rewards else " ".join(done.stdout.split())[-300:]
            made.append(Made(name, rewards[0]["reward"] if rewards else None, expected, told))
        made.append(_trajectory(place, case, Path(folder)))
        return made


def _trajectory(place: Path, case: str, folder: Path) -> Made:
    """A trial of c4s's own as ATIF, read by Harbor's models; its steps are the prompt and one a call."""
    c4s = [sys.executable, "-m", "c4s.cli"]
    command = [*c4s, "agent", "try", "planner", "--case", case, "--json", "--no-open"]
    tried = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    run = Path(tried["folder"]) / "run"
    subprocess.run(
        [*c4s, "export", "atif", str(run), "--out", str(folder / "atif")], check=True, stdout=subprocess.DEVNULL
    )
    read = subprocess.run(
        [str(place / "bin/python"), "-c", ATIF, str(folder / "atif")], capture_output=True, text=True, check=False
    )
    calls = sum(json.loads(path.read_text())["tool_calls"] for path in run.rglob("outcome.json"))
    steps = sum(map(int, read.stdout.split()))
    return Made("atif", float(steps), float(calls + 1), read.stderr[-200:] or "steps of a trial, read by Harbor")
