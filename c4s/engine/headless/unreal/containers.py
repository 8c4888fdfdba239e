"""Name, Text and Array: Unreal's own types, which are not Python's ``str`` and ``list``."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, TypeVar

Self = TypeVar("Self", bound="_Word")


class _Word:
    """An immutable piece of text that compares with ``str`` but is none."""

    __slots__ = ("_text",)

    def __init__(self, value: object = "") -> None:
        if not isinstance(value, (str, _Word)):
            raise TypeError(f"{type(self).__name__}: cannot convert type '{type(value).__name__}' to str")
        self._text = str(value)

    def __str__(self) -> str:
        return self._text

    def __len__(self) -> int:
        return len(self._text)


class Name(_Word):
    """FName: compares without case; the empty name is ``None``."""

    __slots__ = ()

    def __init__(self, value: object = "None") -> None:
        super().__init__(value)
        self._text = self._text or "None"

    def __repr__(self) -> str:
        return f'Name("{self._text}")'

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (str, Name)) and str(other).casefold() == self._text.casefold()

    def __hash__(self) -> int:
        return hash(self._text.casefold())

    def is_none(self) -> bool:
        """Whether this is the empty name."""
        return self._text == "None"


class Text(_Word):
    """FText."""

    __slots__ = ()

    def __repr__(self) -> str:
        return f'Text("{self._text}")'

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (str, Text)) and str(other) == self._text

    def __hash__(self) -> int:
        return hash(self._text)


class Array:
    """TArray: typed, iterable and indexable, but not a list. ``Array(unreal.Vector)`` is empty."""

    __slots__ = ("_items", "_kind")

    def __init__(self, type: Any) -> None:
        self._kind = _kind_name(type)
        self._items: list[Any] = []

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
        from c4s.engine.headless.unreal.core import converted, need

        need(value, self._kind, "Array")
        return converted(value, self._kind)

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

    def __repr__(self) -> str:
        return repr(self._items)

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
        """Cut to ``len`` items; growing is refused for items without a default."""
        if len > self.__len__():
            raise Exception("Array: cannot grow an array of this type")
        del self._items[len:]


def _kind_name(kind: Any) -> str:
    if not isinstance(kind, type):
        raise TypeError(f"Array: cannot convert type '{type(kind).__name__}' to a type")
    return kind.__name__
