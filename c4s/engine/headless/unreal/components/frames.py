"""Where a component is: its pose relative to its parent, and in the world."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.pose import IDENTITY, Pose, compose, relative_to
from c4s.engine.headless.queries.changes import note
from c4s.engine.headless.unreal.components.base import ActorComponent
from c4s.engine.headless.unreal.core import Object, api
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector
from c4s.records.level import Vector as Row

Bounds = tuple[Row, Row]
DEEPEST = 100
"""Longest chain of attachment."""


def finite(pose: Pose, what: Object) -> Pose:
    """Refuse NaN and infinite transforms."""
    if not pose.is_finite():
        raise Exception(f"{what._name}: a transform must be finite numbers")
    return pose


class Frame(ActorComponent):
    """A pose below a parent's; relative in cm and degrees."""

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._relative = IDENTITY
        self._world: Pose | None = IDENTITY
        self._parent: Any = None
        self._children: list[Any] = []

    def _world_pose(self) -> Pose:
        if self._world is None:
            parent = self._parent
            self._world = self._relative if parent is None else compose(self._relative, parent._world_pose())
        return self._world

    def _stale(self) -> None:
        self._world = None
        if self._views:
            self._refresh_views()
        note(self._outer)
        for child in self._children:
            child._stale()

    def _set_relative(self, pose: Pose) -> None:
        self._relative = finite(pose, self)
        self._stale()
        self._changed("relative_transform")

    def _set_world(self, pose: Pose) -> None:
        finite(pose, self)
        self._set_relative(pose if self._parent is None else relative_to(pose, self._parent._world_pose()))
        self._world = pose

    def _height(self) -> int:
        """Length of the longest chain of components below this one."""
        level, height = self._children, 0
        while level:
            level, height = [child for each in level for child in each._children], height + 1
        return height

    def _attach(self, parent: Any) -> None:
        if self._parent is not None:
            self._parent._children.remove(self)
        self._parent = parent
        if parent is not None:
            parent._children.append(self)
        self._stale()

    def _get_relative_location(self) -> Vector:
        return Vector(*self._relative.location)

    def _set_relative_location(self, value: Vector) -> None:
        self._set_relative(self._relative.moved(value._triple()))

    def _get_relative_rotation(self) -> Rotator:
        return Rotator._of(self._relative.rotation_deg)

    def _set_relative_rotation(self, value: Rotator) -> None:
        self._set_relative(self._relative.turned(value._triple()))

    def _get_relative_scale(self) -> Vector:
        return Vector(*self._relative.scale)

    def _set_relative_scale(self, value: Vector) -> None:
        self._set_relative(self._relative.rescaled(value._triple()))

    def _local_bounds(self) -> Bounds | None:
        """Local AABB (cm) of what has an extent, or None."""
        return None

    @api
    def get_world_location(self) -> Vector:
        """World location in cm."""
        return Vector(*self._world_pose().location)

    @api
    def get_world_rotation(self) -> Rotator:
        """World rotation in degrees."""
        return Rotator._of(self._world_pose().rotation_deg)

    @api
    def get_world_scale(self) -> Vector:
        """World scale."""
        return Vector(*self._world_pose().scale)

    @api
    def get_world_transform(self) -> Transform:
        """World transform."""
        return Transform._of(self._world_pose())

    @api
    def get_relative_transform(self) -> Transform:
        """Transform relative to the parent."""
        return Transform._of(self._relative)

    @api
    def get_forward_vector(self) -> Vector:
        """World direction of +X."""
        return self.get_world_rotation().get_forward_vector()

    @api
    def get_right_vector(self) -> Vector:
        """World direction of +Y."""
        return self.get_world_rotation().get_right_vector()

    @api
    def get_up_vector(self) -> Vector:
        """World direction of +Z."""
        return self.get_world_rotation().get_up_vector()
