"""Trigonometry, and angles in degrees."""

from __future__ import annotations

import math

from c4s.engine.headless.unreal.structs.numbers import clamped


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
