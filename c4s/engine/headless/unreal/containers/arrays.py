"""Array and FixedArray."""

from __future__ import annotations

import types
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from c4s.engine.headless.unreal.containers.items import checked, initial, kind_name
from c4s.engine.headless.unreal.containers.live import Live, copied, editing, finite, need_finite


class Array(Live):
    """TArray: typed, iterable and indexable, but not a list. ``Array(unreal.Vector)`` is empty.

    Structs leave it as copies.
    """

    __slots__ = ("_home", "_items", "_kind")

    def __init__(self, type: Any) -> None:
        self._home = None
        self._kind = kind_name(type)
        self._items: list[Any] = []

    def __class_getitem__(cls, *args: Any) -> Any:
        return types.GenericAlias(cls, args)

    @classmethod
    def _of(cls, kind: str, items: Iterable[Any]) -> Array:
        made = cls.__new__(cls)
        made._home = None
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
        item = checked(value, self._kind, "Array")
        need_finite(item, self)
        return item

    def _become(self, other: Array) -> None:
        self._items = list(other._items)

    def _finite(self) -> bool:
        return all(map(finite, self._items))

    def __len__(self) -> int:
        return len(self._items)

    def __iter__(self) -> Iterator[Any]:
        items = self._items
        return iter([item.copy() for item in items] if items and isinstance(items[0], Live) else list(items))

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return Array._of(self._kind, self._items[index])
        return copied(self._items[index])

    @editing
    def __setitem__(self, index: int, value: Any) -> None:
        self._items[index] = self._checked(value)

    @editing
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

    @editing
    def append(self, value: Any) -> None:
        """Add at the end."""
        self._items.append(self._checked(value))

    @editing
    def extend(self, values: Iterable[Any]) -> None:
        """Add all."""
        self._items.extend([self._checked(v) for v in values])

    @editing
    def insert(self, index: int, value: Any) -> None:
        """Insert before ``index``."""
        self._items.insert(index, self._checked(value))

    @editing
    def remove(self, value: Any) -> None:
        """Remove the first equal item; ``ValueError`` when there is none."""
        self._items.remove(value)

    @editing
    def clear(self) -> None:
        """Remove all items."""
        self._items.clear()

    @editing
    def pop(self, index: int = -1) -> Any:
        """Remove and return."""
        return copied(self._items.pop(index))

    def index(self, value: Any, start: int = 0, stop: int = -1) -> int:
        """Index of the first equal item."""
        return self._items.index(value, start, len(self._items) if stop == -1 else stop)

    def count(self, value: Any) -> int:
        """Number of equal items."""
        return self._items.count(value)

    @editing
    def reverse(self) -> None:
        """Reverse in place."""
        self._items.reverse()

    @editing
    def sort(self, key: Callable[[Any], Any] | None = None, reverse: bool = False) -> None:
        """Sort in place."""
        self._items.sort(key=key, reverse=reverse)

    @editing
    def resize(self, len: int) -> None:
        """Cut to ``len`` items, or fill up with defaults."""
        del self._items[len:]
        self._items += [initial(self._kind) for _ in range(len - self.__len__())]


class FixedArray(Live):
    """A typed array of a length that cannot change."""

    __slots__ = ("_home", "_items", "_kind")

    def __init__(self, type: Any, len: int) -> None:
        self._home = None
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
        return iter([copied(item) for item in self._items])

    def __getitem__(self, index: int) -> Any:
        return copied(self._items[index])

    @editing
    def __setitem__(self, index: int, value: Any) -> None:
        item = checked(value, self._kind, "FixedArray")
        need_finite(item, self)
        self._items[index] = item

    def _become(self, other: FixedArray) -> None:
        self._items = list(other._items)

    def _finite(self) -> bool:
        return all(map(finite, self._items))

    def __copy__(self) -> FixedArray:
        return self.copy()

    def copy(self) -> FixedArray:
        """A shallow copy."""
        made = FixedArray.__new__(FixedArray)
        made._home, made._kind, made._items = None, self._kind, list(self._items)
        return made
