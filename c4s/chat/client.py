"""The client: one completion at a time for each caller, over one address or several of the same model."""

from __future__ import annotations

import json
import random
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import httpx

from c4s.chat.failures import (
    FIRST_WAIT_S,
    LONGEST_WAIT_S,
    OF_THE_ADDRESS,
    TRIES,
    ChatEnded,
    ChatFailed,
    ErrorClass,
    Failure,
    failure_of,
)
from c4s.chat.receiving import received
from c4s.chat.replicas import WIRE, Address, Replica, Replicas
from c4s.files import parse_json, whole_characters
from c4s.meter.usage import UNKNOWN, MalformedUsage, Usage
from c4s.meter.wire import BY_NAME
from c4s.meter.wire.base import Reading
from c4s.proxies import check_proxies

CONNECT_S, ANSWER_S = 30.0, 1200.0


@dataclass(frozen=True)
class Reply:
    """An assistant message with how it ended and the prompt's tokens (None where they are not told)."""

    message: dict[str, Any]
    finish: str
    prompt_tokens: int | None
    fingerprint: str | None
    model: str | None = None
    """The model that the answer names."""
    usage: Usage = UNKNOWN


class ChatClient:
    """Asks one model. Safe for threads. ``wait`` waits some seconds and is True when the run ended meanwhile."""

    def __init__(
        self,
        addresses: Sequence[Address],
        *,
        wait: Callable[[float], bool],
        jitter: random.Random,
        note: Callable[[dict[str, Any]], None],
        answer_s: float = ANSWER_S,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """``note`` is given one record for every failure, without address and key; an answer that is not whole after
        ``answer_s`` is one."""
        check_proxies()
        self._http = httpx.Client(
            timeout=httpx.Timeout(answer_s, connect=CONNECT_S),
            limits=httpx.Limits(max_connections=None, max_keepalive_connections=64),
        )
        self._replicas = Replicas(addresses, clock)
        self._within_s, self._clock = answer_s, clock
        self._wait, self._jitter, self._note = wait, jitter, note

    def close(self) -> None:
        """Close the connections."""
        self._http.close()

    def ask(self, body: Mapping[str, Any]) -> Reply:
        """One completion. ``ChatFailed`` when the tries of an error's class are used up or the run has ended."""
        failures: dict[ErrorClass, int] = {}
        while True:
            replica = self._replicas.take()
            outcome = self._once(replica, body)
            if isinstance(outcome, Reply):
                return outcome
            elsewhere = self._settle(replica, outcome)
            count = failures[outcome.kind] = failures.get(outcome.kind, 0) + 1
            again = count <= TRIES[outcome.kind]
            wait = self._pause(outcome, count) if again and not elsewhere else 0.0
            self._note(
                {
                    "event": "error",
                    "class": outcome.kind,
                    "status": outcome.status,
                    "what": outcome.what[:500],
                    "try": count,
                    "again": again,
                    "wait_s": round(wait, 3),
                }
            )
            if not again:
                raise ChatFailed(
                    outcome.kind, f"the model does not answer ({outcome.kind}): {outcome.what[:300]}", outcome.status
                )
            if self._wait(wait):
                raise ChatEnded(outcome.kind, "the run ended while the model did not answer", outcome.status)

    def _settle(self, replica: Replica, outcome: Failure) -> bool:
        """Note how the address did; whether another one can be asked at once."""
        if outcome.kind in OF_THE_ADDRESS:
            return self._replicas.failed(replica, outcome.told_wait_s)
        self._replicas.let_go(replica)
        return False

    def _pause(self, failure: Failure, count: int) -> float:
        if failure.told_wait_s is not None:
            return failure.told_wait_s
        longest: float = min(FIRST_WAIT_S[failure.kind] * 2 ** (count - 1), LONGEST_WAIT_S)
        return longest * (0.5 + self._jitter.random() / 2)

    def _once(self, replica: Replica, body: Mapping[str, Any]) -> Reply | Failure:
        answer = received(self._http, replica.address, body, within_s=self._within_s, clock=self._clock)
        if isinstance(answer, Failure):
            return answer
        if answer.status != 200:
            return failure_of(answer.status, answer.text, answer.retry_after)
        try:
            value = whole_characters(parse_json(answer.data))
        except (ValueError, RecursionError):
            return Failure("malformed", f"not JSON: {answer.text[:200]}")
        outcome = _reply(value)
        if isinstance(outcome, Reply):
            self._replicas.good(replica)
        return outcome


def _reply(value: Any) -> Reply | Failure:
    """The message of a completion, or what is wrong with it. Routers tell some errors with status 200."""
    if not isinstance(value, dict):
        return Failure("malformed", "the answer is no object")
    choices = value.get("choices")
    choice = choices[0] if isinstance(choices, list) and choices and isinstance(choices[0], dict) else {}
    error = value.get("error") or choice.get("error")
    if error:
        code = error.get("code") if isinstance(error, dict) else None
        return failure_of(code if isinstance(code, int) else 502, json.dumps({"error": error}))
    message = choice.get("message")
    if not isinstance(message, dict):
        return Failure("malformed", "the answer has no message")
    calls = message.get("tool_calls") or []
    if not isinstance(calls, list) or not all(
        isinstance(call, dict)
        and isinstance(call.get("function"), dict)
        and isinstance(call["function"].get("name"), str)
        for call in calls
    ):
        return Failure("malformed", "the answer has tool calls without a function")
    usage = value.get("usage")
    tokens = usage.get("prompt_tokens") if isinstance(usage, dict) else None
    told = _told(value)
    return Reply(
        message,
        str(choice.get("finish_reason") or ""),
        tokens if isinstance(tokens, int) else None,
        value.get("system_fingerprint") if isinstance(value.get("system_fingerprint"), str) else None,
        told.model,
        told.usage or UNKNOWN,
    )


def _told(value: Mapping[str, Any]) -> Reading:
    """The model and the usage that an answer tells; a usage that cannot be read is unknown."""
    reading = Reading()
    try:
        BY_NAME[WIRE].read(reading, value)
    except MalformedUsage:
        reading.usage = None
    return reading
