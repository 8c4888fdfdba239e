"""Structs by declared fields."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from typing import Any, ClassVar

from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import TYPES, Prop, camel, converted, copied, need
from c4s.engine.headless.unreal.core.enumeration import PropertyAccessChangeNotifyMode
from c4s.engine.headless.unreal.structs.text import read_text, write_text


class StructBase:
    """Fields by declaration, in constructor order. Equality by value; not hashable."""

    _fields: ClassVar[dict[str, Prop]] = {}
    _takes: ClassVar[int | None] = None
    """How many fields the constructor takes, when not all."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        names = list(self._fields)[: self._takes]
        if len(args) > len(names):
            raise TypeError(f"{type(self).__name__}() takes at most {len(names)} arguments ({len(args)} given)")
        given = dict(zip(names, args, strict=False))
        for name, value in kwargs.items():
            if name not in names:
                raise TypeError(f"'{name}' is an invalid keyword argument for {type(self).__name__}()")
            if name in given:
                raise TypeError(f"{type(self).__name__}() got multiple values for argument '{name}'")
            given[name] = value
        for name, prop in self._fields.items():
            if name in given:
                self._put(name, given[name])
            else:
                default = prop.default() if callable(prop.default) else prop.default
                object.__setattr__(self, name, default)

    @classmethod
    def _from_parts(cls, parts: Any) -> Any:
        """A struct of a sequence of constructor arguments, or of a mapping of its fields, as Unreal converts them."""
        if isinstance(parts, Mapping):
            made = cls()
            for name, value in parts.items():
                made.set_editor_property(str(name), value)
            return made
        limit = len(inspect.signature(cls.__init__).parameters) - 1 if "__init__" in cls.__dict__ else len(cls._fields)
        limit = limit if cls._takes is None else cls._takes
        if len(parts) > limit:
            raise TypeError(
                f"{cls.__name__}: Struct has {limit} initialization parameters, but the given sequence had "
                f"{len(parts)} elements"
            )
        return cls(*parts)

    @classmethod
    def cast(cls, object: Any) -> Any:
        """A copy of a struct, or a struct of a sequence or mapping; ``TypeError`` for anything else."""
        return copied(need(object, cls.__name__, f"Cannot cast type '{type(object).__name__}' to '{cls.__name__}'"))

    @classmethod
    def static_struct(cls) -> Any:
        """The struct's type as an object."""
        return TYPES["ScriptStruct"]._make(cls.__name__, None)  # type: ignore[attr-defined]

    @classmethod
    def _of_fields(cls, *values: Any) -> Any:
        """A struct with its first fields set, whatever its constructor takes."""
        made = cls()
        for name, value in zip(cls._fields, values, strict=False):
            made._put(name, value)
        return made

    def __setattr__(self, name: str, value: Any) -> None:
        prop = self._fields.get(name)
        if prop is None or not prop.attribute:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        self._put(name, value)

    def _put(self, name: str, value: Any) -> None:
        prop = self._fields[name]
        if type(value).__name__ != prop.kind:
            owner = type(self).__name__
            value = need(
                value,
                prop.kind,
                f"{owner}: Failed to convert type '{type(value).__name__}' to property "
                f"'{camel(name)}' for attribute '{name}' on '{owner}'",
                name,
            )
        object.__setattr__(self, name, converted(value, prop.kind))

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self.to_tuple() == other.to_tuple()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        inner = ", ".join(f"{n}: {self.__dict__[n]!r}" for n in self._fields)
        return f"<Struct '{type(self).__name__}' {{{inner}}}>"

    def copy(self) -> Any:
        """An independent copy."""
        made = type(self).__new__(type(self))
        for name in self._fields:
            object.__setattr__(made, name, copied(self.__dict__[name]))
        return made

    def __copy__(self) -> Any:
        return self.copy()

    def assign(self, other: Any) -> None:
        """Take over all fields of a struct of the same type."""
        need(other, type(self).__name__, f"{type(self).__name__}.assign")
        for name in self._fields:
            object.__setattr__(self, name, copied(other.__dict__[name]))

    def to_tuple(self) -> tuple[Any, ...]:
        """All fields in order."""
        return tuple(self.__dict__[n] for n in self._fields)

    def get_editor_property(self, name: str | Name) -> Any:
        """A field by name."""
        self._known(name)
        return copied(self.__dict__[str(name)])

    def set_editor_property(
        self,
        name: str | Name,
        value: Any,
        notify_mode: PropertyAccessChangeNotifyMode = PropertyAccessChangeNotifyMode.DEFAULT,
    ) -> None:
        """Set a field by name."""
        self._known(name)
        self._put(str(name), value)

    def _known(self, name: object) -> None:
        prop = self._fields.get(str(name))
        if prop is None or not prop.scripts:
            owner = type(self).__name__
            raise Exception(f"{owner}: Failed to find property '{name}' for attribute '{name}' on '{owner}'")

    def set_editor_properties(self, properties: Mapping[str, Any]) -> None:
        """Set several fields by name."""
        for name, value in properties.items():
            self.set_editor_property(name, value)

    def import_text(self, content: str) -> bool:
        """Read the fields of Unreal's text form, ``(X=1.0,Y=2.0)``; False (and nothing set) when it is none."""
        return read_text(self, content)

    def export_text(self) -> str:
        """Unreal's text form."""
        return "(" + ",".join(f"{camel(n)}={write_text(self.__dict__[n])}" for n in self._fields) + ")"


class ClosedStruct(StructBase):
    """A struct with fields that are no attributes: scripts reach them by ``get_editor_property``, or not at all."""

    def __getattribute__(self, name: str) -> Any:
        if not name.startswith("_"):
            prop = type(self)._fields.get(name)
            if prop is not None and not prop.attribute:
                raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        return super().__getattribute__(name)
