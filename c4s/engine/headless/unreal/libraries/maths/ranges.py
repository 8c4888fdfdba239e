"""Numbers within ranges, from one range to another, and mixed."""

from __future__ import annotations

import math

from c4s.engine.headless.unreal.structs.numbers import clamped


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


def in_range_float_float(
    value: float, min: float = 0.0, max: float = 1.0, inclusive_min: bool = True, inclusive_max: bool = True
) -> bool:
    """Whether it lies between two."""
    return (value >= min if inclusive_min else value > min) and (value <= max if inclusive_max else value < max)


def in_range_int_int(
    value: int, min: int = 0, max: int = 10, inclusive_min: bool = True, inclusive_max: bool = True
) -> bool:
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
