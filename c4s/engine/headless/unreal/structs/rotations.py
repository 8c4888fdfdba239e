"""Rotators and quaternions."""

from __future__ import annotations

import math
from typing import Any

from c4s.engine.headless.pose import conjugate, normalized, rotate
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.structs.numbers import Components, Constant, Summed, numbers
from c4s.engine.headless.unreal.structs.turns import slerp
from c4s.engine.headless.unreal.structs.vectors import Vector
from c4s.geometry.transform import normalize_axis, quat_angle_deg, quat_from_rotator, quat_multiply, rotator_from_quat


@public
class Rotator(Components):
    """A rotation in degrees; positional order is roll, pitch, yaw. Angles that differ by whole turns are equal."""

    _fields = numbers("roll", "pitch", "yaw")
    roll: float
    pitch: float
    yaw: float

    def __init__(self, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> None:
        if type(roll) is type(pitch) is type(yaw) is float:
            own = self.__dict__
            own["roll"], own["pitch"], own["yaw"] = roll, pitch, yaw
        else:
            super().__init__(roll, pitch, yaw)

    @classmethod
    def _of(cls, rotation_deg: tuple[float, float, float]) -> Rotator:
        return cls(roll=rotation_deg[2] + 0.0, pitch=rotation_deg[0] + 0.0, yaw=rotation_deg[1] + 0.0)

    @classmethod
    def _of_quat(cls, quat: tuple[float, float, float, float]) -> Rotator:
        return cls._of(rotator_from_quat(quat))

    def _triple(self) -> tuple[float, float, float]:
        return (self.pitch, self.yaw, self.roll)

    def _quat(self) -> tuple[float, float, float, float]:
        return quat_from_rotator(self._triple())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Rotator) and self.is_near_equal(other)

    __hash__ = None  # type: ignore[assignment]

    def __neg__(self) -> Rotator:
        return self.inversed()

    @api
    def is_near_equal(self, b: Rotator, error_tolerance: float = 1e-4) -> bool:
        """Whether every angle differs by at most the tolerance, whole turns aside."""
        return all(abs(normalize_axis(p - q)) <= error_tolerance for p, q in zip(self._all(), b._all(), strict=True))

    @api
    def is_not_near_equal(self, b: Rotator, error_tolerance: float = 1e-4) -> bool:
        """Whether any angle differs by more than the tolerance."""
        return not self.is_near_equal(b, error_tolerance)

    def quaternion(self) -> Quat:
        """The same rotation as a quaternion."""
        return Quat(*self._quat())

    def _axis(self, x: float, y: float, z: float) -> Vector:
        return Vector(*rotate(self._quat(), (x, y, z)))

    def get_forward_vector(self) -> Vector:
        """Image of +X."""
        return self._axis(1, 0, 0)

    def get_right_vector(self) -> Vector:
        """Image of +Y."""
        return self._axis(0, 1, 0)

    def get_up_vector(self) -> Vector:
        """Image of +Z."""
        return self._axis(0, 0, 1)

    def get_axes(self) -> tuple[Vector, Vector, Vector]:
        """Images of +X, +Y and +Z."""
        return self.get_forward_vector(), self.get_right_vector(), self.get_up_vector()

    def to_vector(self) -> Vector:
        """Image of +X."""
        return self.get_forward_vector()

    @api
    def combine(self, b: Rotator) -> Rotator:
        """This rotation first, then ``b``."""
        return Rotator._of_quat(quat_multiply(b._quat(), self._quat()))

    @api
    def delta(self, b: Rotator) -> Rotator:
        """Normalised difference ``self - b``."""
        return Rotator(*(normalize_axis(p - q) for p, q in zip(self._all(), b._all(), strict=True)))

    @api
    def lerp(self, b: Rotator, alpha: float, shortest_path: bool) -> Rotator:
        """A rotation part of the way: along the shortest arc, or angle by angle."""
        if shortest_path:
            return Rotator._of_quat(slerp(self._quat(), b._quat(), alpha))
        return Rotator(*(p + (q - p) * alpha for p, q in zip(self._all(), b._all(), strict=True)))

    @api
    def scale(self, b: float) -> Rotator:
        """Every angle times a number."""
        return Rotator(self.roll * b, self.pitch * b, self.yaw * b)

    @api
    def scale_integer(self, b: int) -> Rotator:
        """Every angle times a number."""
        return self.scale(b)

    def inversed(self) -> Rotator:
        """The inverse rotation."""
        return Rotator._of_quat(conjugate(self._quat()))


@public
class Quat(Summed):
    """A quaternion x, y, z, w; one without arguments is all zeros, as in Unreal's Python."""

    _fields = numbers("x", "y", "z", "w")
    x: float
    y: float
    z: float
    w: float

    IDENTITY = Constant(0.0, 0.0, 0.0, 1.0)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 0.0) -> None:
        if type(x) is type(y) is type(z) is type(w) is float:
            own = self.__dict__
            own["x"], own["y"], own["z"], own["w"] = x, y, z, w
        else:
            super().__init__(x, y, z, w)

    def _four(self) -> tuple[float, float, float, float]:
        return (self.x, self.y, self.z, self.w)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Quat) and self.equals(other)

    __hash__ = None  # type: ignore[assignment]

    def __mul__(self, other: Any) -> Any:
        return Quat(*quat_multiply(self._four(), other._four())) if isinstance(other, Quat) else NotImplemented

    def __imul__(self, other: Any) -> Any:
        made = self * other
        return made if made is NotImplemented else self._take(made)

    @api
    def multiply(self, b: Quat) -> Quat:
        """Product: ``b`` first, then this."""
        return Quat(*quat_multiply(self._four(), b._four()))

    @api
    def equals(self, b: Quat, tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance, the sign of all aside."""
        pairs = list(zip(self._four(), b._four(), strict=True))
        return all(abs(p - q) <= tolerance for p, q in pairs) or all(abs(p + q) <= tolerance for p, q in pairs)

    @api
    def not_equal(self, b: Quat, error_tolerance: float = 1e-4) -> bool:
        """Whether any component differs by more than the tolerance."""
        return not self.equals(b, error_tolerance)

    def rotator(self) -> Rotator:
        """The same rotation as angles."""
        return Rotator._of_quat(self._four())

    def euler(self) -> Vector:
        """Roll, pitch, yaw in degrees as a vector."""
        pitch, yaw, roll = rotator_from_quat(self._four())
        return Vector(roll, pitch, yaw)

    @api
    def set_from_euler(self, euler: Vector) -> None:
        """Become the rotation of roll, pitch, yaw in degrees."""
        self._take(Quat(*quat_from_rotator((euler.y, euler.z, euler.x))))

    @api
    def set_components(self, x: float, y: float, z: float, w: float) -> None:
        """Set all numbers."""
        self._take(Quat(x, y, z, w))

    def inversed(self) -> Quat:
        """The inverse rotation."""
        return Quat(*conjugate(self._four()))

    @api
    def normalized(self, tolerance: float = 1e-4) -> Quat:
        """The unit quaternion in the same direction; the identity for a (nearly) zero one."""
        return Quat(*normalized(self._four())) if self.size_squared() >= tolerance else Quat.IDENTITY

    @api
    def normalize(self, tolerance: float = 1e-4) -> None:
        """Make it a unit quaternion in place."""
        self._take(self.normalized(tolerance))

    def size(self) -> float:
        """Length."""
        return math.sqrt(self.size_squared())

    def size_squared(self) -> float:
        """Squared length."""
        return sum(a * a for a in self._four())

    def is_normalized(self) -> bool:
        """Whether it is a unit quaternion, roughly."""
        return abs(1 - self.size_squared()) < 0.01

    @api
    def is_identity(self, tolerance: float = 1e-4) -> bool:
        """Whether it turns nothing."""
        return self.equals(Quat.IDENTITY, tolerance)

    def is_finite(self) -> bool:
        """Whether all numbers are finite."""
        return all(map(math.isfinite, self._four()))

    def is_non_finite(self) -> bool:
        """Whether any number is not finite."""
        return not self.is_finite()

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

    @api
    def slerp_quat(self, b: Quat, alpha: float) -> Quat:
        """A rotation part of the way along the shorter arc."""
        return Quat(*slerp(self._four(), b._four(), alpha))

    @api
    def ensure_shortest_arc_to(self, b: Quat) -> None:
        """Change the sign of all numbers where the other would be the longer way."""
        if sum(p * q for p, q in zip(self._four(), b._four(), strict=True)) < 0:
            self._take(Quat(-self.x, -self.y, -self.z, -self.w))

    def get_angle(self) -> float:
        """Angle of the rotation in radians."""
        return 2 * math.acos(max(-1.0, min(1.0, self.w)))

    def get_rotation_axis(self) -> Vector:
        """Axis of the rotation; +X for none."""
        size = self.x * self.x + self.y * self.y + self.z * self.z
        return Vector(self.x, self.y, self.z).normal(0.0) if size > 1e-8 else Vector(1, 0, 0)

    def log(self) -> Quat:
        """Half angle times axis, with w 0, of a unit quaternion."""
        if abs(self.w) < 1:
            angle = math.acos(self.w)
            if abs(math.sin(angle)) >= 1e-8:
                factor = angle / math.sin(angle)
                return Quat(self.x * factor, self.y * factor, self.z * factor, 0.0)
        return Quat(self.x, self.y, self.z, 0.0)

    def exp(self) -> Quat:
        """The unit quaternion of half angle times axis."""
        angle = math.sqrt(self.x * self.x + self.y * self.y + self.z * self.z)
        factor = math.sin(angle) / angle if abs(math.sin(angle)) >= 1e-8 else 1.0
        return Quat(self.x * factor, self.y * factor, self.z * factor, math.cos(angle))

    def get_axis_x(self) -> Vector:
        """Image of +X."""
        return Vector(*rotate(self._four(), (1, 0, 0)))

    def get_axis_y(self) -> Vector:
        """Image of +Y."""
        return Vector(*rotate(self._four(), (0, 1, 0)))

    def get_axis_z(self) -> Vector:
        """Image of +Z."""
        return Vector(*rotate(self._four(), (0, 0, 1)))

    def vector_forward(self) -> Vector:
        """Image of +X."""
        return self.get_axis_x()

    def vector_right(self) -> Vector:
        """Image of +Y."""
        return self.get_axis_y()

    def vector_up(self) -> Vector:
        """Image of +Z."""
        return self.get_axis_z()
