"""Choosing from lists of actors and objects; groups of levels; the selection."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.asset_tools import operations
from c4s.engine.headless.unreal.asset_tools.paths import package_of
from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, api, as_class, public
from c4s.engine.headless.unreal.enums import (
    EditorScriptingFilterType,
    EditorScriptingStringMatchType,
    LevelVisibilityDirtyMode,
)
from c4s.engine.headless.unreal.levels import Level, World
from c4s.engine.headless.unreal.structs import Vector

_IN, _CONTAINS = EditorScriptingFilterType.INCLUDE, EditorScriptingStringMatchType.CONTAINS


def _chosen(items: Sequence[Any], keep: Any, kind: EditorScriptingFilterType) -> Array:
    return Array._of("Object", [item for item in items if bool(keep(item)) is (kind is _IN)])


def _matches(text: str, part: str, how: EditorScriptingStringMatchType, ignore_case: bool = True) -> bool:
    if ignore_case:
        text, part = text.casefold(), part.casefold()
    if how is EditorScriptingStringMatchType.EXACT_MATCH:
        return text == part
    return fnmatchcase(text, part) if how is EditorScriptingStringMatchType.MATCHES_WILDCARD else part in text


@public
class EditorFilterLibrary(Object):
    """Choosing from lists."""

    _class_module = "EditorScriptingUtilities"

    @classmethod
    @api
    def by_class(
        cls, target_array: Sequence[Object], object_class: Class | type, filter_type: EditorScriptingFilterType = _IN
    ) -> Array:
        """Objects of a class."""
        wanted = as_class(object_class)._python_type
        return _chosen(target_array, lambda o: isinstance(o, wanted), filter_type)

    @classmethod
    @api
    def by_id_name(
        cls,
        target_array: Sequence[Object],
        name_sub_string: str,
        string_match: EditorScriptingStringMatchType = _CONTAINS,
        filter_type: EditorScriptingFilterType = _IN,
    ) -> Array:
        """Objects by their object name."""
        return _chosen(target_array, lambda o: _matches(o.get_name(), str(name_sub_string), string_match), filter_type)

    @classmethod
    @api
    def by_actor_label(
        cls,
        target_array: Sequence[Actor],
        name_sub_string: str,
        string_match: EditorScriptingStringMatchType = _CONTAINS,
        filter_type: EditorScriptingFilterType = _IN,
        ignore_case: bool = True,
    ) -> Array:
        """Actors by their label."""
        return _chosen(
            target_array,
            lambda a: _matches(a.get_actor_label(), str(name_sub_string), string_match, ignore_case),
            filter_type,
        )

    @classmethod
    @api
    def by_actor_tag(
        cls, target_array: Sequence[Actor], tag: Name | str, filter_type: EditorScriptingFilterType = _IN
    ) -> Array:
        """Actors with a tag."""
        return _chosen(target_array, lambda a: a.actor_has_tag(tag), filter_type)

    @classmethod
    @api
    def by_selection(cls, target_array: Sequence[Actor], filter_type: EditorScriptingFilterType = _IN) -> Array:
        """Selected actors."""
        return _chosen(target_array, lambda a: a in world().selection, filter_type)


@public
class EditorUtilityLibrary(Object):
    """The selection, and renaming."""

    _class_module = "Blutility"

    @classmethod
    @api
    def get_selection_set(cls) -> Array:
        """Selected actors."""
        return Array._of("Actor", world().selection)

    @classmethod
    @api
    def get_selection_bounds(cls) -> tuple[Vector, Vector, float]:
        """World AABB of the selected actors (centre, half extent) and its sphere's radius, in cm."""
        boxes = [a.get_actor_bounds(False) for a in world().selection]
        if not boxes:
            return Vector(), Vector(), 0.0
        low, high = boxes[0][0] - boxes[0][1], boxes[0][0] + boxes[0][1]
        for origin, extent in boxes[1:]:
            low, high = low.get_min(origin - extent), high.get_max(origin + extent)
        half = (high - low) * 0.5
        return (low + high) * 0.5, half, half.length()

    @classmethod
    @api
    def get_selected_assets(cls) -> Array:
        """There is no content browser to select in."""
        return Array._of("Object", [])

    @classmethod
    @api
    def get_selected_asset_data(cls) -> Array:
        """There is no content browser to select in."""
        return Array._of("AssetData", [])

    @classmethod
    @api
    def get_actor_reference(cls, path_to_actor: str) -> Actor | None:
        """The actor of a path, or None."""
        return world().actors.get(str(path_to_actor).rsplit(".", 1)[-1])

    @classmethod
    @api
    def rename_asset(cls, asset: Object, new_name: str) -> None:
        """Give a created asset another name in its folder."""
        if isinstance(asset, AssetObject):
            operations.rename_asset(asset._path(), f"{package_of(asset._path()).rsplit('/', 1)[0]}/{new_name}")


@public
class EditorLevelUtils(Object):
    """Levels of a world: there is one, the persistent one; streaming levels are refused (None)."""

    _class_module = "UnrealEd"

    @classmethod
    @api
    def get_levels(cls, world: World) -> Array:
        """The levels of a world."""
        return Array._of("Level", [world._level])

    @classmethod
    @api
    def set_level_visibility(
        cls,
        level: Level,
        should_be_visible: bool,
        force_layers_visible: bool,
        modify_mode: LevelVisibilityDirtyMode = LevelVisibilityDirtyMode.MODIFY_ON_CHANGE,
    ) -> None:
        """The persistent level is always shown."""

    @classmethod
    @api
    def add_level_to_world(cls, world: World, level_package_name: str, level_streaming_class: Class | type) -> Any:
        """Refused: None."""
        return _refused(level_package_name)

    @classmethod
    @api
    def create_new_streaming_level(
        cls,
        level_streaming_class: Class | type,
        new_level_path: str = "",
        move_selected_actors_into_new_level: bool = False,
    ) -> Any:
        """Refused: None."""
        return _refused(new_level_path)

    @classmethod
    @api
    def remove_level_from_world(
        cls, level: Level, clear_selection: bool = True, reset_transaction_buffer: bool = True
    ) -> bool:
        """The persistent level cannot be removed."""
        return False


def _refused(path: str) -> None:
    world().log.error(f"'{path}': the headless engine has one level at a time; streaming levels are refused")
