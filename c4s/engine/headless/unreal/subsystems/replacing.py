"""Replacing meshes, materials and whole actors."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.components import StaticMeshComponent
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class
from c4s.engine.headless.unreal.structs import Rotator, Vector
from c4s.engine.headless.unreal.subsystems.spawning import spawn_from_class


def parts_of(actors: Iterable[Actor]) -> list[Any]:
    """Components of actors that show a mesh."""
    return [c for a in actors for c in a._components if isinstance(c, StaticMeshComponent)]


def replace_meshes(parts: Iterable[Any], old: StaticMesh | None, new: StaticMesh | None) -> None:
    """Show another mesh where one (any, without one) is shown."""
    for part in parts:
        if part._mesh is not None and (old is None or part._mesh is old):
            part.set_static_mesh(new)


def replace_materials(parts: Iterable[Any], old: MaterialInterface | None, new: MaterialInterface | None) -> None:
    """Use another material where one (any, without one) is used."""
    for part in parts:
        for slot in range(part._slot_count()):
            if old is None or part._material(slot) is old:
                part.set_material(slot, new)


def convert(actors: Sequence[Actor], wanted: Class | type) -> Array:
    """New actors of a class in the place of others, with their label, folder, tags and mesh."""
    made: list[Actor] = []
    for actor in actors:
        label, folder, tags = actor._label, actor._folder, actor.get_editor_property("tags")
        shown = parts_of([actor])
        fresh = spawn_from_class(wanted, Vector(), Rotator())
        if fresh is None:
            continue
        fresh._move(actor._pose())
        fresh.set_editor_property("tags", tags)
        fresh.set_folder_path(folder or "None")
        for part in parts_of([fresh])[:1]:
            part.set_static_mesh(shown[0]._mesh if shown else None)
        world().destroy(actor)
        world().relabel(fresh, label)
        made.append(fresh)
    return Array._of("Actor", made)
