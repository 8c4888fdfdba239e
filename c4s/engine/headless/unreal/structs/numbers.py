"""Structs that are a row of numbers."""



from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from c4s.engine.headless.unreal.core import Prop, need
from c4s.engine.headless.unreal.structs.base import StructBase


def numbers(*names: str, default: float = 0.0) -> dict[str, Prop]:
    """Fields that are numbers with one default."""
    return {name: Prop("float", default) for name in names}


class Components(StructBase):
    """Structs that are a row of numbers, with arithmetic by component."""

    def _fill(self, *values: float) -> bool:
        """Set all fields at once when every value is a float; False (and nothing set) otherwise."""
        for value in values:
            if type(value) is not float:
                return False
        put = object.__setattr__
        for name, value in zip(self._fields, values, strict=True):
            put(self, name, value)
        return True

    def copy(self) -> Any:
        """An independent copy."""
        made = type(self).__new__(type(self))
        made.__dict__.update(self.__dict__)
        return made

    def _all(self) -> tuple[float, ...]:
        return tuple(getattr(self, n) for n in self._fields)

    def __iter__(self) -> Iterator[float]:
        raise TypeError(f"'{type(self).__name__}' object is not iterable")

    def _with(self, other: Any, operation: Any, sign: str) -> Any:
        if isinstance(other, (int, float)):
            return type(self)(*(operation(a, other) for a in self._all()))
        if type(other) is type(self):
            return type(self)(*(operation(a, b) for a, b in zip(self._all(), other._all(), strict=True)))
        return NotImplemented

    def __add__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a + b, "+") if type(other) is type(self) else NotImplemented

    def __sub__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a - b, "-") if type(other) is type(self) else NotImplemented

    def __mul__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a * b, "*")

    def __truediv__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a / b, "/")

    def __neg__(self) -> Any:
        return type(self)(*(-a for a in self._all()))

    def _near(self, b: Any, tolerance: float) -> bool:
        need(b, type(self).__name__, f"{type(self).__name__}: comparison")
        return all(abs(p - q) <= tolerance for p, q in zip(self._all(), b._all(), strict=True))


class Near(Components):
    """Rows of numbers that compare within a tolerance."""

    def is_near_equal(self, b: Any, error_tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance."""
        return self._near(b, error_tolerance)


class Constant:
    """A named value of a struct's class, a fresh copy at each use."""

    def __init__(self, *values: float) -> None:
        self._given = values

    def __get__(self, instance: object, owner: type[Any]) -> Any:
        return owner(*self._given)
