"""The API loop's requests: every class of error on a real loopback endpoint, with a clock that does not wait."""

from __future__ import annotations

import itertools
import json
import random
from typing import Any

import pytest
from canned import CannedUpstream, Reply

from c4s.chat.client import ChatClient
from c4s.chat.failures import TRIES, ChatFailed
from c4s.chat.receiving import MOST_BYTES
from c4s.chat.replicas import Address, bearer
from c4s.errors import BadInput

OK = Reply(
    [
        b'{"choices": [{"message": {"role": "assistant", "content": "done"}, "finish_reason": "stop"}], '
        b'"usage": {"prompt_tokens": 7}, "system_fingerprint": "fp"}'
    ]
)


class Clock:
    """Takes waits down; the run ends at the given wait."""

    def __init__(self, ends_at: int = -1) -> None:
        self.waits: list[float] = []
        self.records: list[dict[str, Any]] = []
        self._ends_at = ends_at

    def __call__(self, seconds: float) -> bool:
        self.waits.append(seconds)
        return len(self.waits) == self._ends_at


def client(upstream: CannedUpstream, clock: Clock, /, token: str = "t", **more: Any) -> ChatClient:
    return ChatClient(
        [Address(upstream.url, bearer(token))], wait=clock, jitter=random.Random(0), note=clock.records.append, **more
    )


def error(status: str, text: str = "no", headers: tuple[str, ...] = ()) -> Reply:
    return Reply([json.dumps({"error": {"message": text}}).encode()], status=status, headers=headers)


def test_an_answer() -> None:
    with CannedUpstream(OK) as upstream:
        reply = client(upstream, Clock()).ask({"model": "m"})
        assert "authorization: bearer t" in upstream.requests[0][0].lower()
    assert (reply.message["content"], reply.finish, reply.prompt_tokens, reply.fingerprint) == ("done", "stop", 7, "fp")


@pytest.mark.parametrize(
    ("reply", "kind"),
    [
        (error("429 Slow"), "rate"),
        (error("500 Oops"), "server"),
        (error("529 Overloaded"), "server"),
        (error("504 Late"), "timeout"),
        (error("408 Late"), "timeout"),
        (Reply([b'{"ch'], then="cut"), "connection"),
        (Reply([b"<html>"]), "malformed"),
        (Reply([b'{"choices": []}']), "malformed"),
        (Reply([b'{"choices": [{"message": {"content": NaN}}]}']), "malformed"),
        (Reply([b"[" * 100_000]), "malformed"),
        (Reply([b" " * MOST_BYTES, b"{}"]), "malformed"),
        (Reply([b"no"], status="500 Oops", kind="text/html; charset=hex"), "server"),
        (Reply([b'{"choices": [{"message": {"tool_calls": [{"id": "1"}]}}]}']), "malformed"),
        (Reply([b'{"error": {"code": 503, "message": "busy"}}']), "server"),
        (Reply([b'{"choices": [{"error": {"code": 429, "message": "busy"}}]}']), "rate"),
    ],
)
def test_what_passes_is_asked_again(reply: Reply, kind: str) -> None:
    clock = Clock()
    with CannedUpstream(reply, reply, OK) as upstream:
        assert client(upstream, clock).ask({}).message["content"] == "done"
        assert len(upstream.requests) == 3
    assert [record["class"] for record in clock.records] == [kind, kind]
    assert 0 < clock.waits[0] < clock.waits[1] * 1.01 <= 10.1


def test_half_a_character_of_an_answer_is_replaced() -> None:
    said = Reply([rb'{"choices": [{"message": {"content": "a\ud83d", "reasoning_content": "\ud83d\ude00"}}]}'])
    with CannedUpstream(said) as upstream:
        message = client(upstream, Clock()).ask({}).message
    assert message == {"content": "a?", "reasoning_content": "\U0001f600"}


@pytest.mark.parametrize(
    ("reply", "kind"), [(error("429 Slow"), "rate"), (error("503 Busy"), "server"), (Reply([b"[]"]), "malformed")]
)
def test_tries_are_used_up(reply: Reply, kind: str) -> None:
    clock = Clock()
    with CannedUpstream(reply) as upstream, pytest.raises(ChatFailed) as failed:
        client(upstream, clock).ask({})
    assert failed.value.kind == kind and len(clock.waits) == TRIES[failed.value.kind]
    assert max(clock.waits) <= 60 and clock.records[-1]["again"] is False


def test_retry_after_is_kept_within_bounds() -> None:
    clock = Clock()
    with CannedUpstream(
        error("429 Slow", headers=("Retry-After: 17",)), error("429 Slow", headers=("Retry-After: 9999",)), OK
    ) as upstream:
        client(upstream, clock).ask({})
    assert clock.waits == [17, 600]


@pytest.mark.parametrize(
    ("reply", "kind"),
    [
        (error("401 No"), "refused"),
        (error("400 Bad", "unknown field"), "refused"),
        (error("402 Pay"), "refused"),
        (error("400 Bad", "This model's maximum context length is 8192 tokens"), "context"),
        (error("413 Big", "prompt is too long: 9 > 8"), "context"),
    ],
)
def test_what_does_not_pass_is_not_asked_again(reply: Reply, kind: str) -> None:
    clock = Clock()
    with CannedUpstream(reply) as upstream:
        with pytest.raises(ChatFailed) as failed:
            client(upstream, clock).ask({})
        assert len(upstream.requests) == 1
    assert failed.value.kind == kind and clock.waits == []


def test_an_answer_that_drips_is_late() -> None:
    clock, ticks = Clock(), itertools.count(step=100)
    with CannedUpstream(Reply([b" "], then="hold"), OK) as upstream:
        asked = client(upstream, clock, answer_s=60.0, clock=lambda: float(next(ticks)))
        with pytest.raises(ChatFailed) as failed:
            asked.ask({})
    assert failed.value.kind == "timeout" and "60 s" in failed.value.what


def test_a_key_that_an_endpoint_repeats_is_told_to_nobody() -> None:
    clock, key = Clock(), "sk-not-for-a-record"
    refused = error("401 No", f"Incorrect API key provided: {key}")
    said = Reply([json.dumps({"choices": [{"message": {"content": f"I was given {key}"}}]}).encode()])
    with CannedUpstream(said, refused) as upstream:
        asked = client(upstream, clock, token=key)
        assert asked.ask({}).message["content"] == "I was given ***"
        with pytest.raises(ChatFailed, match=r"provided: \*\*\*") as failed:
            asked.ask({})
        assert all(key in head for head, _ in upstream.requests)
    assert key not in json.dumps(clock.records) + failed.value.line()


@pytest.mark.parametrize("key", ["sk-two\nlines", "sk-\u2019quoted", "sk-nul\0", "sk-\x1b[0m"])
def test_a_key_that_no_header_carries_is_refused_unsaid(key: str) -> None:
    with pytest.raises(BadInput, match="Authorization") as refused:
        Address("http://127.0.0.1:9", bearer(key))
    assert "sk-" not in refused.value.line()


def test_waiting_ends_with_the_run() -> None:
    clock = Clock(ends_at=2)
    with CannedUpstream(error("500 Oops")) as upstream, pytest.raises(ChatFailed, match="run ended"):
        client(upstream, clock).ask({})
    assert len(clock.waits) == 2
