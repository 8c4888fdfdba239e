"""Numbers: rounding, ranges, comparison, trigonometry."""

from __future__ import annotations

import math
from collections.abc import Sequence

from c4s.engine.headless.unreal.structs.numbers import clamped, quotient


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
    return float(base ** exp)


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


# rounding


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


# ranges


def min(a: int, b: int) -> int:
    """The smaller."""
    return a if a < b else b


def max(a: int, b: int) -> int:
    """The larger."""
    return a if a > b else b


def f_min(a: float, b: float) -> float:
    """The smaller."""
    return a if a < b else b


def f_max(a: float, b: float) -> float:
    """The larger."""
    return a if a > b else b


def clamp(value: int, min: int, max: int) -> int:
    """Moved between two."""
    return int(clamped(value, min, max))


def f_clamp(value: float, min: float = 0.0, max: float = 1.0) -> float:
    """Moved between two."""
    return clamped(value, min, max)


def wrap(value: int, min: int = 0, max: int = 100) -> int:
    """Wrapped into min..max."""
    if max == min:
        return max
    while value < min:
        value += max - min
    while value > max:
        value -= max - min
    return value


def f_wrap(value: float, min: float = 0.0, max: float = 1.0) -> float:
    """Wrapped into min..max."""
    if max == min:
        return max
    if min <= value <= max:
        return value
    return min + math.fmod(math.fmod(value - min, max - min) + (max - min), max - min)


def in_range_float_float(value: float, min: float = 0.0, max: float = 1.0, inclusive_min: bool = True,
                         inclusive_max: bool = True) -> bool:
    """Whether it lies between two."""
    return (value >= min if inclusive_min else value > min) and (value <= max if inclusive_max else value < max)


def in_range_int_int(value: int, min: int = 0, max: int = 10, inclusive_min: bool = True,
                     inclusive_max: bool = True) -> bool:
    """Whether it lies between two."""
    return (value >= min if inclusive_min else value > min) and (value <= max if inclusive_max else value < max)


def lerp(a: float, b: float, alpha: float) -> float:
    """Linear mix."""
    return a + (b - a) * alpha


def inverse_lerp(value: float, range_min: float, range_max: float) -> float:
    """How far between two a value lies."""
    return normalize_to_range(value, range_min, range_max)


def normalize_to_range(value: float, range_min: float, range_max: float) -> float:
    """How far between two a value lies; for one point, 0 before it and 1 from it on."""
    if range_min == range_max:
        return 0.0 if value < range_min else 1.0
    return (value - range_min) / (range_max - range_min)


def map_range_clamped(value: float, range_a: float, range_b: float, out_range_a: float, out_range_b: float) -> float:
    """From one range to another, within that."""
    return lerp(out_range_a, out_range_b, clamped(normalize_to_range(value, range_a, range_b), 0.0, 1.0))


def map_range_unclamped(value: float, range_a: float, range_b: float, out_range_a: float, out_range_b: float) -> float:
    """From one range to another, and beyond."""
    return lerp(out_range_a, out_range_b, normalize_to_range(value, range_a, range_b))


def f_interp_to(current: float, target: float, delta_time: float, interp_speed: float) -> float:
    """A step towards a target that slows down as it comes near."""
    if interp_speed <= 0 or (target - current) ** 2 < 1e-8:
        return target
    return lerp(current, target, clamped(delta_time * interp_speed, 0.0, 1.0))


def f_interp_to_constant(current: float, target: float, delta_time: float, interp_speed: float) -> float:
    """A step of constant speed towards a target."""
    step = interp_speed * delta_time
    return current + clamped(target - current, -step, step)


def f_interp_ease_in_out(a: float, b: float, alpha: float, exponent: float) -> float:
    """A mix that starts and ends slowly."""
    half = 0.5 * (2 * alpha) ** exponent if alpha < 0.5 else 1 - 0.5 * (2 * (1 - alpha)) ** exponent
    return lerp(a, b, half)


def make_pulsating_value(current_time: float, pulses_per_second: float = 1.0, phase: float = 0.0) -> float:
    """A wave between 0 and 1."""
    return 0.5 + 0.5 * math.sin(2 * math.pi * (current_time * pulses_per_second + phase) - math.pi / 2)


# comparison


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


# trigonometry


def get_pi() -> float:
    """Half a turn in radians."""
    return math.pi


def get_tau() -> float:
    """A turn in radians."""
    return math.tau


def degrees_to_radians(a: float) -> float:
    """Degrees as radians."""
    return math.radians(a)


def radians_to_degrees(a: float) -> float:
    """Radians as degrees."""
    return math.degrees(a)


def sin(a: float) -> float:
    """Sine of radians."""
    return math.sin(a)


def cos(a: float) -> float:
    """Cosine of radians."""
    return math.cos(a)


def tan(a: float) -> float:
    """Tangent of radians."""
    return math.tan(a)


def asin(a: float) -> float:
    """Radians of a sine."""
    return math.asin(clamped(a, -1.0, 1.0))


def acos(a: float) -> float:
    """Radians of a cosine."""
    return math.acos(clamped(a, -1.0, 1.0))


def atan(a: float) -> float:
    """Radians of a tangent."""
    return math.atan(a)


def atan2(y: float, x: float) -> float:
    """Radians of a direction."""
    return math.atan2(y, x)


def deg_sin(a: float) -> float:
    """Sine of degrees."""
    return math.sin(math.radians(a))


def deg_cos(a: float) -> float:
    """Cosine of degrees."""
    return math.cos(math.radians(a))


def deg_tan(a: float) -> float:
    """Tangent of degrees."""
    return math.tan(math.radians(a))


def deg_asin(a: float) -> float:
    """Degrees of a sine."""
    return math.degrees(asin(a))


def deg_acos(a: float) -> float:
    """Degrees of a cosine."""
    return math.degrees(acos(a))


def deg_atan(a: float) -> float:
    """Degrees of a tangent."""
    return math.degrees(math.atan(a))


def deg_atan2(y: float, x: float) -> float:
    """Degrees of a direction."""
    return math.degrees(math.atan2(y, x))


def normalize_axis(angle: float) -> float:
    """Degrees wrapped to -180..180."""
    turned = clamp_axis(angle)
    return turned - 360 if turned > 180 else turned


def clamp_axis(angle: float) -> float:
    """Degrees wrapped to 0..360."""
    return math.fmod(math.fmod(angle, 360) + 360, 360)


def clamp_angle(angle_degrees: float, min_angle_degrees: float, max_angle_degrees: float) -> float:
    """Degrees moved to the nearer end of an arc."""
    half = clamp_axis(max_angle_degrees - min_angle_degrees) / 2
    middle = clamp_axis(min_angle_degrees + half)
    away = normalize_axis(angle_degrees - middle)
    if away > half:
        return normalize_axis(middle + half)
    return normalize_axis(middle - half) if away < -half else normalize_axis(angle_degrees)


def fixed_turn(current: float, desired: float, delta_rate: float) -> float:
    """Degrees turned towards others the shorter way, by at most a rate."""
    if delta_rate == 0:
        return clamp_axis(current)
    away = normalize_axis(desired - current)
    return clamp_axis(current + clamped(away, -delta_rate, delta_rate))


# logic and lists


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
