"""Editor subsystems and the older static libraries with the same functions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.pose import Pose
from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import AssetObject, Blueprint, StaticMesh
from c4s.engine.headless.unreal.components import finite
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, api, as_class, public, subclass_of
from c4s.engine.headless.unreal.enums import CollisionTraceFlag
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector
from c4s.packs.manifest import HullBody

ABSTRACT = ("Light", "Info", "Volume")
"""Actor classes that cannot be placed."""


def actors() -> Array:
    """All actors of the open level."""
    return Array._of("Actor", world().actor_list())


def spawn_from_class(wanted: Class | type, location: Vector, rotation: Rotator) -> Actor | None:
    """Spawn an actor of a class; None (and why, logged) for a class that is no actor."""
    made = as_class(wanted)
    if not subclass_of(made, Actor) or made._python_type.__name__ in ABSTRACT:
        world().log.error(f"SpawnActor: '{made._path()}' is not a class that can be placed")
        return None
    pose = Pose.from_rotator(location._triple(), rotation._triple())
    return world().spawn(made._path(), finite(pose, made))


def spawn_from_object(source: Object, location: Vector, rotation: Rotator) -> Actor | None:
    """Spawn an actor that shows a mesh, or one of a Blueprint or class."""
    pose = finite(Pose.from_rotator(location._triple(), rotation._triple()), source)
    if isinstance(source, StaticMesh):
        actor = world().spawn("/Script/Engine.StaticMeshActor", pose, source._name)
        actor.get_editor_property("static_mesh_component").set_static_mesh(source)
        return actor
    if isinstance(source, Blueprint):
        return world().spawn(source._generated._path(), pose, source._name)
    if isinstance(source, Class):
        return spawn_from_class(source, location, rotation)
    world().log.error(f"SpawnActor: no actor can be made from '{source._path()}'")
    return None


def _chosen() -> Array:
    return Array._of("Actor", world().selection)


def _choose(chosen: Sequence[Actor]) -> None:
    world().selection = list(chosen)


@public
class EditorSubsystem(Object):
    """Base of editor subsystems."""

    _class_module = "EditorSubsystem"


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
    def spawn_actor_from_class(self, actor_class: Class | type, location: Vector,
                               rotation: Rotator = Rotator(), transient: bool = False) -> Actor | None:  # noqa: B008
        """Spawn an actor of a class."""
        return spawn_from_class(actor_class, location, rotation)

    @api
    def spawn_actor_from_object(self, object_to_use: Object, location: Vector,
                                rotation: Rotator = Rotator(), transient: bool = False) -> Actor | None:  # noqa: B008
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
    def duplicate_actor(self, actor_to_duplicate: Actor, to_world: World | None = None,
                        offset: Vector = Vector()) -> Actor | None:  # noqa: B008
        """Copy an actor."""
        return world().duplicate(actor_to_duplicate, offset._triple())

    @api
    def duplicate_actors(self, actors_to_duplicate: Sequence[Actor], to_world: World | None = None,
                         offset: Vector = Vector()) -> Array:  # noqa: B008
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
        return _chosen()

    @api
    def set_selected_level_actors(self, actors_to_select: Sequence[Actor]) -> None:
        """Select actors."""
        _choose(actors_to_select)

    @api
    def set_actor_selection_state(self, actor: Actor, should_be_selected: bool) -> None:
        """Select an actor, or not."""
        kept = [a for a in world().selection if a is not actor]
        _choose([*kept, actor] if should_be_selected else kept)

    @api
    def clear_actor_selection_set(self) -> None:
        """Select nothing."""
        _choose([])

    @api
    def select_nothing(self) -> None:
        """Select nothing."""
        _choose([])


@public
class UnrealEditorSubsystem(EditorSubsystem):
    """The editor's world and viewport."""

    _class_module = "UnrealEd"

    @api
    def get_editor_world(self) -> World:
        """The open map."""
        return world().map

    @api
    def get_game_world(self) -> World | None:
        """No game is played here: None."""
        return None

    @api
    def set_level_viewport_camera_info(self, camera_location: Vector, camera_rotation: Rotator) -> None:
        """Place the viewport's camera."""
        world().camera = Pose.from_rotator(camera_location._triple(), camera_rotation._triple())

    @api
    def get_level_viewport_camera_info(self) -> tuple[Vector, Rotator]:
        """Place of the viewport's camera."""
        return Vector(*world().camera.location), Rotator._of(world().camera.rotation_deg)


def open_map(path: str) -> World | None:
    """Open a level by its package path."""
    return world().load_map(str(path))


def _new_level(path: str) -> bool:
    if world().level_file(str(path).split(".", 1)[0]) is not None:
        world().log.error(f"NewLevel: '{path}' exists already")
        return False
    if world().content_file(str(path).split(".", 1)[0], ".level.json") is None or world().exists(str(path)):
        world().log.error(f"NewLevel: '{path}' cannot be a level")
        return False
    world().new_map(str(path).split(".", 1)[0])
    return world().save_map(str(path))


def save_current() -> bool:
    """Save the open level under its own name; False when it has none yet."""
    return world().save_map(world().package)


@public
class LevelEditorSubsystem(EditorSubsystem):
    """Opening and saving levels."""

    _class_module = "LevelEditor"

    @api
    def load_level(self, asset_path: str) -> bool:
        """Open a level; the current one is closed without saving."""
        return open_map(asset_path) is not None

    @api
    def new_level(self, asset_path: str, is_partitioned_world: bool = False) -> bool:
        """Open and save an empty level."""
        return _new_level(asset_path)

    @api
    def save_current_level(self) -> bool:
        """Save the open level."""
        return save_current()

    @api
    def save_all_dirty_levels(self) -> bool:
        """Save the open level if it was edited."""
        return save_current() if world().dirty else True

    @api
    def get_current_level(self) -> Any:
        """The open level."""
        return world().map._level

    @api
    def editor_invalidate_viewports(self) -> None:
        """Viewports are drawn on demand here."""


@public
class StaticMeshEditorSubsystem(EditorSubsystem):
    """Collision of static meshes."""

    _class_module = "StaticMeshEditor"

    @api
    def get_simple_collision_count(self, static_mesh: StaticMesh) -> int:
        """Number of boxes, spheres and capsules."""
        return sum(not isinstance(b, HullBody) for b in static_mesh._asset.collision)

    @api
    def get_convex_collision_count(self, static_mesh: StaticMesh) -> int:
        """Number of convex hulls."""
        return sum(isinstance(b, HullBody) for b in static_mesh._asset.collision)

    @api
    def get_collision_complexity(self, static_mesh: StaticMesh) -> CollisionTraceFlag:
        """Which geometry collides."""
        return CollisionTraceFlag.CTF_USE_DEFAULT

    @api
    def get_number_verts(self, static_mesh: StaticMesh, lod_index: int) -> int:
        """Number of vertices."""
        mesh = static_mesh._geometry()
        return len(mesh.vertices) if mesh is not None else 0

    @api
    def get_number_materials(self, static_mesh: StaticMesh) -> int:
        """Number of slots."""
        return len(static_mesh._asset.slots)

    @api
    def get_lod_count(self, static_mesh: StaticMesh) -> int:
        """Always one level of detail."""
        return 1


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
        return _chosen()

    @classmethod
    @api
    def set_selected_level_actors(cls, actors_to_select: Sequence[Actor]) -> None:
        """Select actors."""
        _choose(actors_to_select)

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
        return _new_level(asset_path)

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


def _dirty_assets() -> list[AssetObject]:
    return [asset for asset in world().created.values() if asset._dirty]


@public
class EditorLoadingAndSavingUtils(Object):
    """Maps and packages."""

    _class_module = "UnrealEd"

    @classmethod
    @api
    def load_map(cls, filename: str) -> World | None:
        """Open a level by package path; None when there is none."""
        return open_map(filename)

    @classmethod
    @api
    def new_blank_map(cls, save_existing_map: bool) -> World:
        """Open an empty untitled level."""
        if save_existing_map:
            save_current()
        return world().new_map()

    @classmethod
    @api
    def save_map(cls, world: World, asset_path: str) -> bool:
        """Save the open map under a path; it becomes that map."""
        return _save_map(str(asset_path))

    @classmethod
    @api
    def save_current_level(cls) -> bool:
        """Save the open level."""
        return save_current()

    @classmethod
    @api
    def save_dirty_packages(cls, save_map_packages: bool, save_content_packages: bool) -> bool:
        """Save what was edited."""
        saved = [world().save(asset) for asset in _dirty_assets()] if save_content_packages else []
        if save_map_packages and world().dirty:
            saved.append(save_current())
        return all(saved)

    @classmethod
    @api
    def get_dirty_map_packages(cls) -> Array:
        """Edited maps."""
        return Array._of("Package", [world().map.get_package()] if world().dirty else [])

    @classmethod
    @api
    def get_dirty_content_packages(cls) -> Array:
        """Edited assets."""
        return Array._of("Package", [a.get_package() for a in _dirty_assets()])


def _save_map(path: str) -> bool:
    return world().save_map(path)


SUBSYSTEMS: tuple[type[EditorSubsystem], ...] = (
    EditorActorSubsystem, UnrealEditorSubsystem, LevelEditorSubsystem, StaticMeshEditorSubsystem)
