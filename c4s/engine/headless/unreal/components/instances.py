"""Meshes shown many times."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.pose import Pose, compose, relative_to
from c4s.engine.headless.unreal.components.frames import Bounds, finite
from c4s.engine.headless.unreal.components.meshes import StaticMeshComponent
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.structs import Transform, Vector


@public
class InstancedStaticMeshComponent(StaticMeshComponent):
    """Shows a static mesh many times."""

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._instances: list[Pose] = []

    def _local_bounds(self) -> Bounds | None:
        mesh = super()._local_bounds()
        if mesh is None or not self._instances:
            return None
        low, high = [float("inf")] * 3, [float("-inf")] * 3
        for pose in self._instances:
            origin, extent = pose.box(*mesh)
            low = [min(a, o - e) for a, o, e in zip(low, origin, extent, strict=True)]
            high = [max(a, o + e) for a, o, e in zip(high, origin, extent, strict=True)]
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])

    @api
    def get_local_bounds(self) -> tuple[Vector, Vector]:
        """Lower and upper corner of the mesh's local bounds (cm), instances left aside."""
        bounds = StaticMeshComponent._local_bounds(self)
        return (Vector(*bounds[0]), Vector(*bounds[1])) if bounds else (Vector(), Vector())

    @api
    def get_instance_count(self) -> int:
        """Number of instances."""
        return len(self._instances)

    @api
    def add_instance(self, instance_transform: Transform, world_space: bool = False) -> int:
        """Add an instance; returns its index."""
        pose = finite(instance_transform._pose(), self)
        self._instances.append(relative_to(pose, self._world_pose()) if world_space else pose)
        self._changed("instances")
        return len(self._instances) - 1

    @api
    def add_instances(self, instance_transforms: Sequence[Transform], should_return_indices: bool,
                      world_space: bool = False, update_navigation: bool = True) -> Array:
        """Add instances; returns their indices when asked."""
        indices = [self.add_instance(t, world_space) for t in instance_transforms]
        return Array._of("int", indices if should_return_indices else [])

    @api
    def get_instance_transform(self, instance_index: int, world_space: bool = False) -> Transform | None:
        """Transform of an instance, or None."""
        if not 0 <= instance_index < len(self._instances):
            return None
        pose = self._instances[instance_index]
        return Transform._of(compose(pose, self._world_pose()) if world_space else pose)

    @api
    def update_instance_transform(self, instance_index: int, new_instance_transform: Transform,
                                  world_space: bool = False, mark_render_state_dirty: bool = False,
                                  teleport: bool = False) -> bool:
        """Move an instance; False when there is none."""
        if not 0 <= instance_index < len(self._instances):
            return False
        pose = finite(new_instance_transform._pose(), self)
        self._instances[instance_index] = relative_to(pose, self._world_pose()) if world_space else pose
        self._changed("instances")
        return True

    @api
    def remove_instance(self, instance_index: int) -> bool:
        """Remove an instance; False when there is none."""
        if not 0 <= instance_index < len(self._instances):
            return False
        del self._instances[instance_index]
        self._changed("instances")
        return True

    @api
    def clear_instances(self) -> None:
        """Remove all instances."""
        self._instances.clear()
        self._changed("instances")


@public
class HierarchicalInstancedStaticMeshComponent(InstancedStaticMeshComponent):
    """An instanced mesh with levels of detail (there is one here)."""
