"""What leads from a struct to one that is built on it."""

from __future__ import annotations

import math

from c4s.engine.headless.pose import rotate
from c4s.engine.headless.unreal.core import api, extends
from c4s.engine.headless.unreal.structs.colors import LinearColor
from c4s.engine.headless.unreal.structs.grids import IntPoint, IntVector, IntVector2
from c4s.engine.headless.unreal.structs.matrices import Matrix
from c4s.engine.headless.unreal.structs.planes import Vector2D, Vector4
from c4s.engine.headless.unreal.structs.rotations import Quat, Rotator
from c4s.engine.headless.unreal.structs.transforms import Transform
from c4s.engine.headless.unreal.structs.vectors import Vector
from c4s.geometry.transform import quat_from_rotator


@extends(Vector)
class OfVector(Vector):
    """A vector as something else, and turned."""

    def truncated(self) -> IntVector:
        """Whole parts."""
        return IntVector(*map(int, self._triple()))

    def vector2d(self) -> Vector2D:
        """x and y."""
        return Vector2D(self.x, self.y)

    def linear_color(self) -> LinearColor:
        """As a colour of alpha 1."""
        return LinearColor(self.x, self.y, self.z, 1.0)

    def transform(self) -> Transform:
        """A transform to this place."""
        return Transform(location=self)

    def rotator(self) -> Rotator:
        """Rotation that turns +X into this direction."""
        return Rotator(
            roll=0.0,
            pitch=math.degrees(math.atan2(self.z, math.hypot(self.x, self.y))),
            yaw=math.degrees(math.atan2(self.y, self.x)),
        )

    def quaternion(self) -> Quat:
        """Rotation that turns +X into this direction."""
        return self.rotator().quaternion()

    @api
    def rotate(self, b: Rotator) -> Vector:
        """This vector turned by a rotation."""
        return Vector(*rotate(quat_from_rotator(b._triple()), self._triple()))

    @api
    def unrotate(self, b: Rotator) -> Vector:
        """This vector turned back by a rotation."""
        x, y, z, w = quat_from_rotator(b._triple())
        return Vector(*rotate((-x, -y, -z, w), self._triple()))


@extends(Vector2D)
class OfVector2D(Vector2D):
    """Two numbers as whole ones."""

    def truncated(self) -> IntVector2:
        """Whole parts."""
        return IntVector2(int(self.x), int(self.y))

    def int_point(self) -> IntPoint:
        """Whole parts."""
        return IntPoint(int(self.x), int(self.y))


@extends(Vector4)
class OfVector4(Vector4):
    """Four numbers as a direction."""

    def rotator(self) -> Rotator:
        """Rotation that turns +X into the direction of x, y, z."""
        return self.vector().rotator()  # type: ignore[no-any-return]

    def quaternion(self) -> Quat:
        """Rotation that turns +X into the direction of x, y, z."""
        return self.vector().quaternion()  # type: ignore[no-any-return]


@extends(Rotator)
class OfRotator(Rotator):
    """A rotation as a transform."""

    def transform(self) -> Transform:
        """A transform with this rotation only."""
        return Transform(rotation=self)


@extends(Transform)
class OfTransform(Transform):
    """A transform as a matrix."""

    def to_matrix(self) -> Matrix:
        """Scale, rotation and translation as a matrix."""
        return Matrix._of(self._pose().matrix().T)
