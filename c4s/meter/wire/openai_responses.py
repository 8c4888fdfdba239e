"""OpenAI responses. ``input_tokens`` includes cached and written tokens; the usage comes with the closing event."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.meter.usage import Usage, block, split_input, tokens
from c4s.meter.wire.base import Reading, limit_of, text_of

CLOSING = ("response.completed", "response.incomplete", "response.failed", "response.cancelled")


class OpenAIResponses:
    """``POST .../responses``."""

    name = "openai-responses"
    key_header = "authorization"

    def is_generation(self, path: str) -> bool:
        """See ``Wire``."""
        return path.endswith("/responses")

    def model(self, path: str, body: Mapping[str, Any]) -> str | None:
        """See ``Wire``."""
        return text_of(body.get("model"))

    def streams(self, path: str, body: Mapping[str, Any]) -> bool:
        """See ``Wire``."""
        return body.get("stream") is True

    def most_output(self, body: Mapping[str, Any]) -> int | None:
        """See ``Wire``."""
        return limit_of(body, "max_output_tokens")

    def read(self, reading: Reading, message: Mapping[str, Any]) -> None:
        """A whole response, or an event that may carry one."""
        kind = text_of(message.get("type"))
        response = block(message, "response") if kind is not None and kind.startswith("response.") else message
        if kind == "error":
            reading.error = str(message.get("message") or message.get("error") or "error")
        if response is None:
            return
        reading.model = text_of(response.get("model")) or reading.model
        if response.get("object") == "response" or kind is not None:
            reading.response_id = text_of(response.get("id")) or reading.response_id
        if kind in CLOSING or (kind is None and response.get("status") not in (None, "queued", "in_progress")):
            reading.finished = True
            if response.get("error"):
                reading.error = str(block(response, "error"))
        usage = block(response, "usage")
        if usage is not None:
            reading.usage = _usage(usage)

    def error(self, status: int, kind: str, text: str) -> dict[str, Any]:
        """See ``Wire``."""
        return {"error": {"message": text, "type": kind, "param": None, "code": kind}}


def _usage(usage: Mapping[str, Any]) -> Usage:
    details, output_details = block(usage, "input_tokens_details"), block(usage, "output_tokens_details")
    total = tokens(usage, "input_tokens")
    cache_read = tokens(details, "cached_tokens", 0) if details is not None else None
    cache_write = tokens(details, "cache_write_tokens", 0) if details is not None else None
    return Usage(
        input_tokens=total,
        fresh_input_tokens=split_input(total, cache_read, cache_write),
        cache_read_tokens=cache_read,
        cache_write_tokens=cache_write,
        cache_write_1h_tokens=0 if cache_write is not None else None,
        output_tokens=tokens(usage, "output_tokens"),
        reasoning_tokens=tokens(output_details, "reasoning_tokens", 0) if output_details is not None else None,
    )
