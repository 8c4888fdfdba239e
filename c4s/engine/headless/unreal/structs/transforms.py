"""Transforms."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

from c4s.engine.headless.pose import IDENTITY, Pose, compose, conjugate, normalized, reciprocal, relative_to, rotate
from c4s.engine.headless.unreal.core import Prop, api, need, public
from c4s.engine.headless.unreal.structs.base import StructBase
from c4s.engine.headless.unreal.structs.modes import LerpInterpolationMode
from c4s.engine.headless.unreal.structs.numbers import clamped
from c4s.engine.headless.unreal.structs.rotations import Quat, Rotator
from c4s.engine.headless.unreal.structs.turns import slerp
from c4s.engine.headless.unreal.structs.vectors import Vector
from c4s.geometry.transform import quat_from_rotator, quat_multiply, rotator_from_quat


@public
class Transform(StructBase):
    """Translation (cm), rotation (a Quat) and scale; built from location, Rotator and scale."""

    _fields = {"translation": Prop("Vector"), "rotation": Prop("Quat"), "scale3d": Prop("Vector")}
    translation: Vector
    rotation: Quat
    scale3d: Vector

    def __init__(
        self, location: Any = (0.0, 0.0, 0.0), rotation: Any = (0.0, 0.0, 0.0), scale: Any = (1.0, 1.0, 1.0)
    ) -> None:
        given = [
            need(value, kind, f"Transform: Failed to convert argument '{name}'", name)
            for value, kind, name in (
                (location, "Vector", "location"),
                (rotation, "Rotator", "rotation"),
                (scale, "Vector", "scale"),
            )
        ]
        super().__init__(given[0], given[1].quaternion(), given[2])

    @classmethod
    def _of(cls, pose: Pose) -> Transform:
        made = cls.__new__(cls)
        made.__dict__.update(translation=Vector(*pose.location), rotation=Quat(*pose.quat), scale3d=Vector(*pose.scale))
        return made

    def _pose(self) -> Pose:
        return Pose(self.translation._triple(), normalized(self.rotation._four()), self.scale3d._triple())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Transform) and self.is_near_equal(other)

    __hash__ = None

    @api
    def equals(self, b: Transform) -> bool:
        """Whether all parts agree within 0.0001."""
        return self.is_near_equal(b)

    def __imul__(self, other: Any) -> Any:
        if not isinstance(other, Transform):
            return NotImplemented
        self.assign(self * other)
        return self

    def __mul__(self, other: Any) -> Any:
        return Transform._of(compose(self._pose(), other._pose())) if isinstance(other, Transform) else NotImplemented

    @api
    def multiply(self, b: Transform) -> Transform:
        """This transform first, then ``b``."""
        return Transform._of(compose(self._pose(), b._pose()))

    @api
    def make_relative(self, relative_to: Transform) -> Transform:
        """This transform seen from another."""
        return _relative(self, relative_to)

    def inverse(self) -> Transform:
        """The inverse transform (exact without rotation under non-uniform scale)."""
        pose = self._pose()
        back = conjugate(pose.quat)
        scale = (reciprocal(pose.scale[0]), reciprocal(pose.scale[1]), reciprocal(pose.scale[2]))
        turned = rotate(back, pose.location)
        return Transform._of(Pose((-turned[0] * scale[0], -turned[1] * scale[1], -turned[2] * scale[2]), back, scale))

    @api
    def transform_location(self, location: Vector) -> Vector:
        """World position of a local point."""
        return Vector(*self._pose().point(location._triple()))

    @api
    def inverse_transform_location(self, location: Vector) -> Vector:
        """Local position of a world point."""
        return Vector(*self._pose().inverse_point(location._triple()))

    @api
    def transform_direction(self, direction: Vector) -> Vector:
        """A direction turned, not scaled."""
        return Vector(*rotate(self._pose().quat, direction._triple()))

    @api
    def inverse_transform_direction(self, direction: Vector) -> Vector:
        """A direction turned back, not scaled."""
        return Vector(*rotate(conjugate(self._pose().quat), direction._triple()))

    @api
    def transform_rotation(self, rotation: Rotator) -> Rotator:
        """A local rotation in the world."""
        return Rotator._of(rotator_from_quat(quat_multiply(self._pose().quat, quat_from_rotator(rotation._triple()))))

    @api
    def inverse_transform_rotation(self, rotation: Rotator) -> Rotator:
        """A world rotation seen from here."""
        return Rotator._of_quat(quat_multiply(conjugate(self._pose().quat), rotation._quat()))

    @api
    def lerp(
        self, b: Transform, alpha: float, interp_mode: LerpInterpolationMode = LerpInterpolationMode.QUAT_INTERP
    ) -> Transform:
        """A transform part of the way."""
        one, two = self._pose(), b._pose()
        if interp_mode is LerpInterpolationMode.EULER_INTERP:
            turned = Rotator._of(one.rotation_deg).lerp(Rotator._of(two.rotation_deg), alpha, False)._quat()
        else:
            turned = slerp(one.quat, two.quat, alpha)
        return Transform._of(
            Pose(
                Vector(*one.location).lerp_to(Vector(*two.location), alpha)._triple(),
                turned,
                Vector(*one.scale).lerp_to(Vector(*two.scale), alpha)._triple(),
            )
        )

    @api
    def interp_to(self, target: Transform, delta_time: float, interp_speed: float) -> Transform:
        """A step towards a target that slows down as it comes near."""
        if interp_speed <= 0:
            return target
        return self.lerp(target, clamped(delta_time * interp_speed, 0.0, 1.0))

    def determinant(self) -> float:
        """Product of the scale factors."""
        return self.scale3d.x * self.scale3d.y * self.scale3d.z

    @api
    def is_near_equal(
        self,
        b: Transform,
        location_tolerance: float = 1e-4,
        rotation_tolerance: float = 1e-4,
        scale3d_tolerance: float = 1e-4,
    ) -> bool:
        """Whether all parts agree within the tolerances."""
        same = abs(sum(p * q for p, q in zip(self.rotation._four(), b.rotation._four(), strict=True)))
        return (
            self.translation.is_near_equal(b.translation, location_tolerance)
            and 1 - same <= rotation_tolerance
            and self.scale3d.is_near_equal(b.scale3d, scale3d_tolerance)
        )


def _relative(transform: Transform, base: Transform) -> Transform:
    return Transform._of(relative_to(transform._pose(), base._pose()))


IDENTITY_TRANSFORM = Transform._of(IDENTITY)
