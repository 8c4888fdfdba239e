"""One line of ``usage.jsonl``: one request that a client sent through the meter."""

from __future__ import annotations

from typing import Any, Literal

from c4s.meter.usage import Usage

Ending = Literal["ok", "upstream_error", "stream_error", "unreachable", "timeout", "cut", "aborted", "refused"]
"""How a request ended.

``ok``: a whole answer. ``upstream_error``: an answer with an error status. ``stream_error``: an error inside a stream.
``unreachable``: no connection. ``timeout``: the endpoint fell silent. ``cut``: the answer ended early. ``aborted``: the
client went away. ``refused``: the meter did not send it.
"""
NOT_BILLED = frozenset({"upstream_error", "unreachable", "refused"})
"""Endings that cost nothing: no output was begun."""
UPSTREAM_FAULTS = frozenset({"upstream_error", "stream_error", "unreachable", "timeout", "cut"})


class RequestRecord(Usage):
    """A request. Token counts and cost are null where they are unknown; a request that is not billed has zeros."""

    seq: int
    time: float
    """Unix time at which the request came in, seconds."""
    wire: str | None
    """Wire format; null for a request that asks for no output (a list of models, a token count)."""
    path: str
    model: str | None
    served_model: str | None = None
    response_id: str | None = None
    stream: bool = False
    ending: Ending
    status: int | None = None
    """HTTP status that the client was given."""
    first_byte_s: float | None = None
    """Seconds from sending the request to the head of the answer."""
    duration_s: float
    request_bytes: int
    response_bytes: int = 0
    cost_usd: float | None = None
    cost_note: str = ""
    """Why the cost is unknown."""
    price_from: str | None = None
    """First day of the price row that was used."""
    reported_cost_usd: float | None = None
    """What the endpoint itself says it charges."""
    problem: str = ""

    @property
    def is_generation(self) -> bool:
        """Whether the request asked a model for output."""
        return self.wire is not None


def sums(records: list[dict[str, Any]]) -> dict[str, Any]:
    """Input and output tokens and cost over a run's records; None where any record's value is unknown, or none is.

    Requests that ask for no output are left out.
    """
    counted = [record for record in records if record.get("wire", "") is not None]
    found: dict[str, Any] = {}
    for key in ("input_tokens", "output_tokens", "cost_usd"):
        values = [record.get(key) for record in counted]
        found[key] = None if not values or None in values else sum(value for value in values if value is not None)
    return found
