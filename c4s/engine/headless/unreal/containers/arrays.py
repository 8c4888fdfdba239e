"""Array and FixedArray."""

from __future__ import annotations

import types
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from c4s.engine.headless.unreal.containers.items import checked, initial, kind_name


class Array:
    """TArray: typed, iterable and indexable, but not a list. ``Array(unreal.Vector)`` is empty."""

    __slots__ = ("_items", "_kind")

    def __init__(self, type: Any) -> None:
        self._kind = kind_name(type)
        self._items: list[Any] = []

    def __class_getitem__(cls, *args: Any) -> Any:
        return types.GenericAlias(cls, args)

    @classmethod
    def _of(cls, kind: str, items: Iterable[Any]) -> Array:
        made = cls.__new__(cls)
        made._kind = kind
        made._items = list(items)
        return made

    @classmethod
    def cast(cls, type: Any, obj: Iterable[Any]) -> Array:
        """An array of ``type`` with the items of ``obj``."""
        made = cls(type)
        made.extend(obj)
        return made

    def _checked(self, value: Any) -> Any:
        return checked(value, self._kind, "Array")

    def __len__(self) -> int:
        return len(self._items)

    def __iter__(self) -> Iterator[Any]:
        return iter(list(self._items))

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return Array._of(self._kind, self._items[index])
        return self._items[index]

    def __setitem__(self, index: int, value: Any) -> None:
        self._items[index] = self._checked(value)

    def __delitem__(self, index: int) -> None:
        del self._items[index]

    def __contains__(self, value: object) -> bool:
        return value in self._items

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Array, list)) and list(other) == self._items

    __hash__ = None  # type: ignore[assignment]

    def __add__(self, other: Iterable[Any]) -> Array:
        joined = self.copy()
        joined.extend(other)
        return joined

    def __mul__(self, count: int) -> Array:
        return Array._of(self._kind, self._items * count)

    def __repr__(self) -> str:
        return repr(self._items)

    def __copy__(self) -> Array:
        return self.copy()

    def copy(self) -> Array:
        """A shallow copy."""
        return Array._of(self._kind, self._items)

    def append(self, value: Any) -> None:
        """Add at the end."""
        self._items.append(self._checked(value))

    def extend(self, values: Iterable[Any]) -> None:
        """Add all."""
        self._items.extend([self._checked(v) for v in values])

    def insert(self, index: int, value: Any) -> None:
        """Insert before ``index``."""
        self._items.insert(index, self._checked(value))

    def remove(self, value: Any) -> None:
        """Remove the first equal item; ``ValueError`` when there is none."""
        self._items.remove(value)

    def clear(self) -> None:
        """Remove all items."""
        self._items.clear()

    def pop(self, index: int = -1) -> Any:
        """Remove and return."""
        return self._items.pop(index)

    def index(self, value: Any, start: int = 0, stop: int = -1) -> int:
        """Index of the first equal item."""
        return self._items.index(value, start, len(self._items) if stop == -1 else stop)

    def count(self, value: Any) -> int:
        """Number of equal items."""
        return self._items.count(value)

    def reverse(self) -> None:
        """Reverse in place."""
        self._items.reverse()

    def sort(self, key: Callable[[Any], Any] | None = None, reverse: bool = False) -> None:
        """Sort in place."""
        self._items.sort(key=key, reverse=reverse)

    def resize(self, len: int) -> None:
        """Cut to ``len`` items, or fill up with defaults."""
        del self._items[len:]
        self._items += [initial(self._kind) for _ in range(len - self.__len__())]


class FixedArray:
    """A typed array of a length that cannot change."""

    __slots__ = ("_items", "_kind")

    def __init__(self, type: Any, len: int) -> None:
        self._kind = kind_name(type)
        self._items = [initial(self._kind) for _ in range(len)]

    def __class_getitem__(cls, *args: Any) -> Any:
        return types.GenericAlias(cls, args)

    @classmethod
    def cast(cls, type: Any, obj: Iterable[Any]) -> FixedArray:
        """A fixed array of ``type`` with the items of ``obj``."""
        items = list(obj)
        made = cls(type, len(items))
        for index, item in enumerate(items):
            made[index] = item
        return made

    def __len__(self) -> int:
        return len(self._items)

    def __iter__(self) -> Iterator[Any]:
        return iter(list(self._items))

    def __getitem__(self, index: int) -> Any:
        return self._items[index]

    def __setitem__(self, index: int, value: Any) -> None:
        self._items[index] = checked(value, self._kind, "FixedArray")

    def __copy__(self) -> FixedArray:
        return self.copy()

    def copy(self) -> FixedArray:
        """A shallow copy."""
        made = FixedArray.__new__(FixedArray)
        made._kind, made._items = self._kind, list(self._items)
        return made
