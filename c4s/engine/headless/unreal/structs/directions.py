"""Distances, angles, projections and mixes of vectors."""

from __future__ import annotations

import math

from c4s.engine.headless.pose import rotate
from c4s.engine.headless.unreal.core import api, extends
from c4s.engine.headless.unreal.structs.numbers import SMALL, clamped, quotient
from c4s.engine.headless.unreal.structs.planes import Vector2D
from c4s.engine.headless.unreal.structs.rotations import Quat, Rotator
from c4s.engine.headless.unreal.structs.turns import UNTURNED, between, slerp
from c4s.engine.headless.unreal.structs.vectors import Plane, Vector


@extends(Vector)
class Directions(Vector):
    """Geometry of a vector."""

    @api
    def distance(self, v2: Vector) -> float:
        """Distance in cm."""
        return math.dist(self._triple(), v2._triple())

    @api
    def distance_squared(self, v2: Vector) -> float:
        """Squared distance."""
        return math.dist(self._triple(), v2._triple()) ** 2

    @api
    def distance2d(self, v2: Vector) -> float:
        """Horizontal distance in cm."""
        return math.hypot(self.x - v2.x, self.y - v2.y)

    @api
    def distance2d_squared(self, v2: Vector) -> float:
        """Squared horizontal distance."""
        return float((self.x - v2.x) ** 2 + (self.y - v2.y) ** 2)

    # unit vectors

    @api
    def normal2d(self, tolerance: float = 1e-4) -> Vector:
        """Horizontal unit vector in this direction; zero when the squared length is below the tolerance."""
        squared = self.length2d_squared()
        factor = 0.0 if squared < tolerance else 1 / math.sqrt(squared)
        return Vector(self.x * factor, self.y * factor, 0.0)

    def normal_unsafe(self) -> Vector:
        """Unit vector in this direction; not a number for a zero one."""
        size = self.length()
        return self._map(lambda a: quotient(a, size))  # type: ignore[no-any-return]

    @api
    def normalize(self, tolerance: float = 1e-8) -> None:
        """Make it a unit vector in place, unless the squared length is within the tolerance."""
        if self.length_squared() > tolerance:
            self._take(self._times(1 / self.length()))

    @api
    def direction_unit_to(self, to: Vector) -> Vector:
        """Unit vector from here to there; zero when they are one place."""
        return Vector(to.x - self.x, to.y - self.y, to.z - self.z).normal(SMALL)

    # angles

    def heading_angle(self) -> float:
        """Angle about Z from +X, in radians, -pi to pi."""
        return math.atan2(self.y, self.x)

    @api
    def cosine_angle2d(self, b: Vector) -> float:
        """Cosine of the horizontal angle between two."""
        mine, theirs = self.normal2d(SMALL), b.normal2d(SMALL)
        return mine.x * theirs.x + mine.y * theirs.y  # type: ignore[no-any-return]

    def unit_cartesian_to_spherical(self) -> Vector2D:
        """Angle from +Z and angle about Z, in radians, of a unit vector."""
        return Vector2D(math.acos(clamped(quotient(self.z, self.length()), -1.0, 1.0)), math.atan2(self.y, self.x))

    # projections and reflections

    def _dot(self, b: Vector) -> float:
        return self.x * b.x + self.y * b.y + self.z * b.z

    def _less(self, b: Vector, factor: float) -> Vector:
        return Vector(self.x - b.x * factor, self.y - b.y * factor, self.z - b.z * factor)

    @api
    def project_on_to(self, target: Vector) -> Vector:
        """The part along another vector; zero when that is zero."""
        squared = target.length_squared()
        return target._times(self._dot(target) / squared if squared > SMALL else 0.0)

    @api
    def project_on_to_normal(self, normal: Vector) -> Vector:
        """The part along a unit vector."""
        return normal._times(self._dot(normal))

    @api
    def project_on_to_plane(self, plane_normal: Vector) -> Vector:
        """The part within a plane of a unit normal."""
        return self._less(plane_normal, self._dot(plane_normal))

    @api
    def project_point_on_to_plane(self, plane_base: Vector, plane_normal: Vector) -> Vector:
        """The nearest point of a plane through a point, with a unit normal."""
        return self._less(plane_normal, self._dot(plane_normal) - plane_base._dot(plane_normal))

    @api
    def mirror_by_vector(self, surface_normal: Vector) -> Vector:
        """Reflected by a surface."""
        normal = surface_normal.normal(SMALL)
        return self._less(normal, 2 * self._dot(normal))

    @api
    def mirror_by_plane(self, plane: Plane) -> Vector:
        """The point on the other side of a plane."""
        return self._less(plane, 2 * (self._dot(plane) - plane.w))

    # turns

    @api
    def rotate_angle_axis(self, angle_deg: float, axis: Vector) -> Vector:
        """Turned by degrees about an axis (+X towards +Y about +Z)."""
        unit, half = axis.normal(SMALL), math.radians(angle_deg) / 2
        sine = math.sin(half)
        return Vector(*rotate((unit.x * sine, unit.y * sine, unit.z * sine, math.cos(half)), self._triple()))

    @api
    def rotator_from_axis_and_angle(self, angle: float) -> Rotator:
        """Rotation by degrees about this axis."""
        unit, half = self.normal(SMALL), math.radians(angle) / 2
        sine = math.sin(half)
        return Quat(unit.x * sine, unit.y * sine, unit.z * sine, math.cos(half)).rotator()

    @api
    def find_quat_between_vectors(self, end: Vector) -> Quat:
        """Shortest rotation from this direction to another."""
        return Quat(*between(self._triple(), end._triple()))

    @api
    def find_quat_between_normals(self, end_normal: Vector) -> Quat:
        """Shortest rotation from this unit vector to another."""
        return self.find_quat_between_vectors(end_normal)

    @api
    def slerp_normals(self, normal_b: Vector, alpha: float) -> Vector:
        """A unit vector on the arc to another one."""
        return Vector(*rotate(slerp(UNTURNED, between(self._triple(), normal_b._triple()), alpha), self._triple()))

    @api
    def slerp_vectors(self, direction: Vector, alpha: float) -> Vector:
        """This vector turned part of the way towards a direction; its length stays."""
        return self.slerp_normals(direction, alpha)

    # mixes

    @api
    def lerp_to(self, b: Vector, alpha: float) -> Vector:
        """Linear mix."""
        return self._less(self._less(b, 1.0), alpha)

    @api
    def interp_to(self, target: Vector, delta_time: float, interp_speed: float) -> Vector:
        """A step towards a target that slows down as it comes near."""
        if interp_speed <= 0 or self.distance_squared(target) < 1e-4:
            return target
        return self.lerp_to(target, clamped(delta_time * interp_speed, 0.0, 1.0))

    @api
    def interp_to_constant(self, target: Vector, delta_time: float, interp_speed: float) -> Vector:
        """A step of constant speed towards a target."""
        away, step = self.distance(target), interp_speed * delta_time
        return target if away <= step else self.lerp_to(target, max(step, 0.0) / away)
