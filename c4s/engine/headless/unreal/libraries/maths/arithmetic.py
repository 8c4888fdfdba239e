"""Sums, products, powers and rounding of numbers."""

from __future__ import annotations

import math

from c4s.engine.headless.unreal.structs.numbers import quotient


def abs(a: float) -> float:
    """Without its sign."""
    return math.fabs(a)


def abs_int(a: int) -> int:
    """Without its sign."""
    return a if a >= 0 else -a


def add_double_double(a: float, b: float = 1.0) -> float:
    """Sum."""
    return a + b


def add_float_float(a: float, b: float = 1.0) -> float:
    """Sum."""
    return a + b


def add_int_int(a: int, b: int = 1) -> int:
    """Sum."""
    return a + b


def subtract_double_double(a: float, b: float = 1.0) -> float:
    """Difference."""
    return a - b


def subtract_float_float(a: float, b: float = 1.0) -> float:
    """Difference."""
    return a - b


def subtract_int_int(a: int, b: int = 1) -> int:
    """Difference."""
    return a - b


def multiply_double_double(a: float, b: float) -> float:
    """Product."""
    return a * b


def multiply_float_float(a: float, b: float) -> float:
    """Product."""
    return a * b


def multiply_int_int(a: int, b: int) -> int:
    """Product."""
    return a * b


def multiply_int_float(a: int, b: float) -> float:
    """Product."""
    return a * b


def multiply_by_pi(value: float) -> float:
    """Times pi."""
    return value * math.pi


def multiply_multiply_float_float(base: float, exp: float) -> float:
    """Power."""
    return float(base**exp)


def divide_double_double(a: float, b: float = 1.0) -> float:
    """Quotient; infinite for division by 0."""
    return quotient(a, b)


def divide_float_float(a: float, b: float = 1.0) -> float:
    """Quotient; infinite for division by 0."""
    return quotient(a, b)


def divide_int_int(a: int, b: int = 1) -> int:
    """Quotient without its fraction; 0 for division by 0."""
    return int(a / b) if b else 0


def safe_divide(a: float, b: float) -> float:
    """Quotient; 0 for division by 0."""
    return a / b if b else 0.0


def percent_int_int(a: int, b: int = 1) -> int:
    """Remainder with the sign of ``a``; 0 for division by 0."""
    return int(math.fmod(a, b)) if b else 0


def f_mod(dividend: float, divisor: float) -> tuple[int, float]:
    """How often it goes in, and the remainder with the dividend's sign."""
    return (int(dividend / divisor), math.fmod(dividend, divisor)) if divisor else (0, 0.0)


def square(a: float) -> float:
    """Times itself."""
    return a * a


def sqrt(a: float) -> float:
    """Square root; 0 for negative numbers."""
    return math.sqrt(a) if a > 0 else 0.0


def exp(a: float) -> float:
    """e to the power."""
    return math.exp(a)


def loge(a: float) -> float:
    """Natural logarithm; 0 for what has none."""
    return math.log(a) if a > 0 else 0.0


def log(a: float, base: float = 1.0) -> float:
    """Logarithm; 0 for a base at or below 1."""
    return math.log(a) / math.log(base) if base > 1 and a > 0 else 0.0


def hypotenuse(width: float, height: float) -> float:
    """Length of the diagonal."""
    return math.hypot(width, height)


def sign_of_float(a: float) -> float:
    """1, 0 or -1."""
    return math.copysign(1.0, a) if a else 0.0


def sign_of_integer(a: int) -> int:
    """1, 0 or -1."""
    return (a > 0) - (a < 0)


def round(a: float) -> int:
    """Nearest whole number, halves up."""
    return math.floor(a + 0.5)


def f_floor(a: float) -> int:
    """Next whole number below."""
    return math.floor(a)


def f_ceil(a: float) -> int:
    """Next whole number above."""
    return math.ceil(a)


def f_trunc(a: float) -> int:
    """Whole part."""
    return math.trunc(a)


def fraction(a: float) -> float:
    """Part behind the point, counted from the whole number below."""
    return a - math.floor(a)


def grid_snap_float(location: float, grid_size: float) -> float:
    """Nearest multiple of a grid; 0 changes nothing."""
    return math.floor((location + grid_size / 2) / grid_size) * grid_size if grid_size else location
