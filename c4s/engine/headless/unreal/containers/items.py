"""Items of typed containers: checked, converted, and their defaults, by the rules that ``core`` registers."""

from __future__ import annotations

from typing import Any, Protocol


class Rules(Protocol):
    """How values of a kind are taken: the containers hold them, the object model that is built on them knows."""

    def checked(self, value: Any, kind: str, what: str) -> Any:
        """An item as its container keeps it; ``TypeError`` for one of another type."""
        ...

    def initial(self, kind: str) -> Any:
        """The default of an item type."""
        ...


_rules: list[Rules] = []


def register(rules: Rules) -> None:
    """Let all containers use these rules."""
    _rules[:] = [rules]


def kind_name(kind: Any) -> str:
    """Name of an item type; ``TypeError`` for what is no type."""
    if not isinstance(kind, type):
        raise TypeError(f"Array: cannot convert type '{type(kind).__name__}' to a type")
    return kind.__name__


def checked(value: Any, kind: str, what: str) -> Any:
    """An item as its container keeps it; ``TypeError`` for one of another type."""
    return _rules[0].checked(value, kind, what)


def initial(kind: str) -> Any:
    """The default of an item type."""
    return _rules[0].initial(kind)
