"""A hostile agent asks the gateway for what is another run's."""

from __future__ import annotations

import json

import httpx2
import pytest
from made_case import make_case, make_pack
from prey import Prey

from c4s.files import json_lines
from c4s.toolbox.client import CallRefused, GatewayClient, RunStopped
from c4s.toolbox.gateway_run import Run
from tests.mcp_hello import HEADERS, INITIALIZE


@pytest.fixture
def other(prey: Prey, tmp_path):
    """Another run on the same gateway, with one tool."""
    case, _ = make_case(tmp_path / "suite", make_pack(tmp_path / "packs"), calls=5)
    run = Run("room-2", prey.run.bench, case.budget, tmp_path / "trajectory.jsonl", ["get_categories"])
    endpoint = prey.gateway.open_run(run)
    yield run, endpoint
    prey.gateway.close_run(run)


def test_tokens_cannot_be_guessed_or_bent(prey: Prey) -> None:
    token = prey.run.token
    assert len(token) >= 43
    answers = set()
    for guess in (
        "",
        "Bearer",
        f"Bearer {token[:-1]}",
        f"Bearer {token}x",
        f"Bearer {token.swapcase()}",
        f"Basic {token}",
        token,
        "Bearer *",
        "Bearer null",
        "Bearer room-1",
        f"Bearer {'A' * 100_000}"[:9000],
        "Bearer \u00e9",
    ):
        told = httpx2.post(
            prey.endpoint.url,
            json=INITIALIZE,
            trust_env=False,
            headers={**HEADERS, "Authorization": guess.encode("latin-1")},
        )
        answers.add((told.status_code, told.text))
    assert len(answers) == 1 and answers.pop()[0] == 401
    bare = prey.endpoint.url
    for url in (
        f"{bare}?token={token}",
        f"{bare}?access_token={token}",
        f"{bare}/{token[:-1]}",
        f"{bare}/{token.swapcase()}",
        f"{bare}/{token}/{token}",
        f"{bare}/room-1",
    ):
        assert httpx2.post(url, json=INITIALIZE, headers=HEADERS, trust_env=False).status_code in (401, 404)


def test_another_runs_session_cannot_be_used_ended_or_listened_to(prey: Prey, other) -> None:
    run, endpoint = other
    mine = {**HEADERS, "Authorization": f"Bearer {prey.run.token}"}
    theirs = {**HEADERS, "Authorization": f"Bearer {endpoint.token}"}
    with httpx2.Client(trust_env=False) as http:
        session = http.post(endpoint.url, headers=theirs, json=INITIALIZE).headers["mcp-session-id"]
        stolen = {**mine, "mcp-session-id": session}
        call = {
            "jsonrpc": "2.0",
            "id": 1,
            "method": "tools/call",
            "params": {"name": "get_categories", "arguments": {}},
        }
        assert http.post(endpoint.url, headers=stolen, json=call).status_code == 404
        assert http.delete(endpoint.url, headers=stolen).status_code == 404
        assert http.get(endpoint.url, headers=stolen).status_code == 404
        assert http.post(endpoint.url, headers={**mine, "mcp-session-id": "0" * 32}, json=call).status_code == 404
        own = http.post(endpoint.url, headers={**theirs, "mcp-session-id": session}, json=call)
        assert own.status_code == 200 and "result" in own.text
    assert run.calls == 1


def test_a_run_names_no_tool_of_another_and_none_off_the_list(prey: Prey, other) -> None:
    run, endpoint = other
    with GatewayClient(endpoint) as client:
        assert [tool.name for tool in client.tools()] == ["get_categories"]
        for name in (
            "delete_all_spawned",
            "execute_python_script",
            "run_shell",
            "__class__",
            "get_categories ",
            "",
            "GET_CATEGORIES",
            "c4s:get_categories",
        ):
            with pytest.raises(CallRefused, match="there is no tool"):
                client.call(name)
    assert run.calls == 0 and run.blocked == 8


def test_a_session_does_not_outlive_its_run_under_the_same_name(prey: Prey, other) -> None:
    run, endpoint = other
    theirs = {**HEADERS, "Authorization": f"Bearer {endpoint.token}"}
    with httpx2.Client(trust_env=False) as http:
        session = http.post(endpoint.url, headers=theirs, json=INITIALIZE).headers["mcp-session-id"]
        prey.gateway.close_run(run)
        again = Run(run.run_id, run.bench, run.budget, run.trajectory, ["get_categories"])
        later = {**HEADERS, "Authorization": f"Bearer {prey.gateway.open_run(again).token}", "mcp-session-id": session}
        told = http.post(endpoint.url, headers=later, json={"jsonrpc": "2.0", "id": 1, "method": "tools/list"})
    prey.gateway.close_run(again)
    assert told.status_code == 404


def test_a_token_is_dead_when_its_run_is_closed(prey: Prey, other) -> None:
    run, endpoint = other
    with GatewayClient(endpoint) as client:
        client.call("get_categories")
        run.end("killed", "the operator ended it")
        with pytest.raises(RunStopped):
            client.call("get_categories")
    prey.gateway.close_run(run)
    assert (
        httpx2.post(
            endpoint.url,
            json=INITIALIZE,
            trust_env=False,
            headers={**HEADERS, "Authorization": f"Bearer {endpoint.token}"},
        ).status_code
        == 401
    )


def test_no_call_is_free_by_a_reused_id(prey: Prey, other) -> None:
    run, endpoint = other
    with GatewayClient(endpoint) as client:
        first = client.answer("get_categories", {}, call_id="x")
        assert client.answer("get_categories", {}, call_id="x").content[0].text == first.content[0].text
        for number in range(4):
            client.answer("get_categories", {"n": number}, call_id="x")
        assert run.calls == 5
        with pytest.raises(RunStopped, match="budget is spent"):
            client.call("get_categories")
    with run.trajectory.open() as lines:
        outcomes = [line["outcome"] for line in json_lines(lines) if line["event"] != "started"]
    assert outcomes == ["ok", "duplicate", *["error"] * 4, "refused"]


def test_the_record_of_refused_calls_is_bounded(prey: Prey, other, monkeypatch: pytest.MonkeyPatch) -> None:
    run, endpoint = other
    monkeypatch.setattr("c4s.toolbox.gateway_run.UNCOUNTED_CALLS", 20)
    with GatewayClient(endpoint) as client:
        for number in range(20):
            client.answer("x" * 100_000, {"text": "y" * 100_000}, call_id="z" * 100_000 + str(number % 10))
        assert run.end_reason is None and run.trajectory.stat().st_size < 40_000
        with pytest.raises(CallRefused):
            client.call("run_shell")
        with pytest.raises(RunStopped, match="more than 20 refused and repeated calls"):
            client.call("run_shell")
    assert (run.calls, run.end_reason) == (0, "killed")


def test_sessions_of_a_run_are_bounded(prey: Prey, other, monkeypatch: pytest.MonkeyPatch) -> None:
    _, endpoint = other
    monkeypatch.setattr("c4s.toolbox.gateway.MOST_SESSIONS", 3)
    theirs = {**HEADERS, "Authorization": f"Bearer {endpoint.token}"}
    with httpx2.Client(trust_env=False) as http:
        told = [http.post(endpoint.url, headers=theirs, json=INITIALIZE).status_code for _ in range(5)]
    assert told == [200, 200, 200, 429, 429]
    prey.client.call("get_categories")


def test_calls_are_one_line_each_whatever_they_hold(prey: Prey) -> None:
    prey.client.call("get_categories")
    with prey.run.trajectory.open() as lines:
        before = len(list(json_lines(lines)))
    forged = 'x"}\n{"event": "call", "counted": true, "outcome": "ok", "tool": "forged"}\r\n\x1b[2J\u2028\x00'
    for tool, arguments in (
        ("delete_actor", {"name": forged}),
        ("find_actors_by_name", {"pattern": forged[:400]}),
        (forged, {}),
        ("search_assets", {"query": forged, "k": 1}),
    ):
        prey.client.answer(tool, arguments)
    prey.python(f"print({forged!r}); import sys; sys.stderr.write({forged!r})")
    raw = prey.run.trajectory.read_bytes()
    added = [json.loads(line) for line in raw.split(b"\n")[before:] if line]
    assert [line["event"] for line in added].count("call") == 4 and all(line["tool"] != "forged" for line in added)
    assert [line["seq"] for line in added] == list(range(before + 1, before + 10))
