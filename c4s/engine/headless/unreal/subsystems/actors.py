"""Actors of the open level."""

# ruff: noqa: B008  (signatures as in Unreal; no default is ever changed)

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, api, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem
from c4s.engine.headless.unreal.subsystems.replacing import convert
from c4s.engine.headless.unreal.subsystems.spawning import actors, choose, chosen, spawn_from_class, spawn_from_object


@public
class EditorActorSubsystem(EditorSubsystem):
    """Actors of the open level."""

    _class_module = "UnrealEd"

    @api
    def get_all_level_actors(self) -> Array:
        """All actors."""
        return actors()

    @api
    def get_all_level_actors_components(self) -> Array:
        """All components of all actors."""
        return Array._of("ActorComponent", [c for a in world().actor_list() for c in a._components])

    @api
    def spawn_actor_from_class(
        self, actor_class: Class | type, location: Vector, rotation: Rotator = Rotator(), transient: bool = False
    ) -> Actor | None:
        """Spawn an actor of a class."""
        return spawn_from_class(actor_class, location, rotation)

    @api
    def spawn_actor_from_object(
        self, object_to_use: Object, location: Vector, rotation: Rotator = Rotator(), transient: bool = False
    ) -> Actor | None:
        """Spawn an actor from a mesh, Blueprint or class."""
        return spawn_from_object(object_to_use, location, rotation)

    @api
    def destroy_actor(self, actor_to_destroy: Actor) -> bool:
        """Take an actor out of the level."""
        return world().destroy(actor_to_destroy)

    @api
    def destroy_actors(self, actors_to_destroy: Sequence[Actor]) -> bool:
        """Take actors out of the level."""
        gone = [world().destroy(a) for a in actors_to_destroy]
        return all(gone)

    @api
    def duplicate_actor(
        self, actor_to_duplicate: Actor, to_world: World | None = None, offset: Vector = Vector()
    ) -> Actor | None:
        """Copy an actor."""
        return world().duplicate(actor_to_duplicate, offset._triple())  # type: ignore[no-any-return]

    @api
    def duplicate_actors(
        self, actors_to_duplicate: Sequence[Actor], to_world: World | None = None, offset: Vector = Vector()
    ) -> Array:
        """Copy actors."""
        return Array._of("Actor", [world().duplicate(a, offset._triple()) for a in actors_to_duplicate])

    @api
    def set_actor_transform(self, actor: Actor, world_transform: Transform) -> bool:
        """Place an actor."""
        actor._move(world_transform._pose())
        return True

    @api
    def get_actor_reference(self, path_to_actor: str) -> Actor | None:
        """The actor of a path, or None."""
        return world().actors.get(str(path_to_actor).rsplit(".", 1)[-1])

    @api
    def get_selected_level_actors(self) -> Array:
        """Selected actors."""
        return chosen()

    @api
    def set_selected_level_actors(self, actors_to_select: Sequence[Actor]) -> None:
        """Select actors."""
        choose(actors_to_select)

    @api
    def set_actor_selection_state(self, actor: Actor, should_be_selected: bool) -> None:
        """Select an actor, or not."""
        kept = [a for a in world().selection if a is not actor]
        choose([*kept, actor] if should_be_selected else kept)

    @api
    def clear_actor_selection_set(self) -> None:
        """Select nothing."""
        choose([])

    @api
    def select_nothing(self) -> None:
        """Select nothing."""
        choose([])

    @api
    def select_all(self, world: World) -> None:
        """Select every actor."""
        choose(list(actors()))

    @api
    def invert_selection(self, world: World) -> None:
        """Select what was not selected."""
        kept = list(chosen())
        choose([a for a in actors() if a not in kept])

    @api
    def delete_selected_actors(self, world: World) -> None:
        """Take the selected actors out of the level."""
        for actor in list(chosen()):
            actor.destroy_actor()

    @api
    def duplicate_selected_actors(self, world: World) -> None:
        """Copy the selected actors; the copies are selected."""
        choose(list(self.duplicate_actors(list(chosen()))))

    @api
    def convert_actors(
        self, actors: Sequence[Actor], actor_class: Class | type, static_mesh_package_path: str
    ) -> Array:
        """Replace actors by new ones of another class at the same place."""
        return convert(actors, actor_class)

    @api
    def set_component_transform(self, scene_component: SceneComponent, world_transform: Transform) -> bool:
        """Place a component in the world."""
        scene_component._set_world(world_transform._pose())
        return True
