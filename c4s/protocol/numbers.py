"""What counts as a score: a real number in [0, 1]."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from c4s.errors import BadInput


def unit_number(value: Any) -> float | None:
    """The value as a float when it is a finite number in [0, 1], else None. Booleans and strings are no numbers."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    return float(value) if 0 <= value <= 1 else None


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


def ordered_sum(values: Iterable[float]) -> float:
    """Sum from left to right, rounded at each step as the published scorer does: ``sum`` adds otherwise from Python
    3.12 on."""
    total = 0.0
    for value in values:
        total += value
    return total


def weighted_mean(pairs: Iterable[tuple[float, float]]) -> float:
    """Mean of ``(weight, value)`` pairs, summed in their order. ``BadInput`` when the weights sum to zero."""
    weights = values = 0.0
    for weight, value in pairs:
        weights += weight
        values += weight * value
    if weights == 0:
        raise BadInput("weights sum to zero")
    return values / weights


def record(value: Any, name: str) -> Mapping[str, Any]:
    """A section of a report: the object, or an empty one for null. ``BadInput`` for anything else."""
    if isinstance(value, Mapping):
        return value
    if value:
        raise BadInput(f"{name} must be a JSON object")
    return {}


def records(value: Any, name: str) -> list[Mapping[str, Any]]:
    """A list of objects, empty for null. ``BadInput`` for anything else."""
    if not value:
        return []
    if not isinstance(value, (list, tuple)) or not all(isinstance(item, Mapping) for item in value):
        raise BadInput(f"{name} must be a list of JSON objects")
    return list(value)
