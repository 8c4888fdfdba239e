"""Level documents (``c4s.records.level``) to actors and back."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Protocol

from pydantic import Field

from c4s.bounds import BOUNDS
from c4s.engine.headless.log import EngineLog
from c4s.engine.headless.pose import LARGEST, Pose, relative_to
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import MaterialInstanceDynamic, MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.components import (
    ABSTRACT_COMPONENTS,
    ActorComponent,
    InstancedStaticMeshComponent,
    MeshComponent,
    PrimitiveComponent,
    SceneComponent,
    StaticMeshComponent,
)
from c4s.engine.headless.unreal.components.frames import DEEPEST
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import TYPES, Object
from c4s.engine.headless.unreal.enums import CollisionEnabled
from c4s.engine.headless.unreal.lights import LightComponentBase
from c4s.engine.headless.unreal.subsystems.spawning import ABSTRACT
from c4s.engine.headless.world import codec
from c4s.errors import BadInput
from c4s.files import write_bytes
from c4s.records.base import Record
from c4s.records.level import Level, LevelActor, LevelComponent, Transform

_GUID = re.compile(r"[0-9A-Fa-f]{32}")
_DYNAMIC = "dynamic_materials"


class Maker(Protocol):
    """The world, as far as the actors of a document are made by it."""

    log: EngineLog

    def find(self, path: str) -> Any:
        """The asset or Blueprint class of a path, or None."""
        ...

    def native_class(self, path: str) -> type[Any] | None:
        """The type behind ``/Script/Module.Name``, or None."""
        ...

    def make(self, class_path: str, name: str) -> Actor | None:
        """An actor of a class, in no level yet; None when there is no such class."""
        ...


class DynamicMaterial(Record):
    """A dynamic material instance that a component owns, kept in the component's properties by slot."""

    name: str
    parent: str
    """Path of the parent material; empty when it has none."""
    vectors: dict[str, tuple[float, float, float, float]] = Field(default_factory=dict)
    scalars: dict[str, float] = Field(default_factory=dict)


class _DynamicMaterials(Record):
    slots: dict[int, DynamicMaterial]


def _dynamic(properties: dict[str, Any], where: str) -> dict[int, DynamicMaterial]:
    return _DynamicMaterials.parse({"slots": properties.get(_DYNAMIC, {})}, where=where).slots


def _pose(transform: Transform, where: str = "") -> Pose:
    numbers = (*transform.location_cm, *transform.rotation_deg, *transform.scale)
    if not max(map(abs, numbers)) <= LARGEST or math.isnan(sum(numbers)):
        raise BadInput(f"a transform must be finite numbers of at most {LARGEST:g}, not {numbers}", where=where)
    return Pose.from_rotator(transform.location_cm, transform.rotation_deg, transform.scale)


def _plain(pose: Pose) -> dict[str, Any]:
    if not pose.is_sound():
        raise BadInput(f"a place in the world is beyond {LARGEST:g}")
    return {"location_cm": list(pose.location), "rotation_deg": list(pose.rotation_deg), "scale": list(pose.scale)}


def _native(class_path: str) -> type[Object] | None:
    """The native class of a path."""
    found = TYPES.get(class_path.rsplit(".", 1)[-1])
    return found if found is not None and issubclass(found, Object) else None


def references(level: Level) -> list[str]:
    """Paths of all assets and Blueprint classes that a level document names, sorted."""
    found: set[str] = set()
    for actor in level.actors:
        if actor.class_path.startswith("/Game/"):
            found.add(actor.class_path)
        for component in actor.components:
            found.update(codec.asset_paths(_native(component.class_path), component.properties))
            if component.static_mesh:
                found.add(component.static_mesh)
            found.update(component.materials.values())
            dynamic = _dynamic(component.properties, f"{level.package}: {actor.name}.{component.name}")
            found.update(spec.parent for spec in dynamic.values() if spec.parent)
    return sorted(found)


def _fill_mesh(world: Maker, component: StaticMeshComponent, path: str | None) -> None:
    mesh = world.find(path) if path else None
    if path and not isinstance(mesh, StaticMesh):
        world.log.warning(f"{component._path()}: failed to find static mesh '{path}'")
    component._mesh = mesh if isinstance(mesh, StaticMesh) else None


def _fill(world: Maker, actor: Actor, component: ActorComponent, doc: LevelComponent, where: str) -> None:
    properties = dict(doc.properties)
    if isinstance(component, StaticMeshComponent) and (doc.static_mesh is not None or component._mesh is None):
        _fill_mesh(world, component, doc.static_mesh)
    if isinstance(component, MeshComponent):
        for slot, path in doc.materials.items():
            material = world.find(path)
            if isinstance(material, MaterialInterface):
                component._materials[slot] = material
            else:
                world.log.warning(f"{component._path()}: failed to find material '{path}'")
        for slot, spec in _dynamic(properties, where).items():
            parent = world.find(spec.parent)
            made = MaterialInstanceDynamic._owned(
                spec.name, component, parent if isinstance(parent, MaterialInterface) else None
            )
            made._vectors, made._scalars = dict(spec.vectors), dict(spec.scalars)
            component._materials[slot] = made
        properties.pop(_DYNAMIC, None)
    if isinstance(component, InstancedStaticMeshComponent):
        component._instances = [_pose(t, where) for t in doc.instances]
    codec.restore(component, properties, where, world.find)
    if isinstance(component, PrimitiveComponent) and not doc.collision_enabled:
        component._values["collision_enabled"] = CollisionEnabled.NO_COLLISION
    if isinstance(component, SceneComponent) and component is not actor._components[0]:
        component._relative = _pose(doc.relative, where)
        component._stale()


def _component_for(
    world: Maker, actor: Actor, doc: LevelComponent, free: list[ActorComponent], where: str
) -> ActorComponent:
    """The default component that a document's component describes (by name, else by class), or a new one."""
    wanted = world.native_class(doc.class_path)
    if wanted is None or not issubclass(wanted, ActorComponent):
        raise BadInput(f"unknown component class {doc.class_path!r}", where=where)
    if wanted._absent or wanted.__name__ in ABSTRACT_COMPONENTS:
        raise BadInput(f"no component can be of the abstract class {doc.class_path!r}", where=where)
    for match in (
        [c for c in free if c._name == doc.name and c._class_path() == doc.class_path],
        [c for c in free if c._class_path() == doc.class_path],
    ):
        if match:
            free.remove(match[0])
            match[0]._name = doc.name
            return match[0]
    made: ActorComponent = actor._add(wanted, doc.name)
    made._by_script = True
    return made


def build(world: Maker, level: Level, where: str) -> dict[str, Actor]:
    """Actors of a level document, by object name."""
    actors: dict[str, Actor] = {}
    for doc in level.actors:
        spot = f"{where}: {doc.name}"
        if doc.name in actors:
            raise BadInput("two actors have this object name", where=spot)
        if doc.class_path.rsplit(".", 1)[-1] in ABSTRACT and world.native_class(doc.class_path) is not None:
            raise BadInput(f"no actor can be of the abstract class {doc.class_path!r}", where=spot)
        actor = world.make(doc.class_path, doc.name)
        if actor is None:
            world.log.warning(f"{spot}: failed to find class '{doc.class_path}', the actor is not loaded")
            continue
        actor._label, actor._guid, actor._folder = doc.label, doc.guid, doc.folder
        if not _GUID.fullmatch(doc.guid):
            raise BadInput(f"guid {doc.guid!r} is not 32 hex digits", where=spot)
        if doc.tags:
            actor._values["tags"] = Array._of("Name", [Name(t) for t in doc.tags])
        if doc.hidden:
            actor._values["hidden"] = True
        codec.restore(actor, doc.properties, spot, world.find)
        free = list(actor._components)
        for part in doc.components:
            _fill(world, actor, _component_for(world, actor, part, free, spot), part, f"{spot}.{part.name}")
        root = actor._root()
        root._relative = _pose(doc.transform, spot)
        root._stale()
        root._world = root._relative
        actors[doc.name] = actor
    _hold_lights(actors.values(), where)
    _attach(level, actors, where)
    return actors


def _hold_lights(actors: Iterable[Actor], where: str) -> None:
    """``BadInput`` for more lights than pictures can be taken with."""
    lights = sum(isinstance(part, LightComponentBase) for actor in actors for part in actor._components)
    BOUNDS["level_lights"].hold(lights, where=where)


def _check_parents(level: Level, actors: dict[str, Actor], where: str) -> None:
    """Every parent is in the level, none is below its own child, and no chain is longer than ``DEEPEST``."""
    parents = {doc.name: doc.parent for doc in level.actors if doc.name in actors}
    for name, parent in parents.items():
        if parent is not None and parent not in parents:
            raise BadInput(f"its parent {parent!r} is not in the level", where=f"{where}: {name}")
        above, depth = parent, 1
        while above is not None:
            if above == name or depth > DEEPEST:
                raise BadInput(
                    f"its parent {parent!r} is below it"
                    if above == name
                    else f"it is attached more than {DEEPEST} deep, or below a circle",
                    where=f"{where}: {name}",
                )
            above, depth = parents.get(above), depth + 1


def _attach(level: Level, actors: dict[str, Actor], where: str) -> None:
    _check_parents(level, actors, where)
    for doc in level.actors:
        if doc.parent is None or doc.name not in actors:
            continue
        parent = actors[doc.parent]
        root = actors[doc.name]._root()
        world_pose = root._world_pose()
        root._attach(parent._root())
        root._relative = relative_to(world_pose, parent._root()._world_pose())
        root._world = world_pose


def _below_root(component: SceneComponent) -> Pose:
    """Pose relative to the actor's root, whatever the component is attached to."""
    root = component.get_owner()._root()
    if component._parent is root:
        return component._relative
    return relative_to(component._world_pose(), root._world_pose())


def _component_plain(component: ActorComponent, is_root: bool) -> dict[str, Any]:
    properties = codec.stored(component._properties, component._values)
    out: dict[str, Any] = {"name": component._name, "class_path": component._class_path()}
    if isinstance(component, PrimitiveComponent):
        own = component._own("collision_enabled")
        out["collision_enabled"] = own is not CollisionEnabled.NO_COLLISION
        if own is CollisionEnabled.NO_COLLISION:
            properties.pop("collision_enabled", None)
    if isinstance(component, StaticMeshComponent):
        out["static_mesh"] = component._mesh._path() if component._mesh is not None else None
    if isinstance(component, MeshComponent):
        fixed = {s: m for s, m in component._materials.items() if not m._dead}
        out["materials"] = {
            str(s): m._path() for s, m in sorted(fixed.items()) if not isinstance(m, MaterialInstanceDynamic)
        }
        dynamic = {
            str(s): {
                "name": m._name,
                "parent": "".join(m._references()),
                "vectors": {k: list(v) for k, v in m._vectors.items()},
                "scalars": dict(m._scalars),
            }
            for s, m in sorted(fixed.items())
            if isinstance(m, MaterialInstanceDynamic)
        }
        if dynamic:
            properties[_DYNAMIC] = dynamic
    if isinstance(component, InstancedStaticMeshComponent):
        out["instances"] = [_plain(pose) for pose in component._instances]
    if isinstance(component, SceneComponent) and not is_root:
        out["relative"] = _plain(_below_root(component))
    if properties:
        out["properties"] = properties
    return out


def actor_plain(actor: Actor) -> dict[str, Any]:
    """One actor as the data of a ``LevelActor`` (defaults left out)."""
    root = actor._components[0]
    parent = actor._root()._parent
    out: dict[str, Any] = {
        "name": actor._name,
        "label": actor._label,
        "class_path": actor._class()._path(),
        "guid": actor._guid,
        "transform": _plain(actor._pose()),
        "components": [_component_plain(c, c is root) for c in actor._components],
    }
    tags = actor._values.get("tags")
    if tags is not None and len(tags):
        out["tags"] = [str(t) for t in tags]
    if actor._folder:
        out["folder"] = actor._folder
    if parent is not None:
        out["parent"] = parent.get_owner()._name
    if actor._values.get("hidden"):
        out["hidden"] = True
    properties = codec.stored(actor._properties, actor._values)
    if properties:
        out["properties"] = properties
    return out


def write(path: Path, package: str, actors: list[Actor]) -> None:
    """Write the actors as a level document. ``BadInput`` for what ``read`` would refuse."""
    BOUNDS["level_actors"].hold(len(actors), where=package)
    _hold_lights(actors, package)
    value = {"schema_version": "c4s.level.v1", "package": package, "actors": [_sound(actor) for actor in actors]}
    data = _encoded(value)
    Level.from_text(data, where=package)
    write_bytes(path, data)


def _encoded(value: Any) -> bytes:
    """JSON in UTF-8; ``ValueError`` for NaN, infinities and what is no text."""
    return (json.dumps(value, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _sound(actor: Actor) -> dict[str, Any]:
    try:
        return actor_plain(actor)
    except BadInput as error:
        raise BadInput(error.what, where=ascii(actor._label)) from None


def actor_copy(world: Maker, actor: Actor, name: str) -> Actor:
    """A copy of an actor under another object name, not attached to anything."""
    plain = json.loads(json.dumps(actor_plain(actor)))
    plain.update(name=name)
    plain.pop("parent", None)
    level = Level(package="/Temp/Copy", actors=[LevelActor.model_validate(plain)])
    return build(world, level, "copy")[name]
