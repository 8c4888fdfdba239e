"""Anthropic messages. ``input_tokens`` is fresh input alone; cache reads and writes stand beside it.

A stream tells input at ``message_start`` and the output, running, at each ``message_delta``; later values replace
earlier ones. A cache field that is null says that no cache was used; one that is absent says nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.meter.usage import Usage, block, tokens
from c4s.meter.wire.base import Reading, limit_of, text_of


class AnthropicMessages:
    """``POST .../messages``."""

    name = "anthropic"
    key_header = "x-api-key"

    def is_generation(self, path: str) -> bool:
        """See ``Wire``."""
        return path.endswith("/messages")

    def model(self, path: str, body: Mapping[str, Any]) -> str | None:
        """See ``Wire``."""
        return text_of(body.get("model"))

    def streams(self, path: str, body: Mapping[str, Any]) -> bool:
        """See ``Wire``."""
        return body.get("stream") is True

    def most_output(self, body: Mapping[str, Any]) -> int | None:
        """See ``Wire``."""
        return limit_of(body, "max_tokens")

    def read(self, reading: Reading, message: Mapping[str, Any]) -> None:
        """A whole message, or one event of a stream."""
        kind = message.get("type")
        if kind == "error":
            error = block(message, "error") or {}
            reading.error = f"{error.get('type', 'error')}: {error.get('message', '')}"
        elif kind == "message_stop":
            reading.finished = True
        elif kind == "message_start":
            self._message(reading, block(message, "message") or {}, partial=True)
        elif kind == "message_delta":
            self._gather(reading, block(message, "usage"), partial=False)
        elif kind == "message":
            self._message(reading, message, partial=False)
            reading.finished = text_of(message.get("stop_reason")) is not None

    def _message(self, reading: Reading, message: Mapping[str, Any], *, partial: bool) -> None:
        reading.model = text_of(message.get("model")) or reading.model
        reading.response_id = text_of(message.get("id")) or reading.response_id
        self._gather(reading, block(message, "usage"), partial=partial)

    def _gather(self, reading: Reading, usage: Mapping[str, Any] | None, *, partial: bool) -> None:
        """``partial``: the output told so far is that of the first moment and stands for nothing."""
        if usage is None:
            return
        told = {
            name: value if value is not None else 0
            for name, value in usage.items()
            if value is not None or name.startswith("cache_")
        }
        if partial:
            told.pop("output_tokens", None)
        reading.parts.update(told)
        reading.usage = _usage(reading.parts)

    def error(self, status: int, kind: str, text: str) -> dict[str, Any]:
        """See ``Wire``."""
        names = {
            400: "invalid_request_error",
            401: "authentication_error",
            402: "billing_error",
            403: "permission_error",
            404: "not_found_error",
            504: "timeout_error",
        }
        return {"type": "error", "error": {"type": names.get(status, "api_error"), "message": text}}


def _usage(usage: Mapping[str, Any]) -> Usage:
    fresh, cache_read = tokens(usage, "input_tokens"), tokens(usage, "cache_read_input_tokens")
    cache_write = tokens(usage, "cache_creation_input_tokens")
    lifetimes = usage.get("cache_creation")
    hour = 0 if cache_write == 0 else None
    if isinstance(lifetimes, Mapping):
        hour = tokens(lifetimes, "ephemeral_1h_input_tokens", 0)
        if cache_write is None:
            cache_write = (tokens(lifetimes, "ephemeral_5m_input_tokens", 0) or 0) + (hour or 0)
    known = fresh is not None and cache_read is not None and cache_write is not None
    details = block(usage, "output_tokens_details") or {}
    return Usage(
        input_tokens=(fresh or 0) + (cache_read or 0) + (cache_write or 0) if known else None,
        fresh_input_tokens=fresh,
        cache_read_tokens=cache_read,
        cache_write_tokens=cache_write,
        cache_write_1h_tokens=hour,
        output_tokens=tokens(usage, "output_tokens"),
        reasoning_tokens=tokens(details, "thinking_tokens"),
    )
