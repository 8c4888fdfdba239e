"""List prices with dates, and the cost of a request.

The table is data: ``prices.yaml`` beside this file, and the operator's own ``C4S_HOME/prices.yaml``, whose rows win for
a model and day that both name.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import UTC, date, datetime
from pathlib import Path

from pydantic import Field

from c4s.files import read_yaml
from c4s.home import home
from c4s.meter.usage import Usage
from c4s.records.base import Record

MILLION = 1_000_000
SHIPPED = Path(__file__).with_name("prices.yaml")


class Price(Record):
    """What a model costs from a day on, in US dollars per million tokens, standard tier, base context length.

    A cache price that is absent means that the provider sells no such class: its tokens are billed as fresh input.
    """

    model: str
    also: list[str] = Field(default_factory=list)
    """Other ids of the same model (dated snapshots, a router's prefix)."""
    valid_from: date = Field(alias="from")
    until: date | None = None
    """Last day of a rate that is announced to end; afterwards the price is unknown."""
    input: float = Field(ge=0)
    output: float = Field(ge=0)
    cache_read: float | None = Field(default=None, ge=0)
    cache_write: float | None = Field(default=None, ge=0)
    """Cache writes; with ``cache_write_1h``, those that are kept for five minutes."""
    cache_write_1h: float | None = Field(default=None, ge=0)
    source: str
    """Where the rates were read, and when."""


class PriceFile(Record):
    """The YAML file: ``prices``, a list of rows."""

    prices: list[Price]


COST_CLASSES = ("fresh_input", "cache_read", "cache_write", "output")
"""What is priced apart."""


@dataclass(frozen=True)
class Cost:
    """US dollars; None is unknown, and ``reason`` says why."""

    usd: float | None
    reason: str = ""
    classes: Mapping[str, float] = field(default_factory=dict)
    """US dollars of each of ``COST_CLASSES``; empty where the cost is unknown."""


class PriceTable:
    """Prices by model and day."""

    def __init__(self, rows: Iterable[Price]) -> None:
        self._rows: dict[str, list[Price]] = {}
        for row in rows:
            for name in (row.model, *row.also):
                self._rows.setdefault(name, []).append(row)

    @staticmethod
    def load(*files: Path) -> PriceTable:
        """The shipped table and the operator's; later files win. ``BadInput`` for a row that cannot be used."""
        chosen = files or tuple(path for path in (SHIPPED, home() / "prices.yaml") if path.is_file())
        rows: list[Price] = []
        for path in chosen:
            rows += PriceFile.parse(read_yaml(path, what="price table"), where=str(path)).prices
        return PriceTable(rows)

    def price(self, model: str | None, day: date) -> Price | None:
        """The row in force on that day; None where there is none."""
        found = [row for row in self._rows.get(model or "", []) if row.valid_from <= day]
        found = [row for row in found if row.until is None or day <= row.until]
        newest = max((row.valid_from for row in found), default=None)
        return next((row for row in reversed(found) if row.valid_from == newest), None)


def price_today(model: str | None) -> Price | None:
    """The row in force today, of the shipped table or the operator's; None where there is none."""
    return PriceTable.load().price(model, datetime.now(UTC).date())


def cost_of(usage: Usage, price: Price | None) -> Cost:
    """The cost of a request. Unknown where a class that matters is unknown; a class with 0 tokens never matters."""
    if price is None:
        return Cost(None, "no price for this model")
    if usage.output_tokens is None:
        return Cost(None, "output tokens are unknown")
    output = usage.output_tokens * price.output
    one_price = price.cache_read is None and price.cache_write is None and price.cache_write_1h is None
    if one_price and usage.input_tokens is not None:
        return _cost(usage.input_tokens * price.input, 0.0, 0.0, output)
    if usage.fresh_input_tokens is None:
        return Cost(None, "fresh input is unknown")
    if usage.cache_read_tokens is None:
        return Cost(None, "cache reads are unknown")
    if usage.cache_write_tokens is None:
        return Cost(None, "cache writes are unknown")
    short = _or(price.cache_write, price.input)
    hour = _or(price.cache_write_1h, short)
    kept = usage.cache_write_1h_tokens
    if kept is None and hour != short:
        return Cost(None, "the lifetime of cache writes is unknown")
    return _cost(
        usage.fresh_input_tokens * price.input,
        usage.cache_read_tokens * _or(price.cache_read, price.input),
        (usage.cache_write_tokens - (kept or 0)) * short + (kept or 0) * hour,
        output,
    )


def _cost(*micro_usd: float) -> Cost:
    """From millionths of a dollar of each of ``COST_CLASSES``."""
    parts = dict(zip(COST_CLASSES, micro_usd, strict=True))
    return Cost(sum(micro_usd) / MILLION, classes={name: part / MILLION for name, part in parts.items()})


def _or(price: float | None, other: float) -> float:
    return other if price is None else price
