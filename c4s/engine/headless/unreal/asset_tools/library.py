"""Assets by path."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.asset_tools.paths import in_folder, load, new_object_path, package_of
from c4s.engine.headless.unreal.asset_tools.registry import REGISTRY, AssetData
from c4s.engine.headless.unreal.assets import (
    AssetObject,
    Blueprint,
    Material,
    MaterialInstanceConstant,
    StaticMesh,
)
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, api, public


@public
class EditorAssetLibrary(Object):
    """Assets by path."""

    _class_module = "EditorScriptingUtilities"

    @classmethod
    @api
    def load_asset(cls, asset_path: str) -> Any:
        """The asset, or None with a logged warning."""
        return load(asset_path)

    @classmethod
    @api
    def does_asset_exist(cls, asset_path: str) -> bool:
        """Whether an asset (or a saved level) has this path."""
        return world().exists(str(asset_path)) or world().level_file(package_of(str(asset_path))) is not None

    @classmethod
    @api
    def does_directory_exist(cls, directory_path: str) -> bool:
        """Whether a folder holds assets or was made."""
        folder = str(directory_path).rstrip("/")
        return folder in world().folders or any(in_folder(a._path(), folder, True) for a in world().assets())

    @classmethod
    @api
    def make_directory(cls, directory_path: str) -> bool:
        """Make a folder under /Game/."""
        if world().content_file(str(directory_path).rstrip("/"), "") is None:
            return False
        world().folders.add(str(directory_path).rstrip("/"))
        return True

    @classmethod
    @api
    def list_assets(cls, directory_path: str, recursive: bool = True, include_folder: bool = False) -> Array:
        """Object paths of the assets in a folder."""
        found = sorted(a._path() for a in world().assets() if in_folder(a._path(), str(directory_path), recursive))
        folders = sorted({package_of(p).rsplit("/", 1)[0] + "/" for p in found} if include_folder else set())
        return Array._of("str", folders + found)

    @classmethod
    @api
    def find_asset_data(cls, asset_path: str) -> AssetData:
        """Registry entry, invalid when there is none."""
        return REGISTRY.get_asset_by_object_path(str(asset_path))

    @classmethod
    @api
    def load_blueprint_class(cls, asset_path: str) -> Class | None:
        """Class of a Blueprint asset, or None with a logged warning."""
        found = load(str(asset_path).removesuffix("_C") if "." in str(asset_path) else asset_path)
        if isinstance(found, Blueprint):
            return found.generated_class()
        if found is not None:
            world().log.warning(f"LoadBlueprintClass: '{asset_path}' is no Blueprint")
        return None

    @classmethod
    @api
    def save_asset(cls, asset_to_save: str, only_if_is_dirty: bool = True) -> bool:
        """Save a created asset."""
        found = world().find(str(asset_to_save))
        return world().save(found) if isinstance(found, AssetObject) else False

    @classmethod
    @api
    def save_loaded_asset(cls, asset_to_save: Object, only_if_is_dirty: bool = True) -> bool:
        """Save a created asset."""
        return world().save(asset_to_save) if isinstance(asset_to_save, AssetObject) else False

    @classmethod
    @api
    def save_directory(cls, directory_path: str, only_if_is_dirty: bool = True, recursive: bool = True) -> bool:
        """Save the created assets of a folder."""
        saved = [world().save(a) for a in list(world().created.values())
                 if in_folder(a._path(), str(directory_path), recursive)]
        return all(saved)

    @classmethod
    @api
    def delete_asset(cls, asset_path_to_delete: str) -> bool:
        """Delete a created asset; packs are read-only (False)."""
        return world().delete(str(asset_path_to_delete))

    @classmethod
    @api
    def duplicate_asset(cls, source_asset_path: str, destination_asset_path: str) -> Any:
        """Copy a mesh or material under /Game/, in memory until saved; None when refused."""
        source = load(source_asset_path)
        target = new_object_path(str(destination_asset_path))
        if source is None or target is None:
            return None
        if isinstance(source, StaticMesh):
            made: AssetObject = StaticMesh._at(target, created=True)._bind(source._asset)
        elif isinstance(source, MaterialInstanceConstant):
            made = MaterialInstanceConstant._at(target, created=True)
            made._values["parent"] = source._parent() or source
            made._vectors, made._scalars = dict(source._vectors), dict(source._scalars)
        elif isinstance(source, Material):
            made = Material._at(target, created=True)._bind(source._surface().model_copy(
                update={"path": target, "texture": None}))
        else:
            world().log.error(f"DuplicateAsset: '{source_asset_path}' cannot be copied here")
            return None
        world().create(made)
        return made
