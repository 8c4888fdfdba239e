"""Counts against the quantity of a requirement."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Final

from c4s.protocol.words import tokens, word_set

APPROXIMATE_SHARE = 0.25
"""``approximately N`` accepts N plus or minus a quarter, and at least one more or less."""
VAGUE_FACTOR = 2.0
"""How far beyond the limits of a vague word a count is still open."""
EXACT_WORDS = frozenset({"one", "single", "pair", "a pair", "couple", "a couple", "two", "three", "a dozen", "dozen"})
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
MEASURED_IN: Final = word_set("""
    mm cm dm m km millimetre millimeter centimetre centimeter metre meter kilometre kilometer inch foot feet ft yard
    mile degree percent storey story level acre hectare hour o'clock""")
"""Units of what is not counted: twelve metres of a wall, three storeys of a house."""


def limits(quantity: Mapping[str, Any]) -> tuple[float, float] | None:
    """Inclusive (lower, upper) count of a bundle's quantity; None when it is no count, or is of a unit of measure."""
    unit = str(quantity.get("unit") or "")
    if "%" in unit or MEASURED_IN & set(tokens(unit)):
        return None
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


def loose_limits(quantity: Mapping[str, Any]) -> tuple[float, float] | None:
    """Limits outside which a count surely does not satisfy a quantity: wider where the words are vague."""
    found = limits(quantity)
    if found is None:
        return None
    mode, word = str(quantity.get("mode") or ""), str(quantity.get("qualitative") or "").lower().strip()
    if mode == "qualitative" and word not in EXACT_WORDS:
        return found[0] / VAGUE_FACTOR, found[1] * VAGUE_FACTOR
    if mode in ("approximately", "about"):
        number = (found[0] + found[1]) / 2
        slack = VAGUE_FACTOR * (found[1] - number)
        return number - slack, number + slack
    return found


def bearable(quantity: Mapping[str, Any] | None, *, collection: bool) -> float:
    """The largest count that a quantity bears; without one, any for a collection and 1 for an individual."""
    found = limits(quantity) if quantity else None
    return max(1.0, found[1]) if found else (math.inf if collection else 1.0)


def needed(quantity: Mapping[str, Any] | None, *, collection: bool) -> float:
    """The smallest count that satisfies a quantity; without one, 2 for a collection and 1 for an individual."""
    found = limits(quantity) if quantity else None
    return max(1.0, found[0]) if found else (2.0 if collection else 1.0)
