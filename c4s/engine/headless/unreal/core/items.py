"""The rules of the object model for items of containers: kinds are checked and converted as those of properties."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.containers import Name, Text
from c4s.engine.headless.unreal.core.checks import TYPES, need
from c4s.engine.headless.unreal.core.properties import converted


class ItemRules:
    """Items by the name of their type."""

    def checked(self, value: Any, kind: str, what: str) -> Any:
        """An item as its container keeps it; ``TypeError`` for one of another type."""
        return converted(need(value, kind, f"{what}: Failed to convert an item", "Item"), kind)

    def initial(self, kind: str) -> Any:
        """The default of an item type."""
        plain: dict[str, Any] = {"int": 0, "float": 0.0, "bool": False, "str": "", "Name": Name(), "Text": Text()}
        found = TYPES.get(kind)
        return (
            plain[kind] if kind in plain else found() if found is not None and hasattr(found, "_from_parts") else None
        )
