"""Editor properties: declared in tables, read as copies, refused when unknown."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from c4s.engine.headless.unreal.containers import Array, Name, Text
from c4s.engine.headless.unreal.core.checks import camel, need, property_kind
from c4s.engine.headless.unreal.core.enumeration import PropertyAccessChangeNotifyMode


@dataclass(frozen=True)
class Prop:
    """An editor property: kind, default, and whether scripts may see it as an attribute and write it."""

    kind: str
    default: Any = None
    attribute: bool = True
    writable: bool = True
    get: str = ""
    """Method that computes it, instead of the stored value."""
    set: str = ""
    """Method that applies a new value."""
    saved: bool = True
    """Whether a level or asset document keeps it when it differs from the default."""
    scripts: bool = True
    """Whether ``get_editor_property`` and ``set_editor_property`` know it."""


_IMMUTABLE = frozenset({bool, int, float, str, Name, Text})


def copied(value: Any) -> Any:
    """Structs and arrays leave an object as copies."""
    if value is None or type(value) in _IMMUTABLE:
        return value
    return value.copy() if hasattr(value, "copy") and not isinstance(value, dict) else value


def _finite(value: Any) -> bool:
    """Whether a value holds no NaN and no infinity: no level can hold them either."""
    if isinstance(value, float):
        return math.isfinite(value)
    if isinstance(value, Array):
        return all(_finite(item) for item in value)
    return not hasattr(value, "to_tuple") or all(_finite(part) for part in value.to_tuple())


class ObjectBase:
    """Properties by declaration. Unknown attributes and properties are refused."""

    _declares: ClassVar[dict[str, Prop]] = {}
    _properties: ClassVar[dict[str, Prop]] = {}

    def __init_subclass__(cls) -> None:
        merged: dict[str, Prop] = {}
        for base in reversed(cls.__mro__):
            merged.update(base.__dict__.get("_declares", {}))
        cls._properties = merged

    def __getattr__(self, name: str) -> Any:
        prop = type(self)._properties.get(name)
        if prop is None or not prop.attribute:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        return self._read(name, prop)

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            object.__setattr__(self, name, value)
            return
        prop = type(self)._properties.get(name)
        if prop is None or not prop.attribute:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        self._write(name, prop, value)

    def __dir__(self) -> Iterable[str]:
        names = {n for n in super().__dir__() if not n.startswith("_")}
        return sorted(names | {n for n, p in type(self)._properties.items() if p.attribute})

    def _read(self, name: str, prop: Prop) -> Any:
        self._need_alive()
        if prop.get:
            return getattr(self, prop.get)()
        values: dict[str, Any] = self._values
        if name not in values:
            default = prop.default
            return default() if callable(default) else copied(default)
        return copied(values[name])

    def _write(self, name: str, prop: Prop, value: Any) -> None:
        self._need_alive()
        owner = type(self).__name__
        if not prop.writable:
            raise Exception(
                f"{owner}: Property '{camel(name)}' for attribute '{name}' on '{owner}' is read-only and cannot be set"
            )
        if type(value).__name__ != prop.kind:
            value = need(
                value,
                prop.kind,
                f"{owner}: Failed to convert type '{type(value).__name__}' to property "
                f"'{camel(name)}' ({property_kind(prop.kind)}) for attribute '{name}' "
                f"on '{owner}'",
                name,
            )
        if not _finite(value):
            raise Exception(
                f"{owner}: Property '{camel(name)}' for attribute '{name}' on '{owner}' takes finite numbers"
            )
        if prop.set:
            getattr(self, prop.set)(value)
        else:
            self._values[name] = converted(value, prop.kind)
        self._changed(name)

    def _changed(self, name: str) -> None:
        """Called after a property was written."""

    def _need_alive(self) -> None:
        """Refuse the use of an object that is gone."""

    @classmethod
    def _property(cls, name: str) -> tuple[str, Prop]:
        """A property by its Python name, or by its C++ name, as Unreal finds it too."""
        prop = cls._properties.get(name)
        if prop is None:
            wanted = name.casefold()
            for own, each in cls._properties.items():
                if wanted in (camel(own).casefold(), f"b{camel(own)}".casefold() if each.kind == "bool" else ""):
                    name, prop = own, each
        if prop is None or not prop.scripts:
            raise Exception(
                f"{cls.__name__}: Failed to find property '{name}' for attribute '{name}' on '{cls.__name__}'"
            )
        return name, prop

    def get_editor_property(self, name: str | Name) -> Any:
        """Value of an editor property; structs and arrays are copies."""
        if type(name) is not str:
            name = str(need(name, "str", f"{type(self).__name__}.get_editor_property"))
        return self._read(*self._property(name))

    def set_editor_property(
        self,
        name: str | Name,
        value: Any,
        notify_mode: PropertyAccessChangeNotifyMode = PropertyAccessChangeNotifyMode.DEFAULT,
    ) -> None:
        """Set an editor property."""
        own, prop = self._property(str(need(name, "str", f"{type(self).__name__}.set_editor_property")))
        self._write(own, prop, value)

    def set_editor_properties(self, properties: Mapping[str, Any]) -> None:
        """Set several editor properties."""
        for name, value in properties.items():
            self.set_editor_property(name, value)


def converted(value: Any, kind: str) -> Any:
    """A stored copy of a checked value, in the declared kind."""
    if type(value) is float:
        return value
    if kind == "float":
        return float(value)
    if kind == "int":
        return int(value)
    if kind == "bool":
        return bool(value)
    if kind == "Name":
        return Name(str(value))
    if kind == "str":
        return str(value)
    if kind == "Text":
        return Text(str(value))
    if kind == "Class" and isinstance(value, type):
        return value.static_class()  # type: ignore[attr-defined]
    if kind.startswith("Sequence"):
        item = kind[len("Sequence[") : -1]
        return Array._of(item, [converted(v, item) for v in value])
    return copied(value)
