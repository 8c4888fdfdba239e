"""What is declared elsewhere, when it is first named: types by name, and more properties of a class."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Types(dict[str, type]):
    """Types by name; one that is not there yet is asked for."""

    def __missing__(self, name: str) -> type:
        found = _types(name)
        if found is None:
            raise KeyError(name)
        return found

    def get(self, name: str, default: Any = None) -> Any:
        """A type, or ``default``."""
        try:
            return self[name]
        except KeyError:
            return default

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and self.get(name) is not None


def _no_type(name: str) -> type | None:
    return None


def _no_properties(name: str) -> dict[str, Any]:
    return {}


_types: Callable[[str], type | None] = _no_type
_properties: Callable[[str], dict[str, Any]] = _no_properties


def offer(types: Callable[[str], type | None], properties: Callable[[str], dict[str, Any]]) -> None:
    """Let types and properties of classes be found here too."""
    global _types, _properties
    _types, _properties = types, properties


def properties_of(name: str) -> dict[str, Any]:
    """More properties of a class, its own only."""
    return _properties(name)
