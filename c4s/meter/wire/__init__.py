"""The four wire formats, one file each, and which one a path belongs to."""

from __future__ import annotations

from c4s.meter.wire.anthropic import AnthropicMessages
from c4s.meter.wire.base import Wire
from c4s.meter.wire.gemini import GeminiGenerate
from c4s.meter.wire.openai_chat import OpenAIChat
from c4s.meter.wire.openai_responses import OpenAIResponses

WIRES: tuple[Wire, ...] = (OpenAIChat(), OpenAIResponses(), AnthropicMessages(), GeminiGenerate())
BY_NAME = {wire.name: wire for wire in WIRES}


def wire_of(path: str) -> Wire | None:
    """The wire format of a generation request; None for any other path."""
    return next((wire for wire in WIRES if wire.is_generation(path)), None)


def nearest_wire(path: str) -> Wire:
    """The format whose clients would ask for this path, for the shape of an error."""
    found = wire_of(path)
    if found is not None:
        return found
    if "/messages" in path:
        return BY_NAME["anthropic"]
    return BY_NAME["gemini" if "v1beta" in path or ":countTokens" in path else "openai-chat"]


__all__ = [
    "BY_NAME",
    "AnthropicMessages",
    "GeminiGenerate",
    "OpenAIChat",
    "OpenAIResponses",
    "Wire",
    "base",
    "nearest_wire",
    "wire_of",
]
