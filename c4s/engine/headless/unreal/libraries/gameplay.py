"""Searches in the level."""

from __future__ import annotations

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, api, as_class, public


@public
class GameplayStatics(Object):
    """Searches in the level."""

    @classmethod
    @api
    def get_all_actors_of_class(cls, world_context_object: Object | None, actor_class: Class | type) -> Array:
        """Actors of a class."""
        wanted = as_class(actor_class)
        found = [a for a in world().actor_list()
                 if (a._class() is wanted if wanted._blueprint else isinstance(a, wanted._python_type))]
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
