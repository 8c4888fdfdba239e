"""Functions of the module itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.asset_tools import load, package_of
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Class, Object, Package, api, as_class, subclass_of
from c4s.engine.headless.unreal.libraries.ticks import (
    register_slate_post_tick_callback,
    unregister_slate_post_tick_callback,
)
from c4s.engine.headless.unreal.libraries.utility import uclass, ufunction, uproperty
from c4s.engine.headless.unreal.subobjects import SubobjectDataSubsystem
from c4s.engine.headless.unreal.subsystems import EditorSubsystem
from c4s.packs.store import bare_path


def log(arg: object) -> None:
    """Log a line."""
    world().log.display(str(arg))


def log_warning(arg: object) -> None:
    """Log a warning."""
    world().log.warning(str(arg))


def log_error(arg: object) -> None:
    """Log an error."""
    world().log.error(str(arg))


def _is_below(found: Class, base: Class | type | None) -> bool:
    return base is None or subclass_of(found, as_class(base)._python_type)


def _of_type(found: Any, type: Class | type | None) -> Any:
    """An object of a class, or None."""
    return found if found is not None and _is_below(found._class(), type) else None


def _found(name: str) -> Any:
    """The object of a path: an actor of the open level, one of its components, an asset, a class; or None."""
    path = bare_path(name)
    if ":PersistentLevel." not in path:
        return world().find(path)
    actor_name, _, part = path.split(":PersistentLevel.", 1)[1].partition(".")
    actor = world().actors.get(actor_name) if package_of(path) == world().package else None
    if actor is None or not part:
        return actor
    return next((component for component in actor._components if component._name == part), None)


def _loaded(name: str) -> Any:
    return _found(name) if ":PersistentLevel." in name else load(name)


@api
def load_asset(name: str, type: Class | type | None = None, follow_redirectors: bool = True) -> Any:
    """The asset of a path, or None with a logged warning."""
    return _of_type(load(name), type)


@api
def find_asset(name: str, type: Class | type | None = None, follow_redirectors: bool = True) -> Any:
    """The asset of a path, or None."""
    return _of_type(world().find(name), type)


@api
def load_object(
    outer: Object | None, name: str, type: Class | type | None = None, follow_redirectors: bool = True
) -> Any:
    """The object of a path, or None with a logged warning."""
    return _of_type(_loaded(name), type)


@api
def find_object(
    outer: Object | None, name: str, type: Class | type | None = None, follow_redirectors: bool = True
) -> Any:
    """The object of a path, or None."""
    return _of_type(_found(name), type)


@api
def load_class(outer: Object | None, name: str, type: Class | type | None = None) -> Class | None:
    """The class ``/Script/Module.Name`` or ``/Game/A/B.B_C``, or None with a logged warning."""
    found = world().find(name)
    if not isinstance(found, Class) or not _is_below(found, type):
        world().log.warning(f"LoadClass failed: '{name}' does not exist")
        return None
    return found


@api
def get_editor_subsystem(subsystem: Class | type) -> Any:
    """An editor subsystem."""
    wanted = as_class(subsystem)._python_type
    if not issubclass(wanted, EditorSubsystem):
        raise TypeError(f"get_editor_subsystem: '{wanted.__name__}' is no editor subsystem")
    if wanted is EditorSubsystem:
        return None
    if wanted not in _SUBSYSTEMS:
        _SUBSYSTEMS[wanted] = wanted._make(wanted.__name__, None)
    return _SUBSYSTEMS[wanted]


@api
def get_engine_subsystem(subsystem: Class | type) -> Any:
    """An engine subsystem."""
    if as_class(subsystem)._python_type is not SubobjectDataSubsystem:
        raise TypeError(f"get_engine_subsystem: '{as_class(subsystem).get_name()}' is no engine subsystem")
    return _SUBOBJECTS


@api
def new_object(
    type: Class | type, outer: Object | None = None, name: Name | str = "None", base_type: Class | type | None = None
) -> Any:
    """A new object of a class that scripts may make. A component is no part of its actor until it is added to that."""
    return as_class(type)._python_type(outer, name)


@api
def get_default_object(type: Class | type) -> Any:
    """An object with a class's defaults."""
    return as_class(type)._python_type.get_default_object()


@api
def find_package(name: str) -> Package | None:
    """The package of an asset or level, or None."""
    package = package_of(name)
    known = world().exists(package) or world().level_file(package) is not None or package == world().package
    return Package._make(package, None) if known else None


@api
def load_package(name: str) -> Package | None:
    """The package of an asset or level, or None."""
    return find_package(name)


@api
def get_type_from_class(class_: Class) -> type:
    """The Python type of a class."""
    found: type = class_._python_type
    return found


def collect_garbage() -> None:
    """Memory is freed by itself."""


def log_flush() -> None:
    """Every line is written at once."""


def is_editor() -> bool:
    """This is an editor."""
    return True


_SUBSYSTEMS: dict[type, EditorSubsystem] = {}
_SUBOBJECTS: SubobjectDataSubsystem = SubobjectDataSubsystem._make("SubobjectDataSubsystem", None)


def mesh_facts(path: str) -> dict[str, Any] | None:
    """What the snapshot keeps of a mesh: digest, local bounds and collision bodies (cm), or None when unknown."""
    asset = world().store.asset(path)
    if asset is None:
        found = world().find(path)
        asset = getattr(found, "_asset", None)
    if asset is None:
        return None
    return {
        "sha256": asset.mesh_sha256,
        "bounds_min_cm": list(asset.bounds_min_cm),
        "bounds_max_cm": list(asset.bounds_max_cm),
        "collision": [body.model_dump(mode="json") for body in asset.collision],
    }


FUNCTIONS: dict[str, Callable[..., Any]] = {
    f.__name__: f
    for f in (
        log,
        log_warning,
        log_error,
        log_flush,
        collect_garbage,
        get_default_object,
        find_package,
        load_package,
        get_type_from_class,
        load_asset,
        find_asset,
        load_object,
        find_object,
        load_class,
        get_editor_subsystem,
        get_engine_subsystem,
        new_object,
        is_editor,
        uclass,
        uproperty,
        ufunction,
        register_slate_post_tick_callback,
        unregister_slate_post_tick_callback,
    )
}
FUNCTIONS["c4s_mesh_facts"] = mesh_facts
