"""Maps and packages."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Object, Package, api, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.subsystems.levels import open_map, save_current


def _dirty_assets() -> list[AssetObject]:
    return [asset for asset in world().created.values() if asset._dirty]


@public
class EditorLoadingAndSavingUtils(Object):
    """Maps and packages."""

    _class_module = "UnrealEd"

    @classmethod
    @api
    def load_map(cls, filename: str) -> World | None:
        """Open a level by package path; None when there is none."""
        return open_map(filename)

    @classmethod
    @api
    def new_blank_map(cls, save_existing_map: bool) -> World:
        """Open an empty untitled level."""
        if save_existing_map:
            save_current()
        return world().new_map()  # type: ignore[no-any-return]

    @classmethod
    @api
    def save_map(cls, world: World, asset_path: str) -> bool:
        """Save the open map under a path; it becomes that map."""
        return _save_map(str(asset_path))

    @classmethod
    @api
    def save_current_level(cls) -> bool:
        """Save the open level."""
        return save_current()

    @classmethod
    @api
    def save_dirty_packages(cls, save_map_packages: bool, save_content_packages: bool) -> bool:
        """Save what was edited."""
        saved = [world().save(asset) for asset in _dirty_assets()] if save_content_packages else []
        if save_map_packages and world().dirty:
            saved.append(save_current())
        return all(saved)

    @classmethod
    @api
    def get_dirty_map_packages(cls) -> Array:
        """Edited maps."""
        return Array._of("Package", [world().map.get_package()] if world().dirty else [])

    @classmethod
    @api
    def get_dirty_content_packages(cls) -> Array:
        """Edited assets."""
        return Array._of("Package", [a.get_package() for a in _dirty_assets()])

    @classmethod
    @api
    def save_packages(cls, packages_to_save: Sequence[Package], only_dirty: bool) -> bool:
        """Save maps and created assets by their packages."""
        saved = []
        for package in packages_to_save:
            name = package.get_name()
            asset = world().find(name)
            if name == world().package:
                saved.append(save_current())
            else:
                saved.append(world().save(asset) if isinstance(asset, AssetObject) else False)
        return all(saved)

    @classmethod
    @api
    def save_dirty_packages_with_dialog(cls, save_map_packages: bool, save_content_packages: bool) -> bool:
        """Save what was edited; nobody is asked."""
        return cls.save_dirty_packages(save_map_packages, save_content_packages)

    @classmethod
    @api
    def new_map_from_template(cls, path_to_template_level: str, save_existing_map: bool) -> World | None:
        """Open an untitled copy of a level; None when there is none."""
        if save_existing_map:
            save_current()
        return world().copy_map(str(path_to_template_level))  # type: ignore[no-any-return]


def _save_map(path: str) -> bool:
    return world().save_map(path)
