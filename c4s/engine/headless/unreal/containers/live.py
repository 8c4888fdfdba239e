"""Values that may refer to their owner: structs and containers.

What an editor property gives is the owner's own value: writing into it edits the owner, with the same checks and the
same notice as setting the property. Copies, function results and items of containers refer to nothing.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Any, Protocol, Self, TypeVar


class Owner(Protocol):
    """What holds a value: an object, or a struct that an object holds."""

    def _ready(self) -> None:
        """Refuse an edit of what is gone."""
        ...

    def _member_edited(self, name: str) -> None:
        """Take note that the value of a property was edited in place."""
        ...


class Live:
    """A value with a place: ``_home`` is its owner and the property there, or None for a value on its own.

    Every kind of value has its own ``copy``, ``_become`` and ``_finite``. It is no ABC: ``isinstance`` is on hot paths.
    """

    __slots__: tuple[str, ...] = ()
    _home: tuple[Owner, str] | None = None

    def copy(self) -> Self:
        """An independent value."""
        raise NotImplementedError

    def _become(self, other: Any) -> None:
        """Take over another's value in place, without notice."""
        raise NotImplementedError

    def _finite(self) -> bool:
        """Whether it holds no NaN and no infinity."""
        raise NotImplementedError

    def __deepcopy__(self, memo: Any) -> Self:
        return self.copy()

    def __getstate__(self) -> Any:
        state = self.copy()
        slots: tuple[str, ...] = type(self).__slots__
        return None, {name: getattr(state, name) for name in slots}

    def _settle(self, owner: Owner, name: str) -> None:
        """Belong to a property of an owner from now on."""
        object.__setattr__(self, "_home", (owner, name))

    def _ready(self) -> None:
        home = self._home
        if home is not None:
            home[0]._ready()

    def _edited(self) -> None:
        home = self._home
        if home is not None:
            home[0]._member_edited(home[1])


def finite(value: object) -> bool:
    """Whether a value holds no NaN and no infinity: no level can hold them either."""
    if isinstance(value, float):
        return math.isfinite(value)
    return value._finite() if isinstance(value, Live) else True


def copied(value: Any) -> Any:
    """A value that belongs to nobody: structs and containers as copies, all else as it is."""
    return value.copy() if isinstance(value, Live) else value


def need_finite(value: object, owner: Live) -> None:
    """Refuse NaN and infinities in what an object holds."""
    if owner._home is not None and not finite(value):
        raise Exception(f"{type(owner).__name__}: properties take finite numbers")


_F = TypeVar("_F", bound=Callable[..., Any])


def editing(method: _F) -> _F:
    """A method that edits a container in place: refused when the owner is gone, and noted by the owner."""

    @functools.wraps(method)
    def call(self: Live, *args: Any, **kwargs: Any) -> Any:
        if self._home is None:
            return method(self, *args, **kwargs)
        self._ready()
        given = method(self, *args, **kwargs)
        self._edited()
        return given

    return call  # type: ignore[return-value]
