"""The asset registry."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.asset_tools.paths import in_folder, package_of
from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import TYPES, Object, Prop, api, deprecated, public
from c4s.engine.headless.unreal.structs import StructBase


@public
class TopLevelAssetPath(StructBase):
    """Path of an asset or class: package and name."""

    _fields = {"package_name": Prop("Name", Name), "asset_name": Prop("Name", Name)}

    def __init__(self, package_name: Name | str = "None", asset_name: Name | str = "None") -> None:
        super().__init__(package_name, asset_name)

    def _text(self) -> str:
        fields: Any = self
        return f"{fields.package_name}.{fields.asset_name}"


@public
class ARFilter(StructBase):
    """What to look for in the registry."""

    _fields = {
        name: Prop(kind, (lambda kind=kind: Array._of(kind[9:-1], [])) if "Sequence" in kind else False)
        for name, kind in (
            ("package_names", "Sequence[Name]"),
            ("package_paths", "Sequence[Name]"),
            ("class_paths", "Sequence[TopLevelAssetPath]"),
            ("class_names", "Sequence[Name]"),
            ("recursive_paths", "bool"),
            ("recursive_classes", "bool"),
            ("include_only_on_disk_assets", "bool"),
        )
    }

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)


@public
class AssetRegistryDependencyOptions(StructBase):
    """Which references count."""

    _fields = {
        name: Prop("bool", False)
        for name in (
            "include_soft_package_references",
            "include_hard_package_references",
            "include_searchable_names",
            "include_soft_management_references",
            "include_hard_management_references",
        )
    }


@public
class AssetData(StructBase):
    """What the registry knows of an asset."""

    _fields = {
        "package_name": Prop("Name", Name),
        "package_path": Prop("Name", Name),
        "asset_name": Prop("Name", Name),
        "asset_class_path": Prop("TopLevelAssetPath", TopLevelAssetPath),
        "asset_class": Prop("Name", Name),
    }
    _takes = 4

    @classmethod
    def _for(cls, path: str, class_path: str) -> AssetData:
        package, kind = package_of(path), class_path.rsplit(".", 1)
        made: AssetData = cls._of_fields(
            package, package.rsplit("/", 1)[0], path.rsplit(".", 1)[-1], TopLevelAssetPath(kind[0], kind[1]), kind[1]
        )
        return made

    def _object_path(self) -> str:
        fields: Any = self
        return f"{fields.package_name}.{fields.asset_name}"

    def is_valid(self) -> bool:
        """Whether it names an asset."""
        return not self.package_name.is_none()

    def get_asset(self) -> Any:
        """The asset."""
        return world().find(self._object_path()) if self.is_valid() else None

    def get_class(self) -> Any:
        """The asset's class."""
        asset = self.get_asset()
        return asset.get_class() if asset is not None else None

    def get_full_name(self) -> str:
        """Class and path."""
        return f"{self.asset_class} {self._object_path()}"

    def is_asset_loaded(self) -> bool:
        """Everything that resolves is in memory."""
        return self.get_asset() is not None

    @api
    def get_tag_value(self, tag_name: Name | str) -> str | None:
        """Registry tags are not kept here: None."""
        return None


def data_of(asset: AssetObject) -> AssetData:
    """Registry entry of an asset."""
    return AssetData._for(asset._path(), asset._class()._path())


def _below(class_path: str) -> set[str]:
    """Paths of the classes that derive from a native one, in lower case."""
    kinds = [kind for kind in TYPES.values() if issubclass(kind, Object)]
    base = next((kind for kind in kinds if kind._class_path().casefold() == class_path.casefold()), None)
    return {kind._class_path().casefold() for kind in kinds if base is not None and issubclass(kind, base)}


@public
class AssetRegistry(Object):
    """Everything that paths resolve to."""

    _class_module = "AssetRegistry"

    def _list(self, keep: Any) -> Array:
        return Array._of("AssetData", [data_of(a) for a in world().assets() if keep(a)])

    @api
    def get_all_assets(self, include_only_on_disk_assets: bool = False) -> Array:
        """All assets."""
        return self._list(lambda a: True)

    @api
    def get_assets(self, filter: ARFilter, skip_ar_filtered_assets: bool = True) -> Array | None:
        """Assets that fit a filter."""
        wanted: Any = filter
        classes = {p._text().casefold() for p in wanted.class_paths}
        if wanted.recursive_classes:
            classes |= {below for name in list(classes) for below in _below(name)}
        names = {str(n).casefold() for n in wanted.class_names}
        packages = {str(n).casefold() for n in wanted.package_names}
        folders = [str(p) for p in wanted.package_paths]

        def fits(asset: AssetObject) -> bool:
            path, kind = asset._path(), asset._class()._path()
            return (
                (not classes or kind.casefold() in classes)
                and (not names or kind.rsplit(".", 1)[-1].casefold() in names)
                and (not packages or package_of(path).casefold() in packages)
                and (not folders or any(in_folder(path, f, wanted.recursive_paths) for f in folders))
            )

        return self._list(fits)

    @api
    def get_assets_by_path(
        self, package_path: Name | str, recursive: bool = False, include_only_on_disk_assets: bool = False
    ) -> Array | None:
        """Assets of a folder."""
        return self._list(lambda a: in_folder(a._path(), str(package_path), recursive))

    @api
    def get_assets_by_class(self, class_path_name: TopLevelAssetPath, search_sub_classes: bool = False) -> Array | None:
        """Assets of a class."""
        wanted = {class_path_name._text().casefold()}
        if search_sub_classes:
            wanted |= _below(class_path_name._text())
        return self._list(lambda a: a._class()._path().casefold() in wanted)

    @api
    def get_assets_by_package_name(
        self, package_name: Name | str, include_only_on_disk_assets: bool = False, skip_ar_filtered_assets: bool = True
    ) -> Array | None:
        """Assets of a package."""
        return self._list(lambda a: package_of(a._path()) == str(package_name))

    def _entry(self, path: str) -> AssetData:
        found = world().find(path)
        return data_of(found) if isinstance(found, AssetObject) else AssetData()

    @deprecated("Use other version that takes a SoftObjectPath")
    @api
    def get_asset_by_object_path(self, object_path: Name | str, include_only_on_disk_assets: bool = False) -> AssetData:
        """Registry entry of a path, invalid when there is none."""
        return self._entry(str(object_path))

    @api
    def get_dependencies(
        self, package_name: Name | str, dependency_options: AssetRegistryDependencyOptions
    ) -> Array | None:
        """Packages that a saved package names, or None when it is not on disk. All references here are hard."""
        paths = world().disk_references(package_of(str(package_name)))
        if paths is None:
            return None
        options: Any = dependency_options
        if not options.include_hard_package_references:
            return Array._of("Name", [])
        packages = sorted({package_of(p) for p in paths})
        return Array._of("Name", [Name(p) for p in packages])

    @api
    def get_referencers(
        self, package_name: Name | str, reference_options: AssetRegistryDependencyOptions
    ) -> Array | None:
        """Assets that name a package."""
        wanted = str(package_name)
        return Array._of(
            "Name",
            [
                Name(package_of(a._path()))
                for a in world().assets()
                if wanted in {package_of(p) for p in a._references()}
            ],
        )

    @api
    def scan_paths_synchronous(
        self, paths: Sequence[str], force_rescan: bool = False, ignore_deny_list_scan_filters: bool = False
    ) -> None:
        """Files are looked up when they are asked for."""

    @api
    def wait_for_completion(self) -> None:
        """Nothing runs in the background."""

    @api
    def is_loading_assets(self) -> bool:
        """Nothing runs in the background."""
        return False


@public
class AssetRegistryHelpers(Object):
    """Access to the registry."""

    _class_module = "AssetRegistry"

    @classmethod
    @api
    def get_asset_registry(cls) -> AssetRegistry:
        """The registry."""
        return REGISTRY

    @classmethod
    @api
    def get_asset(cls, asset_data: AssetData) -> Any:
        """The asset of an entry."""
        return asset_data.get_asset()

    @classmethod
    @api
    def get_class(cls, asset_data: AssetData) -> Any:  # type: ignore[override]
        """The class of an entry's asset."""
        return asset_data.get_class()

    @classmethod
    @api
    def get_full_name(cls, asset_data: AssetData) -> str:  # type: ignore[override]
        """Class and path of an entry."""
        return asset_data.get_full_name()

    @classmethod
    @api
    def is_valid(cls, asset_data: AssetData) -> bool:
        """Whether an entry names an asset."""
        return asset_data.is_valid()


REGISTRY: AssetRegistry = AssetRegistry._make("AssetRegistry", None)
