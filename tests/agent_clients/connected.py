"""Tells every installed client of a gateway as ``c4s serve`` prints it, and asks the client whether it is connected.

``python tests/agent_clients/connected.py [--case CASE]`` prints a line a client, with what it says of the server.
Exit 1 where one that is installed is not connected. ``matrix.py --install`` installs the clients. Codex tells only that
it knows the server.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))
from matrix import CASES, built_suite

from c4s.agents.base import agent_of
from c4s.agents.clients.client import ExternalClient
from c4s.errors import BadInput
from c4s.records.plan import Configuration

CLIENTS = {
    "Claude Code": ("claude_code", ["mcp", "list"], r"Connected"),
    "Codex": ("codex", ["mcp", "list"], r"c4s +http://\S+ +C4S_TOKEN +enabled"),
    "Gemini CLI": ("gemini", ["mcp", "list"], r"Connected"),
    "opencode": ("opencode", ["mcp", "list"], r"connected"),
    "Hermes": ("hermes", ["mcp", "test", "c4s"], r"Connected|tools? discovered"),
}
"""By the name that is printed: client, how it is asked, and what it answers where it is connected."""
ASK_S = 120


def ask(client: str, way: dict[str, Any], home: Path) -> tuple[bool | None, str]:
    """Whether a client says that it is connected, and what it says; None for one that is not installed."""
    name, question, yes = CLIENTS[client]
    agent = agent_of(Configuration(name=name, client=name))
    assert isinstance(agent, ExternalClient)
    try:
        program = str(agent.program({}).path)
    except BadInput as error:
        return None, error.line()
    project = home / "project"
    project.mkdir(parents=True)
    environment = {**os.environ, "HOME": str(home), "GEMINI_CLI_TRUST_WORKSPACE": "true", **way.get("environment", {})}
    if "command" in way:
        _run([program, *way["command"][1:]], project, environment)
    else:
        place = way["file"]
        file = home / place.removeprefix("~/") if place.startswith("~/") else project / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(way["text"])
    said = _run([program, *question], project, environment)
    return re.search(yes, said) is not None, said


def _run(command: list[str], folder: Path, environment: dict[str, str]) -> str:
    done = subprocess.run(
        command, cwd=folder, env=environment, text=True, capture_output=True, timeout=ASK_S, check=False
    )
    return re.sub(r"\x1b\[[0-9;]*m", "", done.stdout + done.stderr)


def main() -> int:
    """Print what each client says."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--case", default=CASES[0])
    chosen = parser.parse_args()
    built_suite()
    failed = False
    command = [sys.executable, "-m", "c4s.cli", "serve", chosen.case, "--json"]
    with tempfile.TemporaryDirectory() as root, subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as served:
        assert served.stdout is not None
        told = json.loads(served.stdout.readline())
        for client in CLIENTS:
            connected, said = ask(client, told["connect"][client], Path(root) / client.replace(" ", "-"))
            word = {True: "connected", False: "NOT CONNECTED", None: "not installed"}[connected]
            print(f"{client:12} {word:14} {' '.join(said.split())[:200]}", flush=True)
            failed |= connected is False
        served.send_signal(signal.SIGINT)
        served.communicate()
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
