"""Rows of two and of four numbers."""

from __future__ import annotations

import math
from typing import Any

from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.structs.numbers import SMALL, Constant, Near, Scaled, clamped, numbers, quotient
from c4s.engine.headless.unreal.structs.vectors import Vector


@public
class Vector2D(Scaled):
    """Two numbers."""

    _fields = numbers("x", "y")
    x: float
    y: float

    ZERO = Constant(0.0, 0.0)
    ONE = Constant(1.0, 1.0)
    UNIT45_DEG = Constant(math.sqrt(0.5), math.sqrt(0.5))

    def __init__(self, x: float = 0.0, y: float = 0.0) -> None:
        super().__init__(x, y)

    def __add__(self, other: Any) -> Any:
        return self._scaled(other, lambda a, b: a + b)

    def __sub__(self, other: Any) -> Any:
        return self._scaled(other, lambda a, b: a - b)

    def __or__(self, other: Any) -> Any:
        return self.dot(other) if isinstance(other, Vector2D) else NotImplemented

    def __xor__(self, other: Any) -> Any:
        return self.cross(other) if isinstance(other, Vector2D) else NotImplemented

    @api
    def set(self, x: float, y: float) -> None:
        """Set both numbers."""
        self._take(Vector2D(x, y))

    @api
    def divide(self, b: Vector2D) -> Vector2D:
        """Quotient by component."""
        return self / b  # type: ignore[no-any-return]

    def length(self) -> float:
        """Length."""
        return math.hypot(self.x, self.y)

    def length_squared(self) -> float:
        """Squared length."""
        return self.x * self.x + self.y * self.y

    @api
    def dot(self, b: Vector2D) -> float:
        """Scalar product."""
        return self.x * b.x + self.y * b.y

    @api
    def cross(self, b: Vector2D) -> float:
        """Size of the vector product."""
        return self.x * b.y - self.y * b.x

    @api
    def distance(self, v2: Vector2D) -> float:
        """Distance."""
        return math.hypot(self.x - v2.x, self.y - v2.y)

    @api
    def distance_squared(self, v2: Vector2D) -> float:
        """Squared distance."""
        return float((self.x - v2.x) ** 2 + (self.y - v2.y) ** 2)

    @api
    def normal(self, tolerance: float = 1e-8) -> Vector2D:
        """Unit vector in this direction; zero for a (nearly) zero one."""
        squared = self.length_squared()
        return self * (1 / math.sqrt(squared) if squared > tolerance else 0.0)  # type: ignore[no-any-return]

    def normal_unsafe(self) -> Vector2D:
        """Unit vector in this direction; not a number for a zero one."""
        return self / self.length()  # type: ignore[no-any-return]

    @api
    def normalize(self, tolerance: float = 1e-8) -> None:
        """Make it a unit vector in place; zero for a (nearly) zero one."""
        self._take(self.normal(tolerance))

    @api
    def get_rotated(self, angle_deg: float) -> Vector2D:
        """Turned by degrees, x towards y."""
        sine, cosine = math.sin(math.radians(angle_deg)), math.cos(math.radians(angle_deg))
        return Vector2D(cosine * self.x - sine * self.y, sine * self.x + cosine * self.y)

    def get_abs(self) -> Vector2D:
        """Without signs."""
        return Vector2D(abs(self.x), abs(self.y))

    def get_abs_max(self) -> float:
        """Largest number without sign."""
        return max(abs(self.x), abs(self.y))

    def get_max(self) -> float:
        """Largest number."""
        return max(self.x, self.y)

    def get_min(self) -> float:
        """Smallest number."""
        return min(self.x, self.y)

    @api
    def is_nearly_zero(self, tolerance: float = 1e-4) -> bool:
        """Whether both numbers lie within the tolerance of 0."""
        return self.get_abs_max() <= tolerance

    def to_sign(self) -> Vector2D:
        """1 or -1 by component."""
        return Vector2D(1.0 if self.x >= 0 else -1.0, 1.0 if self.y >= 0 else -1.0)

    def to_rounded(self) -> Vector2D:
        """Nearest whole numbers."""
        return Vector2D(math.floor(self.x + 0.5), math.floor(self.y + 0.5))

    def to_direction_and_length(self) -> tuple[Vector2D, float]:
        """Unit vector and length."""
        size = self.length()
        return (self / size if size > SMALL else Vector2D()), (size if size > SMALL else 0.0)

    @api
    def clamped_axes(self, min_axis_val: float, max_axis_val: float) -> Vector2D:
        """Both numbers moved between two."""
        return Vector2D(clamped(self.x, min_axis_val, max_axis_val), clamped(self.y, min_axis_val, max_axis_val))

    @api
    def interp_to(self, target: Vector2D, delta_time: float, interp_speed: float) -> Vector2D:
        """A step towards a target that slows down as it comes near."""
        if interp_speed <= 0 or self.distance_squared(target) < 1e-4:
            return target
        return self + (target - self) * clamped(delta_time * interp_speed, 0.0, 1.0)  # type: ignore[no-any-return]

    @api
    def interp_to_constant(self, target: Vector2D, delta_time: float, interp_speed: float) -> Vector2D:
        """A step of constant speed towards a target."""
        away, step = self.distance(target), interp_speed * delta_time
        return target if away <= step else self + (target - self) * (max(step, 0.0) / away)

    def spherical_to_unit_cartesian(self) -> Vector:
        """Unit vector of an angle from +Z and an angle about Z, in radians."""
        sine = math.sin(self.x)
        return Vector(math.cos(self.y) * sine, math.sin(self.y) * sine, math.cos(self.x))

    @api
    def vector(self, z: float = 0.0) -> Vector:
        """With a z."""
        return Vector(self.x, self.y, z)


@public
class Vector4(Near):
    """Four numbers."""

    _fields = numbers("x", "y", "z", "w")
    x: float
    y: float
    z: float
    w: float

    ZERO = Constant(0.0, 0.0, 0.0, 0.0)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 0.0) -> None:
        super().__init__(x, y, z, w)

    def __or__(self, other: Any) -> Any:
        return self.dot3(other) if isinstance(other, Vector4) else NotImplemented

    def assign(self, vector: Any) -> None:
        """Take over all numbers."""
        super().assign(vector)

    @api
    def set(self, x: float, y: float, z: float, w: float) -> None:
        """Set all numbers."""
        self._take(Vector4(x, y, z, w))

    @api
    def divide(self, b: Vector4) -> Vector4:
        """Quotient by component."""
        return self / b  # type: ignore[no-any-return]

    def vector(self) -> Vector:
        """x, y and z."""
        return Vector(self.x, self.y, self.z)

    def length(self) -> float:
        """Length of all four."""
        return math.hypot(*self._all())

    def length_squared(self) -> float:
        """Squared length of all four."""
        return sum(a * a for a in self._all())

    def length3(self) -> float:
        """Length of x, y, z."""
        return self.vector().length()

    def length_squared3(self) -> float:
        """Squared length of x, y, z."""
        return self.vector().length_squared()

    @api
    def dot(self, b: Vector4) -> float:
        """Scalar product of all four."""
        return sum(p * q for p, q in zip(self._all(), b._all(), strict=True))

    @api
    def dot3(self, b: Vector4) -> float:
        """Scalar product of x, y, z."""
        return self.vector().dot(b.vector())

    @api
    def cross3(self, b: Vector4) -> Vector4:
        """Vector product of x, y, z."""
        return Vector4(*self.vector().cross(b.vector())._triple(), 0.0)

    def normal_unsafe3(self) -> Vector4:
        """Unit vector of x, y, z; not a number for a zero one."""
        size = self.length3()
        return Vector4(quotient(self.x, size), quotient(self.y, size), quotient(self.z, size), 0.0)

    @api
    def normal3(self, tolerance: float = 1e-4) -> Vector4:
        """Unit vector of x, y, z; zero when the squared length is within the tolerance."""
        return self.normal_unsafe3() if self.length_squared3() > tolerance else Vector4()

    @api
    def normalize3(self, tolerance: float = 1e-8) -> None:
        """Make x, y, z a unit vector in place."""
        self._take(self.normal3(tolerance))

    @api
    def mirror_by_vector3(self, surface_normal: Vector4) -> Vector4:
        """x, y, z reflected by a surface."""
        x, y, z = self.vector().mirror_by_vector(surface_normal.vector())._triple()
        return Vector4(x, y, z, 0.0)

    @api
    def is_unit3(self, squared_lenth_tolerance: float = 1e-4) -> bool:
        """Whether the squared length of x, y, z is 1, within the tolerance."""
        return self.vector().is_unit(squared_lenth_tolerance)

    def is_normal3(self) -> bool:
        """Whether x, y, z are a unit vector, roughly."""
        return self.vector().is_normal()

    @api
    def is_nearly_zero3(self, tolerance: float = 1e-4) -> bool:
        """Whether x, y, z lie within the tolerance of 0."""
        return self.vector().is_nearly_zero(tolerance)

    def is_nan(self) -> bool:
        """Whether any number is not finite."""
        return not all(map(math.isfinite, self._all()))
