"""Numeric evidence: which vectors are valid, and when two are the same within a tolerance."""

from __future__ import annotations

from itertools import chain
from math import isfinite
from typing import Any, TypeAlias

from c4s.errors import BadInput
from c4s.geometry.transform import quat_angle_deg, quat_from_rotator

Vector3: TypeAlias = tuple[float, float, float]
_NUMBER = (int, float)


def valid_vector(value: Any) -> Vector3 | None:
    """Three finite numbers as floats, else None. Booleans and numeric strings are no numbers here."""
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        return None
    x, y, z = value
    if type(x) is float and type(y) is float and type(z) is float and isfinite(x) and isfinite(y) and isfinite(z):
        return x, y, z
    if any(isinstance(v, bool) or not isinstance(v, _NUMBER) for v in value):
        return None
    try:
        vector = (float(x), float(y), float(z))
    except OverflowError:
        return None
    return vector if all(map(isfinite, vector)) else None


def all_valid(vectors: list[Any]) -> bool:
    """A fast yes: all are lists of three finite floats."""
    if set(map(type, vectors)) != {list} or set(map(len, vectors)) != {3}:
        return False
    return set(map(type, chain.from_iterable(vectors))) == {float} and isfinite(
        sum(map(abs, chain.from_iterable(vectors)))
    )


def same_within(a: Any, b: Any, tolerance: float) -> bool:
    """Whether two recorded vectors agree component-wise, limit inclusive.

    Numeric strings and booleans count as numbers. What cannot be read as numbers differs from everything, itself
    included. Raises ``BadInput`` for a number beyond the range of a float.
    """
    if not isinstance(a, (list, tuple)) or not isinstance(b, (list, tuple)) or len(a) != len(b):
        return False
    try:
        return all(abs(float(p) - float(q)) <= tolerance for p, q in zip(a, b, strict=True))
    except (TypeError, ValueError):
        return False
    except OverflowError:
        raise BadInput(
            "a transform holds a number beyond the range of a float", todo="export the scene again"
        ) from None


def angle_deg(a: Vector3, b: Vector3) -> float:
    """Angle in degrees between two rotators ``[pitch, yaw, roll]``, by their quaternions."""
    return quat_angle_deg(quat_from_rotator(a), quat_from_rotator(b))
