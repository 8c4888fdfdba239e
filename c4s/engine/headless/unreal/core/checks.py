"""Types by name, and calls whose arguments are checked and converted as Unreal's Python converts them."""

from __future__ import annotations

import functools
import inspect
import warnings
from collections.abc import Callable, Mapping
from typing import Any, ParamSpec, TypeVar

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.containers import Array, FixedArray, Map, Name, Set, Text
from c4s.engine.headless.unreal.core.later import Types

P = ParamSpec("P")
R = TypeVar("R")
TYPES = Types()
"""Public classes, structs and enums by their name: what ``unreal`` shows and what annotations refer to."""

_PLAIN = {
    "float": "DoubleProperty",
    "int": "IntProperty",
    "bool": "BoolProperty",
    "str": "StrProperty",
    "Name": "NameProperty",
    "Text": "TextProperty",
    "Class": "ClassProperty",
    "type": "ClassProperty",
}


def public(cls: type[R]) -> type[R]:
    """Publish a type in the ``unreal`` module."""
    TYPES[cls.__name__] = cls
    cls.__module__ = "unreal"
    return cls


for _type in (Array, FixedArray, Map, Name, Set, Text):
    TYPES[_type.__name__] = _type


def camel(name: str) -> str:
    """The C++ name of a Python one: ``new_location`` as ``NewLocation``."""
    return "".join(part[:1].upper() + part[1:] for part in name.split("_"))


def fits(value: object, kind: str) -> bool:
    """Whether ``value`` may be passed where ``kind`` (``"float"``, ``"Vector"``, ``"StaticMesh | None"``) is wanted."""
    try:
        accepted(value, kind)
    except TypeError:
        return False
    return True


def accepted(value: Any, kind: str) -> Any:
    """``value`` as ``kind``: a struct may be given as a sequence or mapping of its fields, a whole number as a float.

    Raises:
        TypeError: it is no such thing; the text is Unreal's innermost line.
    """
    if type(value) is str and not value.isascii() and not _is_text(value):
        raise TypeError(_innermost(value, _alternatives(kind)[0]))
    if type(value).__name__ == kind or (type(value), kind) in _AS_IS:
        return value
    parts = _alternatives(kind)
    for part in parts:
        if _fits_one(value, part):
            if part == "int" and isinstance(value, float):
                return int(value)
            if not isinstance(value, type) and not any(each.startswith("Sequence") for each in parts):
                _AS_IS.add((type(value), kind))
            return value
    for part in parts:
        if part.startswith("Sequence") and isinstance(value, (list, tuple, Array)):
            return [accepted(item, part[len("Sequence[") : -1]) for item in value]
        found = TYPES.get(part)
        if found is not None and hasattr(found, "_from_parts") and isinstance(value, (list, tuple, Array, Mapping)):
            return found._from_parts(value)
    raise TypeError(_innermost(value, parts[0]))


def _is_text(value: str) -> bool:
    """Whether it can be written as UTF-8: halves of a surrogate pair cannot."""
    try:
        value.encode()
    except UnicodeEncodeError:
        return False
    return True


_AS_IS: set[tuple[type, str]] = set()
"""Types whose every value passes unchanged for a kind, as far as values were met."""


@functools.cache
def _alternatives(kind: str) -> tuple[str, ...]:
    return tuple(kind.split(" | "))


def _fits_one(value: object, kind: str) -> bool:
    if kind == "Any":
        return True
    if kind == "None":
        return value is None
    if kind in ("float", "int"):
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    if kind == "bool":
        return isinstance(value, (bool, int))
    if kind in ("str", "Name", "Text"):
        return isinstance(value, (str, Name, Text)) and _is_text(str(value))
    if kind in ("Class", "type"):
        return isinstance(value, TYPES["Class"]) or (isinstance(value, type) and issubclass(value, TYPES["Object"]))
    if kind.startswith("Sequence"):
        if not isinstance(value, (list, tuple, Array)):
            return False
        parts = _alternatives(kind[len("Sequence[") : -1])
        return all(any(_fits_one(item, part) for part in parts) for item in value)
    if kind.startswith("Mapping"):
        return isinstance(value, Mapping | Map)
    return isinstance(value, TYPES[kind])


def property_kind(kind: str) -> str:
    """Unreal's name for the kind of a property, as its errors say it."""
    part = _alternatives(kind)[0]
    if part in _PLAIN:
        return _PLAIN[part]
    if part.startswith("Sequence"):
        return "ArrayProperty"
    found = TYPES.get(part)
    if found is not None and hasattr(found, "_from_parts"):
        return "StructProperty"
    return "EnumProperty" if found is not None and hasattr(found, "__members__") else "ObjectProperty"


def _innermost(value: object, kind: str) -> str:
    given = type(value).__name__
    family = property_kind(kind)
    if family == "StructProperty":
        return f"NativizeStructInstance: Cannot nativize '{given}' as '{kind}'"
    if family == "ObjectProperty" and kind in TYPES:
        return f"NativizeObject: Cannot nativize '{given}' as 'Object' (allowed Class type: '{kind}')"
    return f"Nativize: Cannot nativize '{given}' as '{kind}'"


def need(value: Any, kind: str, what: str, name: str = "") -> Any:
    """``value`` as ``kind``, or a ``TypeError`` in Unreal's three lines: what failed, which property, and why."""
    try:
        return accepted(value, kind)
    except TypeError as error:
        label = camel(name) or kind
        raise TypeError(
            f"{what}\n  TypeError: NativizeProperty: Cannot nativize '{type(value).__name__}' as '{label}' "
            f"({property_kind(kind)})\n    TypeError: {error}"
        ) from None


def api(function: Callable[P, R]) -> Callable[P, R]:
    """A function of Unreal's Python API.

    Arguments are checked and converted from the annotations (read as text), dead objects are refused. ``None`` passes
    for any object; where the function needs one, that is logged and the function gives the empty result.
    """
    declared, annotations = _declared(function)
    owned = next(iter(declared), "") == "self"
    bound = owned or next(iter(declared), "") == "cls"
    names = list(declared)[1:] if bound else list(declared)
    kinds = {name: str(annotations.get(name, "Any")) for name in names}
    required = [name for name in names if not declared[name]]
    result = str(annotations.get("return", inspect.Signature.empty))
    title = function.__name__

    def refuse_count(given: int, passed: dict[str, Any]) -> None:
        if not names and (given or passed):
            raise TypeError(f"{title}() takes no arguments ({given + len(passed)} given)")
        if given + len(passed) > len(names):
            raise TypeError(
                f"{title}() takes at most {len(names)} argument{'s' * (len(names) != 1)} ({given + len(passed)} given)"
            )
        for index, name in enumerate(names):
            if name in passed and index < given:
                raise TypeError(f"argument for {title}() given by name ('{name}') and position ({index + 1})")
            if name in required and index >= given and name not in passed:
                raise TypeError(f"{title}() required argument '{name}' (pos {index + 1}) not found")
        for name in passed:
            if name not in kinds:
                raise TypeError(f"'{name}' is an invalid keyword argument for {title}()")

    def convert(owner: Any, name: str, value: Any) -> Any:
        kind = kinds[name]
        if kind == "Any":
            return value
        try:
            value = accepted(value, kind)
        except TypeError:
            where = getattr(owner, "_name", None) or f"Default__{getattr(owner, '__name__', type(owner).__name__)}"
            of = owner.__name__ if isinstance(owner, type) else type(owner).__name__
            need(
                value,
                kind,
                f"{of}: Failed to convert parameter '{name}' when calling function '{of}.{camel(title)}' on '{where}'",
                name,
            )
        if isinstance(value, TYPES["Object"]):
            value._need_alive()  # type: ignore[attr-defined]
        return value

    @functools.wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        owner: Any = args[0] if bound and args else None
        if owned and isinstance(owner, TYPES["Object"]):
            owner._need_alive()  # type: ignore[attr-defined]
        if not (required or kwargs) and len(args) == bound:
            return function(*args, **kwargs)
        given = args[1:] if bound else args
        if kwargs or len(given) != len(names):
            refuse_count(len(given), kwargs)
        pairs = zip(names, given, strict=False)
        for name, value in (*pairs, *kwargs.items()) if kwargs else pairs:
            if value is None and _is_object(kinds[name]):
                return _without(title, name, result)  # type: ignore[no-any-return]
        values: list[Any] = [convert(owner, name, value) for name, value in zip(names, given, strict=False)]
        for name, value in kwargs.items():
            kwargs[name] = convert(owner, name, value)
        return function(*args[:1], *values, **kwargs) if bound else function(*values, **kwargs)  # type: ignore[arg-type]

    return call


def _declared(function: Any) -> tuple[dict[str, bool], Mapping[str, Any]]:
    """The parameters in order, each with whether it has a default, and the annotations.

    Read from the function itself: ``inspect`` takes ten times as long, and a thousand functions are declared at start.
    """
    if hasattr(function, "__signature__"):
        parameters = function.__signature__.parameters.values()
        found = {p.name: p.annotation for p in parameters if p.annotation is not p.empty}
        found["return"] = function.__signature__.return_annotation
        return {p.name: p.default is not p.empty for p in parameters}, found
    code = function.__code__
    if code.co_kwonlyargcount or code.co_flags & (inspect.CO_VARARGS | inspect.CO_VARKEYWORDS):
        raise TypeError(f"{function.__qualname__}: Unreal's functions take plain parameters only")
    names = code.co_varnames[: code.co_argcount]
    plain = len(names) - len(function.__defaults__ or ())
    return {name: index >= plain for index, name in enumerate(names)}, function.__annotations__


@functools.cache
def _is_object(kind: str) -> bool:
    """Whether an object is needed, where ``None`` would be no object."""
    parts = _alternatives(kind)
    return "None" not in parts and (
        parts[0] == "Class" or (parts[0] in TYPES and issubclass(TYPES[parts[0]], TYPES["Object"]))
    )


def _without(title: str, name: str, result: str) -> Any:
    """The empty result of a function that was given no object, which is logged."""
    world().log.error(f"{camel(title)}: {camel(name)} is not valid.")
    if result in ("None", "Any") or "None" in _alternatives(result):
        return None
    if result in ("bool", "int", "float", "str"):
        return {"bool": False, "int": 0, "float": 0.0, "str": ""}[result]
    if result == "Array":
        return Array._of("Any", [])
    found = TYPES.get(result)
    return found() if found is not None and hasattr(found, "_from_parts") else None


def deprecated(reason: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """A function that works and warns its caller, in Unreal's words."""

    def mark(function: Callable[P, R]) -> Callable[P, R]:
        owner = function.__qualname__.split(".")[0]

        @functools.wraps(function)
        def call(*args: P.args, **kwargs: P.kwargs) -> R:
            warnings.warn(
                f"Function '{function.__name__}' on '{owner}' is deprecated: {reason}", DeprecationWarning, stacklevel=2
            )
            return function(*args, **kwargs)

        return call

    return mark
