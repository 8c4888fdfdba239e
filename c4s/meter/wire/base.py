"""What the meter needs to know of a wire format, and what it learns from a response."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from c4s.meter.usage import Usage


@dataclass
class Reading:
    """What is learnt of one response, from its JSON body or event by event."""

    usage: Usage | None = None
    """None until the response has told its usage."""
    model: str | None = None
    """The model that the response names."""
    response_id: str | None = None
    finished: bool = False
    """Whether the response said that it is complete."""
    error: str = ""
    """An error that came inside a stream."""
    reported_cost_usd: float | None = None
    """What the endpoint itself says the request cost (OpenRouter)."""
    parts: dict[str, Any] = field(default_factory=dict)
    """Usage fields gathered so far, for formats that tell them in parts."""


class Wire(Protocol):
    """One wire format. Paths are without the meter's own prefix, with the leading slash."""

    name: str
    key_header: str
    """Header in which the endpoint expects the key; ``authorization`` stands for a bearer token."""

    def is_generation(self, path: str) -> bool:
        """Whether this path asks the model for output, and so costs money."""
        ...

    def model(self, path: str, body: Mapping[str, Any]) -> str | None:
        """The model that a request asks for."""
        ...

    def streams(self, path: str, body: Mapping[str, Any]) -> bool:
        """Whether the request asks for a stream."""
        ...

    def most_output(self, body: Mapping[str, Any]) -> int | None:
        """The request's own limit of output tokens."""
        ...

    def read(self, reading: Reading, message: Mapping[str, Any]) -> None:
        """Learn from a whole response body or from one event of a stream. ``MalformedUsage`` for a bad block."""
        ...

    def error(self, status: int, kind: str, text: str) -> dict[str, Any]:
        """An error body of the shape that clients of this format know."""
        ...


def text_of(value: Any) -> str | None:
    """The value where it is a string that says something."""
    return value if isinstance(value, str) and value else None


def limit_of(body: Mapping[str, Any], *names: str) -> int | None:
    """The first of these fields that holds a positive whole number."""
    for name in names:
        value = body.get(name)
        if isinstance(value, int) and not isinstance(value, bool) and value > 0:
            return value
    return None
