"""OpenAI chat completions, as OpenAI, OpenRouter, DeepSeek, xAI and self-hosted servers speak it.

``prompt_tokens`` includes cached and written tokens. A details block without a class means that the endpoint has no
such class; no details block means that nothing is known of caches. DeepSeek tells cache hits beside ``prompt_tokens``.
xAI leaves reasoning out of ``completion_tokens``, which shows in ``total_tokens``.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.meter.usage import Usage, block, split_input, tokens
from c4s.meter.wire.base import Reading, limit_of, text_of


class OpenAIChat:
    """``POST .../chat/completions``."""

    name = "openai-chat"
    key_header = "authorization"

    def is_generation(self, path: str) -> bool:
        """See ``Wire``."""
        return path.endswith("/chat/completions")

    def model(self, path: str, body: Mapping[str, Any]) -> str | None:
        """See ``Wire``."""
        return text_of(body.get("model"))

    def streams(self, path: str, body: Mapping[str, Any]) -> bool:
        """See ``Wire``."""
        return body.get("stream") is True

    def most_output(self, body: Mapping[str, Any]) -> int | None:
        """See ``Wire``."""
        return limit_of(body, "max_completion_tokens", "max_tokens")

    def read(self, reading: Reading, message: Mapping[str, Any]) -> None:
        """A whole completion, or a chunk; the usage is in the last chunk."""
        reading.model = text_of(message.get("model")) or reading.model
        reading.response_id = text_of(message.get("id")) or reading.response_id
        if message.get("error"):
            reading.error = _error_text(message["error"])
        choices = message.get("choices")
        if isinstance(choices, list) and any(
            isinstance(choice, Mapping) and choice.get("finish_reason") for choice in choices
        ):
            reading.finished = True
        usage = block(message, "usage")
        if usage is not None:
            reading.usage = _usage(usage)
            cost = usage.get("cost")
            if isinstance(cost, int | float) and not isinstance(cost, bool) and cost >= 0:
                reading.reported_cost_usd = float(cost)

    def error(self, status: int, kind: str, text: str) -> dict[str, Any]:
        """See ``Wire``."""
        return {"error": {"message": text, "type": kind, "param": None, "code": kind}}


def _error_text(error: Any) -> str:
    return str(error.get("message") or error) if isinstance(error, Mapping) else str(error)


def _usage(usage: Mapping[str, Any]) -> Usage:
    details = block(usage, "prompt_tokens_details")
    total, output = tokens(usage, "prompt_tokens"), tokens(usage, "completion_tokens")
    cache_read = cache_write = tokens(usage, "prompt_cache_hit_tokens")
    if cache_read is not None:
        cache_write = 0
    if details is not None:
        cache_read = tokens(details, "cached_tokens", cache_read or 0)
        cache_write = tokens(details, "cache_write_tokens", 0)
    output_details = block(usage, "completion_tokens_details")
    reasoning = tokens(output_details, "reasoning_tokens", 0) if output_details is not None else None
    whole = tokens(usage, "total_tokens")
    if reasoning and total is not None and output is not None and whole == total + output + reasoning:
        output += reasoning
    return Usage(
        input_tokens=total,
        fresh_input_tokens=split_input(total, cache_read, cache_write),
        cache_read_tokens=cache_read,
        cache_write_tokens=cache_write,
        cache_write_1h_tokens=0 if cache_write is not None else None,
        output_tokens=output,
        reasoning_tokens=reasoning,
    )
