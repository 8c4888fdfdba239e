"""Finding, creating, saving and editing assets: EditorAssetLibrary, the registry, asset tools, materials."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.assets import (
    SCALAR_PARAMETERS,
    VECTOR_PARAMETERS,
    AssetObject,
    Blueprint,
    Material,
    MaterialInstanceConstant,
    MaterialInterface,
    StaticMesh,
    Texture,
)
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, Prop, api, as_class, public
from c4s.engine.headless.unreal.enums import MaterialParameterAssociation, MaterialProperty
from c4s.engine.headless.unreal.expressions import SURFACE_FIELDS, MaterialExpression, recompile
from c4s.engine.headless.unreal.structs import LinearColor, StructBase
from c4s.packs import manifest


def package_of(path: str) -> str:
    """Package of an object path."""
    return path.split(".", 1)[0]


def load(path: str) -> Any:
    """The asset of a path, or None with a logged warning."""
    found = world().find(str(path))
    if found is None:
        world().log.warning(f"LoadAsset failed: '{path}' does not exist")
    return found


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

    _declares = {"filename": Prop("str", ""), "destination_path": Prop("str", ""), "destination_name": Prop("str", ""),
                 "automated": Prop("bool", False), "save": Prop("bool", False), "replace_existing": Prop("bool", False),
                 "imported_object_paths": Prop("Sequence[str]", lambda: Array._of("str", []), writable=False)}


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

    _fields = {name: Prop(kind, (lambda kind=kind: Array._of(kind[9:-1], [])) if "Sequence" in kind else False)
               for name, kind in (
        ("package_names", "Sequence[Name]"), ("package_paths", "Sequence[Name]"),
        ("class_paths", "Sequence[TopLevelAssetPath]"), ("class_names", "Sequence[Name]"),
        ("recursive_paths", "bool"), ("recursive_classes", "bool"), ("include_only_on_disk_assets", "bool"))}

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)


@public
class AssetRegistryDependencyOptions(StructBase):
    """Which references count."""

    _fields = {name: Prop("bool", False) for name in (
        "include_soft_package_references", "include_hard_package_references", "include_searchable_names",
        "include_soft_management_references", "include_hard_management_references")}


@public
class AssetData(StructBase):
    """What the registry knows of an asset."""

    _fields = {"package_name": Prop("Name", Name), "package_path": Prop("Name", Name), "asset_name": Prop("Name", Name),
               "asset_class_path": Prop("TopLevelAssetPath", TopLevelAssetPath), "asset_class": Prop("Name", Name)}
    _takes = 4

    @classmethod
    def _for(cls, path: str, class_path: str) -> AssetData:
        package, kind = package_of(path), class_path.rsplit(".", 1)
        made: AssetData = cls._of_fields(package, package.rsplit("/", 1)[0], path.rsplit(".", 1)[-1],
                                         TopLevelAssetPath(kind[0], kind[1]), kind[1])
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


def _in_folder(path: str, folder: str, recursive: bool) -> bool:
    folder = folder.rstrip("/")
    parent = package_of(path).rsplit("/", 1)[0]
    return parent == folder or (recursive and parent.startswith(folder + "/"))


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
        names = {str(n).casefold() for n in wanted.class_names}
        packages = {str(n).casefold() for n in wanted.package_names}
        folders = [str(p) for p in wanted.package_paths]

        def fits(asset: AssetObject) -> bool:
            path, kind = asset._path(), asset._class()._path()
            return ((not classes or kind.casefold() in classes)
                    and (not names or kind.rsplit(".", 1)[-1].casefold() in names)
                    and (not packages or package_of(path).casefold() in packages)
                    and (not folders or any(_in_folder(path, f, wanted.recursive_paths) for f in folders)))

        return self._list(fits)

    @api
    def get_assets_by_path(self, package_path: Name | str, recursive: bool = False,
                           include_only_on_disk_assets: bool = False) -> Array | None:
        """Assets of a folder."""
        return self._list(lambda a: _in_folder(a._path(), str(package_path), recursive))

    @api
    def get_assets_by_class(self, class_path_name: TopLevelAssetPath, search_sub_classes: bool = False) -> Array | None:
        """Assets of a class."""
        return self._list(lambda a: a._class()._path() == class_path_name._text())

    @api
    def get_assets_by_package_name(self, package_name: Name | str,
                                   include_only_on_disk_assets: bool = False,
                                   skip_ar_filtered_assets: bool = True) -> Array | None:
        """Assets of a package."""
        return self._list(lambda a: package_of(a._path()) == str(package_name))

    @api
    def get_asset_by_object_path(self, object_path: Name | str,
                                 include_only_on_disk_assets: bool = False) -> AssetData:
        """Registry entry of a path, invalid when there is none."""
        found = world().find(str(object_path))
        return data_of(found) if isinstance(found, AssetObject) else AssetData()

    @api
    def get_dependencies(self, package_name: Name | str,
                         dependency_options: AssetRegistryDependencyOptions) -> Array | None:
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
    def get_referencers(self, package_name: Name | str,
                        reference_options: AssetRegistryDependencyOptions) -> Array | None:
        """Assets that name a package."""
        wanted = str(package_name)
        return Array._of("Name", [Name(package_of(a._path())) for a in world().assets()
                                  if wanted in {package_of(p) for p in a._references()}])

    @api
    def scan_paths_synchronous(self, paths: Sequence[str], force_rescan: bool = False,
                               ignore_deny_list_scan_filters: bool = False) -> None:
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
        return folder in world().folders or any(_in_folder(a._path(), folder, True) for a in world().assets())

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
        found = sorted(a._path() for a in world().assets() if _in_folder(a._path(), str(directory_path), recursive))
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
                 if _in_folder(a._path(), str(directory_path), recursive)]
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
        target = _target(str(destination_asset_path))
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


def _target(path: str) -> str | None:
    package = package_of(path)
    if world().content_file(package, "") is None:
        world().log.error(f"'{path}' is not a package path under /Game/")
        return None
    if world().exists(package) or world().level_file(package) is not None:
        world().log.error(f"'{path}' exists already")
        return None
    return f"{package}.{package.rsplit('/', 1)[-1]}"


@public
class AssetTools(Object):
    """Makes assets."""

    _class_module = "AssetTools"

    @api
    def create_asset(self, asset_name: str, package_path: str, asset_class: Class | type | None,
                     factory: Factory | None, calling_context: Name | str = "None") -> Any:
        """Make a material or material instance, in memory until saved; None when refused."""
        target = _target(f"{str(package_path).rstrip('/')}/{asset_name}")
        if target is None or factory is None:
            return None
        kind = as_class(asset_class)._python_type if asset_class is not None else None
        if isinstance(factory, MaterialFactoryNew) and kind in (None, Material):
            made: AssetObject = Material._at(target, created=True)._bind(manifest.Material(path=target))
        elif isinstance(factory, MaterialInstanceConstantFactoryNew) and kind in (None, MaterialInstanceConstant):
            made = MaterialInstanceConstant._at(target, created=True)
        else:
            world().log.error(f"CreateAsset: {type(factory).__name__} does not make a "
                              f"{kind.__name__ if kind else 'asset'}")
            return None
        world().create(made)
        return made


    @api
    def import_asset_tasks(self, import_tasks: Sequence[AssetImportTask]) -> None:
        """Refused: a case offers the assets of its packs only."""
        for task in import_tasks:
            world().log.error(f"ImportAssetTasks: importing '{task.filename}' is refused by the headless engine")


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


_GLOBAL = MaterialParameterAssociation.GLOBAL_PARAMETER


@public
class MaterialEditingLibrary(Object):
    """Editing of created materials and instances."""

    _class_module = "MaterialEditor"

    @classmethod
    @api
    def set_material_instance_parent(cls, instance: MaterialInstanceConstant, new_parent: MaterialInterface) -> None:
        """Set the parent."""
        if instance._created:
            instance.set_editor_property("parent", new_parent)

    @classmethod
    @api
    def set_material_instance_vector_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str, value: LinearColor,
                                                     association: MaterialParameterAssociation = _GLOBAL) -> bool:
        """Set a vector parameter; False for one that the parent does not have, or a read-only asset."""
        return bool(instance._created and instance._set_vector(parameter_name, value))

    @classmethod
    @api
    def set_material_instance_scalar_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str, value: float,
                                                     association: MaterialParameterAssociation = _GLOBAL) -> bool:
        """Set a scalar parameter; False for one that the parent does not have, or a read-only asset."""
        return bool(instance._created and instance._set_scalar(parameter_name, value))

    @classmethod
    @api
    def set_material_instance_texture_parameter_value(cls, instance: MaterialInstanceConstant,
                                                      parameter_name: Name | str, value: Texture | None,
                                                      association: MaterialParameterAssociation = _GLOBAL) -> bool:
        """False: materials here have no texture parameters."""
        return False

    @classmethod
    @api
    def get_texture_parameter_names(cls, material: MaterialInterface) -> Array:
        """None: materials here have no texture parameters."""
        return Array._of("Name", [])

    @classmethod
    @api
    def get_material_instance_vector_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str,
                                                     association: MaterialParameterAssociation = _GLOBAL
                                                     ) -> LinearColor:
        """Value of a vector parameter."""
        return instance._vector(parameter_name)

    @classmethod
    @api
    def get_material_instance_scalar_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str,
                                                     association: MaterialParameterAssociation = _GLOBAL) -> float:
        """Value of a scalar parameter."""
        return instance._scalar(parameter_name)

    @classmethod
    @api
    def get_vector_parameter_names(cls, material: MaterialInterface) -> Array:
        """Vector parameters of a material: the surface's colours."""
        return Array._of("Name", [Name(n) for n in VECTOR_PARAMETERS])

    @classmethod
    @api
    def get_scalar_parameter_names(cls, material: MaterialInterface) -> Array:
        """Scalar parameters of a material: the surface's factors."""
        return Array._of("Name", [Name(n) for n in SCALAR_PARAMETERS])

    @classmethod
    @api
    def update_material_instance(cls, instance: MaterialInstanceConstant) -> None:
        """Values count at once."""

    @classmethod
    @api
    def create_material_expression(cls, material: Material, expression_class: Class | type, node_pos_x: int = 0,
                                   node_pos_y: int = 0) -> Any:
        """Add an expression to a created material; None for a read-only one."""
        if not material._created:
            world().log.error(f"'{material._path()}' is read-only")
            return None
        kind = as_class(expression_class)._python_type
        made = kind._make(f"{kind.__name__}_{len(material._expressions)}", material)
        material._expressions.append(made)
        return made

    @classmethod
    @api
    def connect_material_property(cls, from_expression: MaterialExpression, from_output_name: str,
                                  property_: MaterialProperty) -> bool:
        """Let an expression drive an input of its material; False for inputs that a surface here does not have."""
        material, field = from_expression._outer, SURFACE_FIELDS.get(property_.name)
        if field is None or not isinstance(material, Material):
            return False
        material._links = {**getattr(material, "_links", {}), field: from_expression}
        recompile(material)
        return True

    @classmethod
    @api
    def recompile_material(cls, material: Material) -> None:
        """Evaluate the expressions."""
        recompile(material)
