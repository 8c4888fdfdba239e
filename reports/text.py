"""Numbers and names as the pages write them."""

from __future__ import annotations

import hashlib
import re
from datetime import datetime
from typing import Final

from c4s.numbers import half_up


def number(value: float | None, digits: int = 3) -> str:
    """A score with three decimals; a dash where there is none."""
    return "–" if value is None else half_up(value, digits)


def percent(value: float | None) -> str:
    """A share as a length of drawings that are 100 wide."""
    return "0" if value is None else f"{100 * value:.2f}"


def step(value: float | None) -> str:
    """The class of a score's shade: ``h0`` to ``h10``; of none, nothing."""
    return "" if value is None else f"h{round(10 * min(1.0, max(0.0, value)))}"


def signed(value: float | None, digits: int = 2) -> str:
    """A difference with its sign; a dash where there is none."""
    return "–" if value is None else f"{value:+.{digits}f}".replace("-", "−")


def headed(title: str) -> str:
    """The title of a column with a capital; one of a letter or with signs, as ``p`` or ``pass@k``, stays."""
    word = title.partition(" ")[0].rstrip(",;:")
    return title[0].upper() + title[1:] if len(word) > 1 and word.isalpha() else title


def p_value(value: float | None) -> str:
    """A p-value with four decimals; one that these do not tell from zero is said to be less."""
    return "< 0.0001" if value is not None and value < 0.00005 else number(value, 4)


MOST_SLUG: Final = 150
"""Characters of a name that a file name keeps: with a suite's id and digests it stays below 255, a folder's most."""


def slug(name: str) -> str:
    """A file name for any name; different names never share one."""
    plain = re.sub(r"[^A-Za-z0-9._-]+", "-", name).strip("-.")[:MOST_SLUG]
    return plain if plain == name else f"{plain}-{hashlib.sha256(name.encode()).hexdigest()[:6]}"


def counted(number: int, one: str, many: str = "") -> str:
    """A number with its noun: ``1 case``, ``16 cases``."""
    return f"{number:,} {one if number == 1 else many or one + 's'}"


def span(seconds: float | None) -> str:
    """A duration: ``12 s``, ``4 min``, ``3 h 20 min``; a dash where there is none."""
    if seconds is None:
        return "–"
    if seconds < 100:
        return f"{seconds:.0f} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 100 else f"{minutes // 60} h {minutes % 60} min"


def moment(seconds: float | None) -> str:
    """A time since a start, with decimals where whole seconds would tell little: ``0.04 s``, ``4.2 s``, ``45 s``."""
    if seconds is None or seconds >= 20:
        return span(seconds)
    return f"{seconds:.2f} s" if seconds < 2 else f"{seconds:.1f} s"


def clock(time: float) -> str:
    """A moment (Unix time, seconds) in this machine's zone, to the minute; with the day where it is another one."""
    at = datetime.fromtimestamp(time).astimezone()
    return at.strftime("%H:%M" if at.date() == datetime.now().date() else "%Y-%m-%d %H:%M")
