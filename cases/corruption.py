"""Corruption recipes: authored changes that turn a scene into the copy that an agent has to repair.

A recipe (``code4scene.recipe.v1``) is a list of operations applied in order to the original level. A target is named
by its stable id, which every actor of a scene carries as a tag. Vectors are new absolute values (cm, [pitch, yaw, roll]
degrees, scale factors), never differences; what is left out stays as it is. So the repair is the inverse of the recipe.

The eight kinds of change (paper, benchmark suite) are made by ``removal``, ``insertion``, ``duplication``,
``replacement``, ``move``, ``rotate``, ``rescale`` and ``mirror``.
"""

from __future__ import annotations

import hashlib
import math
import uuid
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field

from c4s.editor.identity import ID_TAG, ORIGIN_TAG, tag_values, told
from c4s.errors import BadInput
from c4s.geometry.transform import normalize_axis
from c4s.records.base import Record
from c4s.records.level import Level, LevelActor, LevelComponent, Transform, Vector

STABLE_ID_TAG = f"{ID_TAG}="
SOURCE_TAG = f"{ORIGIN_TAG}=source"
IDENTITY_NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "https://simworld.ai/SimCodeArena/stable-actor-id/v1")
"""Namespace of the published ``uuid5-source-v1`` identity scheme."""
STATIC_MESH_ACTOR = "/Script/Engine.StaticMeshActor"
STATIC_MESH_COMPONENT = "/Script/Engine.StaticMeshComponent"

Kind = Literal["removal", "insertion", "duplication", "replacement", "move", "rotate", "rescale", "mirror"]
KINDS: tuple[Kind, ...] = ("removal", "insertion", "duplication", "replacement", "move", "rotate", "rescale", "mirror")


class SetTransform(Record):
    """New location, rotation or scale of an actor."""

    op: Literal["set_transform"] = "set_transform"
    target: str
    location_cm: Vector | None = None
    rotation_deg: Vector | None = None
    scale: Vector | None = None


class RemoveActor(Record):
    """An actor goes missing."""

    op: Literal["remove_actor"] = "remove_actor"
    target: str


class SpawnActor(Record):
    """An actor appears. ``source`` (``from`` in JSON) is ``{"static_mesh": path}`` or ``{"class": path_C}``."""

    op: Literal["spawn_actor"] = "spawn_actor"
    stable_id: str
    identity_tag: bool = True
    object_name: str
    label: str
    source: dict[str, str] = Field(alias="from")
    location_cm: Vector
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    scale: Vector = (1.0, 1.0, 1.0)
    expect: dict[str, Any] = Field(default_factory=dict)
    """``{"like": stable id}``: components and materials are those of that actor."""

    model_config = ConfigDict(populate_by_name=True)


class SetStaticMesh(Record):
    """A component shows another mesh; ``replaces`` is the original one."""

    op: Literal["set_static_mesh"] = "set_static_mesh"
    target: str
    component: str
    static_mesh: str
    replaces: str


Operation = Annotated[SetTransform | RemoveActor | SpawnActor | SetStaticMesh, Field(discriminator="op")]


class Recipe(Record):
    """A recipe in the published format."""

    schema_version: Literal["code4scene.recipe.v1"] = "code4scene.recipe.v1"
    case_id: str
    setting: str
    scene_id: str
    source_map: str
    ground_truth_map: str
    input_map: str
    level_structure: list[dict[str, Any]] = Field(default_factory=list)
    operations: list[Operation]

    def plain(self) -> dict[str, Any]:
        """JSON data with the published names; values that are not set are left out."""
        return self.model_dump(mode="json", by_alias=True, exclude_none=True)


@dataclass(frozen=True)
class Corruption:
    """One authored change: its kind and the operations that make it."""

    kind: Kind
    operations: tuple[SetTransform | RemoveActor | SpawnActor | SetStaticMesh, ...]


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


def _index(actors: Sequence[LevelActor], target: str) -> int:
    for position, actor in enumerate(actors):
        if id_of(actor) == target:
            return position
    raise BadInput("no actor has this stable id", where=target, todo="is it removed by an earlier operation?")


def apply(
    level: Level, operations: Sequence[SetTransform | RemoveActor | SpawnActor | SetStaticMesh], package: str
) -> Level:
    """The corrupted copy of ``level`` as package ``package``. ``BadInput`` where a target or a component is missing."""
    actors = list(level.actors)
    for operation in operations:
        match operation:
            case RemoveActor(target=target):
                gone = actors.pop(_index(actors, target))
                if any(actor.parent == gone.name for actor in actors):
                    raise BadInput("an actor with attached children cannot be removed", where=gone.name)
            case SetTransform(target=target):
                at = _index(actors, target)
                changes = {
                    key: value
                    for key in ("location_cm", "rotation_deg", "scale")
                    if (value := getattr(operation, key)) is not None
                }
                moved = actors[at].transform.model_copy(update=changes)
                actors[at] = actors[at].model_copy(update={"transform": moved})
            case SetStaticMesh(target=target):
                at = _index(actors, target)
                like = _nearest(actors, actors[at].transform.location_cm, operation.static_mesh)
                actors[at] = _with_mesh(actors[at], operation, like)
            case SpawnActor():
                actors.append(_spawned(actors, operation))
    return Level(package=package, actors=actors)


def _with_mesh(actor: LevelActor, operation: SetStaticMesh, like: LevelActor | None) -> LevelActor:
    """The actor with another mesh, painted as the nearest actor of that mesh is."""
    components = []
    for component in actor.components:
        if component.name == operation.component:
            if component.static_mesh != operation.replaces:
                raise BadInput(
                    f"the component shows {component.static_mesh}, not {operation.replaces}", where=actor.name
                )
            materials = like.components[0].materials if like else {}
            component = component.model_copy(update={"static_mesh": operation.static_mesh, "materials": materials})
        components.append(component)
    if components == actor.components:
        raise BadInput(f"no component {operation.component!r} to change", where=actor.name)
    return actor.model_copy(update={"components": components})


def _spawned(actors: Sequence[LevelActor], operation: SpawnActor) -> LevelActor:
    """The new actor. What it shows comes from the operation; all else it has like those that it stands among.

    Its tags, flags and properties are those of the actor that it is made like, or of the nearest one of its mesh, or
    of the nearest static mesh actor; an override of a material is taken from one of its mesh alone.
    """
    if any(actor.name == operation.object_name for actor in actors):
        raise BadInput("an actor of this object name exists", where=operation.object_name)
    mesh = operation.source.get("static_mesh")
    if "like" in operation.expect:
        model: LevelActor | None = actors[_index(actors, operation.expect["like"])]
    elif mesh is not None:
        model = _nearest(actors, operation.location_cm, mesh) or _nearest(actors, operation.location_cm)
    else:
        raise BadInput("a Blueprint is spawned like an existing actor only", where=operation.object_name)
    components = list(model.components) if model else []
    if "like" not in operation.expect:
        components = [_component(model, mesh)]
    tags = [STABLE_ID_TAG + operation.stable_id, SOURCE_TAG] if operation.identity_tag else []
    return LevelActor(
        name=operation.object_name,
        label=operation.label,
        guid=guid_of(operation.stable_id),
        class_path=operation.source.get("class", STATIC_MESH_ACTOR),
        components=components,
        tags=[*_other_tags(model), *tags],
        hidden=model is not None and model.hidden,
        properties=dict(model.properties) if model else {},
        transform=Transform(
            location_cm=operation.location_cm, rotation_deg=operation.rotation_deg, scale=operation.scale
        ),
    )


def _component(model: LevelActor | None, mesh: str | None) -> LevelComponent:
    """A component that shows a mesh, like the one of a static mesh actor."""
    if model is None:
        return LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=mesh)
    like = model.components[0]
    return like.model_copy(
        update={"static_mesh": mesh, "materials": like.materials if like.static_mesh == mesh else {}}
    )


def _other_tags(actor: LevelActor | None) -> list[str]:
    return [tag for tag in (actor.tags if actor else ()) if not tag.startswith((STABLE_ID_TAG, ORIGIN_TAG))]


def _nearest(actors: Sequence[LevelActor], place: Vector, mesh: str | None = None) -> LevelActor | None:
    """The nearest static mesh actor of a single component, of a mesh or of any; None where there is none."""
    found = [
        actor
        for actor in actors
        if actor.class_path == STATIC_MESH_ACTOR and len(actor.components) == 1 and mesh in (None, *meshes(actor))
    ]
    return min(found, key=lambda actor: math.dist(actor.transform.location_cm, place), default=None)


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
            (self._spawn({"static_mesh": mesh}, location_cm, (0.0, yaw_deg, 0.0), (scale, scale, scale), {}),),
        )

    def duplication(self, name: str, location_cm: Vector, *, yaw_deg: float | None = None) -> Corruption:
        """A second copy of an actor appears at another place."""
        actor = self.actor(name)
        mesh = next((c.static_mesh for c in actor.components if c.static_mesh), None)
        simple = actor.class_path == STATIC_MESH_ACTOR and mesh
        source = {"static_mesh": str(mesh)} if simple else {"class": actor.class_path}
        pitch, yaw, roll = actor.transform.rotation_deg
        return Corruption(
            "duplication",
            (
                self._spawn(
                    source,
                    location_cm,
                    (pitch, yaw if yaw_deg is None else yaw_deg, roll),
                    actor.transform.scale,
                    {"like": self.target(name)},
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
        self, source: dict[str, str], location_cm: Vector, rotation_deg: Vector, scale: Vector, expect: dict[str, Any]
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
            expect=expect,
        )

    def _fresh_name(self, asset: str) -> str:
        """An object name that no actor of the original has."""
        stem, number = asset.rsplit(".", 1)[-1].removesuffix("_C"), 1
        while f"{stem}_{number}" in self.names:
            number += 1
        return f"{stem}_{number}"
