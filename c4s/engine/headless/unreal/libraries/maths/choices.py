"""One of two values, and what an array of whole numbers has."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.unreal.containers import Name, Text
from c4s.engine.headless.unreal.core import Class, Object, as_class
from c4s.engine.headless.unreal.structs import LinearColor, Rotator, Transform, Vector


def select_vector(a: Vector, b: Vector, pick_a: bool) -> Vector:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_rotator(a: Rotator, b: Rotator, pick_a: bool) -> Rotator:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_transform(a: Transform, b: Transform, pick_a: bool) -> Transform:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_color(a: LinearColor, b: LinearColor, pick_a: bool) -> LinearColor:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_float(a: float, b: float, pick_a: bool) -> float:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_int(a: int, b: int, pick_a: bool) -> int:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_string(a: str, b: str, pick_a: bool) -> str:
    """``a`` or ``b``."""
    return a if pick_a else b


def select_name(a: Name | str, b: Name | str, pick_a: bool) -> Name:
    """``a`` or ``b``."""
    return Name(str(a if pick_a else b))


def select_text(a: Text | str, b: Text | str, pick_a: bool) -> Text:
    """``a`` or ``b``."""
    return Text(str(a if pick_a else b))


def select_object(a: Object | None, b: Object | None, select_a: bool) -> Object | None:
    """``a`` or ``b``."""
    return a if select_a else b


def select_class(a: Class | type | None, b: Class | type | None, select_a: bool) -> Class | None:
    """``a`` or ``b``."""
    chosen = a if select_a else b
    return as_class(chosen) if chosen is not None else None


def max_of_int_array(int_array: Sequence[int]) -> tuple[int, int]:
    """Where the largest is (-1 in an empty array), and the largest."""
    numbers = list(int_array)
    return (numbers.index(max(numbers)), max(numbers)) if numbers else (-1, 0)


def min_of_int_array(int_array: Sequence[int]) -> tuple[int, int]:
    """Where the smallest is (-1 in an empty array), and the smallest."""
    numbers = list(int_array)
    return (numbers.index(min(numbers)), min(numbers)) if numbers else (-1, 0)


def average_of_int_array(int_array: Sequence[int]) -> float:
    """The mean; 0 of an empty array."""
    return sum(int_array) / len(int_array) if len(int_array) else 0.0


def median_of_int_array(int_array: Sequence[int]) -> float:
    """The median; 0 of an empty array."""
    numbers = sorted(int_array)
    middle = len(numbers) // 2
    return (numbers[middle] + numbers[-1 - middle]) / 2 if numbers else 0.0


def not_equal_bool_bool(a: bool, b: bool) -> bool:
    """Whether two differ."""
    return bool(a) is not bool(b)


def not_equal_name_name(a: Name | str, b: Name | str) -> bool:
    """Whether two differ."""
    return Name(str(a)) != Name(str(b))


def not_equal_object_object(a: Object | None, b: Object | None) -> bool:
    """Whether two are not the same object."""
    return a is not b
