"""Poses: Unreal's FTransform as plain tuples (cm, quaternion x y z w, signed scale), with its composition rules.

Composition drops shear, as Unreal does: a turned child of a non-uniformly scaled parent is not a matrix product.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from c4s.geometry.transform import Array, normalize_axis, quat_from_rotator, quat_multiply, rotator_from_quat

Triple: TypeAlias = tuple[float, float, float]
Quaternion: TypeAlias = tuple[float, float, float, float]

LARGEST = 1e12
"""Largest number of a transform: beyond Unreal's largest world, and far from where bounds overflow."""
_ONE: Triple = (1.0, 1.0, 1.0)
_ZERO: Triple = (0.0, 0.0, 0.0)
_UNTURNED: Quaternion = (0.0, 0.0, 0.0, 1.0)
_ROTATOR_NOISE_DEG = 1e-9


class Pose:
    """A translation (cm), rotation and signed scale. ``rotation_deg`` is (pitch, yaw, roll), without negative zeros.

    Immutable by convention.
    """

    __slots__ = ("location", "quat", "rotation_deg", "scale")

    def __init__(self, location: Triple, quat: Quaternion, scale: Triple, rotation_deg: Triple | None = None) -> None:
        self.location = location
        self.quat = quat
        self.scale = scale
        pitch, yaw, roll = rotator_from_quat(quat) if rotation_deg is None else rotation_deg
        self.rotation_deg: Triple = (pitch + 0.0, yaw + 0.0, roll + 0.0)

    @classmethod
    def from_rotator(cls, location: Triple, rotation_deg: Triple, scale: Triple = _ONE) -> Pose:
        """Pose of ``[pitch, yaw, roll]`` degrees; the angles are kept as given when they are already canonical."""
        if rotation_deg == _ZERO:
            return cls(location, _UNTURNED, scale, _ZERO)
        quat = quat_from_rotator(rotation_deg)
        canonical = rotator_from_quat(quat)
        wrapped = tuple(normalize_axis(a) for a in rotation_deg)
        same = all(abs(a - b) <= _ROTATOR_NOISE_DEG for a, b in zip(canonical, wrapped, strict=True))
        return cls(location, quat, scale, (wrapped[0], wrapped[1], wrapped[2]) if same else canonical)

    def moved(self, location: Triple) -> Pose:
        """The same rotation and scale elsewhere."""
        return Pose(location, self.quat, self.scale, self.rotation_deg)

    def rescaled(self, scale: Triple) -> Pose:
        """The same place and rotation with another scale."""
        return Pose(self.location, self.quat, scale, self.rotation_deg)

    def turned(self, rotation_deg: Triple) -> Pose:
        """The same place and scale with another rotation ([pitch, yaw, roll] degrees)."""
        return Pose.from_rotator(self.location, rotation_deg, self.scale)

    def axes(self) -> tuple[Triple, Triple, Triple]:
        """Rows of the rotation matrix R (``world = R @ local``)."""
        x, y, z, w = self.quat
        return (
            (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
        )

    def matrix(self) -> Array:
        """4x4 matrix acting on column vectors (cm)."""
        out = np.eye(4)
        out[:3, :3] = np.array(self.axes()) * np.array(self.scale)
        out[:3, 3] = self.location
        return out

    def point(self, local: Sequence[float]) -> Triple:
        """World position (cm) of a local point: Q (S p) + T."""
        turned = rotate(self.quat, (local[0] * self.scale[0], local[1] * self.scale[1], local[2] * self.scale[2]))
        return (turned[0] + self.location[0], turned[1] + self.location[1], turned[2] + self.location[2])

    def inverse_point(self, world: Sequence[float]) -> Triple:
        """Local position of a world point; an axis of zero scale gives 0."""
        offset = (world[0] - self.location[0], world[1] - self.location[1], world[2] - self.location[2])
        local = rotate(conjugate(self.quat), offset)
        return (
            local[0] * reciprocal(self.scale[0]),
            local[1] * reciprocal(self.scale[1]),
            local[2] * reciprocal(self.scale[2]),
        )

    def box(self, low: Sequence[float], high: Sequence[float]) -> tuple[Triple, Triple]:
        """World AABB (origin, half extent) of the local box ``low..high``."""
        sx, sy, sz = self.scale
        cx, cy, cz = ((low[0] + high[0]) / 2 * sx, (low[1] + high[1]) / 2 * sy, (low[2] + high[2]) / 2 * sz)
        hx, hy, hz = (
            (high[0] - low[0]) / 2 * abs(sx),
            (high[1] - low[1]) / 2 * abs(sy),
            (high[2] - low[2]) / 2 * abs(sz),
        )
        if self.quat == _UNTURNED:
            return (cx + self.location[0], cy + self.location[1], cz + self.location[2]), (hx, hy, hz)
        origin, extent = [], []
        for (a, b, c), t in zip(self.axes(), self.location, strict=True):
            origin.append(a * cx + b * cy + c * cz + t)
            extent.append(abs(a) * hx + abs(b) * hy + abs(c) * hz)
        return (origin[0], origin[1], origin[2]), (extent[0], extent[1], extent[2])

    def is_finite(self) -> bool:
        """Whether no number is NaN or infinite."""
        return all(math.isfinite(v) for v in (*self.location, *self.quat, *self.scale))

    def is_sound(self) -> bool:
        """Whether every number is one that a level can hold: at most ``LARGEST``, and no NaN."""
        return all(abs(v) <= LARGEST for v in (*self.location, *self.quat, *self.scale))


IDENTITY = Pose(_ZERO, _UNTURNED, _ONE, _ZERO)


def reciprocal(value: float) -> float:
    """1 / value, and 0 for (nearly) 0, as Unreal's safe scale reciprocal."""
    return 0.0 if abs(value) <= 1e-8 else 1.0 / value


def conjugate(quat: Quaternion) -> Quaternion:
    """The inverse of a unit quaternion."""
    return (-quat[0], -quat[1], -quat[2], quat[3])


def rotate(quat: Quaternion, vector: Triple) -> Triple:
    """``vector`` turned by a unit quaternion."""
    x, y, z, w = quat
    tx, ty, tz = (
        2 * (y * vector[2] - z * vector[1]),
        2 * (z * vector[0] - x * vector[2]),
        2 * (x * vector[1] - y * vector[0]),
    )
    return (
        vector[0] + w * tx + y * tz - z * ty,
        vector[1] + w * ty + z * tx - x * tz,
        vector[2] + w * tz + x * ty - y * tx,
    )


def normalized(quat: Sequence[float]) -> Quaternion:
    """A unit quaternion in the same direction; the identity for a (nearly) zero one."""
    size = math.sqrt(sum(q * q for q in quat))
    if size < 1e-8:
        return _UNTURNED
    return (quat[0] / size, quat[1] / size, quat[2] / size, quat[3] / size)


def _product(a: Triple, b: Triple) -> Triple:
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])


def _by_matrices(rotation: Array, scale: Triple) -> Quaternion:
    """Quaternion of a scaled matrix with its scale removed and the signs of ``scale`` put back (negative scales)."""
    lengths = np.linalg.norm(rotation, axis=0)
    axes = rotation / np.where(lengths > 1e-8, lengths, 1.0) * np.where(np.array(scale) < 0, -1.0, 1.0)
    return by_matrix(axes)


def by_matrix(m: Array) -> Quaternion:
    """Quaternion of a 3x3 rotation matrix that acts on column vectors."""
    trace = float(np.trace(m))
    if trace > 0:
        s = math.sqrt(trace + 1) * 2
        return normalized(((m[2, 1] - m[1, 2]) / s, (m[0, 2] - m[2, 0]) / s, (m[1, 0] - m[0, 1]) / s, s / 4))
    i = int(np.argmax(np.diag(m)))
    j, k = (i + 1) % 3, (i + 2) % 3
    s = math.sqrt(max(0.0, m[i, i] - m[j, j] - m[k, k] + 1)) * 2
    if s < 1e-8:
        return _UNTURNED
    quat = [0.0, 0.0, 0.0, float(m[k, j] - m[j, k]) / s]
    quat[i], quat[j], quat[k] = s / 4, float(m[j, i] + m[i, j]) / s, float(m[k, i] + m[i, k]) / s
    return normalized(quat)


def compose(child: Pose, parent: Pose) -> Pose:
    """World pose of ``child`` given relative to ``parent`` (Unreal's ``child * parent``)."""
    location = parent.point(child.location)
    scale = _product(child.scale, parent.scale)
    if min(child.scale) < 0 or min(parent.scale) < 0:
        quat = _by_matrices(parent.matrix()[:3, :3] @ child.matrix()[:3, :3], scale)
    else:
        quat = normalized(quat_multiply(parent.quat, child.quat))
    return Pose(location, quat, scale)


def relative_to(world: Pose, parent: Pose) -> Pose:
    """Pose relative to ``parent`` whose composition with it gives ``world`` (axes of zero scale give 0)."""
    location = parent.inverse_point(world.location)
    back = (reciprocal(parent.scale[0]), reciprocal(parent.scale[1]), reciprocal(parent.scale[2]))
    scale = _product(world.scale, back)
    if min(world.scale) < 0 or min(parent.scale) < 0:
        turned = np.diag(back) @ np.array(parent.axes()).T @ world.matrix()[:3, :3]
        quat = _by_matrices(turned, scale)
    else:
        quat = normalized(quat_multiply(conjugate(parent.quat), world.quat))
    return Pose(location, quat, scale)
