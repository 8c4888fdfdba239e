"""The older static functions for actors and levels."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.pose import Pose
from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, api, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.structs import Rotator, Vector
from c4s.engine.headless.unreal.subsystems.levels import new_level_at, open_map, save_current
from c4s.engine.headless.unreal.subsystems.spawning import actors, choose, chosen, spawn_from_class, spawn_from_object


@public
class EditorLevelLibrary(Object):
    """The older static functions for actors and levels."""

    _class_module = "EditorScriptingUtilities"

    @classmethod
    @api
    def get_all_level_actors(cls) -> Array:
        """All actors."""
        return actors()

    @classmethod
    @api
    def get_all_level_actors_components(cls) -> Array:
        """All components of all actors."""
        return Array._of("ActorComponent", [c for a in world().actor_list() for c in a._components])

    @classmethod
    @api
    def spawn_actor_from_class(cls, actor_class: Class | type, location: Vector, rotation: Rotator = Rotator(),  # noqa: B008
                               transient: bool = False) -> Actor | None:
        """Spawn an actor of a class."""
        return spawn_from_class(actor_class, location, rotation)

    @classmethod
    @api
    def spawn_actor_from_object(cls, object_to_use: Object, location: Vector, rotation: Rotator = Rotator(),  # noqa: B008
                                transient: bool = False) -> Actor | None:
        """Spawn an actor from a mesh, Blueprint or class."""
        return spawn_from_object(object_to_use, location, rotation)

    @classmethod
    @api
    def destroy_actor(cls, actor_to_destroy: Actor) -> bool:
        """Take an actor out of the level."""
        return world().destroy(actor_to_destroy)

    @classmethod
    @api
    def get_editor_world(cls) -> World:
        """The open map."""
        return world().map

    @classmethod
    @api
    def get_actor_reference(cls, path_to_actor: str) -> Actor | None:
        """The actor of a path, or None."""
        return world().actors.get(str(path_to_actor).rsplit(".", 1)[-1])

    @classmethod
    @api
    def get_selected_level_actors(cls) -> Array:
        """Selected actors."""
        return chosen()

    @classmethod
    @api
    def set_selected_level_actors(cls, actors_to_select: Sequence[Actor]) -> None:
        """Select actors."""
        choose(actors_to_select)

    @classmethod
    @api
    def set_level_viewport_camera_info(cls, camera_location: Vector, camera_rotation: Rotator) -> None:
        """Place the viewport's camera."""
        world().camera = Pose.from_rotator(camera_location._triple(), camera_rotation._triple())

    @classmethod
    @api
    def get_level_viewport_camera_info(cls) -> tuple[Vector, Rotator]:
        """Place of the viewport's camera."""
        return Vector(*world().camera.location), Rotator._of(world().camera.rotation_deg)

    @classmethod
    @api
    def load_level(cls, asset_path: str) -> bool:
        """Open a level."""
        return open_map(asset_path) is not None

    @classmethod
    @api
    def new_level(cls, asset_path: str) -> bool:
        """Open and save an empty level."""
        return new_level_at(asset_path)

    @classmethod
    @api
    def save_current_level(cls) -> bool:
        """Save the open level."""
        return save_current()

    @classmethod
    @api
    def save_all_dirty_levels(cls) -> bool:
        """Save the open level if it was edited."""
        return save_current() if world().dirty else True
