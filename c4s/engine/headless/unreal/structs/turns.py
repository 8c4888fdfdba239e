"""Quaternions as tuples x, y, z, w: shortest rotations and mixes."""

from __future__ import annotations

import math

from c4s.engine.headless.pose import Quaternion, Triple, normalized

UNTURNED: Quaternion = (0.0, 0.0, 0.0, 1.0)


def between(a: Triple, b: Triple) -> Quaternion:
    """Shortest rotation that turns ``a`` into the direction of ``b``; half a turn has a fixed axis."""
    scale = math.sqrt((a[0] ** 2 + a[1] ** 2 + a[2] ** 2) * (b[0] ** 2 + b[1] ** 2 + b[2] ** 2))
    w = scale + a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    if w >= 1e-6 * scale:
        return normalized((a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], w))
    return normalized((-a[2], 0.0, a[0], 0.0) if abs(a[0]) > abs(a[1]) else (0.0, -a[2], a[1], 0.0))


def slerp(a: Quaternion, b: Quaternion, alpha: float) -> Quaternion:
    """The rotation part of the way from one to another, along the shorter arc."""
    cosine = sum(p * q for p, q in zip(a, b, strict=True))
    near = abs(cosine)
    if near < 0.9999:
        angle = math.acos(near)
        first, second = math.sin((1 - alpha) * angle) / math.sin(angle), math.sin(alpha * angle) / math.sin(angle)
    else:
        first, second = 1 - alpha, alpha
    if cosine < 0:
        second = -second
    return normalized([first * p + second * q for p, q in zip(a, b, strict=True)])
