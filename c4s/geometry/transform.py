"""Unreal's rigid and scaled transforms (left-handed, X forward, Y right, Z up; centimetres and degrees).

Rotations as three numbers are always ``[pitch, yaw, roll]`` in degrees; quaternions are ``(x, y, z, w)``.
Formulas: the rotator, quaternion and matrix conventions of Unreal Engine, checked by numeric vectors in the tests.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Vec3: TypeAlias = Sequence[float]

WORLD_CM = 8.8e12
"""How far from its origin Unreal's largest world reaches: nothing lies, is met or is looked at beyond."""


def quat_from_rotator(rotation_deg: Vec3) -> tuple[float, float, float, float]:
    """Quaternion (x, y, z, w) of ``[pitch, yaw, roll]`` degrees."""
    pitch, yaw, roll = (math.radians(math.fmod(a, 360.0)) / 2 for a in rotation_deg)
    sp, cp, sy, cy, sr, cr = (
        math.sin(pitch),
        math.cos(pitch),
        math.sin(yaw),
        math.cos(yaw),
        math.sin(roll),
        math.cos(roll),
    )
    return (
        cr * sp * sy - sr * cp * cy,
        -cr * sp * cy - sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def normalize_axis(angle_deg: float) -> float:
    """An angle in degrees wrapped to (-180, 180]."""
    wrapped = math.fmod(angle_deg, 360.0)
    if wrapped > 180.0:
        return wrapped - 360.0
    return wrapped + 360.0 if wrapped <= -180.0 else wrapped


def rotator_from_quat(quat: Sequence[float]) -> tuple[float, float, float]:
    """``(pitch, yaw, roll)`` degrees of a quaternion (x, y, z, w), with Unreal's treatment of the poles."""
    x, y, z, w = quat
    singularity = z * x - w * y
    yaw = math.degrees(math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    if singularity < -0.4999995:
        return -90.0, yaw, normalize_axis(-yaw - math.degrees(2 * math.atan2(x, w)))
    if singularity > 0.4999995:
        return 90.0, yaw, normalize_axis(yaw - math.degrees(2 * math.atan2(x, w)))
    roll = math.degrees(math.atan2(-2 * (w * x + y * z), 1 - 2 * (x * x + y * y)))
    return math.degrees(math.asin(2 * singularity)), yaw, roll


def quat_multiply(a: Sequence[float], b: Sequence[float]) -> tuple[float, float, float, float]:
    """Product ``a * b``: the rotation ``b`` first, then ``a``."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def quat_angle_deg(a: Sequence[float], b: Sequence[float]) -> float:
    """Angle between two rotations in degrees: 2 acos(min(1, |a.b|))."""
    dot = abs(sum(p * q for p, q in zip(a, b, strict=True)))
    return math.degrees(2 * math.acos(min(1.0, dot)))


def rotation_matrix(rotation_deg: Vec3) -> Array:
    """3x3 matrix R with ``world = R @ local`` (columns are the images of the local axes)."""
    x, y, z, w = quat_from_rotator(rotation_deg)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def affine(location_cm: Vec3, rotation_deg: Vec3, scale: Vec3) -> Array:
    """4x4 matrix of ``world = R (S local) + T``; columns act on column vectors."""
    matrix = np.eye(4)
    matrix[:3, :3] = rotation_matrix(rotation_deg) * np.asarray(scale, dtype=float)
    matrix[:3, 3] = location_cm
    return matrix


def transformed_box(matrix: Array, low: Vec3, high: Vec3) -> tuple[Array, Array]:
    """World AABB ``(origin, half extent)`` of the local box ``low..high`` under a 4x4 matrix (Unreal's TransformBy)."""
    centre = (np.asarray(low, dtype=float) + np.asarray(high, dtype=float)) / 2
    half = (np.asarray(high, dtype=float) - np.asarray(low, dtype=float)) / 2
    return matrix[:3, :3] @ centre + matrix[:3, 3], np.abs(matrix[:3, :3]) @ half


def look_at(eye_cm: Vec3, target_cm: Vec3) -> tuple[float, float, float]:
    """``(pitch, yaw, roll)`` degrees that turn +X from ``eye`` towards ``target``."""
    dx, dy, dz = (t - e for e, t in zip(eye_cm, target_cm, strict=True))
    return math.degrees(math.atan2(dz, math.hypot(dx, dy))), math.degrees(math.atan2(dy, dx)), 0.0
