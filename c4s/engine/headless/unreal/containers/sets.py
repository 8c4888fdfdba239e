"""Set."""

from __future__ import annotations

import types
from collections.abc import Iterable, Iterator
from typing import Any

from c4s.engine.headless.unreal.containers.items import checked, kind_name
from c4s.engine.headless.unreal.containers.live import Live, copied, editing, finite, need_finite


class Set(Live):
    """TSet: typed items, each once; not a Python set."""

    __slots__ = ("_home", "_items", "_kind")

    def __init__(self, type: Any) -> None:
        self._home = None
        self._kind = kind_name(type)
        self._items: dict[Any, None] = {}

    def __class_getitem__(cls, *args: Any) -> Any:
        return types.GenericAlias(cls, args)

    @classmethod
    def cast(cls, type: Any, obj: Iterable[Any]) -> Set:
        """A set of ``type`` with the items of ``obj``."""
        made = cls(type)
        made.update(obj)
        return made

    def _like(self, items: Iterable[Any]) -> Set:
        made = Set.__new__(Set)
        made._home, made._kind, made._items = None, self._kind, dict.fromkeys(items)
        return made

    def _checked(self, value: Any) -> Any:
        item = checked(value, self._kind, "Set")
        need_finite(item, self)
        return item

    def _become(self, other: Set) -> None:
        self._items = dict(other._items)

    def _finite(self) -> bool:
        return all(map(finite, self._items))

    def __len__(self) -> int:
        return len(self._items)

    def __iter__(self) -> Iterator[Any]:
        return iter([copied(item) for item in self._items])

    def __contains__(self, value: object) -> bool:
        return self._checked(value) in self._items

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Set, set, frozenset)) and set(other) == set(self._items)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return "{" + ", ".join(map(repr, self._items)) + "}"

    def __copy__(self) -> Set:
        return self.copy()

    def copy(self) -> Set:
        """A shallow copy."""
        return self._like(self._items)

    @editing
    def add(self, value: Any) -> None:
        """Add an item."""
        self._items[self._checked(value)] = None

    @editing
    def discard(self, value: Any) -> None:
        """Remove an item if it is there."""
        self._items.pop(self._checked(value), None)

    @editing
    def remove(self, value: Any) -> None:
        """Remove an item; ``KeyError`` when it is not there."""
        del self._items[self._checked(value)]

    @editing
    def pop(self) -> Any:
        """Remove some item."""
        return self._items.popitem()[0]

    @editing
    def clear(self) -> None:
        """Remove all items."""
        self._items.clear()

    def _others(self, iterables: Iterable[Iterable[Any]]) -> list[set[Any]]:
        return [{self._checked(v) for v in each} for each in iterables]

    def difference(self, *iterable: Iterable[Any]) -> Set:
        """Items that are in none of the others."""
        others = self._others(iterable)
        return self._like(v for v in self._items if not any(v in o for o in others))

    @editing
    def difference_update(self, *iterables: Iterable[Any]) -> None:
        """Keep the items that are in none of the others."""
        self._items = self.difference(*iterables)._items

    def intersection(self, *iterables: Iterable[Any]) -> Set:
        """Items that are in all others too."""
        others = self._others(iterables)
        return self._like(v for v in self._items if all(v in o for o in others))

    @editing
    def intersection_update(self, *iterables: Iterable[Any]) -> None:
        """Keep the items that are in all others too."""
        self._items = self.intersection(*iterables)._items

    def symmetric_difference(self, other: Iterable[Any]) -> Set:
        """Items that are in one of the two."""
        theirs = self._others([other])[0]
        return self._like([*(v for v in self._items if v not in theirs), *(v for v in theirs if v not in self._items)])

    @editing
    def symmetric_difference_update(self, other: Iterable[Any]) -> None:
        """Keep the items that are in one of the two."""
        self._items = self.symmetric_difference(other)._items

    def union(self, *iterables: Iterable[Any]) -> Set:
        """Items of all."""
        made = self.copy()
        made.update(*iterables)
        return made

    def update(self, *iterables: Iterable[Any]) -> None:
        """Add the items of all."""
        for each in iterables:
            for value in each:
                self.add(value)

    def isdisjoint(self, other: Iterable[Any]) -> bool:
        """Whether no item is shared."""
        return not set(self._items) & self._others([other])[0]

    def issubset(self, other: Iterable[Any]) -> bool:
        """Whether all items are in the other."""
        return set(self._items) <= self._others([other])[0]

    def issuperset(self, other: Iterable[Any]) -> bool:
        """Whether all items of the other are here."""
        return set(self._items) >= self._others([other])[0]
