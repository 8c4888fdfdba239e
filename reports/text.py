"""Numbers and names as the pages write them."""

from __future__ import annotations

import hashlib
import re
from datetime import datetime


def number(value: float | None, digits: int = 3) -> str:
    """A score with three decimals; a dash where there is none."""
    return "–" if value is None else f"{value:.{digits}f}"


def percent(value: float | None) -> str:
    """A score as a CSS width."""
    return "0%" if value is None else f"{100 * value:.2f}%"


def slug(name: str) -> str:
    """A file name for any name; different names never share one."""
    plain = re.sub(r"[^A-Za-z0-9._-]+", "-", name).strip("-.")
    return plain if plain == name else f"{plain}-{hashlib.sha256(name.encode()).hexdigest()[:6]}"


def span(seconds: float | None) -> str:
    """A duration: ``12 s``, ``4 min``, ``3 h 20 min``; a dash where there is none."""
    if seconds is None:
        return "–"
    if seconds < 100:
        return f"{seconds:.0f} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 100 else f"{minutes // 60} h {minutes % 60} min"


def clock(time: float) -> str:
    """A moment (Unix time, seconds) in this machine's zone, to the minute; with the day where it is another one."""
    at = datetime.fromtimestamp(time).astimezone()
    return at.strftime("%H:%M" if at.date() == datetime.now().date() else "%Y-%m-%d %H:%M")
