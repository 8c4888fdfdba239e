"""Items of typed containers: checked, converted, and their defaults."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.containers.words import Name, Text


def kind_name(kind: Any) -> str:
    """Name of an item type; ``TypeError`` for what is no type."""
    if not isinstance(kind, type):
        raise TypeError(f"Array: cannot convert type '{type(kind).__name__}' to a type")
    return kind.__name__


def checked(value: Any, kind: str, what: str) -> Any:
    """An item as its container keeps it; ``TypeError`` for one of another type."""
    from c4s.engine.headless.unreal.core import converted, need

    return converted(need(value, kind, f"{what}: Failed to convert an item", "Item"), kind)


def initial(kind: str) -> Any:
    """The default of an item type."""
    from c4s.engine.headless.unreal.core import TYPES

    plain: dict[str, Any] = {"int": 0, "float": 0.0, "bool": False, "str": "", "Name": Name(), "Text": Text()}
    found = TYPES.get(kind)
    return plain[kind] if kind in plain else found() if found is not None and hasattr(found, "_from_parts") else None
