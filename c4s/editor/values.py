"""Values of an engine as JSON. Runs inside an engine: stdlib only."""

from __future__ import annotations

from typing import Any


def plain(value: Any) -> Any:
    """A number or text as it is, a colour or vector as a row, an enum as its text; None for any other thing."""
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if all(hasattr(value, name) for name in "rgba"):
        return [value.r, value.g, value.b, value.a]
    for names in ("xyzw", "xyz"):
        if all(hasattr(value, name) for name in names):
            return [float(getattr(value, name)) for name in names]
    is_enum = (hasattr(value, "name") and hasattr(value, "value")) or "enum" in type(value).__name__.lower()
    return str(value) if is_enum else None
