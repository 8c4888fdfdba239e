"""Corruptions: authored changes that turn a scene into the copy that an agent has to repair.

A change becomes operations of a recipe (``cases.recipe``), which are applied in order to the original level
(``cases.applying``); the repair is the inverse. A target is named by its stable id, which every actor of a scene
carries as a tag.

The eight kinds of change (paper, benchmark suite) are made by ``removal``, ``insertion``, ``duplication``,
``replacement``, ``move``, ``rotate``, ``rescale`` and ``mirror``.
"""

from __future__ import annotations

import hashlib
import uuid
from dataclasses import dataclass
from typing import Literal

from c4s.editor.identity import ID_TAG, ORIGIN_TAG, tag_values, told
from c4s.errors import BadInput
from c4s.geometry.transform import normalize_axis
from c4s.records.level import Level, LevelActor, Vector
from cases.recipe import Expected, Kind, Operation, RemoveActor, SetStaticMesh, SetTransform, SpawnActor

STABLE_ID_TAG = f"{ID_TAG}="
SOURCE_TAG = f"{ORIGIN_TAG}=source"
IDENTITY_NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "https://simworld.ai/SimCodeArena/stable-actor-id/v1")
"""Namespace of the published ``uuid5-source-v1`` identity scheme."""
STATIC_MESH_ACTOR = "/Script/Engine.StaticMeshActor"
STATIC_MESH_COMPONENT = "/Script/Engine.StaticMeshComponent"


@dataclass(frozen=True)
class Corruption:
    """One authored change: its label and the operations that make it, one or several (an entry of a recipe)."""

    kind: Kind
    operations: tuple[Operation, ...]


def compound(label: Kind, *changes: Corruption) -> Corruption:
    """Several changes as one entry of the chain, under one label: a row of lamps that is moved, say."""
    return Corruption(label, tuple(operation for change in changes for operation in change.operations))


def stable_id(scene_id: str, actor_name: str, class_path: str) -> str:
    """Stable id of a scene's actor, after the published ``uuid5-source-v1`` scheme."""
    return "sca_source_" + uuid.uuid5(IDENTITY_NAMESPACE, f"v1|source|{scene_id}|{actor_name}|{class_path}").hex


def with_identities(level: Level, scene_id: str) -> Level:
    """The level with a stable-id tag on every actor that has none."""
    actors = []
    for actor in level.actors:
        if id_of(actor) is None:
            tag = STABLE_ID_TAG + stable_id(scene_id, actor.name, actor.class_path)
            actor = actor.model_copy(update={"tags": [*actor.tags, tag, SOURCE_TAG]})
        actors.append(actor)
    return level.model_copy(update={"actors": actors})


def id_of(actor: LevelActor) -> str | None:
    """The stable id that an actor's tags carry."""
    return told(tag_values(actor.tags), "stable_actor_id")


def meshes(actor: LevelActor) -> list[str]:
    """Static meshes that an actor shows."""
    return [component.static_mesh for component in actor.components if component.static_mesh]


def guid_of(text: str) -> str:
    """A reproducible actor GUID (32 upper-case hex digits)."""
    return hashlib.md5(text.encode(), usedforsecurity=False).hexdigest().upper()


class Author:
    """Makes corruptions of one scene; actors are named by object name, all state is read from the original level.

    Two changes of one actor combine when they set different members; of one member the later value stands.
    """

    def __init__(self, level: Level, scene_id: str) -> None:
        self.level, self.scene_id = with_identities(level, scene_id), scene_id
        self.actors = {actor.name: actor for actor in self.level.actors}
        self.names = set(self.actors)

    def actor(self, name: str) -> LevelActor:
        """The original actor; ``BadInput`` when there is none."""
        if name not in self.actors:
            raise BadInput(f"scene {self.scene_id} has no such actor", where=name)
        return self.actors[name]

    def target(self, name: str) -> str:
        """Stable id of an actor."""
        found = id_of(self.actor(name))
        assert found is not None
        return found

    def removal(self, name: str) -> Corruption:
        """The actor is missing in the corrupted copy."""
        return Corruption("removal", (RemoveActor(target=self.target(name)),))

    def insertion(self, mesh: str, location_cm: Vector, *, yaw_deg: float = 0.0, scale: float = 1.0) -> Corruption:
        """An actor that does not belong appears; ``mesh`` is a static mesh path."""
        return Corruption(
            "insertion",
            (self._spawn({"static_mesh": mesh}, location_cm, (0.0, yaw_deg, 0.0), (scale, scale, scale), None),),
        )

    def duplication(self, name: str, location_cm: Vector, *, yaw_deg: float | None = None) -> Corruption:
        """A second copy of an actor appears at another place."""
        actor = self.actor(name)
        mesh = next((c.static_mesh for c in actor.components if c.static_mesh), None)
        simple = actor.class_path == STATIC_MESH_ACTOR and mesh
        source: dict[Literal["static_mesh", "class"], str] = (
            {"static_mesh": str(mesh)} if simple else {"class": actor.class_path}
        )
        pitch, yaw, roll = actor.transform.rotation_deg
        return Corruption(
            "duplication",
            (
                self._spawn(
                    source,
                    location_cm,
                    (pitch, yaw if yaw_deg is None else yaw_deg, roll),
                    actor.transform.scale,
                    self.target(name),
                ),
            ),
        )

    def replacement(self, name: str, mesh: str) -> Corruption:
        """The actor shows another mesh."""
        component = next((c for c in self.actor(name).components if c.static_mesh), None)
        if component is None or component.static_mesh is None or component.static_mesh == mesh:
            raise BadInput("this actor has no mesh that could be replaced by another", where=name)
        return Corruption(
            "replacement",
            (
                SetStaticMesh(
                    target=self.target(name), component=component.name, static_mesh=mesh, replaces=component.static_mesh
                ),
            ),
        )

    def move(self, name: str, *, by_cm: Vector | None = None, to_cm: Vector | None = None) -> Corruption:
        """The actor stands elsewhere: shifted by ``by_cm``, or at ``to_cm``."""
        x, y, z = self.actor(name).transform.location_cm
        dx, dy, dz = by_cm or (0.0, 0.0, 0.0)
        place = to_cm or (x + dx, y + dy, z + dz)
        return Corruption("move", (SetTransform(target=self.target(name), location_cm=place),))

    def rotate(self, name: str, yaw_deg: float) -> Corruption:
        """The actor is turned by ``yaw_deg`` about the vertical."""
        pitch, yaw, roll = self.actor(name).transform.rotation_deg
        turned = normalize_axis(yaw + yaw_deg)
        return Corruption("rotate", (SetTransform(target=self.target(name), rotation_deg=(pitch, turned, roll)),))

    def rescale(self, name: str, factor: float | Vector) -> Corruption:
        """The actor is larger or smaller by a factor, or by one factor an axis."""
        factors = (factor, factor, factor) if isinstance(factor, float | int) else factor
        x, y, z = (s * f for s, f in zip(self.actor(name).transform.scale, factors, strict=True))
        return Corruption("rescale", (SetTransform(target=self.target(name), scale=(x, y, z)),))

    def mirror(self, name: str, axis: Literal["x", "y"] = "y") -> Corruption:
        """The actor is mirrored: the sign of one scale axis is turned."""
        x, y, z = self.actor(name).transform.scale
        scale = (-x, y, z) if axis == "x" else (x, -y, z)
        return Corruption("mirror", (SetTransform(target=self.target(name), scale=scale),))

    def _spawn(
        self,
        source: dict[Literal["static_mesh", "class"], str],
        location_cm: Vector,
        rotation_deg: Vector,
        scale: Vector,
        like: str | None,
    ) -> SpawnActor:
        name = self._fresh_name(next(iter(source.values())))
        self.names.add(name)
        key = f"{name}|{source}|{location_cm}"
        return SpawnActor(
            stable_id=stable_id(self.scene_id, key, "spawned"),
            object_name=name,
            label=name,
            source=source,
            location_cm=location_cm,
            rotation_deg=rotation_deg,
            scale=scale,
            expect=None if like is None else Expected(like=like),
        )

    def _fresh_name(self, asset: str) -> str:
        """An object name that no actor of the original has."""
        stem, number = asset.rsplit(".", 1)[-1].removesuffix("_C"), 1
        while f"{stem}_{number}" in self.names:
            number += 1
        return f"{stem}_{number}"
