"""Every format's nesting of its counts, through the meter, whole and as a stream."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import httpx
import pytest
from canned import CannedUpstream, Reply

from c4s.meter.meter import Meter
from c4s.meter.metered import MeterRun

FIELDS = (
    "input_tokens",
    "fresh_input_tokens",
    "cache_read_tokens",
    "cache_write_tokens",
    "output_tokens",
    "reasoning_tokens",
)
PATHS = {
    "openai-chat": "/v1/chat/completions",
    "openai-responses": "/v1/responses",
    "anthropic": "/v1/messages",
    "gemini": "/v1beta/models/model-1:generateContent",
}
STREAM_PATHS = {**PATHS, "gemini": "/v1beta/models/model-1:streamGenerateContent?alt=sse"}


def whole(wire: str, usage: Any) -> dict[str, Any]:
    """A whole answer of a format around a usage block."""
    return {
        "openai-chat": {
            "id": "c1",
            "model": "model-1-0601",
            "usage": usage,
            "choices": [{"index": 0, "message": {"content": "x"}, "finish_reason": "stop"}],
        },
        "openai-responses": {
            "id": "r1",
            "object": "response",
            "status": "completed",
            "model": "model-1-0601",
            "output": [],
            "usage": usage,
        },
        "anthropic": {
            "id": "m1",
            "type": "message",
            "model": "model-1-0601",
            "content": [],
            "stop_reason": "end_turn",
            "usage": usage,
        },
        "gemini": {
            "responseId": "g1",
            "modelVersion": "model-1-0601",
            "usageMetadata": usage,
            "candidates": [{"finishReason": "STOP"}],
        },
    }[wire]


HTTP = httpx.Client(trust_env=False, timeout=20)


def ask(meter: Meter, run: MeterRun, path: str, **body: Any) -> httpx.Response:
    return HTTP.post(
        meter.url + path, json={"model": "model-1", **body}, headers={"Authorization": f"Bearer {run.token}"}
    )


CASES: list[tuple[str, str, dict[str, Any], tuple[int | None, ...], float | None]] = [
    (
        "openai-chat",
        "cached and written are inside the prompt",
        {
            "prompt_tokens": 1000,
            "completion_tokens": 50,
            "total_tokens": 1050,
            "prompt_tokens_details": {"cached_tokens": 600, "cache_write_tokens": 100},
            "completion_tokens_details": {"reasoning_tokens": 20},
        },
        (1000, 300, 600, 100, 50, 20),
        9800,
    ),
    (
        "openai-chat",
        "a details block without a class has no such class",
        {
            "prompt_tokens": 1000,
            "completion_tokens": 50,
            "prompt_tokens_details": {"audio_tokens": 0},
            "completion_tokens_details": {},
        },
        (1000, 1000, 0, 0, 50, 0),
        15000,
    ),
    (
        "openai-chat",
        "no details: caches are unknown",
        {"prompt_tokens": 1000, "completion_tokens": 50},
        (1000, None, None, None, 50, None),
        None,
    ),
    (
        "openai-chat",
        "null details are no details",
        {"prompt_tokens": 9, "completion_tokens": 1, "prompt_tokens_details": None, "completion_tokens_details": None},
        (9, None, None, None, 1, None),
        None,
    ),
    (
        "openai-chat",
        "DeepSeek tells hits beside the prompt",
        {
            "prompt_tokens": 1000,
            "completion_tokens": 50,
            "prompt_cache_hit_tokens": 800,
            "prompt_cache_miss_tokens": 200,
        },
        (1000, 200, 800, 0, 50, None),
        7800,
    ),
    (
        "openai-chat",
        "xAI leaves reasoning out of the completion",
        {
            "prompt_tokens": 100,
            "completion_tokens": 10,
            "total_tokens": 140,
            "prompt_tokens_details": {"cached_tokens": 0},
            "completion_tokens_details": {"reasoning_tokens": 30},
        },
        (100, 100, 0, 0, 40, 30),
        5000,
    ),
    (
        "openai-responses",
        "cached inside the input",
        {
            "input_tokens": 1000,
            "output_tokens": 50,
            "input_tokens_details": {"cached_tokens": 400},
            "output_tokens_details": {"reasoning_tokens": 30},
        },
        (1000, 600, 400, 0, 50, 30),
        11400,
    ),
    (
        "openai-responses",
        "cache writes where they are told",
        {
            "input_tokens": 1000,
            "output_tokens": 0,
            "input_tokens_details": {"cached_tokens": 0, "cache_write_tokens": 250},
        },
        (1000, 750, 0, 250, 0, None),
        10500,
    ),
    (
        "anthropic",
        "fresh input stands alone",
        {
            "input_tokens": 100,
            "cache_read_input_tokens": 700,
            "cache_creation_input_tokens": 200,
            "output_tokens": 50,
            "cache_creation": {"ephemeral_5m_input_tokens": 150, "ephemeral_1h_input_tokens": 50},
        },
        (1000, 100, 700, 200, 50, None),
        1000 + 700 + 150 * 12 + 50 * 20 + 5000,
    ),
    (
        "anthropic",
        "null caches were not used",
        {"input_tokens": 100, "cache_read_input_tokens": None, "cache_creation_input_tokens": None, "output_tokens": 5},
        (100, 100, 0, 0, 5, None),
        1500,
    ),
    (
        "anthropic",
        "absent caches are unknown",
        {"input_tokens": 100, "output_tokens": 5},
        (None, 100, None, None, 5, None),
        None,
    ),
    (
        "anthropic",
        "writes of unknown lifetime have no cost",
        {"input_tokens": 1, "cache_read_input_tokens": 0, "cache_creation_input_tokens": 9, "output_tokens": 5},
        (10, 1, 0, 9, 5, None),
        None,
    ),
    (
        "gemini",
        "thoughts beside the answer, cached inside the prompt, tool prompts beside it",
        {
            "promptTokenCount": 1000,
            "cachedContentTokenCount": 300,
            "toolUsePromptTokenCount": 20,
            "candidatesTokenCount": 40,
            "thoughtsTokenCount": 60,
            "totalTokenCount": 1120,
        },
        (1020, 720, 300, 0, 100, 60),
        17500,
    ),
    (
        "gemini",
        "zeros are left out",
        {"promptTokenCount": 1000, "totalTokenCount": 1000},
        (1000, 1000, 0, 0, 0, 0),
        10000,
    ),
]


@pytest.mark.parametrize(
    ("wire", "usage", "counts", "micro_usd"),
    [(c[0], c[2], c[3], c[4]) for c in CASES],
    ids=[f"{c[0]}: {c[1]}" for c in CASES],
)
def test_counts_of_a_whole_answer(
    meter: Meter,
    open_run: Callable[..., MeterRun],
    wire: str,
    usage: dict[str, Any],
    counts: tuple[int | None, ...],
    micro_usd: float | None,
) -> None:
    answer = json.dumps(whole(wire, usage)).encode()
    with CannedUpstream(Reply([answer[:30], answer[30:]])) as upstream:
        run = open_run(upstream.url)
        assert ask(meter, run, PATHS[wire]).content == answer
    record = run.records[0]
    assert tuple(getattr(record, field) for field in FIELDS) == counts
    assert (record.wire, record.model, record.served_model, record.ending) == (wire, "model-1", "model-1-0601", "ok")
    assert record.cost_usd == (None if micro_usd is None else pytest.approx(micro_usd / 1e6))
    assert bool(record.cost_note) == (micro_usd is None)
    assert json.loads(run.usage.read_text()) == record.plain()


def sse(*events: Any) -> bytes:
    return b"".join(b"data: " + json.dumps(event).encode() + b"\r\n\r\n" for event in events)


STREAMS = {
    "openai-chat": sse(
        {"id": "c", "model": "m", "choices": [{"delta": {"content": "usage"}}]},
        {"id": "c", "model": "m", "choices": [{"delta": {}, "finish_reason": "stop"}]},
        {
            "id": "c",
            "model": "m",
            "choices": [],
            "usage": {"prompt_tokens": 10, "completion_tokens": 4, "prompt_tokens_details": {"cached_tokens": 3}},
        },
    )
    + b"data: [DONE]\n\n",
    "openai-responses": sse(
        {"type": "response.created", "response": {"id": "r", "usage": None}},
        {"type": "response.output_text.delta", "delta": "usage"},
        {
            "type": "response.completed",
            "response": {
                "id": "r",
                "model": "m",
                "usage": {"input_tokens": 10, "output_tokens": 4, "input_tokens_details": {"cached_tokens": 3}},
            },
        },
    ),
    "anthropic": sse(
        {
            "type": "message_start",
            "message": {
                "id": "a",
                "model": "m",
                "usage": {
                    "input_tokens": 7,
                    "cache_read_input_tokens": 3,
                    "cache_creation_input_tokens": 0,
                    "output_tokens": 1,
                },
            },
        },
        {"type": "ping"},
        {"type": "content_block_delta", "delta": {"text": "usage"}},
        {"type": "message_delta", "delta": {"stop_reason": "end_turn"}, "usage": {"output_tokens": 2}},
        {"type": "message_delta", "delta": {}, "usage": {"output_tokens": 4}},
        {"type": "message_stop"},
    ),
    "gemini": sse(
        {
            "candidates": [{"content": {}}],
            "modelVersion": "m",
            "usageMetadata": {"promptTokenCount": 10, "cachedContentTokenCount": 3, "totalTokenCount": 10},
        },
        {
            "candidates": [{"finishReason": "STOP"}],
            "modelVersion": "m",
            "usageMetadata": {
                "promptTokenCount": 10,
                "cachedContentTokenCount": 3,
                "candidatesTokenCount": 4,
                "totalTokenCount": 14,
            },
        },
    ),
}


@pytest.mark.parametrize("wire", STREAMS)
@pytest.mark.parametrize("portion", [1, 17, 100000])
def test_counts_of_a_stream_in_any_portions(
    meter: Meter, open_run: Callable[..., MeterRun], wire: str, portion: int
) -> None:
    stream = STREAMS[wire]
    parts = [stream[i : i + portion] for i in range(0, len(stream), portion)]
    with CannedUpstream(Reply(parts, kind="text/event-stream; charset=utf-8")) as upstream:
        run = open_run(upstream.url)
        got = ask(meter, run, STREAM_PATHS[wire], stream=True, stream_options={"include_usage": True})
    assert got.content == stream
    record = run.records[0]
    assert (record.input_tokens, record.fresh_input_tokens, record.cache_read_tokens, record.output_tokens) == (
        10,
        7,
        3,
        4,
    )
    assert record.stream and record.ending == "ok" and record.problem == ""


def test_a_gemini_stream_as_an_array(meter: Meter, open_run: Callable[..., MeterRun]) -> None:
    chunks = [
        {"usageMetadata": {"promptTokenCount": 5}},
        whole("gemini", {"promptTokenCount": 5, "candidatesTokenCount": 2}),
    ]
    with CannedUpstream(Reply([json.dumps(chunks).encode()])) as upstream:
        run = open_run(upstream.url)
        ask(meter, run, "/v1beta/models/model-1:streamGenerateContent")
    assert (run.records[0].input_tokens, run.records[0].output_tokens, run.records[0].stream) == (5, 2, True)


def test_a_chat_stream_is_asked_for_usage_and_the_client_does_not_see_it(
    meter: Meter, open_run: Callable[..., MeterRun]
) -> None:
    with CannedUpstream(Reply([STREAMS["openai-chat"]], kind="text/event-stream")) as upstream:
        run = open_run(upstream.url)
        got = ask(meter, run, PATHS["openai-chat"], stream=True).content
        assert json.loads(upstream.requests[0][1])["stream_options"] == {"include_usage": True}
    assert run.records[0].output_tokens == 4
    assert b"prompt_tokens" not in got and got.endswith(b"data: [DONE]\n\n") and got.count(b"\r\n\r\n") == 2


@pytest.mark.parametrize(
    "usage",
    [
        {"prompt_tokens": -1, "completion_tokens": 1},
        {"prompt_tokens": "12", "completion_tokens": 1},
        {"prompt_tokens": True, "completion_tokens": 1},
        {"prompt_tokens": 1.5, "completion_tokens": 1},
        [1, 2],
        {"prompt_tokens": 10, "completion_tokens": 1, "prompt_tokens_details": {"cached_tokens": 11}},
        {"prompt_tokens": 10, "completion_tokens": 1, "prompt_tokens_details": 3},
    ],
)
def test_malformed_usage_is_unknown_and_noted(meter: Meter, open_run: Callable[..., MeterRun], usage: Any) -> None:
    with CannedUpstream(Reply([json.dumps(whole("openai-chat", usage)).encode()])) as upstream:
        run = open_run(upstream.url)
        assert ask(meter, run, PATHS["openai-chat"]).status_code == 200
    record = run.records[0]
    assert record.output_tokens is None and record.cost_usd is None and record.problem.startswith("malformed usage")


def test_an_answer_without_usage_and_an_answer_that_is_no_json(meter: Meter, open_run: Callable[..., MeterRun]) -> None:
    with CannedUpstream(Reply([b'{"choices": []}']), Reply([b"<html>"])) as upstream:
        run = open_run(upstream.url)
        ask(meter, run, PATHS["openai-chat"])
        ask(meter, run, PATHS["openai-chat"])
    assert [record.cost_usd for record in run.records] == [None, None]
    assert run.records[0].problem == "the answer told no usage" and "unreadable" in run.records[1].problem
