"""Rotators and quaternions."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from c4s.engine.headless.pose import (
    conjugate,
    normalized,
    rotate,
)
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.structs.numbers import Components, Near, numbers
from c4s.engine.headless.unreal.structs.vectors import Vector
from c4s.scene.transform import normalize_axis, quat_angle_deg, quat_from_rotator, quat_multiply, rotator_from_quat

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.structs.transforms import Transform


@public
class Rotator(Near):
    """A rotation in degrees; positional order is roll, pitch, yaw."""

    _fields = numbers("roll", "pitch", "yaw")
    roll: float
    pitch: float
    yaw: float

    def __init__(self, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> None:
        if not self._fill(roll, pitch, yaw):
            super().__init__(roll, pitch, yaw)

    @classmethod
    def _of(cls, rotation_deg: tuple[float, float, float]) -> Rotator:
        return cls(roll=rotation_deg[2] + 0.0, pitch=rotation_deg[0] + 0.0, yaw=rotation_deg[1] + 0.0)

    def _triple(self) -> tuple[float, float, float]:
        return (self.pitch, self.yaw, self.roll)

    def quaternion(self) -> Quat:
        """The same rotation as a quaternion."""
        return Quat(*quat_from_rotator(self._triple()))

    def _axis(self, x: float, y: float, z: float) -> Vector:
        return Vector(*rotate(quat_from_rotator(self._triple()), (x, y, z)))

    def get_forward_vector(self) -> Vector:
        """Image of +X."""
        return self._axis(1, 0, 0)

    def get_right_vector(self) -> Vector:
        """Image of +Y."""
        return self._axis(0, 1, 0)

    def get_up_vector(self) -> Vector:
        """Image of +Z."""
        return self._axis(0, 0, 1)

    @api
    def combine(self, b: Rotator) -> Rotator:
        """This rotation first, then ``b``."""
        return Rotator._of(rotator_from_quat(quat_multiply(quat_from_rotator(b._triple()),
                                                           quat_from_rotator(self._triple()))))

    @api
    def delta(self, b: Rotator) -> Rotator:
        """Normalised difference ``self - b``."""
        return Rotator(*(normalize_axis(p - q) for p, q in zip(self._all(), b._all(), strict=True)))

    def inversed(self) -> Rotator:
        """The inverse rotation."""
        return Rotator._of(rotator_from_quat(conjugate(quat_from_rotator(self._triple()))))

    def transform(self) -> Transform:
        """A transform with this rotation only."""
        from c4s.engine.headless.unreal.structs.transforms import Transform

        return Transform(rotation=self)


@public
class Quat(Components):
    """A unit quaternion x, y, z, w."""

    _fields = {**numbers("x", "y", "z"), "w": Prop("float", 1.0)}
    x: float
    y: float
    z: float
    w: float

    def equals(self, b: Quat, tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance."""
        return self._near(b, tolerance)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 1.0) -> None:
        if not self._fill(x, y, z, w):
            super().__init__(x, y, z, w)

    def _four(self) -> tuple[float, float, float, float]:
        return (self.x, self.y, self.z, self.w)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Quat):
            return Quat(*quat_multiply(self._four(), other._four()))
        return super().__mul__(other)

    @api
    def multiply(self, b: Quat) -> Quat:
        """Product: ``b`` first, then this."""
        return Quat(*quat_multiply(self._four(), b._four()))

    def rotator(self) -> Rotator:
        """The same rotation as angles."""
        return Rotator._of(rotator_from_quat(self._four()))

    def euler(self) -> Vector:
        """Roll, pitch, yaw in degrees as a vector."""
        pitch, yaw, roll = rotator_from_quat(self._four())
        return Vector(roll, pitch, yaw)

    def inversed(self) -> Quat:
        """The inverse rotation."""
        return Quat(*conjugate(self._four()))

    def normalized(self, tolerance: float = 1e-4) -> Quat:
        """The unit quaternion in the same direction."""
        return Quat(*normalized(self._four()))

    @api
    def rotate_vector(self, v: Vector) -> Vector:
        """``v`` turned."""
        return Vector(*rotate(self._four(), v._triple()))

    @api
    def unrotate_vector(self, v: Vector) -> Vector:
        """``v`` turned back."""
        return Vector(*rotate(conjugate(self._four()), v._triple()))

    @api
    def angular_distance(self, b: Quat) -> float:
        """Angle between two rotations in radians."""
        return math.radians(quat_angle_deg(self._four(), b._four()))

    def get_axis_x(self) -> Vector:
        """Image of +X."""
        return Vector(*rotate(self._four(), (1, 0, 0)))

    def get_axis_y(self) -> Vector:
        """Image of +Y."""
        return Vector(*rotate(self._four(), (0, 1, 0)))

    def get_axis_z(self) -> Vector:
        """Image of +Z."""
        return Vector(*rotate(self._four(), (0, 0, 1)))
