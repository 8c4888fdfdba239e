"""Comparison of numbers, logic, and lists of numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence


def equal_equal_double_double(a: float, b: float) -> bool:
    """Whether both are the same."""
    return a == b


def equal_equal_float_float(a: float, b: float) -> bool:
    """Whether both are the same."""
    return a == b


def equal_equal_int_int(a: int, b: int) -> bool:
    """Whether both are the same."""
    return a == b


def equal_equal_bool_bool(a: bool, b: bool) -> bool:
    """Whether both are the same."""
    return a == b


def not_equal_double_double(a: float, b: float) -> bool:
    """Whether they differ."""
    return a != b


def not_equal_float_float(a: float, b: float) -> bool:
    """Whether they differ."""
    return a != b


def not_equal_int_int(a: int, b: int) -> bool:
    """Whether they differ."""
    return a != b


def nearly_equal_float_float(a: float, b: float, error_tolerance: float = 1e-6) -> bool:
    """Whether they differ by at most the tolerance."""
    return math.fabs(a - b) <= error_tolerance


def less_double_double(a: float, b: float) -> bool:
    """Whether a < b."""
    return a < b


def less_float_float(a: float, b: float) -> bool:
    """Whether a < b."""
    return a < b


def less_int_int(a: int, b: int) -> bool:
    """Whether a < b."""
    return a < b


def less_equal_double_double(a: float, b: float) -> bool:
    """Whether a <= b."""
    return a <= b


def less_equal_float_float(a: float, b: float) -> bool:
    """Whether a <= b."""
    return a <= b


def less_equal_int_int(a: int, b: int) -> bool:
    """Whether a <= b."""
    return a <= b


def greater_double_double(a: float, b: float) -> bool:
    """Whether a > b."""
    return a > b


def greater_float_float(a: float, b: float) -> bool:
    """Whether a > b."""
    return a > b


def greater_int_int(a: int, b: int) -> bool:
    """Whether a > b."""
    return a > b


def greater_equal_double_double(a: float, b: float) -> bool:
    """Whether a >= b."""
    return a >= b


def greater_equal_float_float(a: float, b: float) -> bool:
    """Whether a >= b."""
    return a >= b


def greater_equal_int_int(a: int, b: int) -> bool:
    """Whether a >= b."""
    return a >= b


def boolean_and(a: bool, b: bool) -> bool:
    """Both."""
    return a and b


def boolean_or(a: bool, b: bool) -> bool:
    """Any."""
    return a or b


def boolean_xor(a: bool, b: bool) -> bool:
    """One of the two."""
    return a != b


def not_pre_bool(a: bool) -> bool:
    """The opposite."""
    return not a


def max_of_float_array(float_array: Sequence[float]) -> tuple[int, float]:
    """Place and value of the largest; -1 and 0 for none."""
    return _extreme(list(float_array), 1)


def min_of_float_array(float_array: Sequence[float]) -> tuple[int, float]:
    """Place and value of the smallest; -1 and 0 for none."""
    return _extreme(list(float_array), -1)


def _extreme(values: list[float], sign: int) -> tuple[int, float]:
    ranked = sorted(range(len(values)), key=lambda i: (-sign * values[i], i))
    return (ranked[0], values[ranked[0]]) if ranked else (-1, 0.0)


def average_of_int_array(int_array: Sequence[int]) -> float:
    """Mean; 0 for none."""
    return sum(int_array) / len(int_array) if len(int_array) else 0.0
