"""What an actor overlaps, by its components."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, api
from c4s.engine.headless.unreal.traces import casting
from c4s.engine.headless.unreal.traces.own import overlapped
from c4s.engine.headless.unreal.traces.state import CollisionState

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.actors import Actor


class Noticing(Object):
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
