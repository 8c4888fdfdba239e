"""Layers of the level: names that actors carry, and what lies under each."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem
from c4s.engine.headless.unreal.subsystems.spawning import actors, choose, chosen

Names = Sequence[Name | str]


def _put(those: Iterable[Actor], names: Names) -> bool:
    """Put actors in layers; whether one was not in one of them yet."""
    changed = False
    for actor in those:
        held = [str(name) for name in actor.get_editor_property("layers")]
        new = [str(name) for name in names if str(name) not in held]
        if new:
            actor.set_editor_property("layers", [Name(name) for name in dict.fromkeys([*held, *new])])
            changed = True
    return changed


def _take(those: Iterable[Actor], names: Names) -> bool:
    """Take actors out of layers; whether one was in one of them."""
    gone, changed = {str(name) for name in names}, False
    for actor in those:
        held = [str(name) for name in actor.get_editor_property("layers")]
        kept = [name for name in held if name not in gone]
        if kept != held:
            actor.set_editor_property("layers", [Name(name) for name in kept])
            changed = True
    return changed


def _within(names: Names) -> Array:
    wanted = {str(name) for name in names}
    found = [a for a in actors() if wanted & {str(name) for name in a.get_editor_property("layers")}]
    return Array._of("Actor", found)


def _all() -> list[str]:
    return list(dict.fromkeys(str(name) for a in actors() for name in a.get_editor_property("layers")))


@public
class LayersSubsystem(EditorSubsystem):
    """Layers. One is there while an actor is in it."""

    _class_module = "UnrealEd"

    @api
    def get_selected_actors(self) -> Array:
        """Selected actors."""
        return chosen()

    @api
    def add_actor_to_layer(self, actor: Actor, layer_name: Name | str) -> bool:
        """Put an actor in a layer; False where it is already."""
        return _put([actor], [layer_name])

    @api
    def add_actor_to_layers(self, actor: Actor, layer_names: Sequence[Name]) -> bool:
        """Put an actor in layers."""
        return _put([actor], layer_names)

    @api
    def add_actors_to_layer(self, actors: Sequence[Actor], layer_name: Name | str) -> bool:
        """Put actors in a layer."""
        return _put(actors, [layer_name])

    @api
    def add_actors_to_layers(self, actors: Sequence[Actor], layer_names: Sequence[Name]) -> bool:
        """Put actors in layers."""
        return _put(actors, layer_names)

    @api
    def add_selected_actors_to_layer(self, layer_name: Name | str) -> bool:
        """Put the selected actors in a layer."""
        return _put(chosen(), [layer_name])

    @api
    def add_selected_actors_to_layers(self, layer_names: Sequence[Name]) -> bool:
        """Put the selected actors in layers."""
        return _put(chosen(), layer_names)

    @api
    def remove_actor_from_layer(self, actor: Actor, layer_to_remove: Name | str, update_stats: bool = True) -> bool:
        """Take an actor out of a layer; False where it was not in it."""
        return _take([actor], [layer_to_remove])

    @api
    def remove_actors_from_layer(
        self, actors: Sequence[Actor], layer_name: Name | str, update_stats: bool = True
    ) -> bool:
        """Take actors out of a layer."""
        return _take(actors, [layer_name])

    @api
    def remove_selected_actors_from_layer(self, layer_name: Name | str) -> bool:
        """Take the selected actors out of a layer."""
        return _take(chosen(), [layer_name])

    @api
    def delete_layer(self, layer_to_delete: Name | str) -> None:
        """Take all actors out of a layer."""
        _take(actors(), [layer_to_delete])

    @api
    def is_layer(self, layer_name: Name | str) -> bool:
        """Whether an actor is in a layer of this name."""
        return str(layer_name) in _all()

    @api
    def add_all_layer_names_to(self) -> Array:
        """Names of all layers."""
        return Array._of("Name", [Name(name) for name in _all()])

    @api
    def get_actors_from_layer(self, layer_name: Name | str) -> Array:
        """The actors of a layer."""
        return _within([layer_name])

    @api
    def get_actors_from_layers(self, layer_names: Sequence[Name]) -> Array:
        """The actors of several layers."""
        return _within(layer_names)

    @api
    def select_actors_in_layer(
        self, layer_name: Name | str, select: bool, notify: bool, select_even_if_hidden: bool = False
    ) -> bool:
        """Add the actors of a layer to the selection, or take them out of it; False where there are none."""
        found = list(_within([layer_name]))
        others = [actor for actor in world().selection if actor not in found]
        choose([*others, *found] if select else others)
        return bool(found)
