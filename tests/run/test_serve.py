"""``c4s serve``: a client of one's own connects as it was told, works, saves, and the score arrives."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import anyio
import httpx2
from mcp import Client
from mcp.client.streamable_http import streamable_http_client

from c4s.records.suite import SuiteFolder
from tests.run.conftest import Command

CASE = "text-flat-family"


@contextmanager
def served(home: Path, *options: str) -> Iterator[subprocess.Popen[str]]:
    """The command while it runs."""
    process = subprocess.Popen(
        [sys.executable, "-m", "c4s.cli", "serve", CASE, "--suite", "small", *options],
        env={**os.environ, "C4S_HOME": str(home)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def call(server: dict[str, Any], calls: list[tuple[str, dict[str, Any]]]) -> list[dict[str, Any]]:
    """The answers to some calls of a client that was given an entry of a file of MCP servers."""

    async def work() -> list[dict[str, Any]]:
        async with (
            httpx2.AsyncClient(headers=server["headers"], trust_env=False, timeout=60) as http,
            Client(streamable_http_client(server["url"], http_client=http)) as client,
        ):
            answers = [await client.call_tool(name, arguments) for name, arguments in calls]
            return [json.loads(answer.content[0].text) for answer in answers]

    return anyio.run(work)


def test_a_client_of_ones_own_connects_as_told_and_what_it_saves_is_scored(home: Path) -> None:
    suite = SuiteFolder(home / "suites/small")
    case = suite.agent_case(suite.case(CASE).alias)
    mesh = next(path for path in case.catalog if not path.endswith("_C"))
    build = (
        f"import unreal\nmesh = unreal.load_asset('{mesh}')\n"
        "editor = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)\n"
        "for n in range(60): editor.spawn_actor_from_object(mesh, unreal.Vector(300 * (n % 8), 300 * (n // 8), 0))"
    )
    with served(home, "--json", "--after-save", "0") as process:
        assert process.stdout is not None
        told = json.loads(process.stdout.readline())
        assert case.prompt.strip() in Path(told["task"]).read_text()
        assert told["budget"]["tool_calls"] == case.budget.tool_calls
        assert CASE not in told["task"] and not list(Path(told["task"]).parents[6].rglob("withheld"))
        server = json.loads(told["connect"]["any other"]["text"])["mcpServers"]["c4s"]
        script = {"script": build, "execution_mode": "sync"}
        answers = call(server, [("execute_python_script", script), ("save_scene_as", {"name": "mine"})])
        assert answers[0]["result"]["status"] == "done" and "error" not in answers[1]
        out, err = process.communicate(timeout=120)
    score = json.loads(out)
    assert process.returncode == 0 and (score["case_id"], score["status"]) == (CASE, "measured"), err
    assert score["configuration"] == "outside" and 0 < score["score"] < 1 and score["retained_attempt"] == 1


def test_ctrl_c_ends_it_and_without_a_save_there_is_nothing_to_score(home: Path) -> None:
    with served(home) as process:
        assert process.stdout is not None
        lines = [process.stdout.readline()]
        while "Ctrl-C" not in lines[-1]:
            lines.append(process.stdout.readline())
        text = "".join(lines)
        for words in ("claude mcp add", "codex mcp add", "gemini mcp add", "opencode.json", ".hermes/config.yaml"):
            assert words in text
        url, token = lines[0].split()[5].rstrip(","), lines[0].split()[-1]
        server = {"url": url, "headers": {"Authorization": f"Bearer {token}"}}
        call(server, [("get_categories", {})])
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    assert "get_categories" in out and "nothing was saved" in out and "no scene was saved" in out
    assert "attempt 2" not in out


def test_a_port_that_is_taken_is_one_line(c4s: Command, home: Path) -> None:
    before = sorted((home / "tries").rglob("*"))
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        done = c4s("serve", CASE, "--suite", "small", "--port", str(port))
    assert (done.returncode, done.stderr.count("\n")) == (2, 1) and f"port {port} is taken" in done.stderr
    assert sorted((home / "tries").rglob("*")) == before
