"""Map."""

from __future__ import annotations

import types
from collections.abc import ItemsView, Iterable, Iterator, KeysView, Mapping, ValuesView
from typing import Any

from c4s.engine.headless.unreal.containers.items import checked, kind_name
from c4s.engine.headless.unreal.containers.live import Live, copied, editing, finite, need_finite
from c4s.engine.headless.unreal.containers.words import Name

_MISSING = object()


class Map(Live):
    """TMap: typed keys and values; not a dict."""

    __slots__ = ("_home", "_items", "_key", "_value")

    def __init__(self, key: Any, value: Any) -> None:
        self._home = None
        self._key, self._value = kind_name(key), kind_name(value)
        self._items: dict[Any, Any] = {}

    def __class_getitem__(cls, *args: Any) -> Any:
        return types.GenericAlias(cls, args)

    @classmethod
    def _of(cls, key: str, value: str, items: Mapping[Any, Any]) -> Map:
        made = cls.__new__(cls)
        made._home, made._key, made._value, made._items = None, key, value, dict(items)
        return made

    @classmethod
    def cast(cls, key: Any, value: Any, obj: Any) -> Map:
        """A map with the pairs of ``obj``."""
        made = cls(key, value)
        made.update(obj)
        return made

    @classmethod
    def fromkeys(cls, sequence: Iterable[Any], value: Any) -> Map:
        """A map with one value under each key."""
        keys = list(sequence)
        made = cls(type(keys[0]) if keys else str, type(value))
        made.update(dict.fromkeys(keys, value))
        return made

    def _at(self, key: Any) -> Any:
        return checked(key, self._key, "Map")

    def _become(self, other: Map) -> None:
        self._items = dict(other._items)

    def _finite(self) -> bool:
        return all(map(finite, self._items.values()))

    def __len__(self) -> int:
        return len(self._items)

    def __iter__(self) -> Iterator[Any]:
        return iter(list(self._items))

    def __contains__(self, key: object) -> bool:
        return key in self._items or Name(key) in self._items if isinstance(key, str) else key in self._items

    def __getitem__(self, key: Any) -> Any:
        return copied(self._items[self._at(key)])

    @editing
    def __setitem__(self, key: Any, value: Any) -> None:
        item = checked(value, self._value, "Map")
        need_finite(item, self)
        self._items[self._at(key)] = item

    @editing
    def __delitem__(self, key: Any) -> None:
        del self._items[self._at(key)]

    def __eq__(self, other: object) -> bool:
        return dict(other) == self._items if isinstance(other, (Map, dict)) else False

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return repr(self._items)

    def __copy__(self) -> Map:
        return self.copy()

    def copy(self) -> Map:
        """A shallow copy."""
        return Map._of(self._key, self._value, self._items)

    @editing
    def clear(self) -> None:
        """Remove all pairs."""
        self._items.clear()

    def get(self, key: Any, default: Any = None) -> Any:
        """Value under a key, or ``default``."""
        return copied(self._items.get(self._at(key), default))

    def setdefault(self, key: Any, default: Any = None) -> Any:
        """Value under a key, which is set when missing."""
        if self._at(key) not in self._items:
            self[key] = default
        return self[key]

    @editing
    def pop(self, key: Any, default: Any = _MISSING) -> Any:
        """Remove a pair and give its value."""
        return self._items.pop(self._at(key)) if default is _MISSING else self._items.pop(self._at(key), default)

    @editing
    def popitem(self) -> tuple[Any, Any]:
        """Remove the last pair."""
        return self._items.popitem()

    def update(self, pairs: Any) -> None:
        """Set all pairs of a mapping or of a sequence of pairs."""
        for key, value in pairs.items() if hasattr(pairs, "items") else pairs:
            self[key] = value

    def items(self) -> ItemsView[Any, Any]:
        """Pairs."""
        return {key: copied(value) for key, value in self._items.items()}.items()

    def keys(self) -> KeysView[Any]:
        """Keys."""
        return dict(self._items).keys()

    def values(self) -> ValuesView[Any]:
        """Values."""
        return {key: copied(value) for key, value in self._items.items()}.values()
