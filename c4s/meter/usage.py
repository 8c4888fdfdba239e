"""Tokens of one model request, in the classes that are priced apart."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from pydantic import Field

from c4s.records.base import Record

MOST_OF_ONE: Final = 1_000_000_000
"""Tokens of one request; what tells more is not believed, lest one answer use up a run's limit."""
Count = Field(default=None, ge=0)


class MalformedUsage(ValueError):
    """A usage block that cannot be read: what is wrong with it."""


class Usage(Record):
    """Token counts of a request. None is unknown, which is never the same as 0.

    ``input_tokens`` is fresh input + cache reads + cache writes. ``output_tokens`` includes reasoning.
    """

    input_tokens: int | None = Count
    fresh_input_tokens: int | None = Count
    cache_read_tokens: int | None = Count
    cache_write_tokens: int | None = Count
    """All cache writes, whatever their lifetime."""
    cache_write_1h_tokens: int | None = Count
    """The part of ``cache_write_tokens`` that is kept for an hour."""
    output_tokens: int | None = Count
    reasoning_tokens: int | None = Count


ZERO = Usage(
    input_tokens=0,
    fresh_input_tokens=0,
    cache_read_tokens=0,
    cache_write_tokens=0,
    cache_write_1h_tokens=0,
    output_tokens=0,
    reasoning_tokens=0,
)
UNKNOWN = Usage()


def block(parent: Mapping[str, Any], name: str) -> Mapping[str, Any] | None:
    """A nested block; None where it is absent or null. ``MalformedUsage`` when it is something else."""
    value = parent.get(name)
    if value is None or isinstance(value, Mapping):
        return value
    raise MalformedUsage(f"{name} is {type(value).__name__}, not an object")


def tokens(parent: Mapping[str, Any], name: str, default: int | None = None) -> int | None:
    """A token count; ``default`` where it is absent or null. ``MalformedUsage`` for anything but a count."""
    value = parent.get(name)
    if value is None:
        return default
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not number or not 0 <= value <= MOST_OF_ONE or value != int(value):
        raise MalformedUsage(f"{name} is {str(value)[:100]}, not a token count")
    return int(value)


def split_input(total: int | None, cache_read: int | None, cache_write: int | None) -> int | None:
    """Fresh input where ``total`` includes the cache classes; None where a class is unknown."""
    if total is None or cache_read is None or cache_write is None:
        return None
    if cache_read + cache_write > total:
        raise MalformedUsage(f"{cache_read} cache reads and {cache_write} cache writes of {total} input tokens")
    return total - cache_read - cache_write
