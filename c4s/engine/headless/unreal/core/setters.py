"""Methods that set one editor property, made from tables: Unreal has a hundred of them, and all do the same."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any, TypeVar

from c4s.engine.headless.unreal.core.checks import api
from c4s.engine.headless.unreal.core.properties import ObjectBase

_C = TypeVar("_C", bound=type[ObjectBase])
_SELF = inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)


def with_setters(table: str) -> Callable[[_C], _C]:
    """Give a class ``set_<property>`` methods.

    Args:
        table: ``property=argument`` for each; ``property`` alone where the argument is called ``new_value``.
    """

    def add(cls: _C) -> _C:
        for entry in table.split():
            name, _, argument = entry.partition("=")
            method = _setter(name, argument or "new_value", cls._properties[name].kind)
            method.__qualname__ = f"{cls.__qualname__}.{method.__name__}"
            setattr(cls, method.__name__, method)
        return cls

    return add


def _setter(name: str, argument: str, kind: str) -> Any:
    def method(self: Any, *values: Any, **named: Any) -> None:
        self.set_editor_property(name, named[argument] if named else values[0])

    method.__name__, method.__doc__ = f"set_{name}", f"Set ``{name}``."
    value = inspect.Parameter(argument, inspect.Parameter.POSITIONAL_OR_KEYWORD, annotation=kind)
    method.__signature__ = inspect.Signature([_SELF, value], return_annotation="None")  # type: ignore[attr-defined]
    return api(method)
