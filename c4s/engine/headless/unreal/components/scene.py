"""Components with a transform."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import IDENTITY, Pose, Triple, relative_to
from c4s.engine.headless.unreal.components.frames import DEEPEST
from c4s.engine.headless.unreal.components.moves import Moves
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.enums import AttachmentRule, ComponentMobility, DetachmentRule
from c4s.engine.headless.unreal.structs import Rotator, Vector


@public
class SceneComponent(Moves):
    """A component with a transform; relative to its parent, in cm and degrees."""

    _declares = {
        "relative_location": Prop("Vector", get="_get_relative_location", set="_set_relative_location", saved=False),
        "relative_rotation": Prop("Rotator", get="_get_relative_rotation", set="_set_relative_rotation", saved=False),
        "relative_scale3d": Prop("Vector", get="_get_relative_scale", set="_set_relative_scale", saved=False),
        "mobility": Prop("ComponentMobility", ComponentMobility.STATIC),
        "visible": Prop("bool", True),
        "hidden_in_game": Prop("bool", False),
    }

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

    def _shows(self) -> bool:
        """Whether pictures show it, as long as its actor is shown."""
        return bool(self._values.get("visible", True)) and not self._values.get("hidden_in_game", False)

    @api
    def toggle_visibility(self, propagate_to_children: bool = False) -> None:
        """Show what is hidden, hide what is shown."""
        self.set_visibility(not self.get_editor_property("visible"), propagate_to_children)

    @api
    def set_hidden_in_game(self, new_hidden: bool, propagate_to_children: bool = False) -> None:
        """Hide in the game."""
        self.set_editor_property("hidden_in_game", new_hidden)
        if propagate_to_children:
            for child in self._children:
                child.set_hidden_in_game(new_hidden, True)

    @api
    def get_children_components(self, include_all_descendants: bool) -> Array:
        """Attached components."""
        found: list[Any] = []
        for child in self._children:
            found += [child, *(child.get_children_components(True) if include_all_descendants else [])]
        return Array._of("SceneComponent", found)

    @api
    def get_parent_components(self) -> Array:
        """The components that this one is attached to, nearest first."""
        found: list[Any] = []
        above = self._parent
        while above is not None:
            found.append(above)
            above = above._parent
        return Array._of("SceneComponent", found)

    @api
    def get_attach_socket_name(self) -> Name:
        """Sockets do not exist here."""
        return Name()

    @api
    def does_socket_exist(self, socket_name: Name | str) -> bool:
        """Sockets do not exist here."""
        return False

    @api
    def get_all_socket_names(self) -> Array:
        """Sockets do not exist here."""
        return Array._of("Name", [])

    @api
    def get_socket_location(self, socket_name: Name | str) -> Vector:
        """Place of a socket: the component's own, as for any unknown socket."""
        return self.get_world_location()

    @api
    def get_socket_rotation(self, socket_name: Name | str) -> Rotator:
        """Rotation of a socket: the component's own, as for any unknown socket."""
        return self.get_world_rotation()

    @api
    def get_component_velocity(self) -> Vector:
        """Nothing moves by itself."""
        return Vector()

    @api
    def is_simulating_physics(self, bone_name: Name | str = "None") -> bool:
        """There are no dynamics."""
        return False

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
        found: SceneComponent | None = self._children[child_index] if 0 <= child_index < len(self._children) else None
        return found

    @api
    def attach_to_component(
        self,
        parent: SceneComponent,
        socket_name: Name | str,
        location_rule: AttachmentRule,
        rotation_rule: AttachmentRule,
        scale_rule: AttachmentRule,
        weld_simulated_bodies: bool = True,
    ) -> bool:
        """Attach; False when that would close a circle, or make a chain longer than ``DEEPEST``."""
        if not _lasts(parent) and _lasts(self):
            world().log.error(
                f"AttachTo: '{parent._path()}' is in no level, so nothing in the level can be attached to it"
            )
            return False
        above: SceneComponent | None = parent
        length = self._height()
        while above is not None:
            if above is self:
                return False
            above, length = above._parent, length + 1
        if length > DEEPEST:
            world().log.error(f"AttachTo: '{self._path()}' would be attached more than {DEEPEST} deep")
            return False
        place, base = self._world_pose(), parent._world_pose()
        kept = relative_to(place, base)
        rules: list[tuple[AttachmentRule, Callable[[Pose], Triple]]] = [
            (location_rule, lambda p: p.location),
            (rotation_rule, lambda p: p.rotation_deg),
            (scale_rule, lambda p: p.scale),
        ]
        source = {
            AttachmentRule.KEEP_WORLD: kept,
            AttachmentRule.KEEP_RELATIVE: self._relative,
            AttachmentRule.SNAP_TO_TARGET: IDENTITY,
        }
        location, rotation, scale = (part(source[rule]) for rule, part in rules)
        self._attach(parent)
        self._set_relative(Pose.from_rotator(location, rotation, scale))
        if all(rule is AttachmentRule.KEEP_WORLD for rule, _ in rules):
            self._relative = kept
            self._world = place
        return True

    @api
    def detach_from_component(
        self,
        location_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
        rotation_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
        scale_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
        call_modify: bool = True,
    ) -> None:
        """Detach from the parent."""
        keep = DetachmentRule.KEEP_WORLD
        world, own = self._world_pose(), self._relative
        self._attach(None)
        self._set_relative(
            Pose.from_rotator(
                world.location if location_rule is keep else own.location,
                world.rotation_deg if rotation_rule is keep else own.rotation_deg,
                world.scale if scale_rule is keep else own.scale,
            )
        )


def _lasts(component: SceneComponent) -> bool:
    """Whether a component is part of an actor that is in a level, and is saved with it."""
    owner: Any = component._outer
    return owner is not None and owner._outer is not None and component in owner._components
