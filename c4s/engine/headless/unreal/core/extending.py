"""Methods that a class gets from a module above its own.

Unreal's types speak of each other: a vector gives a rotator, which makes vectors; a component ignores actors, which
are made of components. Here a type is declared with what it is made of, and the methods that speak of types built on it
are declared beside those, in a class that derives from it.
"""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import TypeVar

_More = TypeVar("_More", bound=type)


def extends(kind: type) -> Callable[[_More], _More]:
    """Give ``kind`` the methods of the decorated class, which derives from it and has nothing but methods.

    They must not use ``super()``. ``TypeError`` for one that ``kind`` declares itself.
    """

    def add(more: _More) -> _More:
        for name, member in list(vars(more).items()):
            if isinstance(member, FunctionType):
                if name in vars(kind):
                    raise TypeError(f"{kind.__name__}.{name} is declared twice")
                member.__qualname__ = f"{kind.__qualname__}.{name}"
                setattr(kind, name, member)
        return more

    return add
