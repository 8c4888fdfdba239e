"""A client that retries over a new connection: a call whose answer went nowhere runs once."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import httpx2
import pytest

from bench.waiting import until
from c4s.toolbox.gateway import Endpoint
from tests.mcp_hello import HEADERS, INITIALIZE, VERSION

SLOW = {
    "script": "import time, unreal\ntime.sleep(1)\nprint('made')\n"
    "unreal.get_editor_subsystem(unreal.EditorActorSubsystem).spawn_actor_from_class("
    "unreal.StaticMeshActor, unreal.Vector(0, 0, 0)).set_actor_label('Slow')",
    "execution_mode": "sync",
}


@contextmanager
def connection(endpoint: Endpoint) -> Iterator[Callable[..., str]]:
    """A session over a connection of its own; it calls tools, and hangs up after so many seconds."""
    with httpx2.Client(
        headers={**HEADERS, "Authorization": f"Bearer {endpoint.token}"}, trust_env=False, timeout=60
    ) as http:
        hello = http.post(endpoint.url, json=INITIALIZE)
        session = {"mcp-session-id": hello.headers["mcp-session-id"], "mcp-protocol-version": VERSION}
        http.post(endpoint.url, headers=session, json={"jsonrpc": "2.0", "method": "notifications/initialized"})
        sent = 0

        def call(name: str, arguments: dict[str, Any], *, patience_s: float = 60.0, own_id: str = "") -> str:
            nonlocal sent
            sent += 1
            params: dict[str, Any] = {"name": name, "arguments": arguments}
            if own_id:
                params["_meta"] = {"callId": own_id}
            body = {"jsonrpc": "2.0", "id": sent, "method": "tools/call", "params": params}
            answer = http.post(endpoint.url, headers=session, json=body, timeout=patience_s)
            data = next(line for line in answer.text.splitlines() if line.startswith("data:") and "result" in line)
            return json.loads(data.removeprefix("data:"))["result"]["content"][0]["text"]

        yield call


def hang_up(endpoint: Endpoint, **options: Any) -> None:
    """Send the slow call and leave before its answer."""
    with connection(endpoint) as call, pytest.raises(httpx2.ReadTimeout):
        call("execute_python_script", SLOW, patience_s=0.3, **options)


def lost(opened: Any) -> bool:
    """Whether the gateway has noticed that an answer will go nowhere."""
    return bool(opened.run._lost)


def test_a_call_that_is_repeated_over_a_new_connection_runs_once(open_run: Callable) -> None:
    opened = open_run()
    hang_up(opened.endpoint)
    until(lambda: lost(opened))
    with connection(opened.endpoint) as call:
        assert "made" in call("execute_python_script", SLOW)
        assert opened.run.calls == 1
        assert json.loads(call("find_actors_by_name", {"pattern": "Slow"}))["result"]["total"] == 1
        assert "made" in call("execute_python_script", SLOW)
    assert opened.run.calls == 3
    events = [(line["event"], line["tool"]) for line in opened.trajectory()]
    assert events.count(("duplicate", "execute_python_script")) == 1


def test_a_repeat_finds_its_answer_though_the_tool_has_ended(open_run: Callable) -> None:
    opened = open_run()
    hang_up(opened.endpoint)
    until(lambda: any(line["event"] == "call" for line in opened.trajectory()) and lost(opened))
    with connection(opened.endpoint) as call:
        assert "made" in call("execute_python_script", SLOW)
    assert opened.run.calls == 1


def test_what_was_asked_again_after_other_calls_is_asked_anew(open_run: Callable) -> None:
    opened = open_run()
    hang_up(opened.endpoint)
    until(lambda: lost(opened))
    with connection(opened.endpoint) as call:
        call("get_actors_in_level", {})
        call("execute_python_script", SLOW)
    assert opened.run.calls == 3


def test_calls_with_ids_of_their_own_are_told_apart_by_them(open_run: Callable) -> None:
    opened = open_run()
    hang_up(opened.endpoint, own_id="one")
    with connection(opened.endpoint) as call:
        call("execute_python_script", SLOW, own_id="one")
        assert opened.run.calls == 1
        call("execute_python_script", SLOW, own_id="two")
    assert opened.run.calls == 2
