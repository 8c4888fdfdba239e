"""Meshes shown many times."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.pose import Pose, compose, relative_to
from c4s.engine.headless.unreal.components.frames import Bounds, finite
from c4s.engine.headless.unreal.components.meshes import StaticMeshComponent
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Object, Prop, api, public
from c4s.engine.headless.unreal.structs import Box, Transform, Vector


@public
class InstancedStaticMeshComponent(StaticMeshComponent):
    """Shows a static mesh many times."""

    _declares = {
        "instance_start_cull_distance": Prop("int", 0),
        "instance_end_cull_distance": Prop("int", 0),
        "instancing_random_seed": Prop("int", 0),
    }

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
    def add_instances(
        self,
        instance_transforms: Sequence[Transform],
        should_return_indices: bool,
        world_space: bool = False,
        update_navigation: bool = True,
    ) -> Array:
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
    def update_instance_transform(
        self,
        instance_index: int,
        new_instance_transform: Transform,
        world_space: bool = False,
        mark_render_state_dirty: bool = False,
        teleport: bool = False,
    ) -> bool:
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
    def remove_instances(self, instances_to_remove: Sequence[int]) -> bool:
        """Remove instances; False, and none is removed, when one does not exist."""
        gone = set(instances_to_remove)
        if not all(0 <= i < len(self._instances) for i in gone):
            return False
        self._instances = [pose for i, pose in enumerate(self._instances) if i not in gone]
        self._changed("instances")
        return True

    @api
    def add_instance_world_space(self, world_transform: Transform) -> int:
        """Add an instance placed in the world."""
        return self.add_instance(world_transform, True)

    @api
    def batch_update_instances_transforms(
        self,
        start_instance_index: int,
        new_instances_transforms: Sequence[Transform],
        world_space: bool = False,
        mark_render_state_dirty: bool = False,
        teleport: bool = False,
    ) -> bool:
        """Move instances from an index on; False, and none is moved, when one does not exist."""
        if not 0 <= start_instance_index <= len(self._instances) - len(new_instances_transforms):
            return False
        return all(
            self.update_instance_transform(start_instance_index + i, t, world_space)
            for i, t in enumerate(new_instances_transforms)
        )

    @api
    def batch_update_instances_transform(
        self,
        start_instance_index: int,
        num_instances: int,
        new_instances_transform: Transform,
        world_space: bool = False,
        mark_render_state_dirty: bool = False,
        teleport: bool = False,
    ) -> bool:
        """Move instances from an index on to one place."""
        return self.batch_update_instances_transforms(
            start_instance_index, [new_instances_transform] * num_instances, world_space
        )

    @api
    def is_valid_instance(self, instance_index: int) -> bool:
        """Whether an instance exists."""
        return 0 <= instance_index < len(self._instances)

    def _inside(self, low: Vector, high: Vector, in_world: bool) -> list[int]:
        mesh = StaticMeshComponent._local_bounds(self)
        found = []
        for index, pose in enumerate(self._instances if mesh is not None else []):
            origin, extent = (compose(pose, self._world_pose()) if in_world else pose).box(*mesh)  # type: ignore[misc]
            if all(
                o - e <= b and o + e >= a
                for o, e, a, b in zip(origin, extent, low._triple(), high._triple(), strict=True)
            ):
                found.append(index)
        return found

    @api
    def get_instances_overlapping_box(self, box: Box, box_in_world_space: bool = True) -> Array:
        """Indices of the instances whose bounds touch a box."""
        return Array._of("int", self._inside(box.min, box.max, box_in_world_space))

    @api
    def get_instances_overlapping_sphere(
        self, center: Vector, radius: float, sphere_in_world_space: bool = True
    ) -> Array:
        """Indices of the instances whose bounds touch the box around a sphere."""
        half = Vector(radius, radius, radius)
        return Array._of("int", self._inside(center - half, center + half, sphere_in_world_space))

    @api
    def set_cull_distances(self, start_cull_distance: int, end_cull_distance: int) -> None:
        """Set where instances fade out (cm from the camera); pictures here show all of them."""
        self.set_editor_property("instance_start_cull_distance", start_cull_distance)
        self.set_editor_property("instance_end_cull_distance", end_cull_distance)

    @api
    def get_cull_distances(self) -> tuple[int, int]:
        """Where instances fade out (cm from the camera)."""
        return (
            self.get_editor_property("instance_start_cull_distance"),
            self.get_editor_property("instance_end_cull_distance"),
        )

    @api
    def clear_instances(self) -> None:
        """Remove all instances."""
        self._instances.clear()
        self._changed("instances")


@public
class HierarchicalInstancedStaticMeshComponent(InstancedStaticMeshComponent):
    """An instanced mesh with levels of detail (there is one here)."""
