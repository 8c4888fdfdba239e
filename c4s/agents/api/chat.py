"""Chat completions with retries by class of error.

========================== ============================== ==========================================
class                      what it is                     what is done
========================== ============================== ==========================================
``connection``             no connection, a broken answer again, up to 5 times, from 1 s
``timeout``                no answer in time, 408, 504    again, up to 3 times, from 2 s
``rate``                   429                            again, up to 10 times, from 5 s, or as told
``server``                 409, 425, 5xx, 529             again, up to 6 times, from 2 s, or as told
``malformed``              an answer without a message    again, up to 3 times, from 1 s
``context``                the prompt is too long         raised: the caller trims and asks again
``refused``                any other status (400, 401 ..) raised
========================== ============================== ==========================================

Waits double, with jitter, up to 60 s; ``Retry-After`` is kept up to 10 minutes. Waiting ends when the run does.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import httpx

from c4s.errors import AgentFault
from c4s.files import parse_json, whole_characters

ErrorClass = Literal["connection", "timeout", "rate", "server", "malformed", "context", "refused"]
TRIES: dict[ErrorClass, int] = {
    "connection": 5,
    "timeout": 3,
    "rate": 10,
    "server": 6,
    "malformed": 3,
    "context": 0,
    "refused": 0,
}
FIRST_WAIT_S: dict[ErrorClass, float] = {"connection": 1, "timeout": 2, "rate": 5, "server": 2, "malformed": 1}
LONGEST_WAIT_S, LONGEST_TOLD_WAIT_S = 60.0, 600.0
CONNECT_S, SILENCE_S = 30.0, 1200.0
_TOO_LONG = re.compile(
    r"context[ _-]?(length|window|limit)|maximum context|too many tokens|prompt is too long"
    r"|input is too long|exceeds? the .*token|reduce the length",
    re.IGNORECASE,
)


class ChatFailed(AgentFault):
    """A request that will not succeed by asking again. ``kind`` says of which class its error is."""

    def __init__(self, kind: ErrorClass, what: str, status: int | None = None) -> None:
        super().__init__(what)
        self.kind, self.status = kind, status


@dataclass(frozen=True)
class Reply:
    """An assistant message with how it ended and the prompt's tokens (None where they are not told)."""

    message: dict[str, Any]
    finish: str
    prompt_tokens: int | None
    fingerprint: str | None


@dataclass(frozen=True)
class _Failure:
    kind: ErrorClass
    what: str
    status: int | None = None
    told_wait_s: float | None = None


class ChatClient:
    """Asks one model. ``wait`` waits some seconds and is True when the run ended meanwhile."""

    def __init__(
        self,
        base_url: str,
        token: str,
        *,
        wait: Callable[[float], bool],
        jitter: random.Random,
        note: Callable[[dict[str, Any]], None],
    ) -> None:
        """``note`` is given one record for every failure."""
        self._http = httpx.Client(
            base_url=base_url,
            trust_env=False,
            headers={"Authorization": f"Bearer {token}"},
            timeout=httpx.Timeout(SILENCE_S, connect=CONNECT_S),
        )
        self._wait, self._jitter, self._note = wait, jitter, note

    def close(self) -> None:
        """Close the connections."""
        self._http.close()

    def ask(self, body: Mapping[str, Any]) -> Reply:
        """One completion. ``ChatFailed`` when the tries of an error's class are used up or the run has ended."""
        failures: dict[ErrorClass, int] = {}
        while True:
            outcome = self._once(body)
            if isinstance(outcome, Reply):
                return outcome
            count = failures[outcome.kind] = failures.get(outcome.kind, 0) + 1
            again = count <= TRIES[outcome.kind]
            wait = self._pause(outcome, count) if again else 0.0
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
                raise ChatFailed(outcome.kind, "the run ended while the model did not answer", outcome.status)

    def _pause(self, failure: _Failure, count: int) -> float:
        if failure.told_wait_s is not None:
            return min(failure.told_wait_s, LONGEST_TOLD_WAIT_S)
        longest: float = min(FIRST_WAIT_S[failure.kind] * 2 ** (count - 1), LONGEST_WAIT_S)
        return longest * (0.5 + self._jitter.random() / 2)

    def _once(self, body: Mapping[str, Any]) -> Reply | _Failure:
        try:
            answer = self._http.post("/chat/completions", json=body)
        except httpx.TimeoutException as error:
            return _Failure("timeout", f"{type(error).__name__}: {error}")
        except httpx.HTTPError as error:
            return _Failure("connection", f"{type(error).__name__}: {error}")
        if answer.status_code != 200:
            return _failure(answer.status_code, answer.text, answer.headers.get("retry-after"))
        try:
            value = whole_characters(parse_json(answer.content))
        except (ValueError, RecursionError):
            return _Failure("malformed", f"not JSON: {answer.text[:200]}")
        return _reply(value)


def _failure(status: int, text: str, retry_after: str | None = None) -> _Failure:
    told = float(retry_after) if retry_after and re.fullmatch(r"\d+(\.\d+)?", retry_after.strip()) else None
    kind: ErrorClass = "refused"
    if status in (400, 413, 422) and _TOO_LONG.search(text):
        kind = "context"
    elif status in (408, 504):
        kind = "timeout"
    elif status == 429:
        kind = "rate"
    elif status in (409, 425) or status >= 500:
        kind = "server"
    return _Failure(kind, f"status {status}: {_message(text)}", status, told)


def _message(text: str) -> str:
    try:
        error = json.loads(text)["error"]
        return str(error["message"] if isinstance(error, dict) else error)
    except (ValueError, KeyError, TypeError):
        return text


def _reply(value: Any) -> Reply | _Failure:
    """The message of a completion, or what is wrong with it. Routers tell some errors with status 200."""
    if not isinstance(value, dict):
        return _Failure("malformed", "the answer is no object")
    choices = value.get("choices")
    choice = choices[0] if isinstance(choices, list) and choices and isinstance(choices[0], dict) else {}
    error = value.get("error") or choice.get("error")
    if error:
        code = error.get("code") if isinstance(error, dict) else None
        return _failure(code if isinstance(code, int) else 502, json.dumps({"error": error}))
    message = choice.get("message")
    if not isinstance(message, dict):
        return _Failure("malformed", "the answer has no message")
    calls = message.get("tool_calls") or []
    if not isinstance(calls, list) or not all(
        isinstance(call, dict)
        and isinstance(call.get("function"), dict)
        and isinstance(call["function"].get("name"), str)
        for call in calls
    ):
        return _Failure("malformed", "the answer has tool calls without a function")
    usage = value.get("usage")
    tokens = usage.get("prompt_tokens") if isinstance(usage, dict) else None
    return Reply(
        message,
        str(choice.get("finish_reason") or ""),
        tokens if isinstance(tokens, int) else None,
        value.get("system_fingerprint") if isinstance(value.get("system_fingerprint"), str) else None,
    )
