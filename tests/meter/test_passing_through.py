"""Tokens and keys, what is passed and refused, upstream faults, aborted streams, many runs at once."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx
import pytest
from canned import CannedUpstream, Reply
from scripted_endpoint import ScriptedEndpoint, Use

from c4s.meter.meter import Meter
from c4s.meter.metered import MeterRun
from c4s.meter.record import RequestRecord, sums

CHAT, MESSAGES = "/v1/chat/completions", "/v1/messages"
START = b'data: {"type": "message_start", "message": {"model": "m", "usage": {"input_tokens": 9}}}\n\n'
OK = Reply([b'{"choices": [], "usage": {"prompt_tokens": 1, "completion_tokens": 1, "prompt_tokens_details": {}}}'])
PATHS = {
    "openai-chat": CHAT,
    "openai-responses": "/v1/responses",
    "anthropic": MESSAGES,
    "gemini": "/v1beta/models/model-1:generateContent",
}
Open = Callable[..., MeterRun]
HTTP = httpx.Client(trust_env=False, timeout=20)


def post(meter: Meter, token: str, path: str = CHAT, header: str = "Authorization", **more: Any) -> httpx.Response:
    value = f"Bearer {token}" if header == "Authorization" else token
    return HTTP.post(meter.url + path, json={"model": "model-1", **more}, headers={header: value})


def wait_for(run: MeterRun) -> RequestRecord:
    """The first record of a run, which is written after the client has left."""
    done = threading.Event()
    keep = run.record

    def record(one: RequestRecord) -> None:
        keep(one)
        done.set()

    run.record = record  # type: ignore[method-assign]
    if not run.records:
        done.wait()
    return run.records[0]


@pytest.mark.parametrize(
    ("path", "header", "expected"),
    [
        (CHAT, "Authorization", "authorization: bearer real-key"),
        (MESSAGES, "x-api-key", "x-api-key: real-key"),
        ("/v1beta/models/model-1:generateContent", "x-goog-api-key", "x-goog-api-key: real-key"),
        (MESSAGES, "Authorization", "x-api-key: real-key"),
    ],
)
def test_the_real_key_replaces_the_token(meter: Meter, open_run: Open, path: str, header: str, expected: str) -> None:
    with CannedUpstream(OK) as upstream:
        run = open_run(upstream.url, endpoint={"headers": {"X-Title": "c4s"}})
        got = post(meter, run.token, path, header)
        assert got.status_code == 200, got.text
        head = upstream.requests[0][0].lower()
    assert expected in head and run.token.lower() not in head and head.count("real-key") == 1 and "x-title: c4s" in head
    assert "real-key" not in got.text + str(got.headers) and "real-key" not in run.usage.read_text()


def test_a_token_in_the_query_and_a_base_with_a_version(meter: Meter, open_run: Open) -> None:
    with CannedUpstream(OK) as upstream:
        run = open_run(upstream.url + "/api/v1")
        HTTP.post(f"{meter.url}{CHAT}?key={run.token}&x=1", json={"model": "model-1"})
        assert upstream.requests[0][0].startswith("POST /api/v1/chat/completions?x=1 ")


def test_a_token_of_no_run_gets_nothing(meter: Meter, open_run: Open) -> None:
    with CannedUpstream(OK) as upstream:
        run = open_run(upstream.url)
        assert post(meter, "wrong").status_code == 401
        meter.close_run(run)
        assert post(meter, run.token).status_code == 401
        assert upstream.requests == []


@pytest.mark.parametrize(
    ("path", "formats", "status"),
    [
        ("/v1/embeddings", ["openai-chat"], 404),
        ("/v1/images/generations", ["openai-chat"], 404),
        (MESSAGES, ["openai-chat"], 404),
        ("/v1/models", ["openai-chat"], 200),
        ("/v1/messages/count_tokens", ["anthropic"], 200),
    ],
)
def test_only_metered_and_free_requests_pass(
    meter: Meter, open_run: Open, path: str, formats: list[str], status: int
) -> None:
    with CannedUpstream(OK) as upstream:
        run = open_run(upstream.url, formats=formats)
        assert post(meter, run.token, path).status_code == status
        assert len(upstream.requests) == (status == 200)
    assert run.records[0].cost_usd == 0 and run.records[0].ending == ("ok" if status == 200 else "refused")


def test_another_model_than_the_configurations_is_refused(meter: Meter, open_run: Open) -> None:
    with CannedUpstream(OK) as upstream:
        run = open_run(upstream.url, models=["model-1"])
        got = post(meter, run.token, model="model-2")
        assert got.status_code == 403 and "model-2" in got.json()["error"]["message"] and upstream.requests == []
        assert post(meter, run.token).status_code == 200


@pytest.mark.parametrize(
    ("wire", "where"),
    [
        ("openai-chat", ("error", "code")),
        ("openai-responses", ("error", "code")),
        ("anthropic", ("error", "type")),
        ("gemini", ("error", "status")),
    ],
)
def test_a_refusal_has_the_shape_of_the_format(meter: Meter, open_run: Open, wire: str, where: tuple[str, str]) -> None:
    with CannedUpstream(OK) as upstream:
        run = open_run(upstream.url, models=["other"])
        got = post(meter, run.token, PATHS[wire])
    assert got.status_code == 403 and isinstance(got.json()[where[0]][where[1]], str)
    assert "may not use model" in got.json()["error"]["message"]


def test_an_error_status_passes_with_its_body_and_costs_nothing(meter: Meter, open_run: Open) -> None:
    body = b'{"error": {"message": "slow down", "code": "rate_limit"}}'
    with CannedUpstream(Reply([body], status="429 Too Many", headers=["Retry-After: 7"])) as upstream:
        run = open_run(upstream.url)
        got = post(meter, run.token)
    assert (got.status_code, got.content, got.headers["retry-after"]) == (429, body, "7")
    record = run.records[0]
    assert (record.ending, record.status, record.cost_usd, record.problem) == ("upstream_error", 429, 0, "slow down")


def test_an_endpoint_that_is_not_there(meter: Meter, open_run: Open) -> None:
    run = open_run("http://127.0.0.1:1")
    got = post(meter, run.token)
    assert got.status_code == 502 and "model endpoint failed" in got.json()["error"]["message"]
    assert (run.records[0].ending, run.records[0].cost_usd) == ("unreachable", 0)


def test_an_endpoint_that_falls_silent(meter: Meter, open_run: Open) -> None:
    with CannedUpstream(Reply([START], kind="text/event-stream", then="hold")) as upstream:
        run = open_run(upstream.url)
        with pytest.raises(httpx.RemoteProtocolError):
            post(meter, run.token, MESSAGES, stream=True)
    record = run.records[0]
    assert (record.ending, record.fresh_input_tokens, record.output_tokens) == ("timeout", 9, None)
    assert record.cost_usd is None


@pytest.mark.parametrize(
    "reply",
    [
        Reply([START], kind="text/event-stream", then="cut"),
        Reply([START], kind="text/event-stream"),
        Reply([b'{"cho'], then="cut"),
    ],
)
def test_an_answer_that_breaks_off_breaks_off_for_the_client_too(meter: Meter, open_run: Open, reply: Reply) -> None:
    with CannedUpstream(reply) as upstream:
        run = open_run(upstream.url)
        with pytest.raises(httpx.RemoteProtocolError):
            post(meter, run.token, MESSAGES, stream=True)
    assert (run.records[0].ending, run.records[0].cost_usd) == ("cut", None)


def test_an_error_inside_a_stream(meter: Meter, open_run: Open) -> None:
    error = b'event: error\ndata: {"type": "error", "error": {"type": "overloaded_error", "message": "busy"}}\n\n'
    with CannedUpstream(Reply([START, error], kind="text/event-stream")) as upstream:
        run = open_run(upstream.url)
        assert post(meter, run.token, MESSAGES, stream=True).content == START + error
    assert (run.records[0].ending, run.records[0].problem, run.records[0].cost_usd) == (
        "stream_error",
        "overloaded_error: busy",
        None,
    )


def test_a_client_that_leaves_ends_the_upstream_request(meter: Meter, open_run: Open) -> None:
    with CannedUpstream(Reply([START], kind="text/event-stream", then="hold")) as upstream:
        run = open_run(upstream.url)
        with HTTP.stream(
            "POST", meter.url + MESSAGES, json={"model": "model-1", "stream": True}, headers={"x-api-key": run.token}
        ) as got:
            assert next(got.iter_bytes()) == START
        upstream.hung_up.wait()
        record = wait_for(run)
    assert (record.ending, record.input_tokens, record.cost_usd) == ("aborted", None, None)


def test_portions_are_passed_on_before_the_answer_is_complete(meter: Meter, open_run: Open) -> None:
    with CannedUpstream(Reply([START], kind="text/event-stream", then="hold")) as upstream:
        run = open_run(upstream.url)
        with HTTP.stream(
            "POST", meter.url + MESSAGES, json={"model": "model-1", "stream": True}, headers={"x-api-key": run.token}
        ) as got:
            assert next(got.iter_bytes()) == START and not upstream.release.is_set()


def test_a_body_that_is_no_json_object(meter: Meter, open_run: Open) -> None:
    run = open_run("http://127.0.0.1:1")
    got = HTTP.post(meter.url + CHAT, content=b"[1", headers={"Authorization": f"Bearer {run.token}"})
    assert got.status_code == 400 and run.records[0].ending == "refused"


def test_runs_at_once_keep_their_records_apart(meter: Meter, open_run: Open) -> None:
    with ScriptedEndpoint([[Use("save", {})]]) as endpoint, ThreadPoolExecutor(12) as threads:
        runs = [open_run(endpoint.url, number) for number in range(6)]
        tools = [{"type": "function", "function": {"name": "save"}}]
        list(
            threads.map(
                lambda i: post(
                    meter,
                    runs[i % 6].token,
                    model=f"model-{i % 6}",
                    tools=tools,
                    messages=[{"role": "user", "content": "x" * 40 * i}],
                    stream=i % 2 == 0,
                ),
                range(60),
            )
        )
        for number, run in enumerate(runs):
            served = [one for one in endpoint.served if one.model == f"model-{number}"]
            assert len(run.records) == len(served) == 10
            assert {record.seq for record in run.records} == set(range(1, 11))
            assert sum(record.output_tokens or 0 for record in run.records) == sum(one.output for one in served)
            assert len(run.usage.read_text().splitlines()) == 10


@pytest.mark.parametrize("wire", PATHS)
@pytest.mark.parametrize("stream", [False, True])
def test_the_meter_agrees_with_the_endpoints_own_count(meter: Meter, open_run: Open, wire: str, stream: bool) -> None:
    bodies: dict[str, dict[str, Any]] = {
        "openai-chat": {
            "messages": [{"role": "user", "content": "Build."}],
            "tools": [{"type": "function", "function": {"name": "save"}}],
        },
        "openai-responses": {"input": "Build.", "tools": [{"type": "function", "name": "save"}]},
        "anthropic": {"messages": [{"role": "user", "content": "Build."}], "tools": [{"name": "save"}]},
        "gemini": {
            "contents": [{"parts": [{"text": "Build."}]}],
            "tools": [{"functionDeclarations": [{"name": "save"}]}],
        },
    }
    with ScriptedEndpoint([[Use("save", {"name": "room"})]]) as endpoint:
        run = open_run(endpoint.url)
        path = PATHS[wire].replace(":generate", ":streamGenerate") if stream and wire == "gemini" else PATHS[wire]
        got = post(meter, run.token, path, **bodies[wire], stream=stream)
        assert "room" in got.text and endpoint.served[0].key == "real-key"
        one, record = endpoint.served[0], run.records[0]
    assert (record.fresh_input_tokens, record.cache_read_tokens, record.cache_write_tokens, record.output_tokens) == (
        one.fresh,
        one.cache_read,
        one.cache_write,
        one.output,
    )
    assert sums([json.loads(run.usage.read_text())])["cost_usd"] == pytest.approx(
        (one.fresh * 10 + one.cache_read + one.cache_write * 12 + one.output * 100) / 1e6
    )
