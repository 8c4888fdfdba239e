"""Moving a component, in the world or relative to its parent.

Every move gives a ``HitResult``, as Unreal's does. It is empty for a component without a shape; those that have one are
swept on the way (``sweeping.py``).
"""

from __future__ import annotations

from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.unreal.components.frames import Frame
from c4s.engine.headless.unreal.core import api
from c4s.engine.headless.unreal.hits.results import HitResult
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector


def added(vector: tuple[float, float, float], delta: Vector) -> tuple[float, float, float]:
    """A place moved by an offset."""
    return (vector[0] + delta.x, vector[1] + delta.y, vector[2] + delta.z)


def turned_by(pose: Pose, delta: Rotator) -> Pose:
    """A pose turned in world axes."""
    return pose.turned(Rotator._of(pose.rotation_deg).combine(delta)._triple())


def turned_within(pose: Pose, delta: Rotator) -> Pose:
    """A pose turned in its own axes."""
    return pose.turned(delta.combine(Rotator._of(pose.rotation_deg))._triple())


class Moves(Frame):
    """Setters of the pose."""

    def _go(self, pose: Pose, sweep: bool) -> HitResult:
        """Move to a world pose."""
        self._set_world(pose)
        return HitResult()

    def _go_relative(self, pose: Pose, sweep: bool) -> HitResult:
        """Move to a pose relative to the parent."""
        self._set_relative(pose)
        return HitResult()

    @api
    def set_world_location(self, new_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Move in the world."""
        return self._go(self._world_pose().moved(new_location._triple()), sweep)

    @api
    def set_world_rotation(self, new_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn in the world."""
        return self._go(self._world_pose().turned(new_rotation._triple()), sweep)

    @api
    def set_world_location_and_rotation(
        self, new_location: Vector, new_rotation: Rotator, sweep: bool, teleport: bool
    ) -> HitResult:
        """Move and turn in the world."""
        return self._go(self._world_pose().moved(new_location._triple()).turned(new_rotation._triple()), sweep)

    @api
    def set_world_scale3d(self, new_scale: Vector) -> None:
        """Scale in the world."""
        self._set_world(self._world_pose().rescaled(new_scale._triple()))

    @api
    def set_world_transform(self, new_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Place in the world."""
        return self._go(new_transform._pose(), sweep)

    @api
    def add_world_offset(self, delta_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset in the world."""
        pose = self._world_pose()
        return self._go(pose.moved(added(pose.location, delta_location)), sweep)

    @api
    def add_world_rotation(self, delta_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn by a rotation in world axes."""
        return self._go(turned_by(self._world_pose(), delta_rotation), sweep)

    @api
    def add_world_transform(self, delta_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset and turn in world axes; the scale becomes the given one."""
        pose = turned_by(self._world_pose(), delta_transform.rotation.rotator())
        delta = delta_transform.translation
        return self._go(pose.moved(added(pose.location, delta)).rescaled(delta_transform.scale3d._triple()), sweep)

    @api
    def add_world_transform_keep_scale(self, delta_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset and turn in world axes; the scale stays."""
        pose = turned_by(self._world_pose(), delta_transform.rotation.rotator())
        return self._go(pose.moved(added(pose.location, delta_transform.translation)), sweep)

    @api
    def add_local_offset(self, delta_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset in the component's axes."""
        pose = self._relative
        return self._go_relative(
            pose.moved(added(pose.location, delta_location.rotate(Rotator._of(pose.rotation_deg)))), sweep
        )

    @api
    def add_local_rotation(self, delta_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn in the component's axes."""
        return self._go_relative(turned_within(self._relative, delta_rotation), sweep)

    @api
    def add_local_transform(self, delta_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Move, turn and scale in the component's axes."""
        return self._go_relative(compose(delta_transform._pose(), self._relative), sweep)

    @api
    def add_relative_location(self, delta_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Move by an offset in the parent's axes."""
        return self._go_relative(self._relative.moved(added(self._relative.location, delta_location)), sweep)

    @api
    def add_relative_rotation(self, delta_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn in the parent's axes."""
        return self._go_relative(turned_by(self._relative, delta_rotation), sweep)

    @api
    def set_relative_location(self, new_location: Vector, sweep: bool, teleport: bool) -> HitResult:
        """Place relative to the parent."""
        return self._go_relative(self._relative.moved(new_location._triple()), sweep)

    @api
    def set_relative_rotation(self, new_rotation: Rotator, sweep: bool, teleport: bool) -> HitResult:
        """Turn relative to the parent."""
        return self._go_relative(self._relative.turned(new_rotation._triple()), sweep)

    @api
    def set_relative_location_and_rotation(
        self, new_location: Vector, new_rotation: Rotator, sweep: bool, teleport: bool
    ) -> HitResult:
        """Place and turn relative to the parent."""
        return self._go_relative(self._relative.moved(new_location._triple()).turned(new_rotation._triple()), sweep)

    @api
    def set_relative_scale3d(self, new_scale3d: Vector) -> None:
        """Scale relative to the parent."""
        self._set_relative(self._relative.rescaled(new_scale3d._triple()))

    @api
    def set_relative_transform(self, new_transform: Transform, sweep: bool, teleport: bool) -> HitResult:
        """Place, turn and scale relative to the parent."""
        return self._go_relative(new_transform._pose(), sweep)

    @api
    def reset_relative_transform(self) -> None:
        """Take the parent's pose."""
        self._set_relative(Transform()._pose())
