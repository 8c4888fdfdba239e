"""Structs by declared fields."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, ClassVar

from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.containers.live import Live, Owner, finite, need_finite
from c4s.engine.headless.unreal.core import TYPES, Prop, camel, converted, copied, named, need
from c4s.engine.headless.unreal.core.enumeration import PropertyAccessChangeNotifyMode
from c4s.engine.headless.unreal.structs.text import read_text, write_text


class StructBase(Live):
    """Fields by declaration, in constructor order. Equality by value; not hashable.

    A field that is a struct or container is part of this one: it is filled, never replaced, so what was read of it
    stays its own.
    """

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
        self._fill_in(name, converted(value, prop.kind))

    def _fill_in(self, name: str, value: Any) -> None:
        """Set a field to a value of its own; nothing is set when the owner refuses."""
        own = self.__dict__
        old = own.get(name)
        if self._home is None:
            if isinstance(old, Live):
                old._become(value)
            else:
                own[name] = value
            return
        self._ready()
        need_finite(value, self)
        before = copied(old)
        if isinstance(old, Live):
            old._become(value)
        else:
            own[name] = value
        self._announce({name: before})

    def _announce(self, before: Mapping[str, Any]) -> None:
        """Tell the owner of an edit; when it refuses, the fields are as ``before`` again."""
        try:
            self._edited()
        except Exception:
            self._restore(before)
            raise

    def _restore(self, values: Mapping[str, Any]) -> None:
        own = self.__dict__
        for name, value in values.items():
            if isinstance(own.get(name), Live):
                own[name]._become(value)
            else:
                own[name] = value

    def _become(self, other: Any) -> None:
        self._restore({name: copied(other.__dict__[name]) for name in self._fields})

    def _finite(self) -> bool:
        return all(finite(self.__dict__[name]) for name in self._fields)

    def _settle(self, owner: Owner, name: str) -> None:
        self.__dict__["_home"] = (owner, name)
        for part in self._parts():
            self.__dict__[part]._settle(self, part)

    def _parts(self) -> tuple[str, ...]:
        """The fields that are structs or containers."""
        found = type(self).__dict__.get("_live_fields")
        if found is None:
            found = tuple(name for name in self._fields if isinstance(self.__dict__[name], Live))
            type(self)._live_fields = found  # type: ignore[attr-defined]
        return found

    def _member_edited(self, name: str) -> None:
        self._edited()

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
            made.__dict__[name] = copied(self.__dict__[name])
        return made

    def __copy__(self) -> Any:
        return self.copy()

    def __reduce__(self) -> Any:
        return type(self)._of_fields, self.to_tuple()

    def assign(self, other: Any) -> None:
        """Take over all fields of a struct of the same type."""
        need(other, type(self).__name__, f"{type(self).__name__}.assign")
        self._take(other)

    def _take(self, other: Any) -> Any:
        """Become ``other``; gives this struct itself, as operators that work in place do."""
        if self._home is None:
            self._become(other)
            return self
        self._ready()
        need_finite(other, self)
        before = {name: copied(self.__dict__[name]) for name in self._fields}
        self._become(other)
        self._announce(before)
        return self

    def to_tuple(self) -> tuple[Any, ...]:
        """All fields in order."""
        return tuple(self.__dict__[n] for n in self._fields)

    def get_editor_property(self, name: str | Name) -> Any:
        """A field by its Python or C++ name; a struct or container is the field itself."""
        return self.__dict__[self._field_name(name)]

    def set_editor_property(
        self,
        name: str | Name,
        value: Any,
        notify_mode: PropertyAccessChangeNotifyMode = PropertyAccessChangeNotifyMode.DEFAULT,
    ) -> None:
        """Set a field by its Python or C++ name."""
        self._put(self._field_name(name), value)

    def _field_name(self, name: object) -> str:
        own = str(name) if str(name) in self._fields else named(str(name), self._fields)
        prop = self._fields.get(own)
        if prop is None or not prop.scripts:
            owner = type(self).__name__
            raise Exception(f"{owner}: Failed to find property '{name}' for attribute '{name}' on '{owner}'")
        return own

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


class Later:
    """Fields of a struct that are made when they are first asked for."""

    def __init__(self, make: Callable[[], dict[str, Prop]]) -> None:
        self._make = make

    def __get__(self, instance: object, owner: type[StructBase]) -> dict[str, Prop]:
        owner._fields = self._make()
        return owner._fields


class ClosedStruct(StructBase):
    """A struct with fields that are no attributes: scripts reach them by ``get_editor_property``, or not at all."""

    def __getattribute__(self, name: str) -> Any:
        if not name.startswith("_"):
            prop = type(self)._fields.get(name)
            if prop is not None and not prop.attribute:
                raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        return super().__getattribute__(name)
