"""Attaching actors to each other."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import api, extends
from c4s.engine.headless.unreal.enums import AttachmentRule, DetachmentRule


@extends(Actor)
class Attachment(Actor):
    """The actors above and below in the hierarchy."""

    @api
    def attach_to_actor(
        self,
        parent_actor: Actor,
        socket_name: Name | str,
        location_rule: AttachmentRule,
        rotation_rule: AttachmentRule,
        scale_rule: AttachmentRule,
        weld_simulated_bodies: bool = True,
    ) -> bool:
        """Attach to another actor's root."""
        return self._root().attach_to_component(
            parent_actor._root(), socket_name, location_rule, rotation_rule, scale_rule, weld_simulated_bodies
        )

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
        """Attach to a component."""
        return self._root().attach_to_component(
            parent, socket_name, location_rule, rotation_rule, scale_rule, weld_simulated_bodies
        )

    @api
    def get_attach_parent_socket_name(self) -> Name:
        """Sockets do not exist here."""
        return Name()

    @api
    def detach_from_actor(
        self,
        location_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
        rotation_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
        scale_rule: DetachmentRule = DetachmentRule.KEEP_RELATIVE,
    ) -> None:
        """Detach."""
        self._root().detach_from_component(location_rule, rotation_rule, scale_rule)

    @api
    def get_attach_parent_actor(self) -> Actor | None:
        """The actor that this one is attached to."""
        parent = self._root()._parent
        owner: Any = parent._outer if parent is not None else None
        return owner  # type: ignore[no-any-return]

    @api
    def get_attached_actors(self, reset_array: bool = True, recursively_include_attached_actors: bool = False) -> Array:
        """Actors attached to this one."""
        found: list[Any] = []
        for component in self._components:
            for child in component._children if isinstance(component, SceneComponent) else []:
                owner: Any = child._outer
                if owner is not self and owner not in found:
                    found.append(owner)
                    if recursively_include_attached_actors:
                        found += [a for a in owner.get_attached_actors(True, True) if a not in found]
        return Array._of("Actor", found)

    @api
    def get_parent_actor(self) -> Actor | None:
        """The actor whose child-actor component made this one (none here)."""
        return None

    @api
    def get_all_child_actors(self, include_descendants: bool = True) -> Array:
        """Actors made by child-actor components (none here)."""
        return Array._of("Actor", [])

    @api
    def is_child_actor(self) -> bool:
        """Whether a child-actor component made this one (never here)."""
        return False

    @api
    def set_owner(self, new_owner: Actor | None) -> None:
        """Owners count in play only."""

    @api
    def get_owner(self) -> Actor | None:
        """The owner (none here)."""
        return None
