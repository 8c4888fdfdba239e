"""Vectors of a snapshot as the physics rules read them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any


def measured_vector(record: Any, field: str) -> tuple[float, float, float]:
    """Three finite numbers of a record's field; ``ValueError`` otherwise (strings are no numbers, booleans are)."""
    values = record.get(field) if isinstance(record, Mapping) else None
    if type(values) is list and len(values) == 3:
        x, y, z = values
        if type(x) is type(y) is type(z) is float and math.isfinite(x) and math.isfinite(y) and math.isfinite(z):
            return x, y, z
    try:
        if (
            isinstance(values, (list, tuple))
            and len(values) == 3
            and all(isinstance(v, int | float) and math.isfinite(v) for v in values)
        ):
            return float(values[0]), float(values[1]), float(values[2])
    except OverflowError:
        raise ValueError(f"{field} holds a number that is too large") from None
    raise ValueError(f"{field} is not three finite numbers")
