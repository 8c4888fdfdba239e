"""What scripts do with assets by path: one set of functions for ``EditorAssetLibrary`` and ``EditorAssetSubsystem``.

Packs and given levels are read-only: deleting and renaming them is refused (False), copying them works.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.asset_tools.paths import in_folder, load, new_object_path, package_of
from c4s.engine.headless.unreal.asset_tools.registry import REGISTRY, AssetData
from c4s.engine.headless.unreal.assets import (
    AssetObject,
    Blueprint,
    Material,
    MaterialInstanceConstant,
    MaterialInterface,
    StaticMesh,
)
from c4s.engine.headless.unreal.containers import Array, Map, Name, Set
from c4s.engine.headless.unreal.core import Class, Object, Package, as_class


def _folder(path: object) -> str:
    return str(path).rstrip("/")


def _every(results: Iterable[bool]) -> bool:
    """Whether all succeeded, with none left untried."""
    return all(list(results))


def _within(folder: str, recursive: bool = True) -> list[AssetObject]:
    return [a for a in world().assets() if in_folder(a._path(), folder, recursive)]


# existence and lists


def load_asset(asset_path: str) -> Any:
    """The asset, or None with a logged warning; levels are opened, not loaded."""
    return load(asset_path)


def load_blueprint_class(asset_path: str) -> Class | None:
    """Class of a Blueprint asset, or None with a logged warning."""
    found = load(str(asset_path).removesuffix("_C") if "." in str(asset_path) else asset_path)
    if isinstance(found, Blueprint):
        return found.generated_class()
    if found is not None:
        world().log.warning(f"LoadBlueprintClass: '{asset_path}' is no Blueprint")
    return None


def does_asset_exist(asset_path: str) -> bool:
    """Whether an asset (or a saved level) has this path."""
    return world().exists(str(asset_path)) or world().level_file(package_of(str(asset_path))) is not None


def do_assets_exist(asset_paths: Sequence[str]) -> bool:
    """Whether all assets exist."""
    return all(does_asset_exist(path) for path in asset_paths)


def does_directory_exist(directory_path: str) -> bool:
    """Whether a folder holds assets or was made."""
    folder = _folder(directory_path)
    return folder in world().folders or any(in_folder(a._path(), folder, True) for a in world().assets())


def does_directory_have_assets(directory_path: str, recursive: bool = True) -> bool:
    """Whether a folder holds assets."""
    return bool(_within(_folder(directory_path), recursive))


def list_assets(directory_path: str, recursive: bool = True, include_folder: bool = False) -> Array:
    """Object paths of the assets in a folder, in order; folders end with a slash. An asset's path lists itself."""
    text = str(directory_path)
    if world().exists(text):
        return Array._of("str", [world().find(text)._path()])
    found = [a._path() for a in _within(_folder(text), recursive)]
    folders: set[str] = set()
    if include_folder:
        folders = {package_of(a._path()).rsplit("/", 1)[0] for a in _within(_folder(text))} | {
            f for f in world().folders if f.startswith(_folder(text) + "/")
        }
        depth = _folder(text).count("/") + 1
        folders = {f + "/" for f in folders if f != _folder(text) and (recursive or f.count("/") == depth)}
    return Array._of("str", sorted([*folders, *found]))


def list_assets_by_tag_value(tag_name: Name | str, tag_value: str) -> Array:
    """Object paths of the assets whose metadata tag has a value."""
    key = Name(str(tag_name))
    return Array._of("str", [a._path() for a in world().assets() if a._metadata().get(key) == str(tag_value)])


def find_asset_data(asset_path: str) -> AssetData:
    """Registry entry, invalid when there is none."""
    return REGISTRY._entry(str(asset_path))


def find_package_referencers_for_asset(asset_path: str, load_assets_to_confirm: bool = False) -> Array:
    """Packages that name the asset: assets, and the open level."""
    package = package_of(str(asset_path))
    found = {package_of(a._path()) for a in world().assets() if package in {package_of(p) for p in a._references()}}
    if package in {package_of(p) for p in world().references()}:
        found.add(world().package)
    return Array._of("str", sorted(found))


def get_path_name_for_loaded_asset(loaded_asset: Object) -> str:
    """Object path."""
    return loaded_asset.get_path_name()


def get_package_for_object(object: Object) -> Package:
    """Package of an object."""
    return object.get_package()


def get_project_root_asset_directory() -> str:
    """Where a project keeps its assets; no folder is set apart here."""
    return ""


def sync_browser_to_objects(asset_paths: Sequence[str]) -> None:
    """There is no content browser to show them."""


# metadata


def get_tag_values(asset_path: str) -> Map:
    """Registry tags of an asset: its metadata."""
    found = world().find(str(asset_path))
    return Map._of("Name", "str", found._metadata() if isinstance(found, AssetObject) else {})


def get_metadata_tag(object: Object, tag: Name | str) -> str:
    """Value of a metadata tag; empty when it is not set."""
    return object._metadata().get(Name(str(tag)), "") if isinstance(object, AssetObject) else ""


def get_metadata_tag_values(object: Object) -> Map:
    """All metadata tags."""
    return Map._of("Name", "str", object._metadata() if isinstance(object, AssetObject) else {})


def set_metadata_tag(object: Object, tag: Name | str, value: str) -> None:
    """Set a metadata tag, in memory."""
    if isinstance(object, AssetObject):
        object._metadata()[Name(str(tag))] = str(value)


def remove_metadata_tag(object: Object, tag: Name | str) -> None:
    """Take a metadata tag away."""
    if isinstance(object, AssetObject):
        object._metadata().pop(Name(str(tag)), None)


def get_all_assets_by_meta_data_tags(required_tags: Set, allowed_classes: Set) -> Array:
    """Registry entries of the assets of some classes (any, when none is named) that have all tags."""
    kinds = tuple(as_class(c)._python_type for c in allowed_classes)
    return Array._of(
        "AssetData",
        [
            find_asset_data(a._path())
            for a in world().assets()
            if (not kinds or isinstance(a, kinds)) and all(tag in a._metadata() for tag in required_tags)
        ],
    )


# saving and version control


def save_asset(asset_to_save: str, only_if_is_dirty: bool = True) -> bool:
    """Save a created asset."""
    found = world().find(str(asset_to_save))
    if not isinstance(found, AssetObject):
        world().log.error(f"SaveAsset: '{asset_to_save}' could not be found")
        return False
    return world().save(found)


def save_loaded_asset(asset_to_save: Object, only_if_is_dirty: bool = True) -> bool:
    """Save a created asset; the open level is saved as itself."""
    if asset_to_save is world().map:
        return world().save_map(world().package)
    return world().save(asset_to_save) if isinstance(asset_to_save, AssetObject) else False


def save_loaded_assets(assets_to_save: Sequence[Object], only_if_is_dirty: bool = True) -> bool:
    """Save created assets."""
    return _every(save_loaded_asset(asset) for asset in assets_to_save)


def save_directory(directory_path: str, only_if_is_dirty: bool = True, recursive: bool = True) -> bool:
    """Save the created assets of a folder."""
    return _every(
        world().save(a)
        for a in list(world().created.values())
        if in_folder(a._path(), _folder(directory_path), recursive)
    )


def checkout_asset(asset_to_checkout: str) -> bool:
    """There is no version control."""
    return does_asset_exist(asset_to_checkout)


def checkout_directory(directory_path: str, recursive: bool = True) -> bool:
    """There is no version control."""
    return does_directory_exist(directory_path)


def checkout_loaded_asset(asset_to_checkout: Object) -> bool:
    """There is no version control."""
    return isinstance(asset_to_checkout, AssetObject)


def checkout_loaded_assets(assets_to_checkout: Sequence[Object]) -> bool:
    """There is no version control."""
    return all(isinstance(a, AssetObject) for a in assets_to_checkout)


def set_dirty_flag(object: Object, dirty_state: bool) -> bool:
    """Mark an asset as edited or not."""
    if not isinstance(object, AssetObject):
        return False
    object._dirty = dirty_state
    return True


# deleting, renaming, merging


def delete_asset(asset_path_to_delete: str) -> bool:
    """Delete a created asset; what used it has nothing in its place."""
    return world().delete(str(asset_path_to_delete))


def delete_loaded_asset(asset_to_delete: Object) -> bool:
    """Delete a created asset."""
    return isinstance(asset_to_delete, AssetObject) and world().delete(asset_to_delete._path())


def delete_loaded_assets(assets_to_delete: Sequence[Object]) -> bool:
    """Delete created assets."""
    return _every(delete_loaded_asset(a) for a in assets_to_delete)


def make_directory(directory_path: str) -> bool:
    """Make a folder under /Game/."""
    folder = _folder(directory_path)
    if world().content_file(folder, "") is None:
        world().log.error(f"MakeDirectory: '{directory_path}' is not a folder under /Game/")
        return False
    world().folders.add(folder)
    return True


def delete_directory(directory_path: str) -> bool:
    """Delete a folder of created assets; False, and nothing is deleted, when it holds read-only ones."""
    folder = _folder(directory_path)
    inside = _within(folder)
    if not does_directory_exist(folder) or any(not a._created for a in inside):
        world().log.error(f"DeleteDirectory: '{directory_path}' cannot be deleted")
        return False
    for asset in inside:
        world().delete(asset._path())
    world().folders = {f for f in world().folders if f != folder and not f.startswith(folder + "/")}
    return True


def rename_asset(source_asset_path: str, destination_asset_path: str) -> bool:
    """Move a created asset; whatever uses it follows."""
    source, target = load(source_asset_path), new_object_path(str(destination_asset_path))
    return isinstance(source, AssetObject) and target is not None and world().move(source, target)


def rename_loaded_asset(source_asset: Object, destination_asset_path: str) -> bool:
    """Move a created asset."""
    return isinstance(source_asset, AssetObject) and rename_asset(source_asset._path(), destination_asset_path)


def rename_directory(source_directory_path: str, destination_directory_path: str) -> bool:
    """Move a folder of created assets; False, and nothing moves, when it holds read-only ones."""
    source, target = _folder(source_directory_path), _folder(destination_directory_path)
    inside = _within(source)
    if not inside or any(not a._created for a in inside) or does_directory_exist(target):
        world().log.error(f"RenameDirectory: '{source}' cannot become '{target}'")
        return False
    return _every(rename_asset(a._path(), target + package_of(a._path())[len(source) :]) for a in inside)


def consolidate_assets(asset_to_consolidate_to: Object, assets_to_consolidate: Sequence[Object]) -> bool:
    """Let what uses some created assets of the same kind use another one, and delete them."""
    kept, gone = asset_to_consolidate_to, list(assets_to_consolidate)
    family = MaterialInterface if isinstance(kept, MaterialInterface) else type(kept)
    if (
        not isinstance(kept, AssetObject)
        or not gone
        or any(not isinstance(a, family) or a is kept or not a._created for a in gone)
    ):
        world().log.error("ConsolidateAssets: only created assets of one kind can be merged into another asset")
        return False
    for asset in gone:
        world().replace_asset(asset, kept)
        world().delete(asset._path())
    return True


# copying


def duplicate_asset(source_asset_path: str, destination_asset_path: str) -> Any:
    """Copy a mesh or material under /Game/, in memory until saved; None when refused."""
    source = load(source_asset_path)
    target = new_object_path(str(destination_asset_path)) if source is not None else None
    return _copy(source, target) if target is not None else None


def duplicate_loaded_asset(source_asset: Object, destination_asset_path: str) -> Any:
    """Copy a mesh or material."""
    target = new_object_path(str(destination_asset_path))
    return _copy(source_asset, target) if target is not None else None


def duplicate_directory(source_directory_path: str, destination_directory_path: str) -> bool:
    """Copy the assets of a folder; False when it holds none, or one that cannot be copied."""
    source, target = _folder(source_directory_path), _folder(destination_directory_path)
    inside = _within(source)
    if does_directory_exist(target):
        world().log.error(f"DuplicateDirectory: '{target}' exists already")
        return False
    made = [duplicate_loaded_asset(a, target + package_of(a._path())[len(source) :]) for a in inside]
    return bool(made) and all(each is not None for each in made)


def _copy(source: Object, target: str) -> Any:
    if isinstance(source, StaticMesh):
        made: AssetObject = StaticMesh._at(target, created=True)._bind(source._asset)
        made._slot_overrides.update(source._slot_overrides)
    elif isinstance(source, MaterialInstanceConstant):
        made = MaterialInstanceConstant._at(target, created=True)
        made._values["parent"] = source._parent() or source
        made._vectors, made._scalars = dict(source._vectors), dict(source._scalars)
    elif isinstance(source, Material):
        made = Material._at(target, created=True)._bind(
            source._surface().model_copy(update={"path": target}), source._origin
        )
        made._parameters.update(source._named())
    else:
        world().log.error(f"DuplicateAsset: '{source._path()}' cannot be copied here")
        return None
    made._metadata().update(source._metadata())
    world().create(made)
    return made
