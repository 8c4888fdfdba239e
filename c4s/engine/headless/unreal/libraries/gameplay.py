"""Searches in the level."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, api, as_class, public
from c4s.engine.headless.unreal.structs import Vector


@public
class GameplayStatics(Object):
    """Searches in the level."""

    @classmethod
    @api
    def get_all_actors_of_class(cls, world_context_object: Object | None, actor_class: Class | type) -> Array:
        """Actors of a class."""
        wanted = as_class(actor_class)
        found = [
            a
            for a in world().actor_list()
            if (a._class() is wanted if wanted._blueprint else isinstance(a, wanted._python_type))
        ]
        return Array._of("Actor", found)

    @classmethod
    @api
    def get_actor_of_class(cls, world_context_object: Object | None, actor_class: Class | type) -> Actor | None:
        """The first actor of a class, or None."""
        found = cls.get_all_actors_of_class(world_context_object, actor_class)
        return found[0] if len(found) else None

    @classmethod
    @api
    def get_all_actors_with_tag(cls, world_context_object: Object | None, tag: Name | str) -> Array:
        """Actors with a tag."""
        return Array._of("Actor", [a for a in world().actor_list() if a.actor_has_tag(tag)])

    @classmethod
    @api
    def get_all_actors_of_class_with_tag(
        cls, world_context_object: Object | None, actor_class: Class | type, tag: Name | str
    ) -> Array:
        """Actors of a class with a tag."""
        found = cls.get_all_actors_of_class(world_context_object, actor_class)
        return Array._of("Actor", [a for a in found if a.actor_has_tag(tag)])

    @classmethod
    @api
    def find_nearest_actor(cls, origin: Vector, actors_to_check: Sequence[Actor]) -> tuple[Actor | None, float]:
        """The actor nearest to a place, and its distance in cm; None and 0 for none."""
        ranked = sorted(actors_to_check, key=lambda a: a.get_actor_location().distance(origin))
        return (ranked[0], ranked[0].get_actor_location().distance(origin)) if ranked else (None, 0.0)

    @classmethod
    @api
    def get_actor_array_average_location(cls, actors: Sequence[Actor]) -> Vector:
        """Mean of the places of actors; the origin for none."""
        places = [a.get_actor_location() for a in actors]
        return sum(places[1:], places[0]) / len(places) if places else Vector()

    @classmethod
    @api
    def get_actor_array_bounds(cls, actors: Sequence[Actor], only_colliding_components: bool) -> tuple[Vector, Vector]:
        """World AABB of actors: centre and half extent in cm."""
        boxes = [a.get_actor_bounds(only_colliding_components) for a in actors]
        if not boxes:
            return Vector(), Vector()
        low, high = boxes[0][0] - boxes[0][1], boxes[0][0] + boxes[0][1]
        for origin, extent in boxes[1:]:
            low, high = low.get_min(origin - extent), high.get_max(origin + extent)
        return (low + high) * 0.5, (high - low) * 0.5

    @classmethod
    @api
    def get_object_class(cls, object: Object) -> Class | None:
        """Class of an object."""
        return object.get_class()

    @classmethod
    @api
    def object_is_a(cls, object: Object, object_class: Class | type) -> bool:
        """Whether an object is of a class."""
        return isinstance(object, as_class(object_class)._python_type)

    @classmethod
    @api
    def get_current_level_name(cls, world_context_object: Object | None, remove_prefix_string: bool = True) -> str:
        """Name of the open level."""
        return world().package.rsplit("/", 1)[-1]

    @classmethod
    @api
    def get_platform_name(cls) -> str:
        """Name of the platform."""
        return "Linux"
