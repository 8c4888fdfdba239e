"""Structs that are a row of numbers, with the operators that Unreal gives each of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

from c4s.engine.headless.unreal.core import Prop, need
from c4s.engine.headless.unreal.structs.base import StructBase

SMALL = 1e-8
"""Lengths below are treated as zero (cm)."""


def numbers(*names: str, default: float = 0.0) -> dict[str, Prop]:
    """Fields that are numbers with one default."""
    return {name: Prop("float", default) for name in names}


def quotient(a: float, b: float) -> float:
    """a / b as the machine divides: by zero gives an infinity, or NaN for 0 / 0."""
    if b != 0:
        return a / b
    return math.nan if a == 0 or math.isnan(a) else math.copysign(math.inf, a) * math.copysign(1.0, b)


def clamped(value: float, low: float, high: float) -> float:
    """``value`` moved into low..high."""
    return max(low, min(value, high))


class Components(StructBase):
    """Structs that are a row of numbers; comparison is exact unless a subclass says otherwise."""

    def _fill(self, *values: float) -> bool:
        """Set all fields at once when every value is a float; False (and nothing set) otherwise."""
        for value in values:
            if type(value) is not float:
                return False
        self.__dict__.update(zip(self._fields, values, strict=True))
        return True

    def copy(self) -> Any:
        """An independent copy."""
        made = type(self).__new__(type(self))
        made.__dict__.update(self.__dict__)
        if self._home is not None:
            del made.__dict__["_home"]
        return made

    def _become(self, other: Any) -> None:
        own, row = self.__dict__, other.__dict__
        for name in self._fields:
            own[name] = row[name]

    def _all(self) -> tuple[float, ...]:
        return tuple(self.__dict__[n] for n in self._fields)

    def __iter__(self) -> Iterator[float]:
        raise TypeError(f"'{type(self).__name__}' object is not iterable")

    def _map(self, operation: Callable[[float], float]) -> Any:
        return type(self)(*(operation(a) for a in self._all()))

    def _with(self, other: Any, operation: Callable[[float, float], float]) -> Any:
        if type(other) is type(self):
            return type(self)(*(operation(a, b) for a, b in zip(self._all(), other._all(), strict=True)))
        return NotImplemented

    def _scaled(self, other: Any, operation: Callable[[float, float], float]) -> Any:
        if isinstance(other, (int, float)) and not isinstance(other, bool):
            return self._map(lambda a: operation(a, other))
        return self._with(other, operation)

    def _near(self, b: Any, tolerance: float) -> bool:
        need(b, type(self).__name__, f"{type(self).__name__}: comparison")
        return all(abs(p - q) <= tolerance for p, q in zip(self._all(), b._all(), strict=True))


class Summed(Components):
    """Rows with addition and subtraction."""

    def __add__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a + b)

    def __iadd__(self, other: Any) -> Any:
        made = self + other
        return made if made is NotImplemented else self._take(made)

    def __sub__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a - b)

    def __isub__(self, other: Any) -> Any:
        made = self - other
        return made if made is NotImplemented else self._take(made)

    def add(self, b: Any) -> Any:
        """Sum."""
        return self + need(b, type(self).__name__, f"{type(self).__name__}.add")

    def subtract(self, b: Any) -> Any:
        """Difference."""
        return self - need(b, type(self).__name__, f"{type(self).__name__}.subtract")


class Multiplied(Summed):
    """Rows with multiplication and division by component."""

    def __mul__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a * b)

    def __imul__(self, other: Any) -> Any:
        made = self * other
        return made if made is NotImplemented else self._take(made)

    def __truediv__(self, other: Any) -> Any:
        return self._with(other, quotient)

    def multiply(self, b: Any) -> Any:
        """Product by component."""
        return self * need(b, type(self).__name__, f"{type(self).__name__}.multiply")

    def equals(self, b: Any) -> bool:
        """Whether all numbers are the same."""
        return bool(self == need(b, type(self).__name__, f"{type(self).__name__}.equals"))

    def not_equal(self, b: Any) -> bool:
        """Whether any number differs."""
        return not self.equals(b)


class Near(Multiplied):
    """Rows with an opposite, and comparison within a tolerance."""

    def __neg__(self) -> Any:
        return self._map(lambda a: -a)

    def negated(self) -> Any:
        """The opposite."""
        return -self

    def is_near_equal(self, b: Any, error_tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance."""
        return self._near(b, error_tolerance)

    def is_not_near_equal(self, b: Any, error_tolerance: float = 1e-4) -> bool:
        """Whether any component differs by more than the tolerance."""
        return not self._near(b, error_tolerance)

    def is_zero(self) -> bool:
        """Whether all components are exactly 0."""
        return not any(self._all())


class Scaled(Near):
    """Rows that a number multiplies and divides too."""

    def __mul__(self, other: Any) -> Any:
        return self._scaled(other, lambda a, b: a * b)

    def __truediv__(self, other: Any) -> Any:
        return self._scaled(other, quotient)

    def multiply_float(self, b: float) -> Any:
        """Product with a number."""
        return self * need(b, "float", f"{type(self).__name__}.multiply_float")

    def divide_float(self, b: float = 1.0) -> Any:
        """Quotient by a number."""
        return self / need(b, "float", f"{type(self).__name__}.divide_float")

    def add_float(self, b: float) -> Any:
        """A number added to every component."""
        return self._scaled(need(b, "float", f"{type(self).__name__}.add_float"), lambda p, q: p + q)

    def subtract_float(self, b: float) -> Any:
        """A number taken from every component."""
        return self._scaled(need(b, "float", f"{type(self).__name__}.subtract_float"), lambda p, q: p - q)


class Constant:
    """A named value of a struct's class, a fresh copy at each use."""

    def __init__(self, *values: float) -> None:
        self._given = values

    def __get__(self, instance: object, owner: type[Any]) -> Any:
        return owner(*self._given)
