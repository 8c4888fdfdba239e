"""Components: the scene hierarchy, meshes and instanced meshes."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from c4s.engine.headless.pose import IDENTITY, Pose, Triple, compose, relative_to
from c4s.engine.headless.unreal.assets import MaterialInstanceDynamic, MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, Prop, api, public, subclass_of
from c4s.engine.headless.unreal.enums import AttachmentRule, CollisionEnabled, ComponentMobility, DetachmentRule
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector
from c4s.scene.level import Vector as Row

Bounds = tuple[Row, Row]


def finite(pose: Pose, what: Object) -> Pose:
    """Refuse NaN and infinite transforms."""
    if not pose.is_finite():
        raise Exception(f"{what._name}: a transform must be finite numbers")
    return pose


@public
class ActorComponent(Object):
    """Base of components."""

    _declares = {"component_tags": Prop("Sequence[Name]", lambda: Array._of("Name", [])),
                 "is_editor_only": Prop("bool", False)}

    @classmethod
    def _abstract(cls) -> bool:
        return True

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._by_script = False

    @api
    def get_owner(self) -> Any:
        """The actor."""
        return self._outer

    @api
    def component_has_tag(self, tag: Name | str) -> bool:
        """Whether a component tag is set."""
        return Name(str(tag)) in self.get_editor_property("component_tags")

    def _changed(self, name: str) -> None:
        owner = self._outer
        if owner is not None:
            owner._changed(name)

    @api
    def destroy_component(self, object: Object | None) -> None:
        """Remove this component from its actor."""
        owner = self._outer
        if owner is not None:
            owner._drop(self)


@public
class SceneComponent(ActorComponent):
    """A component with a transform; relative to its parent, in cm and degrees."""

    _declares = {
        "relative_location": Prop("Vector", get="_get_relative_location", set="_set_relative_location", saved=False),
        "relative_rotation": Prop("Rotator", get="_get_relative_rotation", set="_set_relative_rotation", saved=False),
        "relative_scale3d": Prop("Vector", get="_get_relative_scale", set="_set_relative_scale", saved=False),
        "mobility": Prop("ComponentMobility", ComponentMobility.STATIC),
        "visible": Prop("bool", True), "hidden_in_game": Prop("bool", False),
    }

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._relative = IDENTITY
        self._world: Pose | None = IDENTITY
        self._parent: SceneComponent | None = None
        self._children: list[SceneComponent] = []

    def _world_pose(self) -> Pose:
        if self._world is None:
            parent = self._parent
            self._world = self._relative if parent is None else compose(self._relative, parent._world_pose())
        return self._world

    def _stale(self) -> None:
        self._world = None
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

    def _attach(self, parent: SceneComponent | None) -> None:
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

    @api
    def set_world_location(self, new_location: Vector, sweep: bool, teleport: bool) -> None:
        """Move in the world (nothing is swept here: no hit is returned)."""
        self._set_world(self._world_pose().moved(new_location._triple()))

    @api
    def set_world_rotation(self, new_rotation: Rotator, sweep: bool, teleport: bool) -> None:
        """Turn in the world."""
        self._set_world(self._world_pose().turned(new_rotation._triple()))

    @api
    def set_world_location_and_rotation(self, new_location: Vector, new_rotation: Rotator, sweep: bool,
                                        teleport: bool) -> None:
        """Move and turn in the world."""
        self._set_world(self._world_pose().moved(new_location._triple()).turned(new_rotation._triple()))

    @api
    def set_world_scale3d(self, new_scale: Vector) -> None:
        """Scale in the world."""
        self._set_world(self._world_pose().rescaled(new_scale._triple()))

    @api
    def set_world_transform(self, new_transform: Transform, sweep: bool, teleport: bool) -> None:
        """Place in the world."""
        self._set_world(new_transform._pose())

    @api
    def add_world_offset(self, delta_location: Vector, sweep: bool, teleport: bool) -> None:
        """Move by an offset in the world."""
        self._set_world(self._world_pose().moved(
            (Vector(*self._world_pose().location) + delta_location)._triple()))

    @api
    def set_relative_location(self, new_location: Vector, sweep: bool, teleport: bool) -> None:
        """Place relative to the parent."""
        self._set_relative_location(new_location)

    @api
    def set_relative_rotation(self, new_rotation: Rotator, sweep: bool, teleport: bool) -> None:
        """Turn relative to the parent."""
        self._set_relative_rotation(new_rotation)

    @api
    def set_relative_scale3d(self, new_scale3d: Vector) -> None:
        """Scale relative to the parent."""
        self._set_relative_scale(new_scale3d)

    @api
    def set_relative_transform(self, new_transform: Transform, sweep: bool, teleport: bool) -> None:
        """Place, turn and scale relative to the parent."""
        self._set_relative(new_transform._pose())

    @api
    def set_mobility(self, new_mobility: ComponentMobility) -> None:
        """Set whether it may move in play."""
        self.set_editor_property("mobility", new_mobility)

    @api
    def set_visibility(self, new_visibility: bool, propagate_to_children: bool = False) -> None:
        """Show or hide."""
        self.set_editor_property("visible", new_visibility)
        if propagate_to_children:
            for child in self._children:
                child.set_visibility(new_visibility, True)

    @api
    def is_visible(self) -> bool:
        """Whether it is shown."""
        return bool(self.get_editor_property("visible"))

    @api
    def set_hidden_in_game(self, new_hidden: bool, propagate_to_children: bool = False) -> None:
        """Hide in the game."""
        self.set_editor_property("hidden_in_game", new_hidden)

    @api
    def get_attach_parent(self) -> SceneComponent | None:
        """The component that this one is attached to."""
        parent: SceneComponent | None = self._parent
        return parent

    @api
    def get_num_children_components(self) -> int:
        """Number of attached components."""
        return len(self._children)

    @api
    def get_child_component(self, child_index: int) -> SceneComponent | None:
        """An attached component."""
        found: SceneComponent | None = (
            self._children[child_index] if 0 <= child_index < len(self._children) else None)
        return found

    @api
    def attach_to_component(self, parent: SceneComponent, socket_name: Name | str, location_rule: AttachmentRule,
                            rotation_rule: AttachmentRule, scale_rule: AttachmentRule,
                            weld_simulated_bodies: bool = True) -> bool:
        """Attach; False when that would close a circle."""
        above: SceneComponent | None = parent
        while above is not None:
            if above is self:
                return False
            above = above._parent
        world, base = self._world_pose(), parent._world_pose()
        kept = relative_to(world, base)
        rules: list[tuple[AttachmentRule, Callable[[Pose], Triple]]] = [
            (location_rule, lambda p: p.location), (rotation_rule, lambda p: p.rotation_deg),
            (scale_rule, lambda p: p.scale)]
        source = {AttachmentRule.KEEP_WORLD: kept, AttachmentRule.KEEP_RELATIVE: self._relative,
                  AttachmentRule.SNAP_TO_TARGET: IDENTITY}
        location, rotation, scale = (part(source[rule]) for rule, part in rules)
        self._attach(parent)
        self._set_relative(Pose.from_rotator(location, rotation, scale))
        if all(rule is AttachmentRule.KEEP_WORLD for rule, _ in rules):
            self._relative = kept
            self._world = world
        return True

    @api
    def detach_from_component(self, location_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
                              rotation_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
                              scale_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
                              call_modify: bool = True) -> None:
        """Detach from the parent."""
        keep = DetachmentRule.KEEP_WORLD
        world, own = self._world_pose(), self._relative
        self._attach(None)
        self._set_relative(Pose.from_rotator(
            world.location if location_rule is keep else own.location,
            world.rotation_deg if rotation_rule is keep else own.rotation_deg,
            world.scale if scale_rule is keep else own.scale))


@public
class PrimitiveComponent(SceneComponent):
    """A component with geometry: bounds, collision and materials."""

    _declares = {"cast_shadow": Prop("bool", True), "hidden_in_scene_capture": Prop("bool", False),
                 "collision_enabled": Prop("CollisionEnabled", CollisionEnabled.QUERY_AND_PHYSICS, attribute=False,
                                           scripts=False),
                 "collision_profile_name": Prop("Name", Name("BlockAllDynamic"), attribute=False, scripts=False)}

    def _own(self, name: str) -> Any:
        """Value of a property that scripts reach by methods only."""
        return self._read(name, type(self)._properties[name])

    def _put(self, name: str, value: Any) -> None:
        """Set a property that scripts reach by methods only."""
        self._write(name, type(self)._properties[name], value)

    def _collides(self) -> bool:
        owner = self._outer
        if owner is not None and not owner._values.get("actor_enable_collision", True):
            return False
        return bool(self._own("collision_enabled") is not CollisionEnabled.NO_COLLISION)

    @api
    def get_collision_enabled(self) -> CollisionEnabled:
        """What the collision takes part in."""
        found: CollisionEnabled = self._own("collision_enabled")
        return found if self._collides() else CollisionEnabled.NO_COLLISION

    @api
    def set_collision_enabled(self, new_type: CollisionEnabled) -> None:
        """Set what the collision takes part in."""
        self._put("collision_enabled", new_type)

    @api
    def is_collision_enabled(self) -> bool:
        """Whether there is any collision."""
        return self._collides()

    @api
    def get_collision_profile_name(self) -> Name:
        """Name of the collision profile."""
        found: Name = self._own("collision_profile_name")
        return found

    @api
    def set_collision_profile_name(self, collision_profile_name: Name | str, update_overlaps: bool = True) -> None:
        """Set the profile; ``NoCollision`` switches collision off."""
        self._put("collision_profile_name", collision_profile_name)
        off = Name(str(collision_profile_name)) == "NoCollision"
        self._put("collision_enabled", CollisionEnabled.NO_COLLISION if off
                                 else CollisionEnabled.QUERY_AND_PHYSICS)

    @api
    def set_simulate_physics(self, simulate: bool) -> None:
        """Refused: the headless engine has no dynamics."""
        raise Exception("set_simulate_physics: the headless engine has no dynamics")

    @api
    def set_cast_shadow(self, new_cast_shadow: bool) -> None:
        """Set whether it casts a shadow."""
        self.set_editor_property("cast_shadow", new_cast_shadow)


@public
class MeshComponent(PrimitiveComponent):
    """A component with material slots."""

    _declares = {"override_materials": Prop("Sequence[MaterialInterface | None]", get="_override_array",
                                            writable=False, attribute=False, saved=False)}

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._materials: dict[int, MaterialInterface] = {}

    def _slot_count(self) -> int:
        return 0

    def _default_material(self, index: int) -> MaterialInterface | None:
        return None

    def _material(self, index: int) -> MaterialInterface | None:
        override = self._materials.get(index)
        if override is not None and not override._dead:
            return override
        return self._default_material(index) if 0 <= index < self._slot_count() else None

    def _override_array(self) -> Array:
        size = max(self._materials, default=-1) + 1
        return Array._of("MaterialInterface | None", [self._materials.get(i) for i in range(size)])

    @api
    def get_num_materials(self) -> int:
        """Number of slots."""
        return self._slot_count()

    @api
    def get_material(self, element_index: int) -> MaterialInterface | None:
        """Override or the mesh's default."""
        return self._material(element_index)

    @api
    def get_materials(self) -> Array:
        """Material of each slot."""
        return Array._of("MaterialInterface | None", [self._material(i) for i in range(self._slot_count())])

    @api
    def set_material(self, element_index: int, material: MaterialInterface | None) -> None:
        """Override the material of a slot; None takes the override away."""
        if element_index < 0:
            return
        if material is None:
            self._materials.pop(element_index, None)
        else:
            self._materials[element_index] = material
        self._changed("override_materials")

    @api
    def get_material_index(self, material_slot_name: Name | str) -> int:
        """Index of a slot by name, -1 when there is none."""
        names = [str(n).casefold() for n in self.get_material_slot_names()]
        wanted = str(material_slot_name).casefold()
        return names.index(wanted) if wanted in names else -1

    @api
    def get_material_slot_names(self) -> Array:
        """Names of the slots."""
        return Array._of("Name", [])

    @api
    def set_material_by_name(self, material_slot_name: Name | str, material: MaterialInterface | None) -> None:
        """Override the material of a slot by its name."""
        index = self.get_material_index(material_slot_name)
        if index >= 0:
            self.set_material(index, material)

    @api
    def create_dynamic_material_instance(self, element_index: int, source_material: MaterialInterface | None = None,
                                         optional_name: Name | str = "None") -> MaterialInstanceDynamic | None:
        """Put a dynamic instance, owned by this component, on a slot."""
        source = source_material if source_material is not None else self._material(element_index)
        if source is None:
            return None
        taken = {m._name for m in self._materials.values()}
        serial = 0
        while f"MaterialInstanceDynamic_{serial}" in taken:
            serial += 1
        name = f"MaterialInstanceDynamic_{serial}" if str(optional_name) == "None" else str(optional_name)
        made: MaterialInstanceDynamic = MaterialInstanceDynamic._owned(name, self, source)
        self.set_material(element_index, made)
        return made

    @api
    def create_and_set_material_instance_dynamic(self, element_index: int) -> MaterialInstanceDynamic | None:
        """Put a dynamic instance of the slot's material on it."""
        return self.create_dynamic_material_instance(element_index)


@public
class StaticMeshComponent(MeshComponent):
    """Shows a static mesh."""

    _declares = {"static_mesh": Prop("StaticMesh | None", get="_get_mesh", set="_set_mesh", saved=False)}

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._mesh: StaticMesh | None = None

    def _get_mesh(self) -> StaticMesh | None:
        mesh: StaticMesh | None = self._mesh
        return mesh

    def _set_mesh(self, value: StaticMesh | None) -> None:
        self._mesh = value

    def _slot_count(self) -> int:
        return len(self._mesh._asset.slots) if self._mesh is not None else 0

    def _default_material(self, index: int) -> MaterialInterface | None:
        found: MaterialInterface | None = self._mesh._slot_material(index) if self._mesh is not None else None
        return found

    def _local_bounds(self) -> Bounds | None:
        if self._mesh is None:
            return None
        return self._mesh._asset.bounds_min_cm, self._mesh._asset.bounds_max_cm

    @api
    def set_static_mesh(self, new_mesh: StaticMesh | None) -> bool:
        """Show another mesh; False when it is shown already."""
        if new_mesh is self._mesh:
            return False
        self._mesh = new_mesh
        self._changed("static_mesh")
        return True

    @api
    def get_material_slot_names(self) -> Array:
        """Names of the slots."""
        slots = self._mesh._asset.slots if self._mesh is not None else []
        return Array._of("Name", [Name(slot.name) for slot in slots])

    @api
    def get_local_bounds(self) -> tuple[Vector, Vector]:
        """Lower and upper corner of the local bounds (cm)."""
        bounds = self._local_bounds()
        return (Vector(*bounds[0]), Vector(*bounds[1])) if bounds else (Vector(), Vector())


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


def of_class(components: list[Any], wanted: Class | type) -> list[Any]:
    """Those components that are of a class."""
    return [c for c in components if subclass_of(type(c), _python_type(wanted))]


def _python_type(wanted: Class | type) -> type[Object]:
    found: type[Object] = wanted._python_type if isinstance(wanted, Class) else wanted
    return found
