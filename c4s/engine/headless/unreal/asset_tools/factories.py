"""Asset tools and their factories."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.asset_tools import operations
from c4s.engine.headless.unreal.asset_tools.paths import new_object_path
from c4s.engine.headless.unreal.assets import AssetObject, Material, MaterialInstanceConstant
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, Prop, api, as_class, public
from c4s.engine.headless.unreal.structs import StructBase
from c4s.records import pack

NO_BLUEPRINTS = "the headless engine makes no Blueprints: place the actors themselves, or spawn those of the packs"


@public
class Factory(Object):
    """Base of asset factories."""

    _class_module = "UnrealEd"


@public
class MaterialFactoryNew(Factory):
    """Makes materials."""


@public
class MaterialInstanceConstantFactoryNew(Factory):
    """Makes material instances."""


@public
class BlueprintFactory(Factory):
    """Makes Blueprints in Unreal; the headless engine refuses to."""

    _declares = {"parent_class": Prop("Class | None", None, attribute=False)}


@public
class AssetImportTask(Object):
    """A file to import; the headless engine refuses to import."""

    _declares = {
        "filename": Prop("str", ""),
        "destination_path": Prop("str", ""),
        "destination_name": Prop("str", ""),
        "automated": Prop("bool", False),
        "save": Prop("bool", False),
        "replace_existing": Prop("bool", False),
        "imported_object_paths": Prop("Sequence[str]", lambda: Array._of("str", []), writable=False),
    }


@public
class AssetRenameData(StructBase):
    """An asset and where it is to go."""

    _fields = {"asset": Prop("Object | None", None), "new_package_path": Prop("str", ""), "new_name": Prop("str", "")}


@public
class AssetTools(Object):
    """Makes assets."""

    _class_module = "AssetTools"

    @api
    def create_asset(
        self,
        asset_name: str,
        package_path: str,
        asset_class: Class | type | None,
        factory: Factory | None,
        calling_context: Name | str = "None",
    ) -> Any:
        """Make a material or material instance, in memory until saved; None when refused."""
        target = new_object_path(f"{str(package_path).rstrip('/')}/{asset_name}")
        if target is None or factory is None:
            return None
        kind = as_class(asset_class)._python_type if asset_class is not None else None
        if isinstance(factory, MaterialFactoryNew) and kind in (None, Material):
            made: AssetObject = Material._at(target, created=True)._bind(pack.Material(path=target))
        elif isinstance(factory, MaterialInstanceConstantFactoryNew) and kind in (None, MaterialInstanceConstant):
            made = MaterialInstanceConstant._at(target, created=True)
        elif isinstance(factory, BlueprintFactory):
            world().log.error(f"CreateAsset: '{target}': {NO_BLUEPRINTS}")
            return None
        else:
            world().log.error(
                f"CreateAsset: {type(factory).__name__} does not make a {kind.__name__ if kind else 'asset'}"
            )
            return None
        world().create(made)
        return made

    @api
    def import_asset_tasks(self, import_tasks: Sequence[AssetImportTask]) -> None:
        """Refused: a case offers the assets of its packs only."""
        for task in import_tasks:
            world().log.error(f"ImportAssetTasks: importing '{task.filename}' is refused by the headless engine")

    @api
    def duplicate_asset(self, asset_name: str, package_path: str, original_object: Object) -> Any:
        """Copy an asset into a folder; None when refused."""
        return operations.duplicate_loaded_asset(original_object, f"{str(package_path).rstrip('/')}/{asset_name}")

    @api
    def rename_assets(self, assets_and_names: Sequence[AssetRenameData]) -> bool:
        """Move assets; False when one is refused."""
        moved = [
            operations.rename_loaded_asset(each.asset, f"{each.new_package_path.rstrip('/')}/{each.new_name}")
            for each in assets_and_names
            if each.asset is not None
        ]
        return len(moved) == len(assets_and_names) and False not in moved

    @api
    def create_unique_asset_name(self, base_package_name: str, suffix: str) -> tuple[str, str]:
        """A free package name that begins so, and its asset name: a number is added until it is free."""
        wanted = stem = f"{base_package_name}{suffix}"
        serial = 1
        while operations.does_asset_exist(wanted):
            wanted, serial = f"{stem}{serial}", serial + 1
        return wanted, wanted.rsplit("/", 1)[-1]


@public
class AssetToolsHelpers(Object):
    """Access to the asset tools."""

    _class_module = "AssetTools"

    @classmethod
    @api
    def get_asset_tools(cls) -> AssetTools:
        """The asset tools."""
        return TOOLS


TOOLS: AssetTools = AssetTools._make("AssetTools", None)
