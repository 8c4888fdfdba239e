"""Structs by declared fields."""



from __future__ import annotations

from typing import Any, ClassVar

from c4s.engine.headless.unreal.core import Prop, converted, copied, need


class StructBase:
    """Fields by declaration, in constructor order. Equality by value; not hashable."""

    _fields: ClassVar[dict[str, Prop]] = {}
    _takes: ClassVar[int | None] = None
    """How many fields the constructor takes, when not all."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        names = list(self._fields)[:self._takes]
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
        need(value, prop.kind, f"{type(self).__name__}: property '{name}'")
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

    def get_editor_property(self, name: str) -> Any:
        """A field by name."""
        self._known(name)
        return copied(self.__dict__[str(name)])

    def set_editor_property(self, name: str, value: Any, notify_mode: Any = None) -> None:
        """Set a field by name."""
        self._known(name)
        self._put(str(name), value)

    def _known(self, name: object) -> None:
        prop = self._fields.get(str(name))
        if prop is None or not prop.scripts:
            raise Exception(f"{type(self).__name__}: failed to find property '{name}'")

    def export_text(self) -> str:
        """Unreal's text form."""
        return "(" + ",".join(f"{_camel(n)}={_text(self.__dict__[n])}" for n in self._fields) + ")"


class ClosedStruct(StructBase):
    """A struct with fields that are no attributes: scripts reach them by ``get_editor_property``, or not at all."""

    def __getattribute__(self, name: str) -> Any:
        if not name.startswith("_"):
            prop = type(self)._fields.get(name)
            if prop is not None and not prop.attribute:
                raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        return super().__getattribute__(name)


def _camel(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))


def _text(value: Any) -> str:
    if isinstance(value, StructBase):
        return value.export_text()
    return f"{value:.6f}" if isinstance(value, float) else str(value)
