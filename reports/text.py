"""Numbers and names as the pages write them."""

from __future__ import annotations

import hashlib
import re


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
