"""The world of an engine process: the open level, its actors, and the assets that paths resolve to."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from types import MappingProxyType
from typing import Any

from c4s.engine.headless.log import EngineLog
from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.unreal import lights
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.asset_tools.paths import package_of
from c4s.engine.headless.unreal.assets import AssetObject, MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.components import (
    InstancedStaticMeshComponent,
    MeshComponent,
    SceneComponent,
    StaticMeshComponent,
)
from c4s.engine.headless.unreal.core import TYPES, Class, Object
from c4s.engine.headless.unreal.levels import World as MapObject
from c4s.engine.headless.world import documents
from c4s.engine.headless.world.library import AssetLibrary
from c4s.errors import BadInput
from c4s.files import append_json_line
from c4s.geometry.transform import Array
from c4s.packs import basic_shapes
from c4s.packs.store import PackStore
from c4s.records.folder import SAVES
from c4s.records.level import Level, LevelActor
from c4s.records.pack import Material

Painter = Callable[[Sequence[Mapping[str, Any]], Sequence[str], str, bool], list[dict[str, Any]]]
"""Renders the open level: cameras, files, mode, and whether to write masks; a record a picture."""
UNTITLED = "/Temp/Untitled_1"
_PACKAGE = re.compile(r"/Game(/[A-Za-z0-9_\-]+)+")
_LAST_DIGITS = re.compile(r"[0-9]{1,9}$")
_NAME = re.compile(r"[A-Za-z0-9_\-]+")


@dataclass(frozen=True)
class Drawable:
    """One mesh in the world: what a renderer or a collider needs."""

    actor: Actor
    actor_index: int
    """Index in ``World.actor_list()``."""
    component: StaticMeshComponent
    mesh: str
    """Asset path; its geometry is ``World.store.mesh(path)``."""
    matrix: Array
    """4x4 local to world (cm)."""
    pose: Pose
    """The same as location, rotation and scale."""

    @property
    def materials(self) -> tuple[Material, ...]:
        """Surface of each slot, overrides applied; the engine's grey where a slot has no material."""
        found = [self.component._material(i) for i in range(self.component._slot_count())]
        return tuple(m._surface() if m is not None else basic_shapes.MATERIAL for m in found)


@dataclass(frozen=True)
class LightSource:
    """One light: ``kind`` is its component's class name, ``properties`` the editor properties that the engine
    declares itself, not those that it only keeps."""

    actor: Actor
    kind: str
    pose: Pose
    properties: dict[str, Any]
    name: str
    """Of the component; of the actor for a post-process volume."""


class World(AssetLibrary):
    """State behind the ``unreal`` module. One a process; see ``state``."""

    def __init__(self, store: PackStore, content: Path, levels: dict[str, Path], painter: Painter) -> None:
        """``painter`` takes the pictures that scripts ask for."""
        self._painter = painter
        self.log = EngineLog()
        super().__init__(store, content)
        self.levels = levels
        self.scratch = content / "Saved"
        self.camera = Pose((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), (1.0, 1.0, 1.0))
        """Viewport camera."""
        self.actors: dict[str, Actor] = {}
        self.selection: list[Actor] = []
        self.dirty = False
        self.transactions: list[str] = []
        """Descriptions of the open transactions, the outermost first."""
        self._serials: dict[str, int] = {}
        self._labels: Counter[str] = Counter()
        self._spawns = 0
        self.package = UNTITLED
        self.map: MapObject = MapObject._at(f"{UNTITLED}.Untitled_1")._lay()

    # the open level

    def map_path(self) -> str:
        """Object path of the open map, ``/Game/A/B.B``."""
        return f"{self.package}.{self.package.rsplit('/', 1)[-1]}"

    def touch(self) -> None:
        """Note that the level has unsaved edits."""
        self.dirty = True

    def close(self) -> None:
        """Drop the open level; its objects are dead from now on."""
        for actor in self.actors.values():
            actor._kill()
        self.map._dead = True
        self.actors = {}
        self.selection = []

    def _open(self, package: str, actors: dict[str, Actor]) -> MapObject:
        self.close()
        self.package = package
        self.map = MapObject._at(self.map_path())._lay()
        self.actors = actors
        self._serials, self._spawns, self.dirty = {}, 0, False
        self._labels = Counter(actor._label for actor in actors.values())
        for actor in actors.values():
            actor._outer = self.map._level
        return self.map

    def new_map(self, package: str = UNTITLED) -> MapObject:
        """Close the level without saving and open an empty one."""
        return self._open(package, {})

    def level_file(self, package: str) -> Path | None:
        """Document of a level: a saved one first, then the read-only ones."""
        saved = self.content_file(package, ".level.json")
        if saved is not None and saved.is_file():
            return saved
        return self.levels.get(package)

    def load_map(self, package: str, read: Mapping[Path, Level] = MappingProxyType({})) -> MapObject | None:
        """Close the level without saving and open another; None (and the old one stays) when there is none.

        ``read``: documents that were read already, each for this one time.
        """
        package = package_of(package)
        path = self.level_file(package)
        if path is None:
            self.log.error(f"LoadMap: failed to find level '{package}'")
            return None
        level = read.get(path) or Level.read(path)
        if level.package != package:
            raise BadInput(f"the document calls itself {level.package}, not {package}", where=str(path))
        return self._open(package, documents.build(self, level, package))

    def copy_map(self, package: str) -> MapObject | None:
        """Open an untitled copy of a level; None (and the old one stays) when there is none."""
        if self.load_map(package) is None:
            return None
        self.package = UNTITLED
        self.map._object_path, self.map._name = self.map_path(), UNTITLED.rsplit("/", 1)[-1]
        self.touch()
        return self.map

    def save_map(self, package: str) -> bool:
        """Save the open level under a package name and make that its own; False (and why, logged) when refused."""
        package = package_of(package)
        path = self.content_file(package, ".level.json")
        if path is None:
            self.log.error(f"SaveMap: '{package}' is not a package path under /Game/")
            return False
        if package in self.levels:
            self.log.error(f"SaveMap: '{package}' is read-only; save under another name")
            return False
        if self.exists(package):
            self.log.error(f"SaveMap: '{package}' is an asset that is not a level")
            return False
        try:
            documents.write(path, package, list(self.actors.values()))
        except BadInput as error:
            self.log.error(f"SaveMap: '{package}' is not saved: {error.line()}")
            return False
        append_json_line(self.content / SAVES, {"package": package})
        self.package = package
        self.map._object_path = self.map_path()
        self.map._name = package.rsplit("/", 1)[-1]
        self.dirty = False
        return True

    # actors

    def native_class(self, path: str) -> type[Object] | None:
        """The type behind ``/Script/Module.Name``, or None."""
        found: type | None = TYPES.get(path.rsplit(".", 1)[-1]) if path.startswith("/Script/") else None
        if found is None or not issubclass(found, Object) or found._class_path() != path:
            return None
        return found

    def make(self, class_path: str, name: str) -> Actor | None:
        """An actor of a class, with default components, in no level yet; None when there is no such class."""
        native = self.native_class(class_path)
        if native is not None:
            if not issubclass(native, Actor) or native._absent:
                return None
            return native._make(name, self.map._level)  # type: ignore[no-any-return]
        asset = self.store.asset(class_path)
        generated = self.find(class_path)
        if asset is None or not isinstance(generated, Class):
            return None
        actor: Actor = Actor._make(name, self.map._level)
        actor._blueprint = generated
        for part in asset.parts:
            component: StaticMeshComponent = actor._add(StaticMeshComponent, part.name)
            documents._fill_mesh(self, component, part.asset)
            component._relative = documents._pose(part.relative)
            component._stale()
        return actor

    def _fresh_name(self, stem: str) -> str:
        serial = self._serials.get(stem, 0)
        while f"{stem}_{serial}" in self.actors:
            serial += 1
        self._serials[stem] = serial + 1
        return f"{stem}_{serial}"

    def _enter(self, actor: Actor) -> None:
        actor._guid = sha256(f"{self.package}|{actor._name}|{self._spawns}".encode()).hexdigest()[:32].upper()
        self._spawns += 1
        self.actors[actor._name] = actor
        self._labels[actor._label] += 1
        self.selection = [actor]
        self.touch()

    def _fresh_label(self, stem: str) -> str:
        """``stem``, or where it is taken the next free one: ``Cube2`` behind ``Cube``, ``Box_02`` behind ``Box_01``."""
        if not self._labels[stem]:
            return stem
        digits = _LAST_DIGITS.search(stem)
        plain, width = (stem[: digits.start()], len(digits[0])) if digits else (stem, 1)
        serial = max(self._serials.get(f"label:{plain}", 0), int(digits[0]) + 1 if digits else 2)
        while self._labels[f"{plain}{serial:0{width}d}"]:
            serial += 1
        if digits is None:
            self._serials[f"label:{plain}"] = serial
        return f"{plain}{serial:0{width}d}"

    def relabel(self, actor: Actor, label: str) -> None:
        """Give an actor another label."""
        if self.actors.get(actor._name) is actor:
            self._labels[actor._label] -= 1
            self._labels[label] += 1
        actor._label = label
        self.touch()

    def spawn(self, class_path: str, pose: Pose, label: str | None = None) -> Actor:
        """Spawn an actor of a class; ``Exception`` when the class is unknown."""
        stem = class_path.rsplit(".", 1)[-1]
        actor = self.make(class_path, self._fresh_name(stem))
        if actor is None:
            raise Exception(f"SpawnActor: the headless engine has no actors of class '{class_path}'")
        actor._label = self._fresh_label(label or stem.removesuffix("_C"))
        actor._move(pose)
        self._enter(actor)
        return actor

    def duplicate(self, actor: Actor, offset: tuple[float, float, float]) -> Actor:
        """Copy an actor, moved by ``offset`` cm."""
        copy = documents.actor_copy(self, actor, self._fresh_name(actor._name.rsplit("_", 1)[0]))
        pose = actor._pose()
        copy._outer = self.map._level
        copy._label = self._fresh_label(actor._label)
        copy._move(pose.moved(tuple(a + b for a, b in zip(pose.location, offset, strict=True))))  # type: ignore[arg-type]
        self._enter(copy)
        return copy

    def destroy(self, actor: Actor) -> bool:
        """Take an actor out of the level; what is attached to it stays where it is."""
        if self.actors.get(actor._name) is not actor:
            return False
        for child in actor.get_attached_actors():
            child.detach_from_actor(*[TYPES["DetachmentRule"].KEEP_WORLD] * 3)  # type: ignore[attr-defined]
        actor._root()._attach(None)
        del self.actors[actor._name]
        self._labels[actor._label] -= 1
        self.selection = [a for a in self.selection if a is not actor]
        actor._kill()
        self.touch()
        return True

    def rename(self, actor: Actor, name: str) -> bool:
        """Give an actor another object name; False when it is taken or not a name."""
        if name in self.actors or not _NAME.fullmatch(name) or self.actors.get(actor._name) is not actor:
            return False
        self.actors = {name if a is actor else n: a for n, a in self.actors.items()}
        actor._name = name
        self.touch()
        return True

    def actor_list(self) -> list[Actor]:
        """All actors in level order."""
        return list(self.actors.values())

    def replace_asset(self, old: AssetObject, new: AssetObject | None) -> None:
        """Let whatever uses an asset, in the open level too, use another one, or none."""
        super().replace_asset(old, new)
        for component in [c for a in self.actors.values() for c in a._components]:
            if isinstance(component, StaticMeshComponent) and component._mesh is old:
                component._mesh = new if isinstance(new, StaticMesh) else None
                component._changed("static_mesh")
            for slot, material in list(component._materials.items()) if isinstance(component, MeshComponent) else []:
                if material is old or material._values.get("parent") is old:
                    component._swap_material(slot, old, new if isinstance(new, MaterialInterface) else None)

    def references(self) -> list[str]:
        """Object paths that the open level names."""
        rows = [documents.actor_plain(actor) for actor in self.actors.values()]
        return documents.references(Level(package=self.package, actors=[LevelActor.model_validate(r) for r in rows]))

    def take_pictures(
        self, cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool
    ) -> list[dict[str, Any]]:
        """Render the open level into PNG files, with ``masks`` into ``<stem>.actors.npz`` too."""
        return self._painter(cameras, files, mode, masks)

    # what a renderer reads

    def drawables(self) -> Iterator[Drawable]:
        """Every visible mesh, instances one by one; a copy of a mesh that no pack holds any more shows nothing."""
        for index, actor in enumerate(self.actors.values()):
            if actor._values.get("hidden") or actor._hidden_ed:
                continue
            for component in actor._components:
                if not isinstance(component, StaticMeshComponent) or component._mesh is None:
                    continue
                mesh = component._mesh._asset.path
                if not component._shows() or self.store.asset(mesh) is None:
                    continue
                pose = component._world_pose()
                instanced = isinstance(component, InstancedStaticMeshComponent)
                for each in [compose(i, pose) for i in component._instances] if instanced else [pose]:
                    yield Drawable(actor, index, component, mesh, each.matrix(), each)

    def light_sources(self) -> Iterator[LightSource]:
        """Every shining light, sky light, fog and atmosphere, and every enabled post-process volume."""
        kinds = (lights.LightComponentBase, lights.ExponentialHeightFogComponent, lights.SkyAtmosphereComponent)
        for actor in self.actors.values():
            if actor._values.get("hidden") or actor._hidden_ed:
                continue
            sources: list[Any] = [
                c
                for c in actor._components
                if isinstance(c, kinds) and isinstance(c, SceneComponent) and c.get_editor_property("visible")
            ]
            if type(actor).__name__ == "PostProcessVolume" and actor.get_editor_property("enabled"):
                sources.append(actor)
            for source in sources:
                pose = actor._pose() if source is actor else source._world_pose()
                properties = {
                    name: source.get_editor_property(name)
                    for name, prop in type(source)._declared.items()
                    if prop.scripts
                }
                yield LightSource(actor, type(source).__name__, pose, properties, source.get_name())


def read_levels(paths: Sequence[Path]) -> dict[Path, Level]:
    """Level documents by their files; ``BadInput`` where two carry one package name."""
    read: dict[Path, Level] = {}
    found: dict[str, Path] = {}
    for path in paths:
        read[path] = level = Level.read(path)
        if level.package in found:
            raise BadInput(f"{level.package} is also {found[level.package]}", where=str(path))
        found[level.package] = path
    return read
