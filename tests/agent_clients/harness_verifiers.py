"""The taskset of ``deploy/verifiers`` in verifiers: a scripted model saves the scene as it is, or says that it is done.

The package is installed as its README says. Nothing is pushed anywhere, and the model is ``ScriptedEndpoint``.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from harness_made import Made
from scripted_endpoint import ScriptedEndpoint, Use

from c4s.home import home

PACKAGE = Path(__file__).parents[2] / "deploy/verifiers"
AGENTS: dict[str, tuple[Sequence[Sequence[Use]], float]] = {
    "saving": ([[Use("save_scene_as", {"name": "saved"})]], 0.2),
    "silent": ([], 0.0),
}
LONGEST_S = 600.0


def run(place: Path, case: str) -> list[Made]:
    """A reward for each scripted model, on one case."""
    with tempfile.TemporaryDirectory(prefix="c4s-verifiers-") as folder:
        shutil.copytree(PACKAGE, Path(folder) / "package")
        install = [str(place / "bin/python"), "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation"]
        subprocess.run([*install, "--force-reinstall", f"{folder}/package"], check=True)
        return [_made(place, case, name, *script, Path(folder) / name) for name, script in AGENTS.items()]


def _made(place: Path, case: str, name: str, steps: Sequence[Sequence[Use]], expected: float, out: Path) -> Made:
    with ScriptedEndpoint(steps) as endpoint:
        command = [str(place / "bin/vf-eval"), "c4s_cases", "-m", "scripted", "--push", "false", "-o", str(out)]
        command += ["--client.base-url", f"{endpoint.url}/v1", "--client.api-key-var", "SCRIPTED_KEY"]
        command += ["--env.taskset.cases", json.dumps([case]), "--env.taskset.task.c4s", _c4s()]
        command += ["--env.agent.harness.id", "null", "--env.agent.runtime.type", "subprocess"]
        environment = {
            **os.environ,
            "SCRIPTED_KEY": "scripted",
            "C4S_HOME": str(home()),
            "PATH": f"{place / 'bin'}:{os.environ['PATH']}",
        }
        done = subprocess.run(
            command, env=environment, cwd=out.parent, capture_output=True, text=True, timeout=LONGEST_S, check=False
        )
    (trace,) = [line for path in out.rglob("traces.jsonl") for line in path.read_text().splitlines()] or [""]
    if not trace:
        return Made(name, None, expected, " ".join((done.stderr or done.stdout).split())[-300:])
    (told,) = json.loads(trace)["traces"]
    rewards = told.get("rewards", {})
    if "reward" not in rewards:
        return Made(name, None, expected, str(told.get("errors"))[-300:])
    return Made(name, rewards["reward"]["score"], expected, f"metrics {' '.join(sorted(told['metrics']))}")


def _c4s() -> str:
    return str(Path(sys.executable).parent / "c4s")
