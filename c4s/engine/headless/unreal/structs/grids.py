"""Rows of whole numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.structs.base import StructBase
from c4s.engine.headless.unreal.structs.planes import Vector2D


def _whole(*names: str) -> dict[str, Prop]:
    return {name: Prop("int", 0) for name in names}


def _cut(a: int, b: int) -> int:
    """a / b without its fraction; 0 for division by 0."""
    return int(a / b) if b else 0


@public
class IntPoint(StructBase):
    """Two whole numbers."""

    _fields = _whole("x", "y")
    x: int
    y: int

    def __init__(self, x: int = 0, y: int = 0) -> None:
        super().__init__(x, y)

    def _with(self, other: Any, operation: Callable[[int, int], int]) -> Any:
        if isinstance(other, IntPoint):
            return IntPoint(operation(self.x, other.x), operation(self.y, other.y))
        if isinstance(other, int) and not isinstance(other, bool):
            return IntPoint(operation(self.x, other), operation(self.y, other))
        return NotImplemented

    def __add__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a + b)

    def __sub__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a - b)

    def __mul__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a * b)

    def __truediv__(self, other: Any) -> Any:
        return self._with(other, _cut)

    @api
    def add(self, b: IntPoint) -> IntPoint:
        """Sum."""
        return self + b  # type: ignore[no-any-return]

    @api
    def add_int(self, b: int) -> IntPoint:
        """A number added to both."""
        return self + b  # type: ignore[no-any-return]

    @api
    def subtract(self, b: IntPoint) -> IntPoint:
        """Difference."""
        return self - b  # type: ignore[no-any-return]

    @api
    def subtract_int(self, b: int) -> IntPoint:
        """A number taken from both."""
        return self - b  # type: ignore[no-any-return]

    @api
    def multiply(self, b: IntPoint) -> IntPoint:
        """Product by component."""
        return self * b  # type: ignore[no-any-return]

    @api
    def multiply_int(self, b: int) -> IntPoint:
        """Product with a number."""
        return self * b  # type: ignore[no-any-return]

    @api
    def divide(self, b: IntPoint) -> IntPoint:
        """Quotient by component."""
        return self / b  # type: ignore[no-any-return]

    @api
    def divide_int(self, b: int) -> IntPoint:
        """Quotient by a number."""
        return self / b  # type: ignore[no-any-return]

    @api
    def equals(self, b: IntPoint) -> bool:
        """Whether both numbers are the same."""
        return self == b

    @api
    def not_equal(self, b: IntPoint) -> bool:
        """Whether any number differs."""
        return self != b

    def vector2d(self) -> Vector2D:
        """As numbers."""
        return Vector2D(self.x, self.y)


@public
class IntVector2(StructBase):
    """Two whole numbers."""

    _fields = _whole("x", "y")

    def __init__(self, x: int = 0, y: int = 0) -> None:
        super().__init__(x, y)


@public
class IntVector(StructBase):
    """Three whole numbers."""

    _fields = _whole("x", "y", "z")
    x: int
    y: int
    z: int

    def __init__(self, x: int = 0, y: int = 0, z: int = 0) -> None:
        super().__init__(x, y, z)
