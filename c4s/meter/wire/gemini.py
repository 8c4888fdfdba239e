"""Gemini generateContent and streamGenerateContent.

``promptTokenCount`` includes cached content; tokens of tool-use prompts stand beside it; ``candidatesTokenCount``
leaves thoughts out. Counts that are 0 are left out of the JSON. Every chunk of a stream tells the running totals. There
is no charge for writing the implicit cache.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from c4s.meter.usage import Usage, block, split_input, tokens
from c4s.meter.wire.base import Reading, limit_of, text_of

_PATH = re.compile(r"/models/(?P<model>[^/:]+(?:/[^/:]+)?):(?P<method>generateContent|streamGenerateContent)$")


class GeminiGenerate:
    """``POST .../models/<model>:generateContent`` and ``:streamGenerateContent``."""

    name = "gemini"
    key_header = "x-goog-api-key"

    def is_generation(self, path: str) -> bool:
        """See ``Wire``."""
        return _PATH.search(path) is not None

    def model(self, path: str, body: Mapping[str, Any]) -> str | None:
        """The model is part of the path."""
        found = _PATH.search(path)
        return found["model"] if found else None

    def streams(self, path: str, body: Mapping[str, Any]) -> bool:
        """See ``Wire``."""
        return path.endswith(":streamGenerateContent")

    def most_output(self, body: Mapping[str, Any]) -> int | None:
        """See ``Wire``."""
        settings = body.get("generationConfig")
        return limit_of(settings, "maxOutputTokens") if isinstance(settings, Mapping) else None

    def read(self, reading: Reading, message: Mapping[str, Any]) -> None:
        """A whole response, or a chunk."""
        reading.model = text_of(message.get("modelVersion")) or reading.model
        reading.response_id = text_of(message.get("responseId")) or reading.response_id
        error = block(message, "error")
        if error is not None:
            reading.error = f"{error.get('status', 'error')}: {error.get('message', '')}"
        candidates, feedback = message.get("candidates"), block(message, "promptFeedback")
        if (feedback and feedback.get("blockReason")) or (
            isinstance(candidates, list)
            and any(isinstance(candidate, Mapping) and candidate.get("finishReason") for candidate in candidates)
        ):
            reading.finished = True
        usage = block(message, "usageMetadata")
        if usage is not None:
            reading.usage = _usage(usage)

    def error(self, status: int, kind: str, text: str) -> dict[str, Any]:
        """See ``Wire``."""
        names = {
            400: "INVALID_ARGUMENT",
            401: "UNAUTHENTICATED",
            403: "PERMISSION_DENIED",
            404: "NOT_FOUND",
            402: "FAILED_PRECONDITION",
            504: "DEADLINE_EXCEEDED",
        }
        return {"error": {"code": status, "message": text, "status": names.get(status, "UNAVAILABLE")}}


def _usage(usage: Mapping[str, Any]) -> Usage:
    prompt = tokens(usage, "promptTokenCount")
    cached, tool_use = tokens(usage, "cachedContentTokenCount", 0), tokens(usage, "toolUsePromptTokenCount", 0) or 0
    fresh = split_input(prompt, cached, 0)
    thoughts, answer = tokens(usage, "thoughtsTokenCount", 0) or 0, tokens(usage, "candidatesTokenCount", 0) or 0
    return Usage(
        input_tokens=None if prompt is None else prompt + tool_use,
        fresh_input_tokens=None if fresh is None else fresh + tool_use,
        cache_read_tokens=cached,
        cache_write_tokens=0,
        cache_write_1h_tokens=0,
        output_tokens=answer + thoughts,
        reasoning_tokens=thoughts,
    )
