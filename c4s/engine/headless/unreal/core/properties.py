"""Editor properties: declared in tables, refused when unknown. Structs and containers refer to their object."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from c4s.engine.headless.unreal.containers import Array, Name, Text
from c4s.engine.headless.unreal.containers.live import Live, copied, finite
from c4s.engine.headless.unreal.core.checks import camel, need, property_kind
from c4s.engine.headless.unreal.core.enumeration import PropertyAccessChangeNotifyMode
from c4s.engine.headless.unreal.core.later import properties_of


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


class ObjectBase:
    """Properties by declaration. Unknown attributes and properties are refused."""

    _declares: ClassVar[dict[str, Prop]] = {}
    _declared: ClassVar[dict[str, Prop]] = {}
    """What the class and its bases declare."""
    _properties: ClassVar[dict[str, Prop]] = {}
    """The same; what the table has beyond that joins when a name is not found here."""
    _views: dict[str, tuple[Any, Any]] | None = None
    """What computed properties gave out, by name, each with the numbers that it was computed as."""

    def __init_subclass__(cls) -> None:
        merged: dict[str, Prop] = {}
        for base in reversed(cls.__mro__):
            merged.update(base.__dict__.get("_declares", {}))
        cls._declared = cls._properties = merged

    @classmethod
    def _known(cls, name: str) -> Prop | None:
        """A property by its Python name."""
        found = cls._properties.get(name)
        return found if found is not None else cls._completed().get(name)

    @classmethod
    def _completed(cls) -> dict[str, Prop]:
        """All properties, those of the table too."""
        if "_has_all" not in cls.__dict__:
            merged: dict[str, Prop] = {}
            for base in reversed(cls.__mro__):
                merged.update(properties_of(base.__name__))
            cls._properties = {**merged, **cls._properties}
            cls._has_all = True  # type: ignore[attr-defined]
        return cls._properties

    def __getattr__(self, name: str) -> Any:
        prop = type(self)._known(name) if name[0] != "_" else None
        if prop is None or not prop.attribute:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        return self._read(name, prop)

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            object.__setattr__(self, name, value)
            return
        prop = type(self)._known(name)
        if prop is None or not prop.attribute:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        self._write(name, prop, value)

    def __dir__(self) -> Iterable[str]:
        names = {n for n in super().__dir__() if not n.startswith("_")}
        return sorted(names | {n for n, p in type(self)._completed().items() if p.attribute})

    def _read(self, name: str, prop: Prop) -> Any:
        self._need_alive()
        if prop.get:
            value = getattr(self, prop.get)()
            return self._viewed(name, value) if prop.set and isinstance(value, Live) else value
        values: dict[str, Any] = self._values
        if name in values:
            value = values[name]
        else:
            value = prop.default() if callable(prop.default) else copied(prop.default)
            if not isinstance(value, Live):
                return value
            values[name] = value
        if isinstance(value, Live) and value._home is None:
            value._settle(self, name)
        return value

    def _viewed(self, name: str, value: Live) -> Live:
        """What a computed property gave out before, brought up to date, or ``value`` as the first."""
        if self._views is None:
            self._views = {}
        numbers = value.to_tuple()  # type: ignore[attr-defined]
        held = self._views.get(name)
        if held is None:
            value._settle(self, name)
            self._views[name] = (value, numbers)
            return value
        view: Live = held[0]
        if held[1] != numbers:
            view._become(value)
            self._views[name] = (view, numbers)
        return view

    def _refresh_views(self) -> None:
        """Bring what computed properties gave out up to date."""
        for name in list(self._views or ()):
            self._viewed(name, getattr(self, type(self)._properties[name].get)())

    def _ready(self) -> None:
        self._need_alive()

    def _member_edited(self, name: str) -> None:
        prop = type(self)._properties[name]
        if prop.set:
            views = self._views or {}
            view, _ = views.pop(name)
            try:
                getattr(self, prop.set)(view)
            finally:
                views[name] = (view, getattr(self, prop.get)().to_tuple())
        self._changed(name)

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
        if not finite(value):
            raise Exception(
                f"{owner}: Property '{camel(name)}' for attribute '{name}' on '{owner}' takes finite numbers"
            )
        if prop.set:
            getattr(self, prop.set)(value)
        else:
            value, held = converted(value, prop.kind), self._values.get(name)
            if isinstance(held, Live) and isinstance(value, Live):
                held._become(value)
            else:
                self._values[name] = value
        self._changed(name)

    def _changed(self, name: str) -> None:
        """Called after a property was written."""

    def _need_alive(self) -> None:
        """Refuse the use of an object that is gone."""

    @classmethod
    def _property(cls, name: str) -> tuple[str, Prop]:
        """A property by its Python name, or by its C++ name, as Unreal finds it too."""
        prop = cls._known(name)
        if prop is None:
            own = named(name, cls._properties)
            prop = cls._properties.get(own)
            name = name if prop is None else own
        if prop is None or not prop.scripts:
            raise Exception(
                f"{cls.__name__}: Failed to find property '{name}' for attribute '{name}' on '{cls.__name__}'"
            )
        return name, prop

    def get_editor_property(self, name: str | Name) -> Any:
        """Value of an editor property; structs and containers refer to this object."""
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


def named(name: str, table: Mapping[str, Prop]) -> str:
    """The Python name of a C++ one: ``Unbound`` or ``bUnbound`` for ``unbound``; itself when there is none."""
    wanted = name.replace("_", "").casefold()
    for own, prop in table.items():
        plain = own.replace("_", "")
        if wanted == plain or (prop.kind == "bool" and wanted == f"b{plain}"):
            return own
    return name


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
