"""Drives every agent client through a scripted model on cases of the starter suite, to a saved and scored scene.

``python tests/agent_clients/matrix.py [--install] [--case CASE ...] [CLIENT ...]`` prints the matrix client x
(installed, drove tools, saved, scored, usage matched the endpoint's own count), on a text and on a repair.
``--install`` installs what is missing under ``C4S_HOME/clients``, from npm and PyPI. Exit 1 where an installed client
fails.

``command`` and ``antigravity`` are any program: here it is ``sdk_client.py``, on the official MCP SDK. It stands where
Antigravity's own would, with the files and the environment that its preset makes.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import yaml

sys.path.insert(0, str(Path(__file__).parent))
from scripted_endpoint import ScriptedEndpoint, Use

from c4s.agents.base import agent_of
from c4s.agents.clients.client import ExternalClient
from c4s.agents.clients.command import CommandClient
from c4s.agents.clients.programs import find
from c4s.errors import BadInput, C4SError
from c4s.files import json_lines
from c4s.home import runs_root, suites_root
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration, Plan
from c4s.records.score import TrialScore
from c4s.records.suite import AgentCase, SuiteFolder
from c4s.run.drive import in_slots, stage_functions
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.trial import run_trial

CLIENTS = ("codex", "claude_code", "gemini", "opencode", "hermes", "command", "antigravity", "api")
MODELS = {"codex": "gpt-5.6-sol", "claude_code": "claude-opus-4-5", "gemini": "gemini-2.5-pro"}
CASES = ("text-flat-family", "indoor-flat-02-living-room")
SDK_CLIENT = Path(__file__).with_name("sdk_client.py").absolute()
BUILD = """\
import unreal
mesh = unreal.load_asset("{mesh}")
editor = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for number in range(48):
    actor = editor.spawn_actor_from_object(mesh, unreal.Vector(400 * (number % 8), 400 * (number // 8) + 500, 0))
    actor.set_actor_label("Part_" + str(number))
"""
COLUMNS = ("installed", "drove tools", "saved", "scored", "usage matched")


@dataclass
class Row:
    """One client's line of the matrix."""

    client: str
    cells: dict[str, str]
    note: str = ""


def script(case: AgentCase) -> list[list[Use]]:
    """A text: look, place two things (two calls at once), 48 more by a script, a picture, environment, save. A repair:
    look, a picture, save."""
    if case.setting != "text-to-scene":
        return [[Use("get_actors_in_level")], [Use("take_screenshot")], [Use("save_scene_as", {"name": "submission"})]]
    first, second = [path for path in case.catalog if "/SM_" in path][:2]
    return [
        [Use("search_assets", {"query": "table", "k": 3})],
        [
            Use("spawn_actor", {"name": "First", "static_mesh": first, "location": [0, 0, 0]}),
            Use("spawn_actor", {"name": "Second", "static_mesh": second, "location": [300, 0, 0]}),
        ],
        [Use("execute_python_script", {"script": BUILD.format(mesh=first), "execution_mode": "sync"})],
        [Use("take_screenshot", {})],
        [Use("setup_environment", {})],
        [Use("save_scene_as", {"name": "submission"})],
    ]


def stand_in(client: str) -> dict[str, Any]:
    """Options of a client that is any program: the one on the MCP SDK; none for a client of its own."""
    own = {"command": ["chat", "{mcp_file}"], "antigravity": ["gemini", "/home/agent/.gemini/config/mcp_config.json"]}
    if client not in own:
        return {}
    told = {
        "command": [sys.executable, str(SDK_CLIENT), *own[client], "{model}"],
        "version": f"SDK {version('mcp')}",
        "read_only": [sys.prefix, sys.base_prefix, str(SDK_CLIENT)],
    }
    environment = {"MODEL_URL": "{model_url}", "MODEL_TOKEN": "{model_token}"}
    return told if client == "antigravity" else {**told, "environment": environment, "wire": "openai-chat"}


@contextmanager
def endpoints(url: str) -> Iterator[None]:
    """The environment in which a model endpoint ``scripted`` is at an address."""
    formats = ["openai-chat", "openai-responses", "anthropic", "gemini"]
    told = {"endpoints": {"scripted": {"url": url, "formats": formats, "key_env": "SCRIPTED_KEY"}}}
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write(yaml.safe_dump(told))
        file.flush()
        os.environ |= {"C4S_ENDPOINTS": file.name, "SCRIPTED_KEY": "the-real-key"}
        yield


def built_suite() -> Path:
    """The starter suite, built where it is not there."""
    suite = suites_root() / "starter"
    if not (suite / "suite.json").is_file():
        subprocess.run([sys.executable, "-m", "c4s.cli", "suite", "build", "starter"], check=True)
    return suite


def drive(client: str, suite: Path, runs: Path, case_id: str) -> Row:
    """One attempt of one client against a scripted endpoint, verified and scored."""
    row = Row(client, dict.fromkeys(COLUMNS, "no"))
    options = stand_in(client)
    agent = agent_of(Configuration(name=client, client=client))
    try:
        program = agent.program(options) if isinstance(agent, ExternalClient) else None
    except BadInput as error:
        row.note = error.line()
        return row
    row.cells["installed"] = program.version or "yes" if program else "built in"
    case = SuiteFolder(suite).agent_case(SuiteFolder(suite).case(case_id).alias)
    with ScriptedEndpoint(script(case)) as endpoint, endpoints(endpoint.url):
        configuration = Configuration(
            name=client,
            client=client,
            model=MODELS.get(client, "scripted-1"),
            options={**options, "endpoint": "scripted"},
        )
        run = runs / f"clients-{client}-{case_id}-{int(time.time())}"
        plan: Plan = open_run(
            run,
            make_plan(
                SuiteFolder(suite),
                [configuration],
                run_id=run.name,
                policy=DEFAULT_POLICY,
                judge="rule",
                engine="headless",
                cases=[case_id],
            ),
        )
        (trial,) = trials(run, suite, plan)
        started = time.monotonic()
        try:
            score = asyncio.run(_run(trial, plan))
        except C4SError as error:
            row.note = error.line()
            score = None
        seconds = time.monotonic() - started
        served, missing = list(endpoint.served), list(endpoint.missing)
    attempt = trial.folder.attempt(1).root
    if missing:
        row.note += f" tools not offered: {', '.join(missing)}"
    with (attempt / "trajectory.jsonl").open() as lines:
        calls = [line for line in json_lines(lines) if line["event"] == "call" and line["outcome"] == "ok"]
    wanted = sum(len(step) for step in script(case))
    row.cells["drove tools"] = "yes" if len(calls) == wanted else f"{len(calls)} of {wanted}"
    with (attempt / "usage.jsonl").open() as lines:
        metered = [line for line in json_lines(lines) if line["wire"] is not None]
    matched = len(metered) == len(served) and all(
        sum(line[f"{name}_tokens"] or 0 for line in metered) == endpoint.totals()[count]
        for name, count in (
            ("fresh_input", "fresh"),
            ("cache_read", "cache_read"),
            ("cache_write", "cache_write"),
            ("output", "output"),
        )
    )
    matched = matched and {one.key for one in served} == {"the-real-key"}
    row.cells["usage matched"] = "yes" if matched else f"{len(metered)} of {len(served)}"
    offered = sorted({tool for one in served for tool in one.tools})
    own = [tool for tool in offered if "c4s" not in tool]
    row.note += (
        f" {len(served)} requests ({sum(one.answered == 'side' for one in served)} beside the work), "
        f"{max((one.pictures for one in served), default=0)} pictures seen, {seconds:.0f} s"
        + (f", own tools: {', '.join(own)}" if own and isinstance(agent, ExternalClient) else "")
    )
    if score is None:
        return row
    first = AttemptOutcome.read(trial.folder.attempt(1).outcome)
    row.cells["saved"] = "yes" if first.submission else f"no ({first.ended_by}: {first.message})"
    if score.retained_attempt is not None:
        row.cells["scored"] = f"{score.score:.2f}" if score.score is not None else score.status
    return row


async def _run(trial: Trial, plan: Plan) -> TrialScore:
    async with Pool(1) as pool:
        return await run_trial(trial, plan, in_slots(pool, stage_functions(), trial, plan))


def main() -> int:
    """Print the matrix."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--case", action="append", help=f"case ids (default {' '.join(CASES)})")
    parser.add_argument("clients", nargs="*", default=CLIENTS)
    chosen = parser.parse_args()
    suite = built_suite()
    rows = []
    for client in chosen.clients:
        agent = agent_of(Configuration(name=client, client=client))
        if chosen.install and isinstance(agent, ExternalClient) and not isinstance(agent, CommandClient):
            try:
                find(agent.install, {})
            except BadInput:
                print(f"installing {agent.install.package}", flush=True)
                subprocess.run(agent.install.command(), check=False, stdout=subprocess.DEVNULL)
        for case_id in chosen.case or CASES:
            row = drive(client, suite, runs_root(), case_id)
            rows.append(row)
            print(f"{row.client:12} " + "  ".join(f"{name}: {row.cells[name]:8}" for name in COLUMNS), flush=True)
            print(f"{'':12} {case_id}: {row.note.strip()}", flush=True)
    failed = [
        row
        for row in rows
        if row.cells["installed"] != "no"
        and not (
            row.cells["drove tools"] == row.cells["saved"] == row.cells["usage matched"] == "yes"
            and row.cells["scored"] not in ("no", "pending")
        )
    ]
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
