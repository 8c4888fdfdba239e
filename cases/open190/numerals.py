"""Counts in words."""

from __future__ import annotations

from typing import Final

UNITS: Final = (
    "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve", "thirteen",
    "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen",
)  # fmt: skip
TENS: Final = ("", "", "twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety")


def numeral(count: int) -> str:
    """A count as prose writes it: in words below a thousand, else in figures."""
    if count < 20:
        return UNITS[count]
    if count < 100:
        tens, rest = divmod(count, 10)
        return TENS[tens] + (f"-{UNITS[rest]}" if rest else "")
    if count < 1000:
        hundreds, rest = divmod(count, 100)
        return f"{UNITS[hundreds]} hundred" + (f" and {numeral(rest)}" if rest else "")
    return f"{count:,}"


def rounded(count: int) -> int:
    """A count as one says it at a glance: to fives below fifty, to tens below two hundred, else to fifties."""
    step = 1 if count < 13 else 5 if count < 50 else 10 if count < 200 else 50
    return round(count / step) * step
