"""Finding, creating, saving and editing assets: EditorAssetLibrary, the registry, asset tools, materials."""

from __future__ import annotations

from c4s.engine.headless.unreal.asset_tools.factories import (
    TOOLS,
    AssetImportTask,
    AssetTools,
    AssetToolsHelpers,
    BlueprintFactory,
    Factory,
    MaterialFactoryNew,
    MaterialInstanceConstantFactoryNew,
)
from c4s.engine.headless.unreal.asset_tools.library import EditorAssetLibrary
from c4s.engine.headless.unreal.asset_tools.materials import MaterialEditingLibrary
from c4s.engine.headless.unreal.asset_tools.paths import load, package_of
from c4s.engine.headless.unreal.asset_tools.registry import (
    REGISTRY,
    ARFilter,
    AssetData,
    AssetRegistry,
    AssetRegistryDependencyOptions,
    AssetRegistryHelpers,
    TopLevelAssetPath,
    data_of,
)

__all__ = [
    "REGISTRY",
    "TOOLS",
    "ARFilter",
    "AssetData",
    "AssetImportTask",
    "AssetRegistry",
    "AssetRegistryDependencyOptions",
    "AssetRegistryHelpers",
    "AssetTools",
    "AssetToolsHelpers",
    "BlueprintFactory",
    "EditorAssetLibrary",
    "Factory",
    "MaterialEditingLibrary",
    "MaterialFactoryNew",
    "MaterialInstanceConstantFactoryNew",
    "TopLevelAssetPath",
    "data_of",
    "load",
    "package_of",
]
