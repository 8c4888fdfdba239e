"""The collision bodies of a snapshot: which actors have them, and which cannot be resolved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from c4s.collision.shapes import Body, BodyFactory


@dataclass(frozen=True)
class SceneBodies:
    """All bodies of a snapshot. ``owners[i]`` is the index of the actor that owns ``bodies[i]``."""

    bodies: list[Body] = field(default_factory=list)
    owners: list[int] = field(default_factory=list)
    unresolved: dict[int, str] = field(default_factory=dict)
    """Actor index to the reason why its bodies are not (all) known."""


def scene_bodies(snapshot: Mapping[str, Any]) -> SceneBodies:
    """World bodies of every actor of a snapshot that carries c4s's keys.

    Components with collision off have none; a body without area (scale zero) has no collision, as in Unreal.
    An actor without the keys, with an unknown mesh or with unusable numbers is unresolved, never guessed.
    """
    scene = SceneBodies()
    extra = snapshot.get("c4s")
    meshes = extra.get("meshes") if isinstance(extra, Mapping) else None
    factory = BodyFactory(meshes if isinstance(meshes, Mapping) else {})
    for index, actor in enumerate(snapshot.get("actors") or []):
        own = actor.get("c4s")
        if not isinstance(meshes, Mapping) or not isinstance(own, Mapping) \
                or not isinstance(own.get("components"), list):
            if (actor.get("collision") or {}).get("collision_enabled") is not False:
                scene.unresolved[index] = "the snapshot holds no collision bodies of this actor"
            continue
        for component in own["components"]:
            reason = _add_component(scene, index, component, factory)
            if reason:
                scene.unresolved[index] = reason
    return scene


def _add_component(scene: SceneBodies, index: int, component: Mapping[str, Any], factory: BodyFactory) -> str:
    """Add a component's bodies; the reason when that is not possible."""
    mesh = component.get("mesh")
    if not mesh or not component.get("collision_enabled"):
        return ""
    if not factory.knows(mesh):
        return f"no collision data of mesh {mesh}"
    instances = component.get("instances")
    placements = instances if isinstance(instances, list) else [component.get("transform") or {}]
    try:
        bodies = [body for placement in placements for body in factory.place(mesh, placement)]
    except (TypeError, ValueError, KeyError) as error:
        return f"component {component.get('name')}: {error}"
    scene.bodies.extend(bodies)
    scene.owners.extend([index] * len(bodies))
    return ""
