"""An actor as seen from another."""

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.core import api, extends
from c4s.engine.headless.unreal.structs import Vector


@extends(Actor)
class Distances(Actor):
    """Distances and directions between actors."""

    def _offset(self, other: Actor) -> Vector:
        return other.get_actor_location() - self.get_actor_location()  # type: ignore[no-any-return]

    @api
    def get_distance_to(self, other_actor: Actor) -> float:
        """Distance between origins in cm."""
        return self._offset(other_actor).length()

    @api
    def get_squared_distance_to(self, other_actor: Actor) -> float:
        """Squared distance between origins."""
        return self._offset(other_actor).length_squared()

    @api
    def get_horizontal_distance_to(self, other_actor: Actor) -> float:
        """Horizontal distance between origins in cm."""
        return self._offset(other_actor).length2d()

    @api
    def get_squared_horizontal_distance_to(self, other_actor: Actor) -> float:
        """Squared horizontal distance between origins."""
        return self._offset(other_actor).length2d_squared()

    @api
    def get_vertical_distance_to(self, other_actor: Actor) -> float:
        """Difference of heights in cm."""
        return abs(self._offset(other_actor).z)

    @api
    def get_dot_product_to(self, other_actor: Actor) -> float:
        """Cosine of the angle between +X and the direction to another actor; -2 without one."""
        away = self._offset(other_actor).normal(1e-8)
        return self.get_actor_forward_vector().dot(away) if not away.is_zero() else -2.0

    @api
    def get_horizontal_dot_product_to(self, other_actor: Actor) -> float:
        """Cosine of the horizontal angle between +X and the direction to another actor; -2 without one."""
        away = self._offset(other_actor).normal2d(1e-8)
        return self.get_actor_forward_vector().normal2d(1e-8).dot(away) if not away.is_zero() else -2.0
