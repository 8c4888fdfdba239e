"""Assets by path: those of packs, the engine's own, and those that scripts create.

A created asset lives in memory until it is saved, as ``<content>/Game/.../Name.asset.json``.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from pydantic import Field

from c4s.bounds import BOUNDS
from c4s.engine.headless.log import EngineLog
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import (
    AssetObject,
    Blueprint,
    Material,
    MaterialInstanceConstant,
    MaterialInterface,
    StaticMesh,
)
from c4s.engine.headless.unreal.core import Class, Object, as_class
from c4s.engine.headless.world import codec, documents
from c4s.errors import BadInput
from c4s.files import read_json
from c4s.names import package_fault
from c4s.packs.store import PackStore, bare_path, object_path
from c4s.records import pack
from c4s.records.base import Record
from c4s.records.level import Level, Number

_PACKAGE = re.compile(r"/Game(/[A-Za-z0-9_\-]+)+")
_LONGEST_PATH, _LONGEST_NAME = 1000, 200
"""Characters that file systems surely take."""


class AssetDocument(Record):
    """A saved asset that a script created."""

    schema_version: Literal["c4s.asset.v1"] = "c4s.asset.v1"
    path: str
    """``/Game/.../M_X.M_X``."""
    class_path: str
    parent: str | None = None
    """Parent material of an instance, or the asset of a pack that this one is a copy of."""
    slots: dict[int, str] = Field(default_factory=dict)
    """Default materials of slots, where they differ from the copied mesh."""
    material: pack.Material | None = None
    parameters: dict[str, str] = Field(default_factory=dict)
    """Parameters of a material by the name that a script gave them, with the field that each one drives."""
    vectors: dict[str, tuple[Number, Number, Number, Number]] = Field(default_factory=dict)
    scalars: dict[str, Number] = Field(default_factory=dict)
    properties: dict[str, Any] = Field(default_factory=dict)
    """Editor properties that differ from the class defaults."""


class AssetLibrary(ABC):
    """Finds, creates, saves and deletes assets."""

    log: EngineLog

    def __init__(self, store: PackStore, content: Path) -> None:
        self.store = store
        self.content = content
        self.created: dict[str, AssetObject] = {}
        """Assets made in this session, and saved ones that were loaded, by object path."""
        self._cache: dict[str, AssetObject | Class] = {}
        self._depth = 0
        """Assets that are being read, each for the one before it."""
        self.folders: set[str] = set()
        """Folders that scripts made."""

    def content_file(self, package: str, suffix: str) -> Path | None:
        """File of a package under the writable content root, or None when that is no package path under /Game/."""
        too_long = len(package) > _LONGEST_PATH or any(len(part) > _LONGEST_NAME for part in package.split("/"))
        if too_long or not _PACKAGE.fullmatch(package):
            return None
        return self.content / f"{package[1:]}{suffix}"

    def package_file(self, package: str, kind: str | None = None) -> Path | None:
        """The file that holds a package, or None: a level's document, the document of a created asset that was saved,
        the mesh of a pack's asset, or the manifest of its pack. ``kind``: ``level`` or ``asset`` only.
        """
        level = self.level_file(package) if kind != "asset" else None
        if level is not None or kind == "level":
            return level
        saved = self.content_file(package, ".asset.json")
        return saved if saved is not None and saved.is_file() else self.store.file(package)

    def find(self, path: str) -> AssetObject | Class | None:
        """The asset of ``/Game/A/B`` or ``/Game/A/B.B``, the class of ``/Game/A/B.B_C`` or ``/Script/Module.Name``, or
        None; each path may have the class around it that export text has."""
        path = bare_path(str(path))
        found = self._cache.get(path)
        if found is None:
            native = self.native_class(path)
            found = as_class(native) if native is not None else self._made(path) or self._of_pack(path)
            if found is not None and not (isinstance(found, AssetObject) and found._created):
                self._cache[path] = found
        return found

    def _made(self, path: str) -> AssetObject | None:
        full = object_path(path) if path.startswith("/Game/") and not path.endswith("_C") else path
        if full in self.created:
            return self.created[full]
        file = self.content_file(full.rsplit(".", 1)[0], ".asset.json")
        if file is None or not file.is_file():
            return None
        document = AssetDocument.parse(
            read_json(file, what="saved asset", bound=BOUNDS["asset_bytes"]), where=str(file)
        )
        if document.path != full:
            raise BadInput(f"the document calls itself {document.path}, not {full}", where=str(file))
        BOUNDS["material_parents"].hold(self._depth, where=full)
        self._depth += 1
        try:
            made = self._from_document(document)
        finally:
            self._depth -= 1
        self.created[full] = made
        codec.restore(made, document.properties, str(file), self.find)
        made._dirty = False
        return made

    def _of_pack(self, path: str) -> Any:
        material = self.store.material(path)
        if material is not None:
            return self._shared(material.path, lambda: self._pack_material(material))
        asset = self.store.asset(path)
        if asset is None:
            if self.store.is_left_out(path):
                self.log.error(f"LoadAsset: '{path}' is not among the assets that this case offers")
            return None
        if asset.kind == "static_mesh":
            return self._shared(asset.path, lambda: StaticMesh._at(asset.path)._bind(asset))
        generated = self._shared(f"{asset.path}_C", lambda: self._generated(asset))
        if path.endswith("_C"):
            return generated
        return self._shared(asset.path, lambda: Blueprint._at(asset.path)._bind(asset, generated))

    def _shared(self, path: str, make: Callable[[], Any]) -> Any:
        if path not in self._cache:
            self._cache[path] = make()
        return self._cache[path]

    @staticmethod
    def _pack_material(record: pack.Material) -> Material | MaterialInstanceConstant:
        if record.class_path.endswith(".MaterialInstanceConstant"):
            return _PackInstance._at(record.path)._bind(record)  # type: ignore[no-any-return]
        return Material._at(record.path)._bind(record)  # type: ignore[no-any-return]

    @staticmethod
    def _generated(asset: pack.Asset) -> Class:
        made: Class = Class._make(asset.path.rsplit(".", 1)[-1] + "_C", None)
        made._bind(Actor, f"{asset.path}_C", asset.path)
        return made

    def exists(self, path: str) -> bool:
        """Whether an asset (not a class) resolves."""
        return isinstance(self.find(path), AssetObject)

    def create(self, made: AssetObject) -> None:
        """Register a new asset in memory."""
        self.created[made._path()] = made

    def save(self, asset: AssetObject) -> bool:
        """Write a created asset; assets of packs are read-only and need no saving (True)."""
        if not asset._created:
            edited = codec.stored(type(asset)._properties, asset._values)
            if edited:
                self.log.error(f"SaveAsset: '{asset._path()}' is read-only; not saved: {', '.join(edited)}")
            return not edited
        file = self.content_file(asset._path().rsplit(".", 1)[0], ".asset.json")
        if file is None:
            self.log.error(f"SaveAsset: '{asset._path()}' does not lie under /Game/")
            return False
        self._document(asset).write(file)
        asset._dirty = False
        return True

    def delete(self, path: str) -> bool:
        """Delete a created asset, in memory and on disk; packs are read-only (False)."""
        asset = self.find(path)
        if not isinstance(asset, AssetObject) or not asset._created:
            return False
        full = asset._path()
        self.created.pop(full)
        self._unlink(full)
        self.replace_asset(asset, None)
        asset._dead = True
        return True

    def _unlink(self, path: str) -> None:
        file = self.content_file(path.rsplit(".", 1)[0], ".asset.json")
        if file is not None:
            file.unlink(missing_ok=True)

    def move(self, asset: AssetObject, target: str) -> bool:
        """Give a created asset another object path, on disk too when it was saved; packs are read-only (False)."""
        old = asset._path()
        if self.created.get(old) is not asset:
            self.log.error(f"RenameAsset: '{old}' is read-only")
            return False
        saved = self._is_saved(old.rsplit(".", 1)[0])
        del self.created[old]
        asset._object_path, asset._name = target, target.rsplit(".", 1)[-1]
        self.created[target] = asset
        if saved:
            self._unlink(old)
            self.save(asset)
        for user in [a for a in self.created.values() if a._path() != target and target in a._references()]:
            user._dirty = True
            if self._is_saved(user._path().rsplit(".", 1)[0]):
                self.save(user)
        return True

    def replace_asset(self, old: AssetObject, new: AssetObject | None) -> None:
        """Let whatever uses an asset use another one, or none."""
        for user in self.created.values():
            if user._values.get("parent") is old:
                user._values["parent"] = new
                user._dirty = True
            overrides: dict[int, Any] = getattr(user, "_slot_overrides", {})
            for slot in [slot for slot, used in overrides.items() if used is old]:
                if new is None:
                    del overrides[slot]
                else:
                    overrides[slot] = new
                user._dirty = True

    @abstractmethod
    def native_class(self, path: str) -> type[Object] | None:
        """The type behind ``/Script/Module.Name``, or None."""

    @abstractmethod
    def references(self) -> list[str]:
        """Object paths that the open level names."""

    def assets(self) -> list[AssetObject]:
        """All assets that resolve: the engine's, the packs', then created ones, each group in path order."""
        paths = [a.path for a in self.store.assets()] + [m.path for m in self.store.materials()]
        for file in sorted(self.content.rglob("*.asset.json")):
            package = "/" + file.relative_to(self.content).as_posix().removesuffix(".asset.json")
            self.find(package)
        found = [self.find(path) for path in sorted(paths)] + [self.created[path] for path in sorted(self.created)]
        return [asset for asset in found if isinstance(asset, AssetObject)]

    def disk_references(self, package: str) -> list[str] | None:
        """Object paths that a saved package names (levels, created assets, packs), or None when it is not on disk."""
        level = self.level_file(package)
        if level is not None:
            return documents.references(Level.read(level))
        asset = self.find(package)
        if isinstance(asset, AssetObject) and (not asset._created or self._is_saved(package)):
            return asset._references()
        return None

    @abstractmethod
    def level_file(self, package: str) -> Path | None:
        """Document of a level, or None."""

    def _is_saved(self, package: str) -> bool:
        file = self.content_file(package, ".asset.json")
        return file is not None and file.is_file()

    @staticmethod
    def _document(asset: AssetObject) -> AssetDocument:
        common: dict[str, Any] = {
            "path": asset._path(),
            "class_path": asset._class_path(),
            "properties": codec.stored(type(asset)._properties, asset._values),
        }
        if isinstance(asset, MaterialInstanceConstant):
            parent = asset._parent()
            values = {
                "parent": parent._path() if parent is not None else None,
                "vectors": asset._vectors,
                "scalars": asset._scalars,
            }
            return AssetDocument.parse({**common, **values}, where=asset._path())
        if isinstance(asset, Material):
            origin = asset._origin if asset._origin != asset._path() else None
            return AssetDocument(**common, material=asset._surface(), parent=origin, parameters=asset._named())
        return AssetDocument(
            **common, parent=asset._asset.path, slots={i: m._path() for i, m in asset._slot_overrides.items()}
        )

    def _from_document(self, document: AssetDocument) -> AssetObject:
        if document.class_path == MaterialInstanceConstant._class_path():
            instance: MaterialInstanceConstant = MaterialInstanceConstant._at(document.path, created=True)
            instance._vectors, instance._scalars = dict(document.vectors), dict(document.scalars)
            self.created[document.path] = instance
            parent = self.find(document.parent) if document.parent else None
            if parent is not None and not (isinstance(parent, MaterialInterface) and instance._may_follow(parent)):
                raise BadInput(f"{document.parent} cannot be its parent", where=document.path)
            instance._values["parent"] = parent
            return instance
        if document.material is not None:
            record = document.material.model_copy(update={"path": document.path})
            material: Material = Material._at(document.path, created=True)._bind(record, document.parent)
            material._parameters = dict(document.parameters)
            return material
        source = self.store.asset(document.parent or "")
        if source is None:
            copied = document.parent or ""
            if copied == document.path or package_fault(copied):
                raise BadInput(f"{copied[:_LONGEST_PATH]!a} cannot be what it copies", where=document.path)
            self.log.warning(f"{document.path}: the mesh '{document.parent}' that it copies is missing")
            source = pack.Asset(
                id="missing", name="missing", path=copied, category="", bounds_min_cm=(0, 0, 0), bounds_max_cm=(0, 0, 0)
            )
        mesh: StaticMesh = StaticMesh._at(document.path, created=True)._bind(source)
        for slot, path in document.slots.items():
            used = self.find(path)
            if isinstance(used, MaterialInterface):
                mesh._slot_overrides[slot] = used
            else:
                self.log.warning(f"{document.path}: failed to find material '{path}'")
        return mesh


class _PackInstance(MaterialInstanceConstant):
    """A material instance of a pack, whose surface the pack states in full."""

    def _bind(self, record: pack.Material) -> Any:
        self._record = record
        return self

    def _surface(self) -> pack.Material:
        record: pack.Material = self._record
        return record

    def _class(self) -> Class:
        return MaterialInstanceConstant.static_class()
