"""Budgets, the tool list, repeats, the kill and the record of calls, over the wire."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from pathlib import Path

import httpx2
import pytest
from made_case import make_case

from bench.waiting import until
from c4s.errors import MachineryFault
from c4s.toolbox.client import CallRefused, GatewayClient, RunStopped
from c4s.toolbox.gateway import Endpoint
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.skill import skill_text
from tests.mcp_hello import HEADERS, INITIALIZE, VERSION


def payload(answer: object) -> dict:
    return json.loads(answer.content[0].text)  # type: ignore[attr-defined]


def test_a_call_counts_when_it_starts_and_the_budget_is_told(open_run: Callable) -> None:
    opened = open_run(calls=3)
    assert opened.client.call("get_categories").budget["tool_calls_left"] == 2
    with pytest.raises(CallRefused, match="no actor"):
        opened.client.call("delete_actor", name="nobody")
    with pytest.raises(CallRefused, match=r"invalid arguments.*'query' is a required property"):
        opened.client.call("search_assets")
    with pytest.raises(RunStopped, match="budget is spent"):
        opened.client.call("get_categories")
    assert opened.run.calls == 3 and opened.run.over_calls
    lines = opened.trajectory()
    begun = [line for line in lines if line["event"] == "started"]
    lines = [line for line in lines if line["event"] != "started"]
    assert [(line["event"], line["outcome"], line["counted"]) for line in lines] == [
        ("call", "ok", True),
        ("call", "error", True),
        ("call", "error", True),
        ("refused", "refused", False),
    ]
    assert [(line["call"], line["outcome"], line["counted"]) for line in begun] == [
        (number, "unfinished", False) for number in (1, 2, 3)
    ]
    assert all(
        start["seq"] < end["seq"] and start["arguments"] == end["arguments"]
        for start, end in zip(begun, lines, strict=False)
    )
    assert all(line["start_s"] >= 0 and line["duration_s"] >= 0 for line in lines[:3])
    assert lines[1]["tool"] == "delete_actor" and lines[1]["arguments"] == {"name": "nobody"}


def test_off_list_tools_are_refused_and_not_counted(open_run: Callable) -> None:
    opened = open_run(tools=["get_categories", "search_assets"])
    assert [tool.name for tool in opened.client.tools()] == ["search_assets", "get_categories"]
    for name in ("delete_actor", "run_shell"):
        with pytest.raises(CallRefused, match="there is no tool"):
            opened.client.call(name, name="x")
    assert (opened.run.calls, opened.run.blocked) == (0, 2)


def test_a_repeated_call_id_is_answered_once_more_and_counted_once(open_run: Callable) -> None:
    opened = open_run()
    where = {"name": "Once", "static_mesh": "crate", "location": [0, 0, 0]}
    first = opened.client.answer("spawn_actor", where, call_id="use-1")
    again = opened.client.answer("spawn_actor", where, call_id="use-1")
    assert not first.is_error and payload(first) == payload(again)
    other = opened.client.answer("spawn_actor", {**where, "name": "Two"}, call_id="use-1")
    assert payload(other)["result"]["actor"]["label"] == "Two"
    assert opened.run.calls == 2
    assert [line["event"] for line in opened.trajectory()] == ["started", "call", "duplicate", "started", "call"]


def test_two_posts_with_one_id_in_flight_share_one_call(open_run: Callable) -> None:
    opened = open_run()
    with httpx2.Client(
        headers={**HEADERS, "Authorization": f"Bearer {opened.endpoint.token}"}, trust_env=False, timeout=60
    ) as http:
        hello = http.post(opened.endpoint.url, json=INITIALIZE)
        session = {"mcp-session-id": hello.headers["mcp-session-id"], "mcp-protocol-version": VERSION}
        http.post(opened.endpoint.url, headers=session, json={"jsonrpc": "2.0", "method": "notifications/initialized"})
        call = {
            "jsonrpc": "2.0",
            "id": 7,
            "method": "tools/call",
            "params": {
                "name": "execute_python_script",
                "arguments": {"script": "import time\ntime.sleep(1)\nprint('slept')", "execution_mode": "sync"},
            },
        }
        texts: list[str] = []

        def post() -> None:
            texts.append(http.post(opened.endpoint.url, headers=session, json=call).text)

        threads = [threading.Thread(target=post) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert len(texts) == 2 and texts[0] == texts[1] and "slept" in texts[0]
        assert opened.run.calls == 1
        assert "slept" in http.post(opened.endpoint.url, headers=session, json=call).text
        assert opened.run.calls == 1


def test_tokens_select_the_run_and_sessions_are_not_shared(open_run: Callable, pack: object) -> None:
    opened = open_run()
    wrong = httpx2.post(opened.endpoint.url, json={}, headers=HEADERS, trust_env=False)
    assert wrong.status_code == 401
    case, _ = make_case(opened.folder / "second", pack, calls=1)  # type: ignore[arg-type]
    second = Run("room-2", opened.run.bench, case.budget, opened.folder / "second.jsonl", ["get_categories"])
    endpoint = opened.gateway.open_run(second)
    with GatewayClient(endpoint) as client:
        client.call("get_categories")
        assert [tool.name for tool in client.tools()] == ["get_categories"]
    assert (opened.run.calls, second.calls) == (0, 1)
    with httpx2.Client(headers=HEADERS, trust_env=False) as http:
        hello = http.post(endpoint.url, headers={"Authorization": f"Bearer {endpoint.token}"}, json=INITIALIZE)
        stolen = http.post(
            endpoint.url,
            json={"jsonrpc": "2.0", "id": 1, "method": "tools/list"},
            headers={
                "Authorization": f"Bearer {opened.endpoint.token}",
                "mcp-session-id": hello.headers["mcp-session-id"],
            },
        )
        assert stolen.status_code == 404


def test_a_run_is_killed_from_the_server_side(open_run: Callable) -> None:
    opened = open_run()
    caught: list[Exception] = []

    def work() -> None:
        try:
            opened.client.call("execute_python_script", script="while True: pass", execution_mode="sync")
        except RunStopped as stopped:
            caught.append(stopped)

    thread = threading.Thread(target=work)
    thread.start()
    until(lambda: opened.run.calls > 0)
    opened.run.end("killed", "the operator ended it")
    thread.join()
    assert "the operator ended it" in str(caught[0])
    with pytest.raises(RunStopped):
        opened.client.call("get_categories")
    assert [line["outcome"] for line in opened.trajectory()] == ["unfinished", "ended", "refused"]


def test_the_wall_budget_ends_the_run(open_run: Callable) -> None:
    opened = open_run(minutes=1 / 60)
    opened.run.ended.wait()
    with pytest.raises(RunStopped, match="time budget"):
        opened.client.call("get_categories")
    assert opened.run.end_reason == "wall_budget" and opened.run.calls == 0


def test_pictures_are_recorded_by_digest_and_never_with_structured_content(open_run: Callable) -> None:
    opened = open_run()
    answer = opened.client.answer("get_asset_preview", {"id": "crate"})
    assert [block.type for block in answer.content] == ["text", "image"] and answer.structured_content is None
    line = opened.trajectory()[1]
    assert len(line["images"][0]["sha256"]) == 64 and answer.content[1].data not in json.dumps(line)


def test_the_skill_is_a_prompt_of_the_server_and_polls_are_told_apart(open_run: Callable) -> None:
    opened = open_run()
    assert opened.client.prompt("skill") == skill_text()
    opened.client.call("execute_python_script", script="print(1)")
    opened.client.call("read_job_log", wait_s=10)
    assert (opened.run.calls, opened.run.polls) == (2, 1)
    assert [line["polling"] for line in opened.trajectory()] == [False, False, True, True]


def test_a_line_that_cannot_be_written_ends_the_run_before_the_tool_works(open_run: Callable) -> None:
    opened = open_run()
    case, _ = make_case(opened.folder / "full", opened.pack)
    run = Run("full", opened.run.bench, case.budget, Path("/dev/full"))
    with GatewayClient(opened.gateway.open_run(run)) as client, pytest.raises(RunStopped, match="cannot be written"):
        client.call("spawn_actor", name="Unseen", static_mesh="crate", location=[0, 0, 0])
    assert isinstance(run.fault, MachineryFault) and "No space left" in run.fault.what
    assert opened.client.call("find_actors_by_name", pattern="Unseen").data["total"] == 0


def test_half_a_character_does_not_break_the_record(open_run: Callable) -> None:
    opened = open_run()
    told = opened.client.call("execute_python_script", script="print('a\\ud800b')", execution_mode="sync").data
    assert told["status"] in ("done", "error") and opened.trajectory()[-1]["tool"] == "execute_python_script"
    with pytest.raises(CallRefused):
        opened.client.call(
            "execute_python_script", script="raise ValueError('\\udcff')", execution_mode="sync", wrong="\u00e9"
        )
    assert opened.trajectory()[-1]["outcome"] == "error"


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"query": "\ud83d"}, "half a surrogate pair"),
        ({"query": "#" * 4_300_000}, "bytes, more than"),
        ({"query": json.loads("[" * 200 + "]" * 200)}, "nested more than 64 deep"),
        ({"query": 10**5000}, "cannot be sent"),
    ],
)
def test_a_call_that_cannot_be_sent_is_refused_and_the_connection_goes_on(
    open_run: Callable, arguments: dict, text: str
) -> None:
    opened = open_run()
    with pytest.raises(CallRefused, match=text):
        opened.client.call("search_assets", **arguments)
    with pytest.raises(CallRefused):
        opened.client.call("search\ud83d")
    assert opened.client.call("get_categories").data["categories"]
    assert len([line for line in opened.trajectory() if line["event"] == "call"]) == 1


@pytest.mark.parametrize("tool", ["get_actors_in_level", "read_job_log", "search_assets"])
def test_an_offset_beyond_any_list_is_refused(open_run: Callable, tool: str) -> None:
    opened = open_run()
    needed = {"query": "table"} if tool == "search_assets" else {}
    for offset in (10**18, 10**30):
        with pytest.raises(CallRefused, match=r"invalid arguments in offset: 10+ is not allowed: it must be"):
            opened.client.call(tool, offset=offset, **needed)


def test_numbers_that_are_none_are_refused(open_run: Callable) -> None:
    opened = open_run()
    body = (
        '{"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"set_actor_transform","arguments":'
        '{"name":"Table","location":[NaN,0,0]}}}'
    )
    headers = {**HEADERS, "Authorization": f"Bearer {opened.endpoint.token}"}
    with httpx2.Client(headers=headers, trust_env=False) as http:
        hello = http.post(opened.endpoint.url, json=INITIALIZE)
        session = {"mcp-session-id": hello.headers["mcp-session-id"], "mcp-protocol-version": VERSION}
        told = http.post(opened.endpoint.url, headers=session, content=body)
    assert "NaN" not in told.text or "invalid" in told.text
    table = opened.client.call("find_actors_by_name", pattern="Table").data["actors"][0]
    assert table["location"] == [0, 0, 0]


@pytest.mark.parametrize("mode", ["auto", "legacy"])
def test_both_protocol_eras_work(open_run: Callable, mode: str) -> None:
    endpoint: Endpoint = open_run().endpoint
    with GatewayClient(endpoint, mode=mode) as client:  # type: ignore[arg-type]
        assert len(client.tools()) == 25
        assert client.call("get_actors_in_level").data["count"] == 6


def test_the_token_may_be_the_end_of_the_path(open_run: Callable) -> None:
    opened = open_run()
    told = httpx2.post(opened.endpoint.url_with_token, json=INITIALIZE, headers=HEADERS, trust_env=False)
    assert told.status_code == 200 and told.headers["mcp-session-id"]
    for path in ("", "/", f"/{opened.endpoint.token}x", f"/{opened.endpoint.token}/x", f"//{opened.endpoint.token}"):
        wrong = httpx2.post(opened.endpoint.url + path, json=INITIALIZE, headers=HEADERS, trust_env=False)
        assert wrong.status_code == 401, path
