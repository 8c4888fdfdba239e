"""Counts against the quantity of a requirement."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

APPROXIMATE_SHARE = 0.25
"""``approximately N`` accepts N plus or minus a quarter, and at least one more or less."""
WORDS: dict[str, tuple[float, float]] = {
    "one": (1, 1),
    "single": (1, 1),
    "a": (1, math.inf),
    "an": (1, math.inf),
    "some": (1, math.inf),
    "pair": (2, 2),
    "a pair": (2, 2),
    "couple": (2, 2),
    "a couple": (2, 2),
    "two": (2, 2),
    "three": (3, 3),
    "few": (2, 5),
    "a few": (2, 5),
    "multiple": (2, math.inf),
    "several": (3, math.inf),
    "many": (6, math.inf),
    "numerous": (6, math.inf),
    "a dozen": (12, 12),
    "dozen": (12, 12),
    "dozens": (24, math.inf),
}
"""Inclusive limits of number words. Other words (dense, sparse) are no count."""


def limits(quantity: Mapping[str, Any]) -> tuple[float, float] | None:
    """Inclusive (lower, upper) count of a bundle's quantity; None when it is no count."""
    mode, value = str(quantity.get("mode") or ""), quantity.get("value")
    low, high = quantity.get("lower"), quantity.get("upper")
    if mode == "qualitative":
        return WORDS.get(str(quantity.get("qualitative") or "").lower().strip())
    if mode in ("range", "between") and low is not None and high is not None:
        return float(low), float(high)
    if mode in ("at_least", "minimum"):
        bound = value if value is not None else low
        return None if bound is None else (float(bound), math.inf)
    if mode in ("at_most", "maximum"):
        bound = value if value is not None else high
        return None if bound is None else (0.0, float(bound))
    if value is None:
        return None
    number = float(value)
    if mode in ("approximately", "about"):
        slack = max(1.0, APPROXIMATE_SHARE * number)
        return number - slack, number + slack
    return (number, number) if mode in ("exact", "exactly", "equals") else None


def needed(quantity: Mapping[str, Any] | None, *, collection: bool) -> float:
    """The smallest count that satisfies a quantity; without one, 2 for a collection and 1 for an individual."""
    found = limits(quantity) if quantity else None
    return max(1.0, found[0]) if found else (2.0 if collection else 1.0)
