"""Where an actor is, and moving it. Moves give a ``HitResult``, as a component's do."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.components.moves import added, turned_by, turned_within
from c4s.engine.headless.unreal.core import Object, api
from c4s.engine.headless.unreal.hits.results import HitResult
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector


class Placed(Object):
    """The pose of an actor's root."""

    def _get_root(self) -> SceneComponent | None:
        components: list[Any] = self._components
        return components[0] if components and isinstance(components[0], SceneComponent) else None

    def _root(self) -> SceneComponent:
        root = self._get_root()
        if root is None:
            raise Exception(f"{self._name}: no root component")
        return root

    def _pose(self) -> Pose:
        return self._root()._world_pose()

    def _move(self, pose: Pose) -> None:
        self._root()._set_world(pose)

    @api
    def get_actor_location(self) -> Vector:
        """World location in cm."""
        return Vector(*self._pose().location)

    @api
    def get_actor_rotation(self) -> Rotator:
        """World rotation in degrees."""
        return Rotator._of(self._pose().rotation_deg)

    @api
    def get_actor_scale3d(self) -> Vector:
        """World scale."""
        return Vector(*self._pose().scale)

    @api
    def get_actor_relative_scale3d(self) -> Vector:
        """Scale relative to the parent."""
        return Vector(*self._root()._relative.scale)

    @api
    def get_actor_transform(self) -> Transform:
        """World transform."""
        return Transform._of(self._pose())

    @api
    def get_actor_forward_vector(self) -> Vector:
        """World direction of +X."""
        return self.get_actor_rotation().get_forward_vector()

    @api
    def get_actor_right_vector(self) -> Vector:
        """World direction of +Y."""
        return self.get_actor_rotation().get_right_vector()

    @api
    def get_actor_up_vector(self) -> Vector:
        """World direction of +Z."""
        return self.get_actor_rotation().get_up_vector()

    @api
    def get_actor_eyes_view_point(self) -> tuple[Vector, Rotator]:
        """Where it looks from."""
        return self.get_actor_location(), self.get_actor_rotation()

    @api
    def get_velocity(self) -> Vector:
        """Nothing moves by itself."""
        return Vector()

    @api
    def set_actor_location(self, new_location: Vector, sweep: bool, teleport: bool) -> HitResult | None:
        """Move."""
        return self._root()._go(self._pose().moved(new_location._triple()), sweep)

    @api
    def set_actor_rotation(self, new_rotation: Rotator, teleport_physics: bool) -> bool:
        """Turn."""
        self._move(self._pose().turned(new_rotation._triple()))
        return True

    @api
    def set_actor_scale3d(self, new_scale3d: Vector) -> None:
        """Scale."""
        self._move(self._pose().rescaled(new_scale3d._triple()))

    @api
    def set_actor_location_and_rotation(
        self, new_location: Vector, new_rotation: Rotator, sweep: bool, teleport: bool
    ) -> HitResult | None:
        """Move and turn."""
        return self._root()._go(self._pose().moved(new_location._triple()).turned(new_rotation._triple()), sweep)

    @api
    def set_actor_transform(self, new_transform: Transform, sweep: bool, teleport: bool) -> HitResult | None:
        """Place."""
        return self._root()._go(new_transform._pose(), sweep)

    @api
    def teleport(self, dest_location: Vector, dest_rotation: Rotator) -> bool:
        """Move and turn."""
        self._move(self._pose().moved(dest_location._triple()).turned(dest_rotation._triple()))
        return True

    @api
    def set_actor_relative_location(self, new_relative_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Place relative to the parent."""
        return self._root().set_relative_location(new_relative_location, sweep, teleport)

    @api
    def set_actor_relative_rotation(self, new_relative_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn relative to the parent."""
        return self._root().set_relative_rotation(new_relative_rotation, sweep, teleport)

    @api
    def set_actor_relative_scale3d(self, new_relative_scale: Vector) -> None:
        """Scale relative to the parent."""
        self._root().set_relative_scale3d(new_relative_scale)

    @api
    def set_actor_relative_transform(self, new_relative_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Place, turn and scale relative to the parent."""
        return self._root().set_relative_transform(new_relative_transform, sweep, teleport)

    @api
    def add_actor_world_offset(self, delta_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset."""
        return self._root().add_world_offset(delta_location, sweep, teleport)

    @api
    def add_actor_world_rotation(self, delta_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn by a rotation given in world axes."""
        return self._root()._go(turned_by(self._pose(), delta_rotation), sweep)

    @api
    def add_actor_world_transform(self, delta_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Move and turn in world axes; the scale becomes the given one."""
        return self._root().add_world_transform(delta_transform, sweep, teleport)

    @api
    def add_actor_world_transform_keep_scale(
        self, delta_transform: Transform, sweep: bool, teleport: bool
    ) -> HitResult:
        """Move and turn in world axes; the scale stays."""
        return self._root().add_world_transform_keep_scale(delta_transform, sweep, teleport)

    @api
    def add_actor_local_offset(self, delta_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset given in the actor's axes."""
        turned = delta_location.rotate(self.get_actor_rotation())
        return self._root()._go(self._pose().moved(added(self._pose().location, turned)), sweep)

    @api
    def add_actor_local_rotation(self, delta_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn by a rotation given in the actor's axes."""
        return self._root()._go(turned_within(self._pose(), delta_rotation), sweep)

    @api
    def add_actor_local_transform(self, new_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Move, turn and scale in the actor's axes."""
        return self._root()._go(compose(new_transform._pose(), self._pose()), sweep)
