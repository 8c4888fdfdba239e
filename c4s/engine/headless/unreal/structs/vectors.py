"""Vectors."""



from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from c4s.engine.headless.pose import (
    rotate,
)
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.structs.numbers import Constant, Near, numbers
from c4s.scene.transform import quat_from_rotator

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.structs.rotations import Rotator


@public
class Vector2D(Near):
    """Two numbers."""

    _fields = numbers("x", "y")
    x: float
    y: float

    def __init__(self, x: float = 0.0, y: float = 0.0) -> None:
        super().__init__(x, y)


@public
class Vector(Near):
    """A point or direction in cm."""

    _fields = numbers("x", "y", "z")
    x: float
    y: float
    z: float

    ZERO = Constant(0.0, 0.0, 0.0)
    ONE = Constant(1.0, 1.0, 1.0)
    FORWARD = Constant(1.0, 0.0, 0.0)
    BACKWARD = Constant(-1.0, 0.0, 0.0)
    RIGHT = Constant(0.0, 1.0, 0.0)
    LEFT = Constant(0.0, -1.0, 0.0)
    UP = Constant(0.0, 0.0, 1.0)
    DOWN = Constant(0.0, 0.0, -1.0)

    def assign(self, vector: Any) -> None:
        """Take over all numbers."""
        super().assign(vector)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        if not self._fill(x, y, z):
            super().__init__(x, y, z)

    def _triple(self) -> tuple[float, float, float]:
        return (self.x, self.y, self.z)

    def length(self) -> float:
        """Length in cm."""
        return math.sqrt(self.x * self.x + self.y * self.y + self.z * self.z)

    def length_squared(self) -> float:
        """Squared length."""
        return self.x * self.x + self.y * self.y + self.z * self.z

    @api
    def dot(self, b: Vector) -> float:
        """Scalar product."""
        return self.x * b.x + self.y * b.y + self.z * b.z

    @api
    def cross(self, b: Vector) -> Vector:
        """Vector product."""
        return Vector(self.y * b.z - self.z * b.y, self.z * b.x - self.x * b.z, self.x * b.y - self.y * b.x)

    def normal(self, tolerance: float = 1e-4) -> Vector:
        """Unit vector in this direction; zero for a (nearly) zero one."""
        size = self.length()
        return Vector() if size * size < tolerance * tolerance else Vector(self.x / size, self.y / size, self.z / size)

    def normalize(self, tolerance: float = 1e-8) -> None:
        """Make it a unit vector in place."""
        self.assign(self.normal(tolerance))

    @api
    def distance(self, v2: Vector) -> float:
        """Distance in cm."""
        return math.dist(self._triple(), v2._triple())

    @api
    def distance2d(self, v2: Vector) -> float:
        """Horizontal distance in cm."""
        return math.hypot(self.x - v2.x, self.y - v2.y)

    def rotator(self) -> Rotator:
        """Rotation that turns +X into this direction."""
        from c4s.engine.headless.unreal.structs.rotations import Rotator

        return Rotator(roll=0.0, pitch=math.degrees(math.atan2(self.z, math.hypot(self.x, self.y))),
                       yaw=math.degrees(math.atan2(self.y, self.x)))

    @api
    def rotate(self, b: Rotator) -> Vector:
        """This vector turned by a rotation."""
        return Vector(*rotate(quat_from_rotator(b._triple()), self._triple()))

    def length2d(self) -> float:
        """Horizontal length in cm."""
        return math.hypot(self.x, self.y)

    def is_zero(self) -> bool:
        """Whether all components are exactly 0."""
        return self._triple() == (0.0, 0.0, 0.0)

    @api
    def is_nearly_zero(self, tolerance: float = 1e-4) -> bool:
        """Whether all components lie within the tolerance of 0."""
        return max(map(abs, self._triple())) <= tolerance

    @api
    def lerp_to(self, b: Vector, alpha: float) -> Vector:
        """Linear mix."""
        return Vector(*(p + (q - p) * alpha for p, q in zip(self._triple(), b._triple(), strict=True)))


@public
class Vector4(Near):
    """Four numbers."""

    _fields = numbers("x", "y", "z", "w")

    def assign(self, vector: Any) -> None:
        """Take over all numbers."""
        super().assign(vector)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 0.0) -> None:
        super().__init__(x, y, z, w)
