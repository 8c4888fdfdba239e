"""Mathematics."""

from __future__ import annotations

import math
import random

from c4s.engine.headless.pose import rotate
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector
from c4s.scene.transform import look_at, quat_from_rotator


@public
class MathLibrary(Object):
    """Mathematics."""

    @classmethod
    @api
    def find_look_at_rotation(cls, start: Vector, target: Vector) -> Rotator:
        """Rotation that turns +X from ``start`` towards ``target``."""
        return Rotator._of(look_at(start._triple(), target._triple()))

    @classmethod
    @api
    def get_forward_vector(cls, rot: Rotator) -> Vector:
        """Image of +X."""
        return rot.get_forward_vector()

    @classmethod
    @api
    def get_right_vector(cls, rot: Rotator) -> Vector:
        """Image of +Y."""
        return rot.get_right_vector()

    @classmethod
    @api
    def get_up_vector(cls, rot: Rotator) -> Vector:
        """Image of +Z."""
        return rot.get_up_vector()

    @classmethod
    @api
    def compose_rotators(cls, a: Rotator, b: Rotator) -> Rotator:
        """``a`` first, then ``b``."""
        return a.combine(b)

    @classmethod
    @api
    def compose_transforms(cls, a: Transform, b: Transform) -> Transform:
        """``a`` first, then ``b``."""
        return a.multiply(b)

    @classmethod
    @api
    def greater_greater_vector_rotator(cls, a: Vector, b: Rotator) -> Vector:
        """``a`` turned by ``b``."""
        return Vector(*rotate(quat_from_rotator(b._triple()), a._triple()))

    @classmethod
    @api
    def vector_distance(cls, v1: Vector, v2: Vector) -> float:
        """Distance in cm."""
        return v1.distance(v2)

    @classmethod
    @api
    def degrees_to_radians(cls, a: float) -> float:
        """Degrees as radians."""
        return math.radians(a)

    @classmethod
    @api
    def lerp(cls, a: float, b: float, alpha: float) -> float:
        """Linear mix."""
        return a + (b - a) * alpha

    @classmethod
    @api
    def v_lerp(cls, a: Vector, b: Vector, alpha: float) -> Vector:
        """Linear mix of vectors."""
        return a.lerp_to(b, alpha)

    @classmethod
    @api
    def make_rot_from_x(cls, x: Vector) -> Rotator:
        """Rotation that turns +X into a direction."""
        return x.rotator()

    @classmethod
    @api
    def conv_rotator_to_vector(cls, rot: Rotator) -> Vector:
        """Image of +X."""
        return rot.get_forward_vector()

    @classmethod
    @api
    def transform_location(cls, t: Transform, location: Vector) -> Vector:
        """World place of a local point."""
        found: Vector = t.transform_location(location)
        return found

    @classmethod
    @api
    def random_float_in_range(cls, min: float, max: float) -> float:
        """A number between two, from Python's generator (``random.seed`` repeats it)."""
        return random.uniform(min, max)

    @classmethod
    @api
    def random_integer_in_range(cls, min: int, max: int) -> int:
        """A whole number between two, both included, from Python's generator."""
        return random.randint(min, max)
