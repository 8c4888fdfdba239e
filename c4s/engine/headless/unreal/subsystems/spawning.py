"""Placing actors, and the selection."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import Pose
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import Blueprint, StaticMesh
from c4s.engine.headless.unreal.components import finite
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, as_class, subclass_of
from c4s.engine.headless.unreal.structs import Rotator, Vector

ABSTRACT = ("Light", "Info", "Volume", "SceneCapture", "TriggerBase", "ReflectionCapture", "WorldSettings")
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
    actor: Actor = world().spawn(made._path(), finite(pose, made))
    actor._placed()
    return actor


def spawn_from_object(source: Object, location: Vector, rotation: Rotator) -> Actor | None:
    """Spawn an actor that shows a mesh, or one of a Blueprint or class."""
    pose = finite(Pose.from_rotator(location._triple(), rotation._triple()), source)
    if isinstance(source, StaticMesh):
        actor = world().spawn("/Script/Engine.StaticMeshActor", pose, source._name)
        actor.get_editor_property("static_mesh_component").set_static_mesh(source)
        return actor  # type: ignore[no-any-return]
    if isinstance(source, Blueprint):
        return world().spawn(source._generated._path(), pose, source._name)  # type: ignore[no-any-return]
    if isinstance(source, Class):
        return spawn_from_class(source, location, rotation)
    world().log.error(f"SpawnActor: no actor can be made from '{source._path()}'")
    return None


def chosen() -> Array:
    return Array._of("Actor", world().selection)


def choose(chosen: Sequence[Actor]) -> None:
    world().selection = list(chosen)
