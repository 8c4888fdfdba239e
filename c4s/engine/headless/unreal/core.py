"""The strict object model of the ``unreal`` module: checked calls, editor properties, classes and objects.

An unknown name is an ``AttributeError``, a wrong number or type of arguments a ``TypeError``, an unknown editor
property an ``Exception``: as in Unreal's own Python.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, ClassVar, ParamSpec, TypeVar

from c4s.engine.headless.unreal.containers import Array, Name, Text

P = ParamSpec("P")
R = TypeVar("R")

TYPES: dict[str, type] = {}
"""Public classes, structs and enums by their name: what ``unreal`` shows and what annotations refer to."""


def public(cls: type[R]) -> type[R]:
    """Publish a type in the ``unreal`` module."""
    TYPES[cls.__name__] = cls
    cls.__module__ = "unreal"
    return cls


for _type in (Array, Name, Text):
    TYPES[_type.__name__] = _type


def fits(value: object, kind: str) -> bool:
    """Whether ``value`` may be passed where ``kind`` (``"float"``, ``"Vector"``, ``"StaticMesh | None"``) is wanted."""
    if type(value).__name__ == kind:
        return True
    return any(_fits_one(value, part) for part in _alternatives(kind))


@functools.cache
def _alternatives(kind: str) -> tuple[str, ...]:
    return tuple(kind.split(" | "))


def _fits_one(value: object, kind: str) -> bool:
    if kind == "Any":
        return True
    if kind == "None":
        return value is None
    if kind == "float":
        return isinstance(value, (int, float))
    if kind == "int":
        return isinstance(value, int)
    if kind == "bool":
        return isinstance(value, (bool, int))
    if kind in ("str", "Name", "Text"):
        return isinstance(value, (str, Name, Text))
    if kind in ("Class", "type"):
        return isinstance(value, Class) or (isinstance(value, type) and issubclass(value, Object))
    if kind.startswith("Sequence"):
        if not isinstance(value, (list, tuple, Array)):
            return False
        return all(_fits_one(item, kind[len("Sequence["):-1]) for item in value)
    return isinstance(value, TYPES[kind])


def need(value: object, kind: str, what: str) -> None:
    """``TypeError`` when ``value`` is not of ``kind``."""
    if not fits(value, kind):
        raise TypeError(f"{what}: cannot convert type '{type(value).__name__}' to {kind}")


def api(function: Callable[P, R]) -> Callable[P, R]:
    """A function of Unreal's Python API: argument types checked from the annotations, dead objects refused."""
    parameters = list(inspect.signature(function).parameters.values())
    by_name = {p.name: str(p.annotation) if p.annotation is not p.empty else "Any" for p in parameters}
    owned = bool(parameters) and parameters[0].name == "self"

    def check(name: str, value: object, kind: str) -> None:
        if not fits(value, kind):
            raise TypeError(f"{function.__qualname__}: parameter '{name}': "
                            f"cannot convert type '{type(value).__name__}' to {kind}")
        if isinstance(value, Object):
            value._need_alive()

    @functools.wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        if owned and args and isinstance(args[0], Object):
            args[0]._need_alive()
            if len(args) == 1 and not kwargs:
                return function(*args, **kwargs)
        for value, (name, kind) in zip(args, by_name.items(), strict=False):
            if kind != "Any":
                check(name, value, kind)
        for name, value in kwargs.items():
            if by_name.get(name, "Any") != "Any":
                check(name, value, by_name[name])
        return function(*args, **kwargs)

    return call


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


def copied(value: Any) -> Any:
    """Structs and arrays leave an object as copies."""
    return value.copy() if hasattr(value, "copy") and not isinstance(value, dict) else value


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
            return prop.default() if callable(prop.default) else copied(prop.default)
        return copied(values[name])

    def _write(self, name: str, prop: Prop, value: Any) -> None:
        self._need_alive()
        if not prop.writable:
            raise Exception(f"{type(self).__name__}: property '{name}' is read-only and cannot be set")
        need(value, prop.kind, f"{type(self).__name__}: property '{name}'")
        if prop.set:
            getattr(self, prop.set)(value)
        else:
            self._values[name] = converted(value, prop.kind)
        self._changed(name)

    def _changed(self, name: str) -> None:
        """Called after a property was written."""

    def _need_alive(self) -> None:
        """Refuse the use of an object that is gone."""

    def _property(self, name: str) -> Prop:
        prop = type(self)._properties.get(name)
        if prop is None or not prop.scripts:
            raise Exception(f"{type(self).__name__}: failed to find property '{name}' for attribute '{name}' "
                            f"on '{type(self).__name__}'")
        return prop

    def get_editor_property(self, name: str | Name) -> Any:
        """Value of an editor property (snake_case name); structs are copies."""
        need(name, "str", f"{type(self).__name__}.get_editor_property")
        return self._read(str(name), self._property(str(name)))

    def set_editor_property(self, name: str | Name, value: Any, notify_mode: Any = None) -> None:
        """Set an editor property (snake_case name)."""
        need(name, "str", f"{type(self).__name__}.set_editor_property")
        self._write(str(name), self._property(str(name)), value)

    def set_editor_properties(self, properties: dict[str, Any]) -> None:
        """Set several editor properties."""
        for name, value in properties.items():
            self.set_editor_property(name, value)


def converted(value: Any, kind: str) -> Any:
    """A stored copy of a checked value, in the declared kind."""
    if type(value) is float:
        return value
    if kind == "float":
        return float(value)
    if kind == "bool":
        return bool(value)
    if kind == "Name":
        return Name(str(value))
    if kind == "str":
        return str(value)
    if kind == "Class" and isinstance(value, type):
        return as_class(value)
    if kind.startswith("Sequence"):
        item = kind[len("Sequence["):-1]
        return Array._of(item, [converted(v, item) for v in value])
    return copied(value)


@public
class Object(ObjectBase):
    """Base of all engine objects."""

    _class_module: ClassVar[str] = "Engine"

    def __init__(self, outer: Object | None = None, name: str | Name = "None") -> None:
        if type(self)._abstract():
            raise Exception(f"{type(self).__name__}: an object of this class cannot be made from Python here")
        self._start(str(name) if str(name) != "None" else f"{type(self).__name__}_0", outer)

    @classmethod
    def _abstract(cls) -> bool:
        return False

    def _start(self, name: str, outer: Object | None) -> None:
        self._name = name
        self._outer = outer
        self._dead = False
        self._values: dict[str, Any] = {}

    @classmethod
    def _make(cls, name: str, outer: Object | None) -> Any:
        made = cls.__new__(cls)
        made._start(name, outer)
        return made

    def _need_alive(self) -> None:
        if self._dead:
            raise Exception(f"{type(self).__name__}: Internal Error - ObjectInstance is null!")

    def __repr__(self) -> str:
        if self._dead:
            return f"<Object destroyed Class '{type(self).__name__}'>"
        return f"<Object '{self._path()}' Class '{self._class().get_name()}'>"

    def _path(self) -> str:
        return f"{self._outer._path()}.{self._name}" if self._outer is not None else f"/Engine/Transient.{self._name}"

    def _class(self) -> Class:
        return as_class(type(self))

    @classmethod
    def _class_path(cls) -> str:
        return f"/Script/{cls._class_module}.{cls.__name__}"

    @api
    def get_name(self) -> str:
        """Object name."""
        return str(self._name)

    @api
    def get_fname(self) -> Name:
        """Object name as a Name."""
        return Name(self._name)

    @api
    def get_path_name(self) -> str:
        """Full object path."""
        return str(self._path())

    @api
    def get_full_name(self) -> str:
        """Class name and path."""
        return f"{self._class().get_name()} {self._path()}"

    @api
    def get_class(self) -> Class:
        """The object's class."""
        return self._class()

    @classmethod
    def static_class(cls) -> Class:
        """The class object of this type."""
        return as_class(cls)

    @classmethod
    def get_default_object(cls) -> Any:
        """An object with the class defaults."""
        return cls._make(f"Default__{cls.__name__}", None)

    @classmethod
    def cast(cls, object: Object) -> Any:
        """``object`` if it is of this type, else ``TypeError``."""
        if not isinstance(object, cls):
            raise TypeError(f"Cannot cast type '{type(object).__name__}' to '{cls.__name__}'")
        return object

    @api
    def get_outer(self) -> Object | None:
        """The object that this one lies in."""
        outer: Object | None = self._outer
        return outer

    @api
    def get_outermost(self) -> Package:
        """The package."""
        return _package(self)

    @api
    def get_package(self) -> Package:
        """The package."""
        return _package(self)

    @api
    def get_world(self) -> Any:
        """The world that this object lies in, or None."""
        outer = self._outer
        while outer is not None and type(outer).__name__ != "World":
            outer = outer._outer
        return outer

    @api
    def modify(self, always_mark_dirty: bool = True) -> bool:
        """Announce an edit."""
        return True

    @api
    def is_package_external(self) -> bool:
        """Whether the object lies in its own package (never here)."""
        return False

    @api
    def rename(self, name: Name | str | None = None, outer: Object | None = None) -> bool:
        """Rename; refused for objects without a level."""
        return False


@public
class Package(Object):
    """A package; its name is its path."""

    _class_module = "CoreUObject"

    def _path(self) -> str:
        return str(self._name)


def _package(of: Object) -> Package:
    made: Package = Package._make(of._path().split(".", 1)[0], None)
    return made


@public
class Class(Object):
    """A class: a type of this module, or a Blueprint's generated class."""

    _class_module = "CoreUObject"

    def _bind(self, python_type: type[Object], path: str, blueprint: str | None = None) -> None:
        self._python_type = python_type
        self._class_object_path = path
        self._blueprint = blueprint

    def _path(self) -> str:
        return str(self._class_object_path)

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        raise TypeError("'Class' object is not callable")


_CLASSES: dict[str, Class] = {}


def as_class(value: Class | type) -> Class:
    """The class object of a type, one a type."""
    if isinstance(value, Class):
        return value
    kind: type[Object] = value
    path = kind._class_path()
    if path not in _CLASSES:
        made: Class = Class._make(value.__name__, None)
        made._bind(kind, path)
        _CLASSES[path] = made
    return _CLASSES[path]


def subclass_of(value: Class | type, base: type[Object]) -> bool:
    """Whether a class or type derives from ``base``."""
    return issubclass(as_class(value)._python_type, base)
