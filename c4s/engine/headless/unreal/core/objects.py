"""Objects, classes and packages."""

from __future__ import annotations

from typing import Any, ClassVar

from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core.checks import api, public
from c4s.engine.headless.unreal.core.properties import ObjectBase


@public
class Object(ObjectBase):
    """Base of all engine objects."""

    _class_module: ClassVar[str] = "Engine"
    _absent: ClassVar[bool] = False
    """Whether it is known by its name only: nothing here is one, and none can be made."""

    def __init__(self, outer: Object | None = None, name: str | Name = "None") -> None:
        if type(self)._absent or type(self)._abstract():
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
    def get_typed_outer(self, type: Class | type) -> Any:
        """The nearest object of a type that this one lies in, or None."""
        outer: Any = self._outer
        while outer is not None and not isinstance(outer, as_class(type)._python_type):
            outer = outer._outer
        return outer

    def call_method(self, name: str, *args: Any, **kwargs: Any) -> Any:
        """Call a function by name, with a tuple of arguments and a dict of named ones."""
        function = getattr(self, str(name), None)
        if str(name).startswith("_") or not callable(function):
            raise Exception(f"{self._class().get_name()}: Failed to find function '{name}' on '{self._name}'")
        given = args[0] if args and isinstance(args[0], tuple) else args
        named = args[1] if len(args) > 1 and isinstance(args[1], dict) else kwargs
        return function(*given, **named)

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
    def rename(self, name: Name | str = "None", outer: Object | None = None) -> bool:
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


@public
class ScriptStruct(Object):
    """The type of a struct as an object."""

    _class_module = "CoreUObject"


@public
class Enum(Object):
    """An enum as an object."""

    _class_module = "CoreUObject"


_CLASSES: dict[str, Class] = {}
_BY_TYPE: dict[type, Class] = {}


def as_class(value: Class | type) -> Class:
    """The class object of a type, one a type."""
    if isinstance(value, Class):
        return value
    found = _BY_TYPE.get(value)
    if found is None:
        kind: type[Object] = value
        path = kind._class_path()
        if path not in _CLASSES:
            made: Class = Class._make(value.__name__, None)
            made._bind(kind, path)
            _CLASSES[path] = made
        found = _BY_TYPE[value] = _CLASSES[path]
    return found


def subclass_of(value: Class | type, base: type[Object]) -> bool:
    """Whether a class or type derives from ``base``."""
    return issubclass(as_class(value)._python_type, base)
