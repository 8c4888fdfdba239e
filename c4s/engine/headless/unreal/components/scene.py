"""Components with a transform."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Callable

from c4s.engine.headless.pose import IDENTITY, Pose, Triple, compose, relative_to
from c4s.engine.headless.queries.changes import note
from c4s.engine.headless.unreal.components.base import ActorComponent
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Object, Prop, api, public
from c4s.engine.headless.unreal.enums import AttachmentRule, ComponentMobility, DetachmentRule
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector
from c4s.scene.level import Vector as Row

Bounds = tuple[Row, Row]


def finite(pose: Pose, what: Object) -> Pose:
    """Refuse NaN and infinite transforms."""
    if not pose.is_finite():
        raise Exception(f"{what._name}: a transform must be finite numbers")
    return pose


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
