"""Assets by path: ``EditorAssetLibrary``, and ``EditorAssetSubsystem`` with the same functions."""

from __future__ import annotations

import inspect

from c4s.engine.headless.unreal.asset_tools import operations
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem

_FUNCTIONS = {
    name: value
    for name, value in vars(operations).items()
    if inspect.isfunction(value) and value.__module__ == operations.__name__ and not name.startswith("_")
}
_ONLY_LIBRARY = {"get_package_for_object", "get_project_root_asset_directory", "sync_browser_to_objects"}
_ONLY_SUBSYSTEM = {"get_all_assets_by_meta_data_tags", "set_dirty_flag"}
_OTHER_NAMES = {
    "list_assets_by_tag_value": "list_asset_by_tag_value",
    "does_directory_have_assets": "does_directory_contain_assets",
}
"""Where the two differ: the first is the subsystem's name and the library's other one, the second the reverse."""


@public
class EditorAssetLibrary(Object):
    """Assets by path."""

    _class_module = "EditorScriptingUtilities"


@public
class EditorAssetSubsystem(EditorSubsystem):
    """Assets by path."""

    _class_module = "UnrealEd"


for _name, _function in _FUNCTIONS.items():
    _checked = staticmethod(api(_function))
    if _name not in _ONLY_SUBSYSTEM:
        setattr(EditorAssetLibrary, _OTHER_NAMES[_name] if _name == "list_assets_by_tag_value" else _name, _checked)
    if _name not in _ONLY_LIBRARY:
        setattr(EditorAssetSubsystem, _OTHER_NAMES[_name] if _name == "does_directory_have_assets" else _name, _checked)
