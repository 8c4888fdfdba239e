"""What an actor overlaps, by its components, and what a component has to do with other actors."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.components import PrimitiveComponent
from c4s.engine.headless.unreal.components.collision import CollisionState
from c4s.engine.headless.unreal.components.queries import overlapped
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, api, extends
from c4s.engine.headless.unreal.hits import casting


@extends(Actor)
class Noticing(Actor):
    """Overlaps that both sides notice: those that block each other are none, as in Unreal."""

    def _overlapped(self) -> list[Any]:
        own: list[Any] = self._components
        return list(
            dict.fromkeys(
                other for component in own if isinstance(component, CollisionState) for other in overlapped(component)
            )
        )

    @api
    def get_overlapping_components(self) -> Array:
        """Components that its own overlap."""
        return Array._of("PrimitiveComponent", self._overlapped())

    @api
    def get_overlapping_actors(self, class_filter: Class | type | None = None) -> Array:
        """Actors of a class that it overlaps."""
        found = dict.fromkeys(component._outer for component in self._overlapped())
        return Array._of("Actor", [actor for actor in found if casting.is_of(actor, class_filter)])

    @api
    def is_overlapping_actor(self, other: Actor) -> bool:
        """Whether it overlaps an actor."""
        return any(component._outer is other for component in self._overlapped())


@extends(PrimitiveComponent)
class NoticingActors(PrimitiveComponent):
    """Other actors that a component overlaps, or passes through."""

    @api
    def is_overlapping_actor(self, other: Actor) -> bool:
        """Whether it overlaps an actor, and both notice that."""
        return any(component._outer is other for component in overlapped(self))

    @api
    def ignore_actor_when_moving(self, actor: Actor | None, should_ignore: bool) -> None:
        """Let swept moves pass through an actor, or not any more."""
        self._ignore(actor, should_ignore)
