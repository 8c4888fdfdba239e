"""The older static functions for actors and levels. They work, and warn their caller as in Unreal."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import Pose
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.components import MeshComponent, StaticMeshComponent
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, api, deprecated, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.structs import Rotator, Vector
from c4s.engine.headless.unreal.subsystems.levels import (
    is_current_level,
    new_level_at,
    new_level_like,
    open_map,
    save_current,
)
from c4s.engine.headless.unreal.subsystems.replacing import convert, parts_of, replace_materials, replace_meshes
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
    def spawn_actor_from_class(
        cls,
        actor_class: Class | type,
        location: Vector,
        rotation: Rotator = Rotator(),  # noqa: B008
        transient: bool = False,
    ) -> Actor | None:
        """Spawn an actor of a class."""
        return spawn_from_class(actor_class, location, rotation)

    @classmethod
    @api
    def spawn_actor_from_object(
        cls,
        object_to_use: Object,
        location: Vector,
        rotation: Rotator = Rotator(),  # noqa: B008
        transient: bool = False,
    ) -> Actor | None:
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
        return world().map  # type: ignore[no-any-return]

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
    def pilot_level_actor(cls, actor_to_pilot: Actor) -> None:
        """Look from where an actor is."""
        world().camera = actor_to_pilot._pose()

    @classmethod
    @api
    def eject_pilot_level_actor(cls) -> None:
        """The viewport stays where it is."""

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

    @classmethod
    @api
    def set_actor_selection_state(cls, actor: Actor, should_be_selected: bool) -> None:
        """Select an actor, or not."""
        kept = [a for a in world().selection if a is not actor]
        choose([*kept, actor] if should_be_selected else kept)

    @classmethod
    @api
    def select_nothing(cls) -> None:
        """Select nothing."""
        choose([])

    @classmethod
    @api
    def clear_actor_selection_set(cls) -> None:
        """Select nothing."""
        choose([])

    @classmethod
    @api
    def get_game_world(cls) -> World | None:
        """No game is played here: None."""
        return None

    @classmethod
    @api
    def editor_invalidate_viewports(cls) -> None:
        """Viewports are drawn on demand here."""

    @classmethod
    @api
    def editor_set_game_view(cls, game_view: bool) -> None:
        """Viewports show nothing but the level here."""

    @classmethod
    @api
    def set_current_level_by_name(cls, level_name: Name | str) -> bool:
        """There is one level, the persistent one."""
        return is_current_level(level_name)

    @classmethod
    @api
    def new_level_from_template(cls, asset_path: str, template_asset_path: str) -> bool:
        """Open and save a copy of a level."""
        return new_level_like(asset_path, template_asset_path)

    @classmethod
    @api
    def convert_actors(cls, actors: Sequence[Actor], actor_class: Class | type, static_mesh_package_path: str) -> Array:
        """Replace actors by new ones of another class at the same place."""
        return convert(actors, actor_class)

    @classmethod
    @api
    def replace_mesh_components_meshes(
        cls,
        mesh_components: Sequence[StaticMeshComponent],
        mesh_to_be_replaced: StaticMesh | None,
        new_mesh: StaticMesh | None,
    ) -> None:
        """Show another mesh where components show one (or any, without one)."""
        replace_meshes(mesh_components, mesh_to_be_replaced, new_mesh)

    @classmethod
    @api
    def replace_mesh_components_meshes_on_actors(
        cls, actors: Sequence[Actor], mesh_to_be_replaced: StaticMesh | None, new_mesh: StaticMesh | None
    ) -> None:
        """Show another mesh where actors show one (or any, without one)."""
        replace_meshes(parts_of(actors), mesh_to_be_replaced, new_mesh)

    @classmethod
    @api
    def replace_mesh_components_materials(
        cls,
        mesh_components: Sequence[MeshComponent],
        material_to_be_replaced: MaterialInterface | None,
        new_material: MaterialInterface | None,
    ) -> None:
        """Use another material where components use one (or any, without one)."""
        replace_materials(mesh_components, material_to_be_replaced, new_material)

    @classmethod
    @api
    def replace_mesh_components_materials_on_actors(
        cls,
        actors: Sequence[Actor],
        material_to_be_replaced: MaterialInterface | None,
        new_material: MaterialInterface | None,
    ) -> None:
        """Use another material where actors use one (or any, without one)."""
        replace_materials(parts_of(actors), material_to_be_replaced, new_material)


_NOW_IN = {
    "Level Editor Subsystem": "load_level new_level new_level_from_template save_current_level save_all_dirty_levels "
    "set_current_level_by_name editor_invalidate_viewports editor_set_game_view pilot_level_actor "
    "eject_pilot_level_actor",
    "Unreal Editor Subsystem": "get_editor_world get_game_world set_level_viewport_camera_info "
    "get_level_viewport_camera_info",
    "Static Mesh Editor Subsystem": "replace_mesh_components_meshes replace_mesh_components_meshes_on_actors "
    "replace_mesh_components_materials replace_mesh_components_materials_on_actors",
    "Editor Actor Utilities Subsystem": "get_all_level_actors get_all_level_actors_components get_actor_reference "
    "destroy_actor get_selected_level_actors set_selected_level_actors "
    "set_actor_selection_state select_nothing clear_actor_selection_set "
    "convert_actors",
}
"""Where each function lives now; spawning is not deprecated."""

for _place, _names in _NOW_IN.items():
    for _name in _names.split():
        _function = EditorLevelLibrary.__dict__[_name].__func__
        setattr(
            EditorLevelLibrary,
            _name,
            classmethod(
                deprecated(f"The Editor Scripting Utilities Plugin is deprecated - Use the function in {_place}")(
                    _function
                )
            ),
        )
