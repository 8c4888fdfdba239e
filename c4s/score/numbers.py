"""What counts as a score: a real number in [0, 1]."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from c4s.errors import BadInput


def unit_number(value: Any) -> float | None:
    """The value as a float when it is a finite number in [0, 1], else None. Booleans and strings are no numbers."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    return float(value) if math.isfinite(value) and 0 <= value <= 1 else None


def required_unit_number(value: Any, name: str, *, where: str = "") -> float:
    """As ``unit_number``, but raises ``BadInput`` where it would be None."""
    number = unit_number(value)
    if number is None:
        raise BadInput(f"{name} must be a number in [0, 1], not {value!r}", where=where)
    return number


def mean(values: Iterable[float]) -> float:
    """Arithmetic mean by an exact sum; the values must not be empty."""
    items = list(values)
    return math.fsum(items) / len(items)
