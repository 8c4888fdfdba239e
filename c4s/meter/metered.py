"""A run behind the meter: its token, its upstream, what it may ask for, and its records."""

from __future__ import annotations

import secrets
import threading
from collections.abc import Callable, Iterable, Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from c4s.files import append_json_line
from c4s.meter.endpoints import ModelEndpoint
from c4s.meter.prices import MILLION, Price, PriceTable
from c4s.meter.record import RequestRecord
from c4s.meter.spending import Ledger
from c4s.meter.wire.base import Wire

CHARACTERS_A_TOKEN = 4
PICTURE_TOKENS = 1600
ASSUMED_OUTPUT_TOKENS = 8192
"""Assumed for a request without a limit of its own, and the most that an estimate counts."""


class MeterRun:
    """One run. ``token`` is all that its client is given; it is worth nothing outside this meter."""

    def __init__(
        self,
        run_id: str,
        upstream: ModelEndpoint,
        key: str | None,
        usage: Path,
        *,
        prices: PriceTable,
        ledger: Ledger | None = None,
        models: Iterable[str] = (),
        at_limit: Callable[[], None] | None = None,
    ) -> None:
        """
        Args:
            run_id: for messages.
            upstream: where its requests go.
            key: the real key of the upstream.
            usage: file that takes one line a request.
            prices: list prices.
            ledger: spending of the whole run with its limit; none is kept without it.
            models: ids of the models that it may use; any when empty.
            at_limit: called once when a request is refused because of the spending limit.
        """
        self.run_id, self.upstream, self.key, self.usage, self.prices = run_id, upstream, key, usage, prices
        self.ledger, self.models = ledger, frozenset(models)
        self.token = secrets.token_urlsafe(32)
        self.records: list[RequestRecord] = []
        self.held_bytes = 0
        """Of the bodies of its requests that are in work; belongs to the meter's event loop."""
        self.limit_message = ""
        """Why requests were refused for spending; empty while none was."""
        self._at_limit = at_limit
        self._lock = threading.Lock()
        self._sequence = 0

    def next_number(self) -> int:
        """Number of the next request, from 1."""
        with self._lock:
            self._sequence += 1
            return self._sequence

    def price(self, model: str | None) -> Price | None:
        """The price of a model today (UTC)."""
        return self.prices.price(model, datetime.now(UTC).date())

    def admit(self, wire: Wire, model: str | None, body: Mapping[str, Any]) -> tuple[str | None, str]:
        """Whether a request may be sent: its entry in the ledger, and a refusal (empty where it may)."""
        if self.ledger is None:
            return None, ""
        price = self.price(model)
        entry = self.ledger.hold(None if price is None else estimate_usd(wire, body, price))
        if entry is not None:
            return entry, ""
        if price is None:
            message = (
                f"the spending limit of {self.ledger.limit_usd:.2f} USD cannot be kept: no price for model "
                f"{model!r} (add it to prices.yaml)"
            )
        else:
            message = (
                f"the spending limit of this run is reached: {self.ledger.spent().total_usd:.4f} of "
                f"{self.ledger.limit_usd:.4f} USD"
            )
        with self._lock:
            first, self.limit_message = not self.limit_message, message
        if first and self._at_limit is not None:
            self._at_limit()
        return None, message

    def settle(self, entry: str | None, cost_usd: float | None) -> None:
        """Enter what an admitted request cost."""
        if self.ledger is not None and entry is not None:
            self.ledger.settle(entry, cost_usd)

    def record(self, record: RequestRecord) -> None:
        """Keep a record, at once on disk."""
        with self._lock:
            self.records.append(record)
            append_json_line(self.usage, {name: _whole(value) for name, value in record.plain().items()})

    @property
    def last_generation(self) -> RequestRecord | None:
        """The record of the last request that asked for output."""
        with self._lock:
            return next((record for record in reversed(self.records) if record.is_generation), None)


def _whole(value: Any) -> Any:
    """A value as it can be written: half characters, which JSON can name, are replaced."""
    return value.encode("utf-8", "replace").decode() if isinstance(value, str) else value


def estimate_usd(wire: Wire, body: Mapping[str, Any], price: Price) -> float:
    """What a request may cost before anything is known of it, at the dearest price of its input."""
    read, written = estimate_tokens(wire, body)
    dearest = max(price.input, price.cache_write or 0, price.cache_write_1h or 0)
    return (read * dearest + written * price.output) / MILLION


def estimate_tokens(wire: Wire, body: Mapping[str, Any]) -> tuple[float, int]:
    """Tokens that a request may read and write: its text at four characters a token, a flat number of tokens a picture,
    and its own output limit up to 8,192 tokens."""
    characters, pictures = _size(body)
    output = min(wire.most_output(body) or ASSUMED_OUTPUT_TOKENS, ASSUMED_OUTPUT_TOKENS)
    return characters / CHARACTERS_A_TOKEN + pictures * PICTURE_TOKENS, output


def _size(value: Any) -> tuple[int, int]:
    """Characters of text and number of pictures in a request body (a long string without a blank)."""
    characters = pictures = 0
    left = [value]
    while left:
        item = left.pop()
        if isinstance(item, str):
            if len(item) > 2000 and " " not in item:
                pictures += 1
            else:
                characters += len(item)
        elif isinstance(item, Mapping):
            left += item.values()
            characters += sum(map(len, item))
        elif isinstance(item, list):
            left += item
    return characters, pictures
