"""How numbers are rounded where people read them: one rule, so that a number looks the same everywhere."""

from __future__ import annotations

from decimal import ROUND_HALF_UP, Decimal
from math import isfinite

_NOISE = 12
"""Digits beyond which a number is what arithmetic left of it."""


def half_up(value: float, decimals: int) -> str:
    """A number with so many decimals, halves away from zero: 0.0875 is 0.088, whatever sum it is of."""
    if not isfinite(value):
        return str(value)
    exact = Decimal(repr(round(float(value), _NOISE)))
    return f"{exact.quantize(Decimal(1).scaleb(-decimals), rounding=ROUND_HALF_UP):f}"
