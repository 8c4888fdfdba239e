"""Types by name, and calls whose arguments are checked."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import ParamSpec, TypeVar

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
        return isinstance(value, TYPES["Class"]) or (isinstance(value, type) and issubclass(value, TYPES["Object"]))
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
        if isinstance(value, TYPES["Object"]):
            value._need_alive()  # type: ignore[attr-defined]

    @functools.wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        if owned and args and isinstance(args[0], TYPES["Object"]):
            args[0]._need_alive()  # type: ignore[attr-defined]
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
